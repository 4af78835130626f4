# SPDX-License-Identifier: MIT
"""Progress, cancelling, interrupts and the interpreter lock."""
import _thread
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
from conftest import fibonacci_sphere, torus

import hrbfnpr

MANY = fibonacci_sphere(500)  # a fit that takes long enough to be cancelled


def test_progress_never_falls():
    seen = []
    hrbfnpr.Model.fit(MANY, MANY, solver="direct", progress=seen.append)
    assert seen and seen == sorted(seen) and 0 <= seen[0] and seen[-1] <= 1
    assert len(set(seen)) > 3


@pytest.mark.parametrize(
    "stage",
    ["fit", "evaluate", "project", "curvature", "cast_rays", "lipschitz", "contains", "generate", "step_patches"],
)
def test_an_operation_cancelled_beforehand_stops_every_call(sphere, stage):
    operation = hrbfnpr.Operation()
    operation.cancel()
    operation.cancel()
    assert operation.cancelled
    calls = {
        "fit": lambda: hrbfnpr.Model.fit(MANY, MANY, solver="direct", operation=operation),
        "cast_rays": lambda: sphere.cast_rays(MANY, -MANY, operation=operation),
        "lipschitz": lambda: sphere.lipschitz(operation=operation),
        "generate": lambda: hrbfnpr.PointSet.generate(sphere, operation=operation),
        "step_patches": lambda: hrbfnpr.PointSet.step_patches(sphere, operation=operation),
    }
    with pytest.raises(hrbfnpr.CancelledError):
        calls.get(stage, lambda: getattr(sphere, stage)(MANY, operation=operation))()


def test_cancelled_by_another_thread():
    operation = hrbfnpr.Operation()
    started = threading.Event()

    def cancel():
        while operation.fraction == 0:
            time.sleep(0.001)
        started.set()
        operation.cancel()

    thread = threading.Thread(target=cancel)
    thread.start()
    with pytest.raises(hrbfnpr.CancelledError):
        hrbfnpr.Model.fit(MANY, MANY, solver="direct", operation=operation)
    thread.join()
    assert started.is_set() and operation.fraction < 1


def test_an_operation_can_be_used_for_several_calls_in_turn(sphere):
    seen = []
    operation = hrbfnpr.Operation(seen.append)
    for _ in range(2):
        hrbfnpr.PointSet.generate(sphere, budget=300, operation=operation)
    assert operation.fraction == 1.0 and not operation.cancelled
    falls = sum(b < a for a, b in zip(seen, seen[1:]))
    assert falls == 1


def test_an_operation_refuses_two_calls_at_a_time(sphere):
    caught = []

    def nested(fraction):
        if not caught:
            try:
                sphere.evaluate([0, 0, 0], operation=operation)
            except ValueError as error:
                caught.append(error)

    operation = hrbfnpr.Operation(nested)
    hrbfnpr.Model.fit(MANY[:100], MANY[:100], operation=operation)
    assert "already serves" in str(caught[0])
    with pytest.raises(TypeError, match="not both"):
        sphere.evaluate([0, 0, 0], operation=operation, progress=print)


def test_an_error_in_progress_cancels():
    class Enough(Exception):
        pass

    def enough(fraction):
        raise Enough("that will do")

    operation = hrbfnpr.Operation(enough)
    with pytest.raises(hrbfnpr.CallbackError) as caught:
        hrbfnpr.Model.fit(MANY, MANY, solver="direct", operation=operation)
    assert isinstance(caught.value.__cause__, Enough) and operation.cancelled

    def cancel(fraction):
        raise hrbfnpr.CancelledError("by me")

    with pytest.raises(hrbfnpr.CancelledError, match="by me"):
        hrbfnpr.Model.fit(MANY, MANY, solver="direct", progress=cancel)


def test_the_result_of_progress_is_ignored():
    hrbfnpr.Model.fit(MANY[:50], MANY[:50], progress=lambda fraction: True)


@pytest.mark.parametrize("total", [1.0, 200, None])
def test_a_tqdm_bar_is_filled(total):
    tqdm = pytest.importorskip("tqdm").tqdm
    with open(os.devnull, "w") as nowhere, tqdm(total=total, file=nowhere) as bar:
        hrbfnpr.Model.fit(MANY[:200], MANY[:200], progress=bar)
        assert bar.n == pytest.approx(total or 1.0)


def test_other_threads_run_during_a_call():
    ticks = []
    done = threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(0)
            time.sleep(0.002)

    thread = threading.Thread(target=tick)
    thread.start()
    hrbfnpr.Model.fit(MANY, MANY, solver="direct", context=hrbfnpr.Context(1), operation=None)
    done.set()
    thread.join()
    assert len(ticks) > 5


def test_ctrl_c_cancels_a_long_call():
    # Without a progress callback, the library's own reports notice the interrupt.
    timer = threading.Timer(0.05, _thread.interrupt_main)
    many = fibonacci_sphere(1500)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        hrbfnpr.Model.fit(many, many, solver="direct")
        time.sleep(10)  # in case the fit ends before the timer
    timer.join()


CTRL_C = """
import os, signal, threading, numpy as np, hrbfnpr
points = np.random.default_rng(1).normal(size=(3000, 3))
points /= np.linalg.norm(points, axis=1)[:, None]
threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    hrbfnpr.Model.fit(points, points, solver="direct")
except KeyboardInterrupt:
    hrbfnpr.Model.fit(points[:10], points[:10])  # all is well
    print("interrupted")
"""


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_ctrl_c_interrupts_a_process():
    result = subprocess.run([sys.executable, "-c", CTRL_C], capture_output=True, text=True, timeout=120)
    assert result.stdout == "interrupted\n" and result.stderr == ""


@pytest.mark.parametrize("level, wanted", [("debug", {"info", "warning"}), ("warning", {"warning"})])
def test_log_level(level, wanted):
    points = np.random.default_rng(3).normal(size=(60, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    heard = set()
    context = hrbfnpr.Context(1, log=lambda level, message: heard.add(level), log_level=level)
    hrbfnpr.Model.fit(points, 2 * points, context=context)
    assert heard == wanted


def test_log_and_run_tasks(ring):
    from concurrent.futures import ThreadPoolExecutor

    where = np.random.default_rng(3).uniform(-1, 1, (5000, 3))
    runs = []
    with ThreadPoolExecutor(3) as pool:

        def run_tasks(task, count):
            runs.append(count)
            list(pool.map(task, range(count)))

        context = hrbfnpr.Context(run_tasks=run_tasks, log=lambda level, message: None)
        model = hrbfnpr.Model.fit(*torus(), context=context)
        np.testing.assert_array_equal(model.evaluate(where).value, ring.evaluate(where).value)
    assert runs


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
def test_tasks_left_by_a_failed_runner_are_done(ring):
    failures = []

    def run_tasks(task, count):
        failures.append(count)
        task(0)
        raise RuntimeError("the pool is closed")

    context = hrbfnpr.Context(run_tasks=run_tasks)
    where = np.random.default_rng(3).uniform(-1, 1, (5000, 3))
    model = hrbfnpr.Model.load(ring.to_bytes(), context=context)
    np.testing.assert_array_equal(model.evaluate(where).value, ring.evaluate(where).value)
    assert failures


def test_contexts():
    assert hrbfnpr.default_context() is hrbfnpr.default_context()
    mine = hrbfnpr.Context(1, instruction_set="baseline")
    assert (mine.info.thread_count, mine.info.instruction_set) == (1, "baseline")
    before = hrbfnpr.default_context()
    hrbfnpr.set_default_context(mine)
    assert hrbfnpr.default_context() is mine
    hrbfnpr.set_default_context(before)
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="thread_count"):
        hrbfnpr.Context(-1)
    with pytest.raises(ValueError, match="instruction_set"):
        hrbfnpr.Context(instruction_set="mmx")
    info = hrbfnpr.build_info()
    assert info["version"] == hrbfnpr.__version__ and os.path.basename(info["library"]).startswith("libhrbfnpr")


def test_children_outlive_their_context():
    context = hrbfnpr.Context(1, log=lambda level, message: None)
    model = hrbfnpr.Model.fit(MANY[:30], MANY[:30], context=context)
    context.close()
    del context
    assert abs(model.evaluate(MANY[0]).value) < 1e-8
