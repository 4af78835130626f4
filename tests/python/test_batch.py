# SPDX-License-Identifier: MIT
"""Turntables and batches on Dask: two workers, one of which is killed."""
import os
import re
import signal
import subprocess
import sys
import time
import warnings

import numpy as np
import pytest
from conftest import ROOT, torus
from test_cli import rows
from test_shapes import write

import hrbfnpr
from hrbfnpr import batch

Image = pytest.importorskip("PIL.Image")

POINTS, NORMALS = torus(14, 6)
QUICK = {"size": 90, "marks": 800, "up": "z"}


@pytest.fixture(scope="module")
def client():
    distributed = pytest.importorskip("distributed", reason="dask.distributed is not installed (Debian: python3-distributed)")
    import dask

    settings = {"distributed.worker.multiprocessing-method": "spawn", "distributed.scheduler.allowed-failures": 0}
    with dask.config.set(settings), distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None
    ) as cluster, distributed.Client(cluster) as client:
        yield client


@pytest.fixture(scope="module")
def here():
    return list(hrbfnpr.animate((POINTS, NORMALS), frames=8, **QUICK).images())


def test_frames_match_a_single_process(client, here):
    found = dict(batch.frames_of((POINTS, NORMALS), frames=8, scheduler=client, **QUICK))
    assert sorted(found) == list(range(8))
    assert all(np.array_equal(found[i], here[i]) for i in range(8))
    assert client.status == "running"


def slow(folder):
    """Slows a worker down: each frame writes a file when it starts, and takes half a second more."""
    made = batch._scene

    def scene(sent):
        with open(os.path.join(folder, f"{os.getpid()}-{time.time_ns()}"), "w"):
            pass
        time.sleep(0.5)
        return made(sent)

    batch._scene = scene
    return os.getpid()


def restore():
    import importlib

    importlib.reload(batch)


def begun(folder, pid):
    return sum(name.startswith(f"{pid}-") for name in os.listdir(folder))


def test_a_worker_that_is_killed_loses_nothing(client, here, tmp_path):
    client.wait_for_workers(2)
    pids = list(client.run(slow, str(tmp_path)).values())
    assert len(set(pids)) == 2 and os.getpid() not in pids
    results, killed = {}, None
    for number, image in batch.frames_of((POINTS, NORMALS), frames=8, scheduler=client, **QUICK):
        assert number not in results
        results[number] = image
        if killed is None and begun(tmp_path, pids[0]):
            killed = pids[0]  # in the middle of a frame, with others waiting
            os.kill(killed, signal.SIGKILL)
    assert killed is not None
    assert begun(tmp_path, pids[0]) + begun(tmp_path, pids[1]) >= 3
    assert sorted(results) == list(range(8))
    assert all(np.array_equal(results[i], here[i]) for i in range(8))
    client.wait_for_workers(2)
    client.run(restore)


def die():
    """Makes a worker exit at its next frame."""
    batch._scene = lambda sent: os._exit(1)


@pytest.mark.parametrize("retries", [0, 3])
def test_dying_workers_are_retried(client, here, monkeypatch, retries):
    monkeypatch.setattr(batch, "RETRIES", retries)
    client.wait_for_workers(2)
    client.run(die)  # workers that start later are not affected
    drawn = batch.frames_of((POINTS, NORMALS), frames=8, scheduler=client, **QUICK)
    if retries == 0:
        with pytest.raises(batch.WorkerError, match="workers died 1 time while drawing number"):
            dict(drawn)
    else:
        found = dict(drawn)
        assert all(np.array_equal(found[i], here[i]) for i in range(8))
    client.wait_for_workers(2)
    client.run(restore)


def test_a_turntable_is_written_in_order(client, tmp_path):
    told = []
    options = {"frames": 5, "scheduler": client, **QUICK}
    batch.turntable((POINTS, NORMALS), tmp_path / "a.gif", progress=lambda stage, part: told.append((stage, part)), **options)
    hrbfnpr.animate((POINTS, NORMALS), tmp_path / "b.gif", frames=5, **QUICK)
    assert (tmp_path / "a.gif").read_bytes() == (tmp_path / "b.gif").read_bytes()
    assert told[-1] == ("drawing frames", pytest.approx(1))


def test_given_marks_and_a_given_style(client):
    style = hrbfnpr.Style("stipple", stipples={"radius": 2.0})
    marks = hrbfnpr.draw((POINTS, NORMALS), keep_marks=True, **QUICK).marks
    found = dict(batch.frames_of(marks, style, frames=2, size=90, scheduler=client))
    wanted = hrbfnpr.animate(marks, style=style, frames=2, size=90)
    assert all(np.array_equal(found[i], wanted[i].image) for i in range(2))


def test_many_sources(client, tmp_path):
    paths = []
    for number in range(4):
        points = POINTS * (1, 1, 1 + 0.2 * number)
        paths.append(write(tmp_path, f"{number}.xyz", rows(np.hstack([points, NORMALS]))))
    found = dict(batch.draw(paths, "stipple", scheduler=client, **QUICK))
    for number, path in enumerate(paths):
        assert np.array_equal(found[number], hrbfnpr.draw(path, "stipple", **QUICK).image)
    with pytest.warns(hrbfnpr.DrawingWarning, match="number 1: there are only 6 points") as told:
        dict(batch.draw([paths[0], hrbfnpr.datasets.sphere(6)], scheduler=client, **QUICK))
    assert told[0].filename == __file__
    with pytest.raises(FileNotFoundError):
        dict(batch.draw([paths[0], tmp_path / "missing.xyz"], scheduler=client, **QUICK))
    with pytest.raises(TypeError, match="no option 'azimut'"):
        dict(batch.draw(paths, scheduler=client, azimut=3))


def test_stopping_early_leaves_nothing_running(client, tmp_path):
    drawn = batch.frames_of((POINTS, NORMALS), frames=8, scheduler=client, **QUICK)
    next(drawn)
    drawn.close()
    for _ in range(100):
        if not client.processing() or not any(client.processing().values()):
            break
        time.sleep(0.1)
    assert not any(client.processing().values()) and client.status == "running"


def test_a_local_cluster_and_an_address(here):
    distributed = pytest.importorskip("distributed", reason="dask.distributed is not installed (Debian: python3-distributed)")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = dict(batch.frames_of((POINTS, NORMALS), frames=3, turn=90, workers=1, **QUICK))
    assert sorted(found) == [0, 1, 2] and found[0].shape[2] == 4
    with distributed.LocalCluster(n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None) as cluster:
        again = dict(batch.frames_of((POINTS, NORMALS), frames=3, turn=90, scheduler=cluster.scheduler_address, **QUICK))
    assert all(np.array_equal(found[i], again[i]) for i in range(3))
    with pytest.raises(ValueError, match="workers must be at least 1"):
        dict(batch.frames_of((POINTS, NORMALS), frames=1, workers=0, **QUICK))


def test_a_missing_dask_is_named(monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(ImportError, match=r"needs dask.distributed \(Debian: python3-distributed\)"):
        batch.turntable((POINTS, NORMALS), tmp_path / "a.gif", frames=2)
    with pytest.raises(ImportError, match="python3-distributed"):
        next(batch.draw([(POINTS, NORMALS)]))
    with pytest.raises(ValueError, match="a.avi: an animation ends in"):
        batch.turntable((POINTS, NORMALS), "a.avi")
    with pytest.raises(ValueError, match="frames must be at least 1"):
        next(batch.frames_of((POINTS, NORMALS), frames=0))


def test_the_example_of_the_documentation_runs(tmp_path):
    pytest.importorskip("distributed", reason="dask.distributed is not installed (Debian: python3-distributed)")
    text = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    (block,) = [one for one in re.findall(r"^```py\n(.*?)^```$", text, re.DOTALL | re.MULTILINE) if "hrbfnpr.batch" in one]
    (tmp_path / "script.py").write_text(block)
    run = subprocess.run([sys.executable, "script.py"], cwd=tmp_path, capture_output=True, text=True, timeout=300)
    assert run.returncode == 0, run.stderr
    lines = run.stdout.splitlines()
    assert sorted(line[0] for line in lines) == sorted("01234501") and Image.open(tmp_path / "ring.gif").n_frames == 6
