# SPDX-License-Identifier: MIT
"""A model of a mesh: with as many samples as its shape needs, or with as many as were asked for."""
from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, List, NamedTuple, Optional, Tuple

import numpy as np

from .._context import Context
from .._mesh import Mesh, MeshFitInfo, MeshInfo
from .._model import Model
from ..shapes import Shape, subdivide
from ..shapes._shape import Floats
from ..shapes._sharp_edges import Kind, kind, moved
from ..shapes._subdivide import coarseness, mean_edge, raised, subdivide_round
from . import _apart, _far, _orient, _up
from ._nearness import in_words, of
from ._progress import Reporter

TOLERANCE = 0.002  # of the diagonal, as Model.fit_mesh has it
MOST_COARSE = 50_000  # faces of a mesh that may be coarse
MOST_ROUNDS = 3
COARSE_EDGE = 0.025  # of the diagonal: faces whose edges are shorter on average bend by noise
_MOST_MOVED = 1.5  # how much farther than the faces bulge vertices may be moved: of figures and rings it is 1.2 at most
_MOST_RAISED = 3.0  # the same of places in the midst of faces: of a ball of 156 faces 1.8, of figures 2.7 at most
_OTHERWISE = "--edges auto keeps those that stand out"
_FLAT_BEND = 5.0  # degrees by which flat faces bend to each other
LOOKED_AT = 2000  # samples that tell which way is up
SAMPLES = 1000  # where the fit is not to choose them
_ROUND = 0.9  # share of a mesh within the tolerance: where it is less, that is not for a few edges
_ROOM_A_SHEET = 32  # centres that a fit with sharp edges may have, as the library has it
_CHOOSES = ("tolerance", "maximum_centres", "kernel", "kernel_radius", "polynomial_degree", "solver")
_OF_ONE = ("save_model", "save_points", "save_settings", "settings", "scale_bar")
_NOT_WITH_CHOICE = ("samples", "outliers", "flipped_normals", "refinement_steps", "flip")


@dataclass(frozen=True)
class Read:
    """A mesh that was looked at, what it is of, and even samples of it."""

    mesh: Mesh
    shape: Shape
    points: Floats
    normals: Floats
    edges: Optional[float] = None  # degrees: what bends more is an edge; None: what stands out is


def read(shape: Shape, arguments: Any, context: Context, report: Reporter) -> Read:
    """Weld it, turn its faces outward, leave out what lies inside; and say so."""
    with report.stage("mesh", "looking at the mesh") as stage:
        mesh = _welded(shape, shape.triangles, arguments, stage.bar, context)
        mesh, shape, lost = _without_lost(mesh, shape, arguments, context)
        stage.says = _in_words(mesh.info)
    _tell(mesh.info, report)
    for some in lost:
        report.note(f"{some} left out; --parts all keeps them")
    count = LOOKED_AT if chooses(arguments) else arguments.samples or SAMPLES
    with report.stage("sample", "sampling") as stage:
        points, normals = _sampled(mesh, count, arguments, stage.bar)
        stage.says = f"{count} samples" + (", to look at" if chooses(arguments) else "")
        settled = mesh.info.closed or arguments.normals == "keep" or arguments.flip
        why = None if settled else _looks_wrong(points, normals)
        if why is not None:
            assert shape.triangles is not None
            mesh = _welded(shape, np.ascontiguousarray(shape.triangles[:, ::-1]), arguments, None, context)
        made = _with_edges(mesh, shape, arguments, context)
        if why is not None or made.mesh is not mesh:
            points, normals = _sampled(made.mesh, count, arguments, None)
    if why is not None:
        report.note(f"{why} (--normals keep leaves them)")
    for said in made.said:
        report.note(said)
    return Read(made.mesh, made.shape, points, -normals if arguments.flip else normals, made.edges)


class _Made(NamedTuple):
    """Of a mesh: a finer one or itself, what was done, in words, and from which angle on edges are some."""

    mesh: Mesh
    shape: Shape
    said: Tuple[str, ...] = ()
    edges: Optional[float] = None


def _with_edges(mesh: Mesh, shape: Shape, arguments: Any, context: Context) -> _Made:
    """Round where the mesh is coarse and meant to be so, and sharp where it is, as far as that can be told."""
    given, told = _plain(mesh), Kind.NOTHING
    if arguments.edges is None and chooses(arguments):
        given, told = _with_given_edges(given, shape)
    rounds = _rounds(mesh, given, told, arguments)
    if rounds == 0:
        return _Made(mesh, shape)
    if told is Kind.ALL and getattr(arguments, "subdivide", None) is None:
        return _Made(mesh, shape, ("by the normals of its file all faces are flat (--edges smooth rounds)",), _FLAT_BEND)
    return _divided(mesh, shape, given, rounds, arguments, context)


def _plain(mesh: Mesh) -> Shape:
    return Shape(np.array(mesh.vertices), None, np.array(mesh.triangles, dtype=np.int64))


def _with_given_edges(given: Shape, shape: Shape) -> Tuple[Shape, Kind]:
    """A welded mesh, with the edges that are sharp by the normals of its file where others are not."""
    assert given.triangles is not None
    if shape.sharp_edges is None:
        return given, Kind.NOTHING
    edges = moved(shape.sharp_edges, shape.points, given.points)
    said = kind(given.points, given.triangles, edges)
    return (replace(given, sharp_edges=edges) if said is Kind.SOME else given), said


def _rounds(mesh: Mesh, given: Shape, told: Kind, arguments: Any) -> int:
    """How often faces are to be divided: those that something round would bulge out of by more than the tolerance."""
    wanted = getattr(arguments, "subdivide", None)
    if wanted is not None:
        return int(wanted)
    sharp = arguments.edges is not None and arguments.edges[0] == "sharp"
    if sharp or not chooses(arguments) or len(mesh.triangles) > MOST_COARSE or mean_edge(given) < COARSE_EDGE:
        return 0
    tolerance, off = _tolerance(given, arguments), coarseness(given)
    if off <= tolerance or (told is not Kind.SOME and _has_edges(given, arguments)):
        return 0
    return min(MOST_ROUNDS, int(np.ceil(np.log(2 * off / tolerance) / np.log(4))))


def _tolerance(given: Shape, arguments: Any) -> float:
    """As a share of the diagonal."""
    across = float(np.linalg.norm(np.ptp(given.points, axis=0)))
    return float(arguments.tolerance) / across if arguments.tolerance and across > 0 else TOLERANCE


def _has_edges(given: Shape, arguments: Any) -> bool:
    """Whether a fit keeps some sharp, as those of machine parts and of polyhedra. Where none stand out, those of a part
    by itself may: asked with a rough fit, in silence."""
    across = float(np.linalg.norm(np.ptp(given.points, axis=0)))
    with Context(getattr(arguments, "threads", None) or 0) as silent:
        mesh = Mesh(given.points, given.triangles, parts="all", faces="keep", context=silent)
        if mesh.info.creases:
            return True
        rough = Model.fit_mesh(mesh, tolerance=0.1 * across, maximum_centres=100, trim="never")
    assert rough.mesh_fit is not None
    return rough.mesh_fit.sheets > 1


def _divided(mesh: Mesh, shape: Shape, given: Shape, rounds: int, arguments: Any, context: Context) -> _Made:
    """A finer mesh, round where the given one is coarse, or the same if nothing round goes through its vertices: faces
    of a convex hull, which are long and of any size, would fold."""
    told, wanted = given.sharp_edges is not None, getattr(arguments, "subdivide", None) is not None
    crease = 180.0 if arguments.crease is None else arguments.crease
    if told and not wanted:
        finer, parents = subdivide_round(given, rounds, crease, _tolerance(given, arguments))
        rise = raised(given, finer, parents)
    else:
        finer = subdivide(given, rounds, crease)
        rise = raised(given, finer)
    moved_by = np.linalg.norm(finer.points[: len(given.points)] - given.points, axis=1).max()
    across = np.linalg.norm(np.ptp(given.points, axis=0))
    said = f"divided {of(rounds, 'time')}, vertices moved by at most {moved_by / across:.2%}"
    said += f", what lies between them by {rise.max():.2%}"
    if wanted:
        said = f"the faces are {said}"
    else:
        off = coarseness(given)
        if told and moved_by > _MOST_MOVED * coarseness(given, 100.0) * across:
            return _Made(mesh, shape)
        folds = not told and (moved_by > _MOST_MOVED * off * across or np.percentile(rise, 99) > _MOST_RAISED * off)
        if folds and arguments.edges is None:
            said = "the faces are coarse, but nothing round goes through them: flat (--edges smooth rounds)"
            return _Made(mesh, shape, (said,), _FLAT_BEND)
        said = f"the faces are coarse, {off:.2%} of the diagonal off something round: {said} (--subdivide 0 leaves them)"
    assert finer.triangles is not None
    made = Mesh(
        finer.points, finer.triangles, parts="all", faces="keep", context=context,
        crease_angle=60.0 if arguments.crease is None else arguments.crease,
    )  # fmt: skip
    fine = replace(shape, points=finer.points, triangles=finer.triangles, normals=None, sharp_edges=None)
    by_file = f"some edges are sharp and others round, by the normals of its file ({_OTHERWISE})"
    return _Made(made, fine, (by_file, said) if told else (said,))


def _welded(shape: Shape, triangles: Any, arguments: Any, bar: Any, context: Context) -> Mesh:
    return Mesh(
        shape.points, triangles, parts=arguments.parts or "outer", progress=bar, context=context,
        faces="keep" if arguments.normals == "keep" else "turn",
        crease_angle=60.0 if arguments.crease is None else arguments.crease,
    )  # fmt: skip


def _without_lost(mesh: Mesh, shape: Shape, arguments: Any, context: Context) -> Tuple[Mesh, Shape, List[str]]:
    """Without parts of next to no area that are far away, and faces left over; and in words how many these were."""
    said: List[str] = []
    if (arguments.parts or "outer") != "outer":
        return mesh, shape, said
    lost = _far.lost_parts(mesh)
    if lost is not None:
        parts = len(np.unique(np.asarray(mesh.components)[lost]))
        said.append(f"{of(parts, 'part')} ({of(int(lost.sum()), 'face')}) far from all others")
        mesh, shape = _without(lost, mesh, shape, arguments, context)
    flaps = _apart.flaps(mesh)
    if flaps is not None:
        said.append(f"{of(len(flaps), 'face')} that only an edge of two others holds")
        mesh, shape = _without(flaps, mesh, shape, arguments, context)
    return mesh, shape, said


def _without(which: Any, mesh: Mesh, shape: Shape, arguments: Any, context: Context) -> Tuple[Mesh, Shape]:
    assert shape.triangles is not None
    faces = np.delete(shape.triangles, np.asarray(mesh.given_faces)[which], axis=0)
    return _welded(shape, faces, arguments, None, context), replace(shape, triangles=faces)


def _sampled(mesh: Mesh, count: int, arguments: Any, bar: Any) -> Tuple[Floats, Floats]:
    points, normals = mesh.sample(count, random_seed=_seed(arguments), progress=bar)
    return np.asarray(points), np.asarray(normals)


def _looks_wrong(points: Floats, normals: Floats) -> Optional[str]:
    """Why the faces of an open mesh are to be turned; None if they are not."""
    axis = _up.hangs(points, normals)
    if axis is not None:
        return f"the surface is a terrain that looked down along {axis}: its normals are turned"
    if _orient.look(points, normals, True).inward:
        return "all normals looked inward: they are turned"
    return None


def chooses(arguments: Any) -> bool:
    """Whether the fit takes as many samples as it needs: unless they, or what only such a fit does, are asked for."""
    return not any(getattr(arguments, name, None) for name in _NOT_WITH_CHOICE) and arguments.regularization != "auto"


def in_groups(read_mesh: Read, arguments: Any, context: Context, report: Reporter) -> List[Read]:
    """The mesh, or groups of its parts that are no surface together, the largest first."""
    found = _apart.groups(read_mesh.mesh) if _may_be_apart(arguments) else None
    if found is None:
        return [read_mesh]
    report.note(
        f"{of(found.parts, 'part')} of the mesh, not all of them closed, cross or are close to each other: they are "
        f"fitted and drawn in {len(found.groups)} groups, each a surface of its own (--together makes one of them)"
    )
    return [_group(read_mesh, faces, arguments, context) for faces in found.groups]


def _may_be_apart(arguments: Any) -> bool:
    """Unless one model is wanted, or what is made of one."""
    if arguments.together or arguments.close or arguments.command not in ("draw", "turntable"):
        return False
    one = any(getattr(arguments, name, None) for name in _OF_ONE) or arguments.style == "archaeological"
    return chooses(arguments) and not one and arguments.profile != "yes"


def _group(whole: Read, faces: Any, arguments: Any, context: Context) -> Read:
    triangles = np.asarray(whole.mesh.triangles, dtype=np.int64)[faces]
    used, triangles = np.unique(triangles, return_inverse=True)
    shape = replace(
        whole.shape, points=np.asarray(whole.mesh.vertices)[used], triangles=triangles.reshape(-1, 3), normals=None,
        sharp_edges=None,
    )  # fmt: skip
    mesh = Mesh(
        shape.points, shape.triangles, parts="all", faces="keep", context=context,
        crease_angle=60.0 if arguments.crease is None else arguments.crease,
    )  # fmt: skip
    return Read(mesh, shape, whole.points, whole.normals, whole.edges)


def fit(read_mesh: Read, arguments: Any, report: Reporter, across: float = 0.0) -> Model:
    """Within a tolerance both ways; what falls short is warned of.

    `across` is the diagonal of all that is drawn.  What is small beside it is seen as near: its tolerance is between that
    of the whole and its own.
    """
    options = {"random_seed": _seed(arguments), **(getattr(arguments, "own_mesh_fit", None) or {})}
    options.update({name: value for name in _CHOOSES if (value := getattr(arguments, name, None)) is not None})
    if arguments.regularization is not None:
        options["regularization"] = arguments.regularization
    if arguments.edges is not None:
        options["edges"], options["crease_angle"] = arguments.edges
    elif read_mesh.edges is not None:
        options["edges"], options["crease_angle"] = "sharp", read_mesh.edges
    if across > 0:
        own = float(np.linalg.norm(np.ptp(read_mesh.shape.points, axis=0)))
        options.setdefault("tolerance", TOLERANCE * float(np.sqrt(own * across)))
    is_open = read_mesh.mesh.info.boundary_edges > 0
    with report.stage("fit", "fitting") as stage:
        model = Model.fit_mesh(
            read_mesh.mesh, trim="auto" if is_open and not arguments.close else "never", progress=stage.bar, **options
        )
        done = model.mesh_fit
        assert done is not None
        how = of(done.rounds, "round") if done.sheets == 1 else f"{done.sheets} sheets"
        stage.says = f"{done.centres} centres in {how}; {in_words(done, diagonal(model))}"
    if not done.reached:
        report.warn(_shortfall(done, model, arguments))
    if done.smooth_length > 0.01 * diagonal(model):
        report.note(f"edges {done.smooth_length / diagonal(model):.2g} diagonals long stay smooth")
    return model


def _seed(arguments: Any) -> int:
    return 1 if arguments.random_seed is None else int(arguments.random_seed)


def _in_words(info: MeshInfo) -> str:
    parts = "1 part" if info.components == 1 else f"{info.components} parts"
    if info.closed:
        return f"{parts}, closed"
    return f"{parts}, {of(info.boundary_loops, 'border')}" if info.boundary_edges else f"{parts}, not closed"


def _tell(info: MeshInfo, report: Reporter) -> None:
    """What was repaired, and what cannot be."""
    if info.turned_faces:
        report.note(f"{of(info.turned_faces, 'face')} looked to the other side than those beside: turned")
    if info.turned_components:
        some = f"{of(info.turned_components, 'part')} of the mesh were"
        inside_out = "the mesh was" if info.components == 1 else some
        report.note(f"{inside_out} inside out: its faces are turned")
    if info.degenerate_faces or info.repeated_faces:
        report.note(f"{of(info.degenerate_faces + info.repeated_faces, 'face')} without area, or twice there, left out")
    if info.left_out_components:
        report.note(
            f"{of(info.left_out_components, 'part')} inside others left out ({info.left_out_faces} faces); --parts all "
            "keeps them"
        )
    if info.contrary_edges:
        report.warn(
            f"{of(info.contrary_edges, 'edge')} between faces that look to opposite sides, which cannot be turned: a "
            "surface of one side, or one that crosses itself"
        )


def _shortfall(done: MeshFitInfo, model: Model, arguments: Any) -> str:
    d = diagonal(model)
    farthest = float(np.fmax(done.mesh_max, done.surface_max)) / d
    surface = "nothing of the surface was found to measure from" if np.isnan(done.surface_share) else (
        f"{1 - done.surface_share:.1%} of the surface are farther")  # fmt: skip
    text = (
        f"the surface is not within {done.tolerance / d:.2%} of the diagonal everywhere: {1 - done.mesh_share:.1%} of "
        f"the mesh and {surface}, "
        + (f"at most {farthest:.1%}" if np.isfinite(farthest) else "and some of the mesh has no surface near it")
    )
    most = max(arguments.maximum_centres or 8000, _ROOM_A_SHEET * done.sheets if done.sheets > 1 else 0)
    if done.centres >= 0.9 * most:
        return text + f"; --max-centres {2 * most} allows more samples"
    if done.sheets > 1 and done.mesh_share < _ROUND and arguments.edges is None:
        return text + "; its faces are coarse, and what is round bulges over them: if they are flat, --edges 5 keeps them so"
    rounded = "sharp edges and very thin parts" if done.sheets == 1 else "some edges and very thin parts"
    return text + f"; {rounded} are rounded"


def diagonal(model: Model) -> float:
    low, high = model.bounds
    return float(np.linalg.norm(np.subtract(high, low))) or 1.0


def off(model: Model) -> float:
    """How far from the mesh what is none of it lies, in diagonals: few samples round what is sharp, as the fit has it."""
    if model.mesh_fit is None:
        return max(0.009, 1.5 * model.info.spacing / diagonal(model))
    return float(np.clip(1.5 * np.nan_to_num(model.mesh_fit.mesh_p99) / diagonal(model), 0.009, 0.015))
