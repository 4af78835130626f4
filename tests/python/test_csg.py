# SPDX-License-Identifier: MIT
"""Constructive solid geometry: solids made from other solids."""
import math
import pickle

import pytest

import hrbfnpr
from hrbfnpr import csg

POINTS = [[0.7 * math.sin(1.3 * i), 0.9 * math.cos(2.1 * i + 1), 1.1 * math.sin(0.7 * i + 2)] for i in range(200)]


def values(model):
    return [float(v) for v in model.evaluate(POINTS).value]


def ball(p, center, radius):
    return math.dist(p, center) - radius


def check(model, expected, tolerance=1e-13):
    for value, point in zip(values(model), POINTS):
        assert abs(value - expected(point)) < tolerance, point


def test_operators_are_minima_and_maxima():
    a, b = csg.sphere(0.8), csg.sphere(0.6, (0.5, 0, 0.2))
    left, right = (lambda p: ball(p, (0, 0, 0), 0.8)), (lambda p: ball(p, (0.5, 0, 0.2), 0.6))
    check(a | b, lambda p: min(left(p), right(p)))
    check(a & b, lambda p: max(left(p), right(p)))
    check(a - b, lambda p: max(left(p), -right(p)))
    check(~a, lambda p: -left(p))
    check(a.offset(0.1), lambda p: left(p) - 0.1)
    check(a.shell(0.1), lambda p: max(left(p), -left(p) - 0.1))
    check(a.union(b, csg.sphere(0.3, (0, 1, 0))), lambda p: min(left(p), right(p), ball(p, (0, 1, 0), 0.3)))

    def blended(p):
        x, y = left(p), right(p)
        return min(x, y) - 0.5 / 6 * max(0, 1 - abs(x - y) / 0.5) ** 3

    check(a.blend(b, 0.5), blended)
    assert values(a.blend(b, 0.5, 2.0)) != values(a.blend(b, 0.5))
    assert values((~a).intersection(~b, radius=0.5)) == [-v for v in values(a.blend(b, 0.5))]
    assert repr(a | b) == "<hrbfnpr.Model csg, 3 nodes>"


def test_primitives_lie_at_their_given_places():
    check(csg.box((1, 2, 3), (0.1, 0.2, 0.3)),
          lambda p: max(abs(p[0] - 0.1) - 0.5, abs(p[1] - 0.2) - 1, abs(p[2] - 0.3) - 1.5))  # fmt: skip
    check(csg.cylinder(0.4, 1, (0, 0.1, 0), (-3, 0, 0)),
          lambda p: max(math.hypot(p[1] - 0.1, p[2]) - 0.4, abs(p[0]) - 0.5))  # fmt: skip
    check(csg.torus(0.6, 0.2, axis=(0, 1, 0)), lambda p: math.hypot(math.hypot(p[0], p[2]) - 0.6, p[1]) - 0.2)
    # The axis points to the cone's apex.
    cone = csg.cone(0.5, 2, axis=(0.2, -0.3, -1))
    top = [c / math.sqrt(1.13) for c in (0.2, -0.3, -1)]
    assert cone.contains([0.97 * c for c in top]) and not cone.contains([1.03 * c for c in top])
    assert abs(cone.evaluate(top).value) < 1e-15
    for normal in ((0.3, 0.4, 0.5), (0.3, 0.4, -0.5), (0, 0, -2)):
        length = math.sqrt(sum(c * c for c in normal))
        check(csg.half_space((0.1, 0, 0), normal),
              lambda p: sum(n * (x - o) for n, x, o in zip(normal, p, (0.1, 0, 0))) / length)  # fmt: skip


def test_transforms_keep_distances_and_orientation():
    part = csg.box((1, 0.5, 0.25)) - csg.cylinder(0.1, 1, (0.2, 0, 0))
    moved = part.rotated(90).translated(0, 0, 1).scaled(2)
    inverse = [[p[1] / 2, -p[0] / 2, p[2] / 2 - 1] for p in POINTS]
    for value, expected in zip(values(moved), part.evaluate(inverse).value):
        assert abs(value - 2 * expected) < 1e-13
    same = part.transformed([[0, -2, 0, 0], [2, 0, 0, 0], [0, 0, 2, 2]])
    for value, expected in zip(values(moved), values(same)):
        assert abs(value - expected) < 1e-13
    assert max(abs(a - b) for a, b in zip(moved.bounds[1], (0.5, 1, 2.25))) < 1e-13


def test_factors_of_scaled_are_one_or_three():
    ball = csg.sphere(1)
    egg = ball.scaled((1, 1, 2))
    assert egg.contains((0, 0, 1.9)) and not egg.contains((1.1, 0, 0)) and not egg.contains((0, 0, 2.1))
    assert values(ball.scaled(3)) == values(ball.scaled([3, 3, 3]))
    for factor in ((1, 2), "2", None, (1, 2, 3, 4)):
        with pytest.raises((TypeError, ValueError), match="factor"):
            ball.scaled(factor)
    for factor in (0, (1, 0, 1), math.nan, (1, math.inf, 1)):
        with pytest.raises(hrbfnpr.Error, match="transform"):
            ball.scaled(factor)


def test_solids_keep_their_operands_alive():
    fitted = hrbfnpr.Model.fit([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)],
                               [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)])  # fmt: skip
    part = fitted - csg.half_space()
    assert part.contains((0, 0, 0.5)) and not part.contains((0, 0, -0.5))
    assert part.csg_info.models == 1 and part.info.kernel == "csg" and fitted.csg_info.nodes == 0
    with hrbfnpr.Model.from_function(lambda p: [math.dist(x, (0, 0, 0)) - 1 for x in p.tolist()],
                                     bounds=((-1, -1, -1), (1, 1, 1))) as function:  # fmt: skip
        both = function.translated(3, 0, 0) | part
    assert both.contains((3, 0, 0)) and both.contains((0, 0, 0.5))
    marks = both.generate(budget=500)
    assert len(marks.layers[0].positions) > 100


def test_solids_can_be_pickled(tmp_path):
    part = (csg.box((1, 2, 3)) - csg.cone(0.4, 4, top_radius=0.2)).shell(0.1)
    again = pickle.loads(pickle.dumps(part))
    assert values(again) == values(part) and again.csg_info == part.csg_info and again.bounds == part.bounds
    part.save(tmp_path / "part.hrbf")
    assert hrbfnpr.Model.load(tmp_path / "part.hrbf").to_bytes() == part.to_bytes()


def test_an_exception_in_either_function_is_the_cause():
    def failing(name):
        def value(points):
            raise KeyError(name)

        return hrbfnpr.Model.from_function(value, bounds=((-1, -1, -1), (1, 1, 1)))

    both = failing("first") | failing("second")
    with pytest.raises(hrbfnpr.CallbackError, match="KeyError") as caught:
        both.evaluate((0, 0, 0))
    assert isinstance(caught.value.__cause__, KeyError)
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="custom"):
        both.to_bytes()


def test_invalid_solids_are_refused():
    a = csg.sphere(1)
    with pytest.raises(TypeError):
        a | 3
    with pytest.raises(TypeError, match="not with int"):
        a.union(3)
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="unbounded along"):
        a | csg.half_space()
    assert a.union(csg.half_space(), bounds=((-2, -2, -2), (2, 2, 2))).contains((1.5, 0, -1))
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="the solid is empty"):
        a & csg.sphere(1, (3, 0, 0))
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="radius is -1"):
        csg.sphere(-1)
    with pytest.raises(ValueError, match="axis must have a length"):
        csg.cylinder(1, 1, axis=(0, 0, 0))
    with pytest.raises(ValueError, match="3 or 4 rows"):
        a.transformed([[1, 0, 0, 0]])


def test_many_operators_make_one_tree():
    row = csg.sphere(0.3)
    for i in range(1, 200):
        row = row | csg.sphere(0.3, (0.5 * i, 0, 0))
    assert row.csg_info.nodes == 200 + 199 and row.csg_info.depth == 200 and row.csg_info.models == 0
    assert row.contains((99.5, 0, 0))
