# SPDX-License-Identifier: MIT
# Made by make_options.py from ../picture_options.py and include/hrbfnpr.h; do not edit.
"""A drawing of anything in one call.  Needs NumPy."""
from __future__ import annotations

from typing import Any, Mapping, Optional, Sequence, Tuple, Union

from ._camera import Camera
from ._context import Context
from ._fields import Color
from ._picture import Picture, draw_of
from ._request import in_documentation
from ._report import Progress
from ._style import Style

Floats = Sequence[float]
Direction = Union[None, str, Floats]
Names = Union[None, str, Sequence[str]]
NumberOr = Union[None, str, float]
PerLayer = Union[None, int, Mapping[str, int]]
Size = Union[None, int, str, Tuple[int, int]]

__all__ = ["Picture", "draw"]


def draw(
    source: Any,
    style: Union[str, Style] = "contour-and-stipple",
    *,
    camera: Optional[Camera] = None,
    progress: Progress = None,
    context: Optional[Context] = None,
    allow_blank: bool = False, size: Size = None, mark_radius: Optional[float] = None, ink: Optional[Color] = None,
    paper: Optional[Color] = None, transparent: bool = False, sides: Optional[str] = None,
    hidden_lines: Optional[str] = None, visibility: Optional[str] = None, delta: Optional[float] = None,
    silhouette_law: Optional[str] = None, silhouette_width: Optional[float] = None, lines: Names = None,
    hidden: Optional[str] = None, support: Optional[float] = None, line_width: Optional[float] = None,
    outline: Optional[float] = None, far_lines: Optional[float] = None, lit_lines: Optional[float] = None,
    sharp_lines: Optional[float] = None, wobble: Optional[float] = None, attenuation_front: Optional[float] = None,
    attenuation_back: Optional[float] = None, splat_radius: Optional[float] = None,
    splat_overlap: Optional[float] = None, halo: Optional[float] = None, tone: Optional[str] = None,
    tone_rule: Optional[str] = None, tone_curve: Optional[str] = None, tone_fade: Optional[float] = None,
    tone_exponent: Optional[float] = None, fill_light: Optional[float] = None, light: Direction = None,
    light_space: Optional[str] = None, depth_range: Optional[Floats] = None, zoom_reference: Optional[float] = None,
    zoom_exponent: Optional[float] = None, silhouette_ink: Optional[Color] = None,
    silhouette_radius: Optional[float] = None, contours_of: Names = None, shape: Optional[str] = None,
    scale_bar: Optional[str] = None, profile: Optional[str] = None, share: Optional[float] = None,
    set: Optional[Mapping[str, Any]] = None, up: Direction = None, azimuth: Optional[float] = None,
    elevation: Optional[float] = None, direction: Direction = None, eye: Optional[Floats] = None,
    target: Optional[Floats] = None, fov: Optional[float] = None, margin: Optional[float] = None, layers: Names = None,
    distribution: Optional[str] = None, marks: PerLayer = None, levels: PerLayer = None, step: Optional[float] = None,
    seeds: Optional[str] = None, seed_points: Optional[Any] = None, box_resolution: Optional[int] = None,
    box_jitter: Optional[float] = None, stroke_start: Optional[str] = None, start_level: Optional[int] = None,
    separation: Optional[float] = None, stroke_step: Optional[float] = None, stroke_length: Optional[float] = None,
    symmetry: Optional[str] = None, guide: Optional[str] = None, guide_direction: Direction = None,
    guide_weight: Optional[float] = None, hatch_angle: Optional[float] = None, density: Optional[str] = None,
    density_strength: Optional[float] = None, tone_ranges: Optional[str] = None, shared_marks: Optional[int] = None,
    tone_smoothing: Optional[float] = None, projection_tolerance: Optional[float] = None, curvature_of: Names = None,
    kernel: Optional[str] = None, kernel_radius: Optional[float] = None, degree: Optional[int] = None,
    regularization: NumberOr = None, solver: Optional[str] = None, tolerance: Optional[float] = None,
    max_centres: Optional[int] = None, outliers: Optional[str] = None, flipped_normals: Optional[str] = None,
    refinement_steps: Optional[int] = None, samples: Optional[int] = None, crease: Optional[float] = None,
    edges: NumberOr = None, subdivide: NumberOr = None, parts: Optional[str] = None, together: bool = False,
    normals: Optional[str] = None, viewpoint: Optional[Floats] = None, depth_smoothing: Optional[float] = None,
    flip: bool = False, close: bool = False, random_seed: Optional[int] = None, page: Size = None,
    page_margin: Optional[float] = None, dots: Optional[str] = None, stroke_widths: Optional[str] = None,
    pens: Names = None, pen_widths: Optional[Floats] = None, single_pass: bool = False, plot_order: bool = False,
    vector_tolerance: Optional[float] = None, draw_speed: Optional[float] = None, pen_up: Optional[str] = None,
    pen_down: Optional[str] = None,
    **others: Any,
) -> Picture:  # fmt: skip
    """Draw a file, arrays, or a mesh or cloud of another package, in one call.

    Options are those of ``python3 -m hrbfnpr draw`` that are not about files, as Python's values:
    ``size=(800, 600)``, ``samples=2000``, ``lines=["contour", "ridges"]``, ``ink="#203040"``,
    ``marks={"stipples": 20000}``, ``flip=True``, ``set={"principal.ink": "#800000"}``; None stands for the default.

    Parameters
    ----------
    source : path, arrays, Shape, Mesh, Model, PointSet, or a mesh or cloud of PyVista, trimesh or Open3D
        A path is that of any file that the command line reads.  Arrays are points of shape (n, 3), whose normals are
        found, (points, normals) with an array of floats, or (points, triangles) with an array of integers.
    style : str or Style
        A named style (`hrbfnpr.PRESETS`), whose marks are sized for the picture, or one that is used as it is.
    camera : Camera, optional
        By default one that sees all, from `azimuth` and `elevation`.
    progress : callable, tqdm bar or True, optional
        Called with what is done and a fraction in [0, 1] of it; True makes a bar of tqdm's.
    context : Context, optional
        A new one if omitted.
    {options}
    **others
        Other names of these: those of the fields that they set, such as ``budget`` of ``marks``.

    Returns
    -------
    Picture
        Shows itself in a notebook; ``save``, ``image``, ``seen`` from another side.

    Raises
    ------
    TypeError
        For a source or an option that is unknown.
    ValueError
        For a source that cannot be drawn, a value out of its range, and a picture that would be blank
        (``allow_blank=True`` lets it be).

    Warns
    -----
    DrawingWarning
        Where the command line prints a warning.

    Examples
    --------
    >>> hrbfnpr.draw("bunny.ply", "hatch", size=800).save("bunny.png")
    >>> hrbfnpr.draw((points, normals), azimuth=60, lines="contour,suggestive")
    """
    options = dict(
        allow_blank=allow_blank, size=size, mark_radius=mark_radius, ink=ink, paper=paper, transparent=transparent,
        sides=sides, hidden_lines=hidden_lines, visibility=visibility, delta=delta, silhouette_law=silhouette_law,
        silhouette_width=silhouette_width, lines=lines, hidden=hidden, support=support, line_width=line_width,
        outline=outline, far_lines=far_lines, lit_lines=lit_lines, sharp_lines=sharp_lines, wobble=wobble,
        attenuation_front=attenuation_front, attenuation_back=attenuation_back, splat_radius=splat_radius,
        splat_overlap=splat_overlap, halo=halo, tone=tone, tone_rule=tone_rule, tone_curve=tone_curve,
        tone_fade=tone_fade, tone_exponent=tone_exponent, fill_light=fill_light, light=light, light_space=light_space,
        depth_range=depth_range, zoom_reference=zoom_reference, zoom_exponent=zoom_exponent,
        silhouette_ink=silhouette_ink, silhouette_radius=silhouette_radius, contours_of=contours_of, shape=shape,
        scale_bar=scale_bar, profile=profile, share=share, set=set, up=up, azimuth=azimuth, elevation=elevation,
        direction=direction, eye=eye, target=target, fov=fov, margin=margin, layers=layers, distribution=distribution,
        marks=marks, levels=levels, step=step, seeds=seeds, seed_points=seed_points, box_resolution=box_resolution,
        box_jitter=box_jitter, stroke_start=stroke_start, start_level=start_level, separation=separation,
        stroke_step=stroke_step, stroke_length=stroke_length, symmetry=symmetry, guide=guide,
        guide_direction=guide_direction, guide_weight=guide_weight, hatch_angle=hatch_angle, density=density,
        density_strength=density_strength, tone_ranges=tone_ranges, shared_marks=shared_marks,
        tone_smoothing=tone_smoothing, projection_tolerance=projection_tolerance, curvature_of=curvature_of,
        kernel=kernel, kernel_radius=kernel_radius, degree=degree, regularization=regularization, solver=solver,
        tolerance=tolerance, max_centres=max_centres, outliers=outliers, flipped_normals=flipped_normals,
        refinement_steps=refinement_steps, samples=samples, crease=crease, edges=edges, subdivide=subdivide,
        parts=parts, together=together, normals=normals, viewpoint=viewpoint, depth_smoothing=depth_smoothing,
        flip=flip, close=close, random_seed=random_seed, page=page, page_margin=page_margin, dots=dots,
        stroke_widths=stroke_widths, pens=pens, pen_widths=pen_widths, single_pass=single_pass, plot_order=plot_order,
        vector_tolerance=vector_tolerance, draw_speed=draw_speed, pen_up=pen_up, pen_down=pen_down, **others,
    )  # fmt: skip
    return draw_of(source, style, options, camera, progress, context)


draw.__doc__ = (draw.__doc__ or "").replace("{options}", in_documentation("    "))
