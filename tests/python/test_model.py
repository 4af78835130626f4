# SPDX-License-Identifier: MIT
"""Models: fitting, functions, projection, curvature and saving."""
import copy
import gc
import io
import pickle
import weakref

import numpy as np
import pytest
from conftest import fibonacci_sphere, torus

import hrbfnpr


def test_info(ring):
    info = ring.info
    assert (info.kernel, info.polynomial_degree, info.solver) == ("triharmonic", 1, "iterative")
    assert info.samples == info.centres == 192 and info.merged_samples == 0
    assert info.fallback is False
    history = np.asarray(ring.residual_history)
    assert history.shape == (info.iterations,) and (history > 0).all()
    assert history[-1] < 1e-9 < history[0]
    np.testing.assert_allclose(info.bounds_max, (1.4, 1.4, 0.4))
    assert info.value_residual_max < 1e-8 and info.gradient_residual_max < 1e-8
    assert ring.bounds == (info.bounds_min, info.bounds_max)
    assert "192 centres" in repr(ring)


@pytest.mark.parametrize("kernel", ["gaussian", "wendland-c2", "wendland_c2"])
def test_other_kernels_interpolate(kernel):
    points, normals = torus(12, 6)
    model = hrbfnpr.Model.fit(points, normals, kernel=kernel)
    assert model.info.kernel == kernel.replace("-", "_") and model.info.kernel_radius > 0
    assert np.abs(model.evaluate(points).value).max() < 1e-6


GOOD = fibonacci_sphere(20)


@pytest.mark.parametrize(
    "points, normals, options, kind, words",
    [
        (GOOD, GOOD[:19], {}, hrbfnpr.InvalidArgumentError, "normals"),
        (np.empty((0, 3)), np.empty((0, 3)), {}, hrbfnpr.InvalidArgumentError, "points"),
        (np.where(GOOD == GOOD[3], np.nan, GOOD), GOOD, {}, hrbfnpr.InvalidArgumentError, "points.*3"),
        (GOOD, GOOD, {"polynomial_degree": 4}, hrbfnpr.InvalidArgumentError, "polynomial_degree"),
        (GOOD, GOOD, {"outliers": "reorient"}, hrbfnpr.InvalidArgumentError, "outliers"),
        (GOOD, GOOD, {"flipped_normals": "fix"}, ValueError, "flipped_normals.*reorient"),
        (GOOD, GOOD, {"regularization": "some"}, TypeError, ""),
        (GOOD, GOOD, {"kernel": "cubic"}, ValueError, "kernel.*triharmonic"),
        (GOOD, GOOD, {"kernel": 0}, ValueError, "kernel"),
        (GOOD, GOOD, {"solver": "magic"}, ValueError, "solver"),
        (GOOD, GOOD, {"polynomial_degree": 2**40}, OverflowError, ""),
        (GOOD, GOOD, {"progress": 3}, TypeError, "progress"),
    ],
)
def test_bad_samples(points, normals, options, kind, words):
    with pytest.raises(kind, match=words):
        hrbfnpr.Model.fit(points, normals, **options)


def test_errors_are_also_python_errors():
    with pytest.raises(ValueError) as caught:
        hrbfnpr.Model.fit(GOOD, GOOD[:19])
    assert isinstance(caught.value, hrbfnpr.Error)
    assert caught.value.status == -1 and caught.value.status_name == "INVALID_ARGUMENT"
    for kind, parent in {
        hrbfnpr.OutOfMemoryError: MemoryError,
        hrbfnpr.StreamError: OSError,
        hrbfnpr.CorruptDataError: ValueError,
        hrbfnpr.CallbackError: RuntimeError,
        hrbfnpr.SingularSystemError: ArithmeticError,
    }.items():
        error = kind("what it was")
        assert isinstance(error, parent) and str(error) == "what it was"
        assert error.status == kind.default_status


def test_every_status_has_its_exception():
    from hrbfnpr._cffi import ffi
    from hrbfnpr._errors import make_error

    names = "INVALID_ARGUMENT OUT_OF_MEMORY BUFFER_TOO_SMALL UNSUPPORTED_STRUCT SINGULAR_SYSTEM NOT_CONVERGED CANCELLED"
    for name in (names + " CORRUPT_DATA VERSION_MISMATCH CALLBACK INTERNAL").split():
        error = make_error(ffi.integer_const(f"HRBFNPR_STATUS_{name}"))
        assert error.status_name == name
        assert type(error).__name__ == name.title().replace("_", "") + "Error"
    assert type(make_error(ffi.integer_const("HRBFNPR_STATUS_IO"))) is hrbfnpr.StreamError
    assert type(make_error(-12345)) is hrbfnpr.InternalError


# --- functions ---------------------------------------------------------------------------------


def sphere_value(p):
    return np.linalg.norm(p, axis=1) - 1


def sphere_gradient(p):
    return p / np.linalg.norm(p, axis=1)[:, None]


def sphere_hessian(p):
    n = sphere_gradient(p)
    return (np.eye(3) - n[:, :, None] * n[:, None, :]) / np.linalg.norm(p, axis=1)[:, None, None]


BOUNDS = ((-1, -1, -1), (1, 1, 1))
WHERE = fibonacci_sphere(40) * 1.1


@pytest.mark.parametrize("thread_safe", [False, True])
def test_from_function(thread_safe):
    model = hrbfnpr.Model.from_function(
        sphere_value, sphere_gradient, sphere_hessian, bounds=BOUNDS, thread_safe=thread_safe
    )
    result = model.evaluate(WHERE, gradient=True, hessian=True)
    np.testing.assert_allclose(result.value, 0.1)
    np.testing.assert_allclose(result.gradient, WHERE / 1.1)
    np.testing.assert_allclose(result.hessian_matrix(), sphere_hessian(WHERE), atol=1e-12)
    bend = model.curvature(WHERE)
    np.testing.assert_allclose(bend.k1, -1 / 1.1, rtol=1e-6)
    np.testing.assert_allclose(np.einsum("ij,ij->i", bend.d1, bend.d2), 0, atol=1e-9)
    assert model.info.kernel == "custom" and len(model.points) == 0
    assert len(hrbfnpr.PointSet.generate(model, budget=800)) > 400


def test_from_function_takes_six_numbers_and_lists():
    six = lambda p: sphere_hessian(p)[:, [0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2]]
    model = hrbfnpr.Model.from_function(
        lambda p: sphere_value(p).tolist(), lambda p: sphere_gradient(p).astype("f4"), six, bounds=BOUNDS
    )
    result = model.evaluate(WHERE, gradient=True, hessian=True)
    np.testing.assert_allclose(result.gradient, WHERE / 1.1, atol=1e-6)
    np.testing.assert_allclose(result.hessian_matrix(), sphere_hessian(WHERE), atol=1e-12)


class Oops(Exception):
    pass


def failing(p):
    raise Oops("no idea")


@pytest.mark.parametrize("call", ["evaluate", "project", "curvature", "generate", "step_patches"])
def test_an_exception_in_a_function_is_the_cause(call):
    model = hrbfnpr.Model.from_function(failing, bounds=BOUNDS)
    calls = {
        "generate": lambda: hrbfnpr.PointSet.generate(model),
        "step_patches": lambda: hrbfnpr.PointSet.step_patches(model),
    }
    with pytest.raises(hrbfnpr.CallbackError, match="Oops: no idea") as caught:
        calls.get(call, lambda: getattr(model, call)(WHERE))()
    assert isinstance(caught.value.__cause__, Oops)


@pytest.mark.parametrize(
    "value, words",
    [
        (lambda p: 1.0, "must have 40 elements, not 1"),
        (lambda p: np.zeros(len(p) + 1), "must have 40 elements, not 41"),
        (lambda p: None, "numbers"),
        (lambda p: "abc", "numbers"),
    ],
)
def test_a_wrong_result_of_a_function(value, words):
    model = hrbfnpr.Model.from_function(value, bounds=BOUNDS)
    with pytest.raises(hrbfnpr.CallbackError, match=words):
        model.evaluate(WHERE)


def test_keyboard_interrupt_in_a_function_is_kept():
    def interrupted(p):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        hrbfnpr.Model.from_function(interrupted, bounds=BOUNDS).evaluate(WHERE)


def test_a_function_is_released_with_its_model():
    class Function:
        def __call__(self, p):
            return sphere_value(p)

    function = Function()
    gone = weakref.ref(function)
    model = hrbfnpr.Model.from_function(function, bounds=BOUNDS)
    marks = hrbfnpr.PointSet.generate(model, budget=100)
    del function
    gc.collect()
    assert gone() is not None
    model.evaluate(WHERE)
    del model, marks
    gc.collect()
    assert gone() is None


def test_a_function_may_keep_its_points():
    kept = []

    def value(p):
        kept.append(p)
        p[0] = 0  # the array belongs to the function
        return np.ones(len(p))

    hrbfnpr.Model.from_function(value, bounds=BOUNDS).evaluate(WHERE)
    np.testing.assert_array_equal(kept[0][1:], WHERE[1:])


@pytest.mark.parametrize("bounds", [((1, 0, 0), (0, 1, 1)), ((0, 0, np.nan), (1, 1, 1))])
def test_bad_bounds(bounds):
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="bounds"):
        hrbfnpr.Model.from_function(sphere_value, bounds=bounds)
    with pytest.raises(ValueError, match="bounds"):
        hrbfnpr.Model.from_function(sphere_value, bounds=((0, 0), (1, 1)))


# --- operators ---------------------------------------------------------------------------------


def test_project(sphere):
    result = sphere.project(WHERE)
    assert result.converged == 40 and (result.status == hrbfnpr.PROJECTION_STATUS["converged"]).all()
    assert np.abs(sphere.evaluate(result.position).value).max() < 1e-8
    np.testing.assert_allclose(np.linalg.norm(result.normal, axis=1), 1)
    tight = sphere.project(WHERE, evaluation_limit=1, tolerance=1e-15)
    assert tight.converged < 40 and (tight.status == hrbfnpr.PROJECTION_STATUS["not_converged"]).any()
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="armijo_factor"):
        sphere.project(WHERE, armijo_factor=2)


# --- saving ------------------------------------------------------------------------------------


def test_save_and_load(ring, tmp_path):
    where = np.random.default_rng(3).uniform(-1, 1, (100, 3))
    wanted = ring.evaluate(where, gradient=True, hessian=True)
    data = ring.to_bytes()
    ring.save(tmp_path / "ring.hrbf")
    assert (tmp_path / "ring.hrbf").read_bytes() == data
    stream = io.BytesIO()
    ring.save(stream)
    assert stream.getvalue() == data
    stream.seek(0)
    sources = [data, bytearray(data), memoryview(data), tmp_path / "ring.hrbf", str(tmp_path / "ring.hrbf"), stream]
    for source in sources:
        loaded = hrbfnpr.Model.load(source)
        for ours, theirs in zip(loaded.evaluate(where, gradient=True, hessian=True), wanted):
            np.testing.assert_array_equal(ours, theirs)
    assert loaded.info == ring.info
    assert list(tmp_path.iterdir()) == [tmp_path / "ring.hrbf"]


def test_pickle_and_deepcopy(ring):
    for other in (pickle.loads(pickle.dumps(ring)), copy.deepcopy(ring)):
        np.testing.assert_array_equal(other.evaluate(WHERE).value, ring.evaluate(WHERE).value)
    with pytest.raises(hrbfnpr.InvalidArgumentError):
        pickle.dumps(hrbfnpr.Model.from_function(sphere_value, bounds=BOUNDS))


@pytest.mark.parametrize("damage", ["cut", "flip", "foreign", "empty"])
def test_damaged_data(ring, damage):
    data = bytearray(ring.to_bytes())
    if damage == "cut":
        del data[len(data) // 2 :]
    elif damage == "flip":
        data[len(data) // 2] ^= 16
    elif damage == "foreign":
        data = bytearray(b"ply\nformat ascii 1.0\n")
    else:
        data = bytearray()
    with pytest.raises(hrbfnpr.CorruptDataError):
        hrbfnpr.Model.load(data)
    with pytest.raises(hrbfnpr.CorruptDataError):
        hrbfnpr.Model.load(io.BytesIO(data))


def test_a_stream_that_fails(ring, tmp_path):
    class Full(io.RawIOBase):
        def write(self, data):
            raise OSError(28, "No space left on device")

        def readinto(self, data):
            raise OSError(5, "Input/output error")

        def readable(self):
            return True

    with pytest.raises(hrbfnpr.CallbackError, match="No space left") as caught:
        ring.save(Full())
    assert caught.value.__cause__.errno == 28
    with pytest.raises(hrbfnpr.CallbackError, match="Input/output"):
        hrbfnpr.Model.load(Full())
    with pytest.raises(FileNotFoundError):
        hrbfnpr.Model.load(tmp_path / "nothing.hrbf")
    with pytest.raises(FileNotFoundError):
        ring.save(tmp_path / "nowhere" / "ring.hrbf")


def test_a_stream_may_return_small_pieces(ring):
    class Trickle(io.RawIOBase):
        def __init__(self):
            self.data = bytearray()
            self.at = 0

        def write(self, data):
            self.data += data[:1000]
            return min(1000, len(data))

        def read(self, size=-1):
            block = bytes(self.data[self.at : self.at + min(size, 777)])
            self.at += len(block)
            return block

    stream = Trickle()
    ring.save(stream)
    assert bytes(stream.data) == ring.to_bytes()
    assert hrbfnpr.Model.load(stream).to_bytes() == ring.to_bytes()


def test_a_closed_model(ring):
    model = hrbfnpr.Model.load(ring.to_bytes())
    assert not model.closed
    with model as same:
        assert same is model
    assert model.closed and "closed" in repr(model)
    for call in (lambda: model.info, lambda: model.evaluate(WHERE), lambda: model.to_bytes(), lambda: model.points):
        with pytest.raises(ValueError, match="closed"):
            call()
    model.close()
