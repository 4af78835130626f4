# SPDX-License-Identifier: MIT
"""Cameras: where a picture is seen from."""
from __future__ import annotations

import math
from typing import Any, Optional, Sequence, Tuple

from ._arrays import Array, block_in, matrix_in, matrix_out, vector
from ._errors import check, new_error, new_struct
from ._library import ffi, lib
from ._names import DEPTH_CONVENTIONS, name_of, number_of


def _vector(argument: str, value: Sequence[float]) -> Any:
    return ffi.new("double[3]", vector(argument, value))


def corners(bounds: Any) -> Tuple[Sequence[float], Sequence[float]]:
    """Two corners of a box: `bounds` itself, or its attribute `bounds`."""
    low, high = getattr(bounds, "bounds", bounds)
    return vector("bounds", low), vector("bounds", high)


class Camera:
    """A camera: two matrices, a viewport and a depth convention.

    A camera never changes: its methods return new cameras.  Coordinate systems are right-handed, the eye looks along -z,
    and pixels count from the top-left corner.

    Parameters
    ----------
    view : array of float, shape (4, 4), optional
        The matrix from world to eye, which acts on column vectors; invertible; the identity by default.
    projection : array of float, shape (4, 4), optional
        The matrix from eye to clip coordinates; invertible; the identity by default.
    viewport : (x, y, width, height), optional
        The top-left corner and the size of the picture, in pixels.  The default size is 0, with which nothing can be drawn.
    depth_convention : str
        Range of clip-space depth from the near to the far plane: ``"negative_one_to_one"`` (OpenGL), ``"zero_to_one"``
        (Direct3D, Vulkan, Metal) or ``"reversed"`` (1 to 0).

    Examples
    --------
    >>> camera = hrbfnpr.Camera.fit(model, direction=(-1, -0.5, -1), size=(1600, 1200), vertical_angle=0.5)
    >>> camera = hrbfnpr.Camera.look_at((3, 2, 4), (0, 0, 0)).perspective(0.5, (1600, 1200), 0.1, 100)
    """

    def __init__(
        self,
        view: Optional[Array] = None,
        projection: Optional[Array] = None,
        viewport: Optional[Sequence[float]] = None,
        depth_convention: str = "negative_one_to_one",
    ) -> None:
        self._struct = new_struct("hrbfnpr_camera")
        self._struct.depth_convention = number_of("depth_convention", DEPTH_CONVENTIONS, depth_convention)
        if view is not None:
            self._struct.view = matrix_in("view", view)
        if projection is not None:
            self._struct.projection = matrix_in("projection", projection)
        if viewport is not None:
            self._struct.viewport = vector("viewport", viewport, 4)

    def _copy(self) -> Camera:
        copy = Camera()
        copy._struct[0] = self._struct[0]
        return copy

    @classmethod
    def look_at(
        cls,
        eye: Sequence[float],
        target: Sequence[float],
        up: Sequence[float] = (0.0, 1.0, 0.0),
        *,
        depth_convention: str = "negative_one_to_one",
    ) -> Camera:
        """Make a camera that looks from an eye towards a target.

        The result has no lens yet: call its `perspective` or `orthographic`.

        Parameters
        ----------
        eye, target : sequence of float
            Places in the world; they must differ.
        up : sequence of float
            The direction that is roughly upward in the picture; not parallel to the view.
        depth_convention : str
            As in `Camera`.

        Raises
        ------
        InvalidArgumentError
            If eye and target are the same, or `up` is 0 or parallel to the view.
        """
        camera = cls(depth_convention=depth_convention)
        vectors = _vector("eye", eye), _vector("target", target), _vector("up", up)
        error = new_error()
        check(lib.hrbfnpr_camera_look_at(camera._struct, *vectors, error), error)
        return camera

    def perspective(self, vertical_angle: float, size: Tuple[float, float], near: float, far: float) -> Camera:
        """Return a copy of this camera with a perspective projection.

        Parameters
        ----------
        vertical_angle : float
            Vertical angle of view in radians, above 0 and below pi.  A larger angle shows more, and smaller.
        size : (width, height)
            Size of the viewport in pixels.
        near, far : float
            Distances of the near and the far plane from the eye, 0 < near < far.
        """
        camera, error = self._copy(), new_error()
        check(lib.hrbfnpr_camera_perspective(camera._struct, vertical_angle, *size, near, far, error), error)
        return camera

    def orthographic(self, view_height: float, size: Tuple[float, float], near: float, far: float) -> Camera:
        """Return a copy of this camera with a parallel projection.

        Parameters
        ----------
        view_height : float
            Height of the visible part of the world, in world units, above 0.
        size : (width, height)
            Size of the viewport in pixels.
        near, far : float
            Distances of the near and the far plane from the eye, near < far; either may be negative.
        """
        camera, error = self._copy(), new_error()
        check(lib.hrbfnpr_camera_orthographic(camera._struct, view_height, *size, near, far, error), error)
        return camera

    @classmethod
    def fit(
        cls,
        bounds: Any,
        direction: Sequence[float] = (-0.5, -0.35, -0.8),
        up: Sequence[float] = (0.0, 1.0, 0.0),
        *,
        size: Tuple[float, float] = (800, 800),
        vertical_angle: float = 0.0,
        margin: float = 0.05,
        depth_convention: str = "negative_one_to_one",
    ) -> Camera:
        """Make a camera in which a box fills the picture.

        Parameters
        ----------
        bounds : Model, PointSet, or (minimum, maximum)
            The box: two corners, or any object with `bounds`.
        direction : sequence of float
            The direction from the eye into the scene.
        up : sequence of float
            The direction that is roughly upward in the picture; not parallel to `direction`.
        size : (width, height)
            Size of the picture in pixels.
        vertical_angle : float
            Vertical angle of view in radians, 0 or more and below pi; 0 = orthographic.
        margin : float
            Share of the picture that stays free on each side, 0 to 0.45.
        depth_convention : str
            As in `Camera`.
        """
        camera = cls(depth_convention=depth_convention)
        low, high = corners(bounds)
        vectors = [_vector("bounds", low), _vector("bounds", high)]
        vectors += [_vector("direction", direction), _vector("up", up)]
        error = new_error()
        status = lib.hrbfnpr_camera_fit_bounds(camera._struct, *vectors, vertical_angle, *size, margin, error)
        check(status, error)
        return camera

    @classmethod
    def fit_points(
        cls,
        points: Any,
        direction: Sequence[float] = (-0.5, -0.35, -0.8),
        up: Sequence[float] = (0.0, 1.0, 0.0),
        *,
        origin: Sequence[float] = (0.0, 0.0, 0.0),
        size: Tuple[float, float] = (800, 800),
        vertical_angle: float = 0.0,
        margin: float = 0.05,
        depth_convention: str = "negative_one_to_one",
    ) -> Camera:
        """Make a camera in which points fill the picture.

        The points themselves fill the picture, not the corners of their box.  Other parameters are those of `fit`.

        Parameters
        ----------
        points : array of float, shape (n, 3)
            The points, such as the positions of a layer of marks.
        origin : sequence of float
            This is added to each point.  For marks, give `PointSet.origin`.
        """
        camera, block = cls(depth_convention=depth_convention), block_in("points", points)
        vectors = [_vector("origin", origin), _vector("direction", direction), _vector("up", up)]
        error = new_error()
        status = lib.hrbfnpr_camera_fit_points(
            camera._struct, block.view(), *vectors, vertical_angle, *size, margin, error
        )
        check(status, error)
        return camera

    @property
    def view(self) -> Array:
        """The matrix from world to eye, float64 (4, 4); a copy."""
        return matrix_out(self._struct.view)

    @property
    def projection(self) -> Array:
        """The matrix from eye to clip coordinates, float64 (4, 4); a copy."""
        return matrix_out(self._struct.projection)

    @property
    def viewport(self) -> Tuple[float, float, float, float]:
        """x and y of the top-left corner, width and height, in pixels."""
        x, y, width, height = self._struct.viewport
        return x, y, width, height

    @property
    def size(self) -> Tuple[int, int]:
        """Width and height of an image that holds the viewport, in pixels."""
        x, y, width, height = self.viewport
        return math.ceil(x + width), math.ceil(y + height)

    @property
    def depth_convention(self) -> str:
        """Range of clip-space depth from the near to the far plane, by name."""
        return name_of(DEPTH_CONVENTIONS, self._struct.depth_convention)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Camera):
            return NotImplemented
        return bytes(ffi.buffer(self._struct)) == bytes(ffi.buffer(other._struct))

    def __hash__(self) -> int:
        return hash(bytes(ffi.buffer(self._struct)))

    def __reduce__(self) -> Any:
        view, projection = self._struct.view, self._struct.projection
        rows = [[[m[4 * column + row] for column in range(4)] for row in range(4)] for m in (view, projection)]
        return Camera, (*rows, self.viewport, self.depth_convention)

    def __repr__(self) -> str:
        return f"<hrbfnpr.Camera {self.size[0]}x{self.size[1]}>"
