# SPDX-License-Identifier: MIT
"""Turntables and batches of drawings on many processes or machines, with Dask.  Needs NumPy and dask.distributed.

For a turntable, the calling process fits the model and places the marks.  It sends both to every worker once, as saved
bytes.  Each worker makes its own context, finds lines once, and draws its frames.  Results come back as soon as they are
ready.  If a worker dies, another one draws its frames.

>>> hrbfnpr.batch.turntable("bunny.ply", "bunny.gif", frames=72)
>>> for number, image in hrbfnpr.batch.draw(["a.ply", "b.ply"], "hatch", scheduler="tcp://10.0.0.5:8786"):
...     print(number)

A local cluster starts new processes, never by fork.  A script that uses one therefore needs
``if __name__ == "__main__":``.
"""
from __future__ import annotations

import os
import threading
from collections import OrderedDict
from contextlib import closing, contextmanager
from typing import Any, Callable, Dict, Generator, Iterable, Iterator, List, NamedTuple, Optional, Tuple, Union
from uuid import uuid4

from . import _movies
from ._animate import SIZE, turntable_of
from ._arrays import Array
from ._camera import Camera
from ._context import Context
from ._model import Model
from ._picture import asked
from ._point_set import PointSet
from ._report import CallReport, Progress
from ._request import Options
from ._scene import Scene
from ._style import Style

RETRIES = 3  # how often a task is repeated if its worker dies
_KEPT = 2  # number of scenes that a worker keeps

Numbered = Tuple[int, Array]


class Sent(NamedTuple):
    """What a worker draws: the saved models and marks, and the options, style and camera."""

    name: str
    surfaces: Tuple[Tuple[Optional[bytes], bytes], ...]
    options: Options
    style: Union[str, Style]
    camera: Camera
    threads: int


class WorkerError(RuntimeError):
    """The workers of a task died again and again while they drew."""


def turntable(
    source: Any,
    path: Union[str, "os.PathLike[str]"],
    style: Union[str, Style] = "contour-and-stipple",
    *,
    frames: int = 36,
    fps: float = 12.0,
    turn: float = 360.0,
    loops: int = 0,
    **options: Any,
) -> None:
    """Draw a turntable on many workers and write it to a file, as `hrbfnpr.animate` does.

    Parameters
    ----------
    source, path, style, frames, fps, turn, loops
        As in `hrbfnpr.animate`.
    **options
        `scheduler`, `workers`, `camera`, `progress` and `context`, as in `frames_of`, and the options of `hrbfnpr.draw`.

    Raises
    ------
    ImportError, WorkerError
        As `frames_of`.
    """
    _movies.check_movie(path, fps)
    paper: List[Any] = []
    drawn = frames_of(source, style, frames=frames, turn=turn, tell=lambda scene: paper.extend(scene.style.paper), **options)
    first = next(drawn)  # after this the paper is known

    def ordered() -> Iterator[Array]:
        waiting: Dict[int, Array] = dict([first])
        for number in range(frames):
            while number not in waiting:
                waiting.update([next(drawn)])
            yield waiting.pop(number)

    with closing(drawn):
        _movies.write(path, ordered(), fps, loops, paper)


def frames_of(
    source: Any,
    style: Union[str, Style] = "contour-and-stipple",
    *,
    frames: int = 36,
    turn: float = 360.0,
    scheduler: Any = None,
    workers: Optional[int] = None,
    camera: Optional[Camera] = None,
    progress: Progress = None,
    context: Optional[Context] = None,
    tell: Optional[Callable[[Scene], Any]] = None,
    **options: Any,
) -> Generator[Numbered, None, None]:
    """Draw the frames of a turntable on many workers.  Yields the number and the image of each frame when it is ready.

    The frames come in any order.

    Parameters
    ----------
    source, style, frames, turn, camera, progress, **options
        As in `hrbfnpr.animate`.
    scheduler : str or Client, optional
        The address of Dask's scheduler, such as "tcp://10.0.0.5:8786", or a client, which stays open; None: a local
        cluster of processes for this call.
    workers : int, optional
        Number of processes of the local cluster; None: the number of processors.
    context : Context, optional
        The context for the fit and the marks.
    tell : callable, optional
        A function that gets the scene before the first frame.

    Raises
    ------
    ImportError
        If dask.distributed is not installed.
    WorkerError
        If the workers of a frame died more than `RETRIES` times.
    """
    if frames < 1:
        raise ValueError(f"frames must be at least 1, not {frames}")
    _distributed()
    report = CallReport(progress)
    scene = turntable_of(source, style, frames, turn, camera, context, {"size": SIZE, **options}, report)
    if tell is not None:
        tell(scene)
    with _client(scheduler, workers) as (client, threads):
        sent = _sent(scene, threads)
        yield from _results(client, _frame, sent, scene.orbit(frames, turn), report)


def draw(
    sources: Iterable[Any],
    style: Union[str, Style] = "contour-and-stipple",
    *,
    scheduler: Any = None,
    workers: Optional[int] = None,
    progress: Progress = None,
    **options: Any,
) -> Iterator[Numbered]:
    """Draw many sources on many workers.  Yields the number and the image of each source when it is ready.

    The images come in any order.

    Parameters
    ----------
    sources : iterable
        Sources of `hrbfnpr.draw` that can be pickled.  The workers read files.
    style, **options
        As in `hrbfnpr.draw`.
    scheduler, workers, progress
        As in `frames_of`.

    Raises
    ------
    ImportError, WorkerError
        As `frames_of`.
    ValueError, OSError, ...
        The error of `hrbfnpr.draw` for one of the sources.

    Warns
    -----
    DrawingWarning
        The warnings of `hrbfnpr.draw`, with the number of the source.
    """
    _distributed()
    with _client(scheduler, workers) as (client, threads):
        report, sent = CallReport(progress), (style, options, threads)
        for number, (image, told) in _results(client, _whole, sent, list(sources), report):
            for text in told:
                report.warn(f"number {number}: {text}")
            report.finish()
            yield number, image


def _times(count: int) -> str:
    return f"{count} time{'' if count == 1 else 's'}"


def _distributed() -> Any:
    try:
        import distributed
    except ImportError as error:
        raise ImportError("hrbfnpr.batch needs dask.distributed (Debian: python3-distributed)") from error
    return distributed


@contextmanager
def _client(scheduler: Any, workers: Optional[int]) -> Iterator[Tuple[Any, int]]:
    """A client, and the number of threads that each worker may have; 0 = all of its machine."""
    distributed = _distributed()
    if scheduler is not None:
        if isinstance(scheduler, distributed.Client):
            yield scheduler, 0
            return
        with distributed.Client(scheduler) as client:
            yield client, 0
        return
    import dask

    processors = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    count = processors if workers is None else workers
    if count < 1:
        raise ValueError(f"workers must be at least 1, not {count}")
    settings = {"distributed.worker.multiprocessing-method": "spawn"}
    with dask.config.set(settings), distributed.LocalCluster(
        n_workers=count, threads_per_worker=1, processes=True, dashboard_address=None
    ) as cluster, distributed.Client(cluster) as client:
        yield client, max(1, processors // count)


def _sent(scene: Scene, threads: int) -> Sent:
    surfaces = tuple(
        (None if part.model is None else part.model.to_bytes(), part.marks.to_bytes())
        for part in scene.parts
        if part.marks is not None
    )
    options = {**scene.options, "up": tuple(scene.info.up)}
    return Sent(uuid4().hex, surfaces, options, scene.style_given, scene.camera, threads)


class _Work:
    """Tasks on a client.  A task whose worker dies is repeated."""

    def __init__(self, client: Any, function: Any, sent: Any, parts: List[Any]) -> None:
        self._client, self._function, self._sent, self._parts = client, function, sent, parts
        self._data = self._scattered()
        self._numbers: Dict[Any, int] = {}  # the number of each open future
        self._tries = [0] * len(parts)

    def _scattered(self) -> Any:
        """Send the data to every worker, once."""
        return self._client.scatter([self._sent], broadcast=True, hash=False)[0]

    def submit(self, number: int) -> Any:
        self._tries[number] += 1
        future = self._client.submit(self._function, self._data, self._parts[number], pure=False)
        self._numbers[future] = number
        return future

    def number_of(self, future: Any) -> int:
        return self._numbers.pop(future)

    def again(self, number: int, error: BaseException) -> Any:
        """Repeat a task whose worker died."""
        if self._tries[number] > RETRIES:
            raise WorkerError(f"workers died {_times(self._tries[number])} while drawing number {number}") from error
        if self._data.status != "finished":  # all workers that had the data are gone
            self._data = self._scattered()
        return self.submit(number)

    def stop(self) -> None:
        """Cancel the tasks that are still open."""
        if self._numbers:
            self._client.cancel(list(self._numbers))
        self._numbers.clear()


def _results(
    client: Any, function: Any, sent: Any, parts: List[Any], report: CallReport
) -> Iterator[Tuple[int, Any]]:
    """The result of `function` for each part, with its number, as it comes."""
    distributed = _distributed()
    lost = (distributed.KilledWorker, distributed.CancelledError)
    work = _Work(client, function, sent, parts)
    try:
        with report.stage("frames", "drawing frames") as stage:
            waiting = distributed.as_completed([work.submit(number) for number in range(len(parts))])
            for future in waiting:
                number = work.number_of(future)
                try:
                    result = future.result()
                except lost as error:
                    waiting.add(work.again(number, error))
                    continue
                del future  # otherwise the worker would keep the result
                if stage.bar is not None:
                    stage.bar.update(1 / len(parts))
                yield number, result
    finally:
        work.stop()


_scenes: "OrderedDict[str, Scene]" = OrderedDict()  # the scenes of this worker
_making = threading.Lock()


def _scene(sent: Sent) -> Scene:
    """The scene of the sent arguments, made once for all frames that this worker draws."""
    with _making:
        found = _scenes.get(sent.name)
        if found is None:
            found = _scenes[sent.name] = _made(sent)
            while len(_scenes) > _KEPT:
                _scenes.popitem(last=False)
        return found


def _made(sent: Sent) -> Scene:
    context = Context(sent.threads)
    sources: List[Any] = []
    for saved, saved_marks in sent.surfaces:
        marks = PointSet.load(saved_marks, context=context)
        sources.append(marks if saved is None else (Model.load(saved, context=context), marks))
    return Scene.create(sources, sent.options, sent.style, context, CallReport(), camera=sent.camera)


def _frame(sent: Sent, camera: Camera) -> Array:
    """Draw a frame, on a worker."""
    return _scene(sent).draw(camera).image()


def _whole(sent: Any, source: Any) -> Tuple[Array, List[str]]:
    """Draw a source, on a worker.  Returns the image and the warnings."""
    style, options, threads = sent
    report = CallReport()
    scene = asked(source, style, options, None, _context(threads), report)
    image = scene.image(scene.draw(report=report), scene.camera)
    return image, [str(text) for text in report.taken()]


_contexts: Dict[int, Context] = {}  # the contexts of this worker


def _context(threads: int) -> Context:
    with _making:
        if threads not in _contexts:
            _contexts[threads] = Context(threads)
        return _contexts[threads]
