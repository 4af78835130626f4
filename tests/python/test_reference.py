# SPDX-License-Identifier: MIT
"""Fits agree with an independent dense solve in NumPy, written from the formulas."""
import numpy as np
import pytest
from conftest import torus

import hrbfnpr


def quotient(a, b):
    """a / b, or 0 where b is 0."""
    return np.divide(a, b, out=np.zeros_like(b), where=b > 0)


# Each function returns phi, D phi, D D phi and D D D phi, where D = (1/r) d/dr.


def triharmonic(r, _):
    return r**3, 3 * r, quotient(3.0, r), quotient(-3.0, r**3)


def gaussian(r, sigma):
    phi = np.exp(-(r**2) / (2 * sigma**2))
    return phi, -phi / sigma**2, phi / sigma**4, -phi / sigma**6


def wendland(r, rho):
    t = np.clip(1 - r / rho, 0, None)
    second = quotient(60 * t**2 / rho**3, r)
    third = quotient(-60 * t * (2 * r / rho + t) / rho**3, r**3)
    return t**4 * (4 * r / rho + 1), -20 * t**3 / rho**2, second, third


KERNELS = {"triharmonic": triharmonic, "gaussian": gaussian, "wendland_c2": wendland}


def jets(kernel, radius, d):
    """phi(|d|) and its derivatives up to the third, for vectors d of shape (..., 3)."""
    phi, first, second, third = kernel(np.linalg.norm(d, axis=-1), radius)
    one = np.eye(3)
    gradient = first[..., None] * d
    hessian = first[..., None, None] * one + second[..., None, None] * d[..., :, None] * d[..., None, :]
    mixed = np.einsum("kl,...m->...klm", one, d)
    mixed = mixed + np.einsum("km,...l->...klm", one, d) + np.einsum("lm,...k->...klm", one, d)
    cubic = np.einsum("...k,...l,...m->...klm", d, d, d)
    return phi, gradient, hessian, second[..., None, None, None] * mixed + third[..., None, None, None] * cubic


class Reference:
    """f(x) = sum a_j phi(x - x_j) - b_j . grad phi(x - x_j) + c_0 + c . x, from one dense linear solve."""

    def __init__(self, points, normals, kernel, radius):
        self.centre = points.mean(axis=0)
        self.scale = np.abs(points - self.centre).max()
        self.kernel = KERNELS[kernel]
        self.radius = radius / self.scale
        self.x = (points - self.centre) / self.scale
        n = len(points)
        phi, gradient, hessian, _ = jets(self.kernel, self.radius, self.x[:, None] - self.x[None])
        block = np.zeros((n, 4, n, 4))
        block[:, 0, :, 0] = phi
        block[:, 0, :, 1:] = -gradient
        block[:, 1:, :, 0] = gradient.transpose(0, 2, 1)
        block[:, 1:, :, 1:] = -hessian.transpose(0, 2, 1, 3)
        side = np.zeros((n, 4, 4))
        side[:, 0, 0] = 1
        side[:, 0, 1:] = self.x
        side[:, 1:, 1:] = np.eye(3)
        size = 4 * n
        matrix = np.zeros((size + 4, size + 4))
        matrix[:size, :size] = block.reshape(size, size)
        matrix[:size, size:] = side.reshape(size, 4)
        matrix[size:, :size] = side.reshape(size, 4).T
        right = np.zeros((n, 4))
        right[:, 1:] = normals
        right = np.concatenate([right.reshape(-1), np.zeros(4)])
        solution = np.linalg.solve(matrix, right)
        solution += np.linalg.solve(matrix, right - matrix @ solution)
        self.a, self.b = solution[:size].reshape(n, 4)[:, 0], solution[:size].reshape(n, 4)[:, 1:]
        self.c = solution[size:]

    def __call__(self, points):
        """f and its gradient, in the unit of the points."""
        y = (points - self.centre) / self.scale
        phi, gradient, hessian, _ = jets(self.kernel, self.radius, y[:, None] - self.x[None])
        value = phi @ self.a - np.einsum("ijk,jk->i", gradient, self.b) + self.c[0] + y @ self.c[1:]
        slope = np.einsum("ijk,j->ik", gradient, self.a) - np.einsum("ijkl,jl->ik", hessian, self.b) + self.c[1:]
        return value * self.scale, slope

    def hessian(self, points):
        y = (points - self.centre) / self.scale
        _, _, hessian, change = jets(self.kernel, self.radius, y[:, None] - self.x[None])
        result = np.einsum("ijkl,j->ikl", hessian, self.a) - np.einsum("ijklm,jm->ikl", change, self.b)
        return result / self.scale


@pytest.fixture(params=[("triharmonic", 0.0), ("gaussian", 0.35), ("wendland_c2", 1.2)], ids=lambda p: p[0])
def pair(request):
    """The library's model and the reference, on a large torus far from the origin."""
    kernel, radius = request.param
    unit, offset = 3.7, np.array([40.0, -7.0, 12.0])
    points, normals = torus(16, 6)
    points = points * unit + offset
    model = hrbfnpr.Model.fit(points, normals, kernel=kernel, kernel_radius=radius * unit)
    random = np.random.default_rng(5)
    where = offset + unit * random.uniform(-1.5, 1.5, (300, 3))
    return model, Reference(points, normals, kernel, radius * unit), where, unit


def relative(ours, theirs):
    return np.abs(ours - theirs).max() / np.abs(theirs).max()


def test_value_and_gradient(pair):
    model, reference, where, _ = pair
    ours = model.evaluate(where, gradient=True)
    value, gradient = reference(where)
    assert relative(ours.value, value) < 1e-9
    assert relative(ours.gradient, gradient) < 1e-9


def test_hessian(pair):
    model, reference, where, _ = pair
    ours = model.evaluate(where, hessian=True).hessian_matrix()
    assert relative(ours, reference.hessian(where)) < 1e-9


def test_hessian_is_the_derivative_of_the_gradient(pair):
    model, _, where, unit = pair
    h = 1e-5 * unit
    ours = model.evaluate(where, hessian=True).hessian_matrix()
    steps = np.eye(3) * h
    gradients = [
        (model.evaluate(where + e, gradient=True).gradient - model.evaluate(where - e, gradient=True).gradient) / (2 * h)
        for e in steps
    ]
    assert relative(ours, np.stack(gradients, axis=-1)) < 1e-5


def test_the_samples_are_interpolated(pair):
    model, _, _, unit = pair
    at_samples = model.evaluate(model.points, gradient=True)
    assert np.abs(at_samples.value).max() < 1e-8 * unit
    assert np.abs(at_samples.gradient - model.normals).max() < 1e-8
