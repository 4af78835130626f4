# SPDX-License-Identifier: MIT
"""The context: threads, instruction set and log."""
from __future__ import annotations

import json
import threading
from typing import TYPE_CHECKING, Any, Callable, Optional

from . import _records
from ._callbacks import CallbackState, plain_callback
from ._errors import check, new_error, new_struct
from ._handles import Owner, own
from ._library import ffi, lib, library_path
from ._names import INSTRUCTION_SETS, LOG_LEVELS, THREAD_BACKENDS, name_of, number_of
from ._records import get

if TYPE_CHECKING:
    from ._records import ContextInfo

RunTasks = Callable[[Callable[[int], None], int], Any]


@plain_callback("void(void *, int32_t, const char *)")
def _on_log(user: Any, level: int, message: Any) -> None:
    ffi.from_handle(user).function(name_of(LOG_LEVELS, level), ffi.string(message).decode("utf-8", "replace"))


@plain_callback("void(void *, hrbfnpr_task_fn, void *, int64_t)")
def _on_run_tasks(user: Any, task: Any, task_context: Any, count: int) -> None:
    started = bytearray(count)

    def run(index: int) -> None:
        started[index] = 1
        task(task_context, index)

    try:
        ffi.from_handle(user).function(run, count)
    finally:
        # The library cannot go on without these tasks, so this thread runs those that a failed runner left.
        for index in range(count):
            if not started[index]:
                run(index)


class Context(Owner):
    """The threads, the instruction set and the log of everything that is made with it.

    Most programs need no context: calls without one share a default (`default_context`).  Several threads may use one
    context at the same time.

    Parameters
    ----------
    thread_count : int, optional
        Number of threads; 0 = all processors (default), 1 = only the calling thread; at most 256 are used.  Results have
        the same bits for every number.
    thread_backend : str, optional
        What runs the library's tasks: ``"auto"`` (default: `run_tasks` if it is given, else the pool), ``"pool"`` (threads
        of the context, which a busy processor hardly slows down), ``"openmp"`` (threads of the OpenMP runtime),
        ``"run_tasks"`` or ``"serial"`` (the calling thread).
    instruction_set : str, optional
        The highest instruction set to use: ``"auto"`` (default), ``"baseline"``, ``"avx2"``, ``"avx512"`` or ``"neon"``.
    log : callable, optional
        Called as ``log(level, message)``; the level is ``"debug"``, ``"info"`` or ``"warning"``.
    log_level : str, optional
        The lowest level that is reported: ``"debug"`` (default), ``"info"`` or ``"warning"``.
    run_tasks : callable, optional
        Runs the library's tasks instead of the context's own threads.  It is called as ``run_tasks(task, count)``.  It
        must call ``task(i)`` once for each i in ``range(count)``, on any threads, and return when all have ended.  The
        tasks release the interpreter lock.

    Raises
    ------
    InvalidArgumentError
        If the thread count is negative, `thread_backend` contradicts `run_tasks`, or the library has no ``"openmp"``.

    Examples
    --------
    >>> with ThreadPoolExecutor() as pool:
    ...     context = hrbfnpr.Context(run_tasks=lambda task, count: list(pool.map(task, range(count))))
    """

    def __init__(
        self,
        thread_count: int = 0,
        *,
        thread_backend: str = "auto",
        instruction_set: str = "auto",
        log: Optional[Callable[[str, str], Any]] = None,
        log_level: str = "debug",
        run_tasks: Optional[RunTasks] = None,
    ) -> None:
        desc = new_struct("hrbfnpr_context_desc")
        desc.thread_count = thread_count
        desc.thread_backend = number_of("thread_backend", THREAD_BACKENDS, thread_backend)
        desc.highest_instruction_set = number_of("instruction_set", INSTRUCTION_SETS, instruction_set)
        desc.log_level = number_of("log_level", LOG_LEVELS, log_level)
        keep = []
        if log is not None:
            keep.append(CallbackState(log).new_handle())
            desc.log, desc.log_user = _on_log, keep[-1]
        if run_tasks is not None:
            keep.append(CallbackState(run_tasks).new_handle())
            desc.run_tasks, desc.run_tasks_user = _on_run_tasks, keep[-1]
        out, error = ffi.new("hrbfnpr_context **"), new_error()
        check(lib.hrbfnpr_context_create(desc, out, error), error)
        super().__init__(own(out[0], lib.hrbfnpr_context_release, *keep))

    @property
    def info(self) -> ContextInfo:
        """The threads, the backend and the instruction set in use, and the memory now and at its peak."""
        return get(_records.ContextInfo, lib.hrbfnpr_context_get_info, self._handle)

    def __repr__(self) -> str:
        return "<hrbfnpr.Context closed>" if self.closed else f"<hrbfnpr.Context {self.info}>"


_default: Optional[Context] = None
_default_lock = threading.Lock()


def default_context() -> Context:
    """Return the context of calls that are given none.  It uses all processors, and is made on first use."""
    global _default
    with _default_lock:
        if _default is None or _default.closed:
            _default = Context()
        return _default


def set_default_context(context: Optional[Context]) -> None:
    """Make `context` the default.  None: the next use makes a new one."""
    global _default
    with _default_lock:
        _default = context


def resolve(context: Optional[Context]) -> Context:
    return default_context() if context is None else context


def build_info() -> "dict[str, Any]":
    """Return facts about the loaded library: version, compiler, instruction sets, thread backends, dependencies and path."""
    needed = ffi.new("int64_t *")
    lib.hrbfnpr_build_info(ffi.NULL, 0, needed)
    text = ffi.new("char[]", needed[0])
    check(lib.hrbfnpr_build_info(text, needed[0], ffi.NULL))
    info: "dict[str, Any]" = json.loads(ffi.string(text).decode())
    info["library"] = library_path
    return info
