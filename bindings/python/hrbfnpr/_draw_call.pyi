# SPDX-License-Identifier: MIT
# Made by make_options.py from draw_call.pyi.in, ../picture_options.py and include/hrbfnpr.h; do not edit.
"""The arguments of _draw_call.py, for type checkers and editors."""
from typing import Any, Mapping, Optional, Sequence, Tuple, Union

from ._camera import Camera
from ._context import Context
from ._fields import Color
from ._light import Light
from ._picture import Picture as Picture
from ._report import Progress
from ._style import Style

Floats = Sequence[float]
Direction = Union[None, str, Floats]
Names = Union[None, str, Sequence[str]]
NumberOr = Union[None, str, float]
Ground = Union[None, bool, str, float]
PerLayer = Union[None, int, Mapping[str, int]]
Fields = Union[None, str, Sequence[str], Mapping[str, str]]
Palette = Union[None, str, Sequence[Color]]
Lights = Union[None, str, Floats, Light, Sequence[Union[str, Floats, Light]]]
Size = Union[None, int, str, Tuple[int, int]]

def draw(
    source: Any,
    style: Union[str, Style] = ...,
    *,
    camera: Optional[Camera] = ...,
    progress: Progress = ...,
    context: Optional[Context] = ...,
    fields: Optional[Mapping[str, Any]] = ...,
    allow_blank: bool = ..., size: Size = ..., mark_radius: Optional[float] = ..., ink: Optional[Color] = ...,
    paper: Optional[Color] = ..., transparent: bool = ..., field: Fields = ..., palette: Palette = ...,
    sides: Optional[str] = ..., hidden_lines: Optional[str] = ..., visibility: Optional[str] = ...,
    delta: Optional[float] = ..., lines: Names = ..., hidden: Optional[str] = ..., verify: bool = ...,
    support: Optional[float] = ..., line_width: Optional[float] = ..., outline: Optional[float] = ...,
    far_lines: Optional[float] = ..., lit_lines: Optional[float] = ..., sharp_lines: Optional[float] = ...,
    wobble: Optional[float] = ..., attenuation_front: Optional[float] = ..., attenuation_back: Optional[float] = ...,
    splat_radius: Optional[float] = ..., splat_overlap: Optional[float] = ..., halo: Optional[float] = ...,
    tone: Optional[str] = ..., tone_rule: Optional[str] = ..., tone_curve: Optional[str] = ...,
    tone_fade: Optional[float] = ..., tone_exponent: Optional[float] = ..., fill_light: Optional[float] = ...,
    light: Lights = ..., light_space: Optional[str] = ..., shadow: Optional[float] = ...,
    softness: Optional[float] = ..., occlusion: Optional[float] = ..., rim_light: Optional[float] = ...,
    steps: Optional[float] = ..., black_point: Optional[float] = ..., white_point: Optional[float] = ...,
    gamma: Optional[float] = ..., ground: Ground = ..., contrast: Optional[float] = ...,
    depth_range: Optional[Floats] = ..., zoom_reference: Optional[float] = ..., zoom_exponent: Optional[float] = ...,
    silhouette_ink: Optional[Color] = ..., silhouette_radius: Optional[float] = ..., shape: Optional[str] = ...,
    scale_bar: Optional[str] = ..., profile: Optional[str] = ..., share: Optional[float] = ...,
    set: Optional[Mapping[str, Any]] = ..., up: Direction = ..., azimuth: Optional[float] = ...,
    elevation: Optional[float] = ..., direction: Direction = ..., eye: Optional[Floats] = ...,
    target: Optional[Floats] = ..., fov: Optional[float] = ..., margin: Optional[float] = ..., keep_marks: bool = ...,
    layers: Names = ..., distribution: Optional[str] = ..., marks: PerLayer = ..., levels: PerLayer = ...,
    step: Optional[float] = ..., seeds: Optional[str] = ..., seed_points: Optional[Any] = ...,
    box_resolution: Optional[int] = ..., box_jitter: Optional[float] = ..., stroke_start: Optional[str] = ...,
    start_level: Optional[int] = ..., separation: Optional[float] = ..., stroke_step: Optional[float] = ...,
    guide: Optional[str] = ..., guide_direction: Direction = ..., guide_weight: Optional[float] = ...,
    hatch_angle: Optional[float] = ..., density: Optional[str] = ..., density_strength: Optional[float] = ...,
    tone_ranges: Optional[str] = ..., shared_marks: Optional[int] = ..., tone_smoothing: Optional[float] = ...,
    projection_tolerance: Optional[float] = ..., curvature_of: Names = ..., kernel: Optional[str] = ...,
    kernel_radius: Optional[float] = ..., degree: Optional[int] = ..., regularization: NumberOr = ...,
    solver: Optional[str] = ..., tolerance: Optional[float] = ..., max_centres: Optional[int] = ...,
    outliers: Optional[str] = ..., flipped_normals: Optional[str] = ..., refinement_steps: Optional[int] = ...,
    samples: Optional[int] = ..., crease: Optional[float] = ..., edges: NumberOr = ..., subdivide: NumberOr = ...,
    parts: Optional[str] = ..., together: bool = ..., normals: Optional[str] = ..., classes: Union[str, int,
    Sequence[int], None] = ..., viewpoint: Optional[Floats] = ..., depth_smoothing: Optional[float] = ...,
    flip: bool = ..., close: bool = ..., random_seed: Optional[int] = ..., page: Size = ...,
    page_margin: Optional[float] = ..., dots: Optional[str] = ..., stroke_widths: Optional[str] = ...,
    pens: Names = ..., pen_widths: Optional[Floats] = ..., single_pass: bool = ..., plot_order: bool = ...,
    vector_tolerance: Optional[float] = ..., draw_speed: Optional[float] = ..., curves: Optional[str] = ...,
    longest_path: Optional[float] = ..., pen_up: Optional[str] = ..., pen_down: Optional[str] = ...,
    **others: Any,
) -> Picture: ...

def from_pyvista(
    plotter: Any,
    style: Union[str, Style] = ...,
    *,
    camera: Optional[Camera] = ...,
    progress: Progress = ...,
    context: Optional[Context] = ...,
    **options: Any,
) -> Picture: ...
