# SPDX-License-Identifier: MIT
# Made by make_options.py from ../picture_options.py and include/hrbfnpr.h; do not edit.
"""A drawing of anything in one call.  Needs NumPy."""
from __future__ import annotations

from typing import Any, Mapping, Optional, Sequence, Tuple, Union

from ._camera import Camera
from ._context import Context
from ._fields import Color
from ._picture import Picture, draw_of
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
    allow_blank : bool
        Make the picture even if hardly anything is seen.
    size : (width, height) or int
        Pixels, or the longer side alone; 1600.
    mark_radius : float
        Radius of the pen, which styles vary a little; an 800th of the longer side, at least 0.75.
    ink : (r, g, b, a) or str
        Of all marks: #rrggbb[aa] or R,G,B[,A] in 0 to 1.
    paper : (r, g, b, a) or str
        As that of ink.
    transparent : bool
        Paper that lets all through.
    sides : {"auto", "front", "both"}
        Of a surface on which marks are drawn: auto = both of one that ends.
    hidden_lines : {"attenuate", "hide", "show"}
        What becomes of them.
    visibility : {"depth_layers", "published"}
        How hidden marks are found.
    delta : float
        Limit of silhouettes, 0 to 1.
    silhouette_law : {"width", "angle"}
        Which marks are silhouettes.
    silhouette_width : float
        On either side of the contour.
    lines : str or sequence of str
        Lines drawn as curves: contour, suggestive, ridges, valleys, apparent, parabolic, isophotes, section, border,
        crease, with commas between; section=z:20, isophotes=0.3:0.6; none: contours by marks; those of the style.
    hidden : {"none", "attenuated", "dashed", "shown"}
        Hidden parts of lines.
    support : float
        Where lines end beyond the samples of open data: 1.5 close to even ones, 3 farther; 0 nowhere; 3 with a border
        among the lines, else 0.
    line_width : float
        Of contours; others are finer.
    outline : float
        Times the width of lines where nothing lies beside them; 1.5 of silhouette and xray, else 1.
    far_lines : float
        Times the width of lines at the farthest place; 1.
    lit_lines : float
        Times the width of lines towards the light; 1.
    sharp_lines : float
        Times the width of lines where the surface bends sharply; 1.
    wobble : float
        How far lines stray, as of an unsteady hand; their width varies by half as much; 0.
    attenuation_front : float
        Of what lies behind front marks.
    attenuation_back : float
        Of what lies behind back marks.
    splat_radius : float
        Of the splats that stand for the surface; automatic.
    splat_overlap : float
        Opacity of a layer of surface; 0 as published.
    halo : float
        How far beyond its contour a surface hides; as the pen.
    tone : {"none", "light"}
        What marks are dense by.
    tone_rule : {"share", "published"}
        How tone, depth, zoom and share combine.
    tone_curve : {"coverage", "linear"}
        What is as dark as asked for.
    tone_fade : float
        Share of marks that grow instead of popping, 0 to 1.
    tone_exponent : float
        Of the tone law; more is darker.
    fill_light : float
        From the side opposite to the light, 0 to 1.
    light : (x, y, z) or str
        Towards the light.
    light_space : {"world", "camera"}
        Frame of the light.
    depth_range : (low, high)
        Distances between which marks vanish.
    zoom_reference : float
        Pixels per unit at which all marks show.
    zoom_exponent : float
        How fast they vanish below it.
    silhouette_ink : (r, g, b, a) or str
        As that of ink.
    silhouette_radius : float
        Of silhouette marks.
    contours_of : str or sequence of str
        Layers whose marks draw contours.
    shape : {"dots", "strokes", "hatch"}
        How marks of strokes are drawn.
    scale_bar : str
        A scale bar below the picture, its length in this unit; none: no bar; units of archaeological.
    profile : {"yes", "no"}
        Whether an upright section through the middle is drawn beside the picture; yes of archaeological.
    share : float
        Share of the style's marks that is used, 0 to 1.
    set : mapping of str
        Any other field of a style, such as principal.directions=first or stipples.ink=#800000; may be repeated.
    up : (x, y, z) or str
        X, y, z, -y, ... or X,Y,Z; auto (default): by the kind of file and the shape, y where neither tells.
    azimuth : float
        Degrees, of the camera about the up axis; 30, and another where that sees the back of an open surface.
    elevation : float
        Degrees, of the camera above the horizon; 20.
    direction : (x, y, z) or str
        From the eye into the scene, instead of these.
    eye : (x, y, z)
        Place of the eye, looking at the target.
    target : (x, y, z)
        The middle of the model.
    fov : float
        Vertical angle of view, 0 = orthographic; 30.
    margin : float
        Free on each side, 0 to 0.45; 0.05.
    layers : str or sequence of str
        Stipples,principal,combing; those the style draws.
    distribution : {"blue_noise", "published"}
        Of marks over the surface.
    marks : int, or mapping of str to int
        The most marks of each layer, or LAYER=N,...; enough to make the darkest tone nearly black.
    levels : int, or mapping of str to int
        Refinement steps of published, or LAYER=N,....
    step : float
        Initial step rho_0 of published.
    seeds : {"auto", "samples", "box", "points"}
        Where marks start.
    seed_points : path
        Points to be the seeds.
    box_resolution : int
        Cells of the box of seeds; 8.
    box_jitter : float
        In cell sides, 0 to 0.5; 0.25.
    stroke_start : {"seeds", "stipples"}
        What strokes of published start from.
    start_level : int
        Last level of those stipples; 0.
    separation : float
        Of neighbouring strokes.
    stroke_step : float
        Of the marks along a stroke.
    stroke_length : float
        Of the longest stroke; 0 = no limit.
    symmetry : {"line", "cross"}
        Where the directions change places.
    guide : {"curvature", "combing", "sections", "light", "silhouette"}
        What lines of hatching follow.
    guide_direction : (x, y, z) or str
        To the light, or to the eye, that such a guide means; z.
    guide_weight : float
        Of that guide; the rest of 1 is curvature's; 1.
    hatch_angle : float
        By which all lines of hatching are turned; 90 is across what they follow; 0.
    density : {"uniform", "curvature"}
        Where stipples are denser.
    density_strength : float
        Of curvature, 0 to 1; 0.5.
    tone_ranges : {"full", "in_turn"}
        Whether one layer of marks follows the other from light to dark.
    shared_marks : int
        The most marks of all layers together, in place of those of each.
    tone_smoothing : float
        Share of the diagonal over which normals are averaged for tone, 0 to 0.1; 0.006 of hatching, else 0.
    projection_tolerance : float
        Share of the diagonal; 1e-7.
    curvature_of : str or sequence of str
        Keep curvatures of these layers too.
    kernel : {"triharmonic", "gaussian", "wendland_c2"}
        Radial function.
    kernel_radius : float
        Of gaussian and wendland-c2.
    degree : int
        Of the polynomial, -1 (none) to 3; 1.
    regularization : float or str
        0 interpolates, more is smoother, auto takes it from the noise, and is 0 if none is seen; auto, but 0 for
        samples of meshes.
    solver : {"auto", "direct", "iterative"}
        Solver.
    tolerance : float
        Choose samples as centres until all are this near to the surface.
    max_centres : int
        Choose no more samples than this as centres.
    outliers : {"keep", "drop"}
        What becomes of stray samples; without normals they are dropped.
    flipped_normals : {"keep", "drop", "reorient"}
        What becomes of them.
    refinement_steps : int
        After a direct solve; 2.
    samples : int
        How many samples: of a mesh (by default as many as its shape needs), or chosen from a point set (all up to 4096
        by default).
    crease : float
        Faces of a mesh that meet at a sharper angle do not share their normals; 60.
    edges : str or float
        Of a mesh: auto keeps those sharp that stand out, as of machine parts, smooth rounds them, a number of degrees
        keeps all that bend more; by default as auto, and where faces are coarse as the normals of the file tell, if
        they do.
    subdivide : int or str
        Divide the faces of a mesh into four, so often, to something round; by default where they are coarse and no
        edges stand out.
    parts : {"outer", "all", "largest"}
        Which parts of a mesh: all but those inside others (default), all, or that of the largest area.
    together : bool
        Fit an open mesh as one surface, also where parts cross.
    normals : {"auto", "keep", "none", "unoriented", "mixed", "inward"}
        What is known of those of points: auto (default) finds it out and repairs them, keep leaves them, none makes new
        ones, unoriented and mixed turn some, inward turns all.
    viewpoint : (x, y, z)
        Where the scanner stood, in the coordinates of the file: open surfaces of points whose normals are made look to
        it; by default what the file tells.
    depth_smoothing : float
        Factor of the width over which the picture of a depth camera is smoothed; 1, and 0 leaves its points where they
        are.
    flip : bool
        All normals are turned, whatever they look like.
    close : bool
        Let the surface go on beyond open data, as the fit has it.
    random_seed : int
        Of all that is random; 1.
    page : (width, height) or str
        Paper that the drawing fills but for 10 mm, turned as it fits better: a4, a3, letter, ... or WIDTHxHEIGHT in mm;
        by default a pixel is 1/96 inch.
    page_margin : float
        Free on each side of the page; 10.
    dots : {"circles", "lines", "spirals"}
        Of stipples: circles, lines of no length that a pen touches the paper with, or spirals that fill them; circles,
        which plotters fill unless in a single pass.
    stroke_widths : {"outlines", "classes"}
        Of strokes that swell: outlines, or classes of even widths; outlines.
    pens : str
        Pens of groups, with commas between, such as contour=#000000:0.5,hatch*=#803000:0.3; a third part is a line type
        of ISO 128, such as dashed.
    pen_widths : sequence of float
        Widths of the pens at hand: each group gets the one that is nearest to its lines' median width, or to its dots'
        median diameter.
    single_pass : bool
        Draw a line that is wider than its pen once, along its centre, and touch the paper for a dot; else plotters, and
        pens in plot order, fill both by several passes.
    plot_order : bool
        Sort lines so that a pen travels little; plotters' files always are.
    vector_tolerance : float
        Between what is drawn and what is written; 0.05.
    draw_speed : float
        Of a plotter's pen, for the time it takes; 30.
    pen_up : str
        Raises the pen in .gcode; G0 Z5.
    pen_down : str
        Lowers it; G1 Z0.
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
