# SPDX-License-Identifier: MIT
"""Small cases whose results show what a tuning constant changes, for scripts/ablate.py.

A case returns a dictionary of numbers, arrays of bytes (pictures) and bytes (files), by name. Files are compared byte for
byte. Models that several cases draw are fitted once, with unchanged constants, and kept in a folder.
"""

import contextlib
import io
import tempfile
import zlib
from pathlib import Path
from typing import Any, Callable, Dict, List

import numpy as np

import hrbfnpr
from hrbfnpr import csg, datasets, shapes

Result = Dict[str, Any]
CASES: Dict[str, Callable[["Kept"], Result]] = {}
SIZE = 300


def case(function: Callable[["Kept"], Result]) -> Callable[["Kept"], Result]:
    CASES[function.__name__] = function
    return function


# ---- Shapes


def lathe(profile: Any, count: int = 40) -> shapes.Shape:
    """Returns the mesh that a profile of (radius, height) pairs, from axis to axis, makes by rotation."""
    profile = np.asarray(profile, float)
    turn = 2 * np.pi * np.arange(count) / count
    rings = profile[1:-1]
    points = [[0, 0, profile[0, 1]], [0, 0, profile[-1, 1]]]
    points += [[r * np.cos(a), r * np.sin(a), z] for r, z in rings for a in turn]
    faces: List[List[int]] = []
    for k in range(count):
        n = (k + 1) % count
        faces.append([0, 2 + n, 2 + k])
        last = 2 + count * (len(rings) - 1)
        faces.append([1, last + k, last + n])
        for ring in range(len(rings) - 1):
            a, b = 2 + count * ring, 2 + count * (ring + 1)
            faces += [[a + k, a + n, b + n], [a + k, b + n, b + k]]
    return shapes.Shape(np.array(points), None, np.array(faces))


def bush() -> shapes.Shape:
    """A flanged shaft with a fillet and a chamfer."""
    fillet = [(0.5 + 0.15 * (1 - np.sin(a)), 0.2 + 0.15 * (1 - np.cos(a))) for a in np.linspace(0, np.pi / 2, 6)]
    return lathe([(0, 0), (0.4, 0), (1, 0), (1, 0.2), *fillet, (0.5, 0.7), (0.5, 0.9), (0.4, 1.0), (0.2, 1.0), (0, 1.0)])


def block(low: Any, high: Any, turned: float = 0.0, cuts: int = 3) -> shapes.Shape:
    """A box whose sides are cut into squares."""
    points: List[Any] = []
    faces: List[List[int]] = []
    low, high = np.asarray(low, float), np.asarray(high, float)
    for axis in range(3):
        for end in (0, 1):
            first = len(points)
            for i in range(cuts + 1):
                for j in range(cuts + 1):
                    p = np.zeros(3)
                    p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = end, i / cuts, j / cuts
                    points.append(low + p * (high - low))
            for i in range(cuts):
                for j in range(cuts):
                    a = first + i * (cuts + 1) + j
                    b, c, d = a + cuts + 1, a + cuts + 2, a + 1
                    quad = [[a, b, c], [a, c, d]]
                    faces += quad if end else [face[::-1] for face in quad]
    c, s = np.cos(turned), np.sin(turned)
    return shapes.Shape(np.array(points) @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]), None, np.array(faces))


def together(*parts: shapes.Shape) -> shapes.Shape:
    first = np.cumsum([0] + [len(part.points) for part in parts])
    faces = [part.triangles + at for part, at in zip(parts, first)]
    return shapes.Shape(np.concatenate([part.points for part in parts]), None, np.concatenate(faces))


def crossing() -> shapes.Shape:
    """Two beams that cross, and a separate ball."""
    ball = datasets.sphere(300, radius=0.35, mesh=True)
    away = shapes.Shape(ball.points + [0.0, 0.0, 0.9], None, ball.triangles)
    return together(block([-1, -0.2, -0.2], [1, 0.2, 0.2]), block([-0.2, -1, -0.15], [0.2, 1, 0.25], 0.3), away)


def folded_roof() -> shapes.Shape:
    """An open mesh with an edge along its middle and a curved end."""
    u, v = np.meshgrid(np.linspace(-1, 1, 21), np.linspace(-1, 1, 21), indexing="ij")
    z = 0.6 - 0.5 * np.abs(u) + 0.1 * np.sin(3 * v)
    points = np.column_stack([u.ravel(), v.ravel(), z.ravel()])
    faces = [[i * 21 + j, (i + 1) * 21 + j, (i + 1) * 21 + j + 1] for i in range(20) for j in range(20)]
    faces += [[i * 21 + j, (i + 1) * 21 + j + 1, i * 21 + j + 1] for i in range(20) for j in range(20)]
    return shapes.Shape(points, None, np.array(faces))


def kinect() -> Any:
    """Returns the image of a ball before a wall from a depth camera, with noise and steps."""
    row, column = np.indices((60, 80))
    u, v = (column - 40) / 80, (row - 30) / 80
    z = 4.0 / (1 - 0.1 * u + 0.05 * v)
    along, middle = u * u + v * v + 1, 0.3 * u + 1.5
    inside = middle**2 - along * (0.3**2 + 1.5**2 - 0.3**2)
    z = np.where(inside > 0, (middle - np.sqrt(np.maximum(inside, 0))) / along, z)
    seen = 1 / z + 0.0014 * np.random.default_rng(3).normal(size=z.shape)
    seen = 0.0029 * np.round(seen / 0.0029)
    return np.stack([u / seen, v / seen, 1 / seen], axis=-1)


def noisy(shape: shapes.Shape, share: float, seed: int = 1) -> shapes.Shape:
    size = np.linalg.norm(np.ptp(shape.points, axis=0))
    noise = np.random.default_rng(seed).normal(size=shape.points.shape)
    return shapes.Shape(shape.points + share * size * noise)


def bracket() -> hrbfnpr.Model:
    body = csg.box((2, 1.2, 0.3)) | csg.box((0.3, 1.2, 1.2), (-0.85, 0, 0.45))
    body = body - csg.cylinder(0.3, 1, (0.45, 0, 0)) - csg.cylinder(0.2, 1, (-0.85, 0, 0.6), (1, 0, 0))
    return body.blend(csg.torus(0.42, 0.1, (0.45, 0, 0.15)), 0.08) & csg.sphere(1.2, (0, 0, 0.2))


def heart_function(points: Any) -> Any:
    """Taubin's heart times 0.3, whose gradient is far from 1."""
    x, y, z = (np.asarray(points) / 0.3).T
    return (x * x + 2.25 * y * y + z * z - 1) ** 3 - x * x * z**3 - 0.1125 * y * y * z**3


# ---- Models and marks that are made once


class Kept:
    """Models and marks that are made once and saved in a folder."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._made: Dict[str, Any] = {}

    def mesh(self, number: int) -> hrbfnpr.Mesh:
        """A mesh of `bench_edges --only=verdict --save=DIR`."""
        if number not in self._made:
            lines = [line.split() for line in (self._folder / "meshes" / f"{number:03d}.obj").read_text().splitlines()]
            points = np.array([line[1:] for line in lines if line[0] == "v"], float)
            faces = np.array([line[1:] for line in lines if line[0] == "f"], int) - 1
            self._made[number] = points, faces
        return hrbfnpr.Mesh(*self._made[number])

    def model(self, name: str) -> hrbfnpr.Model:
        if name not in self._made:
            file = self._folder / f"{name}.hrbf"
            if not file.exists():
                made: hrbfnpr.Model = MODELS[name]()
                made.save(str(file))
            self._made[name] = hrbfnpr.Model.load(str(file))
        return self._made[name]

    def marks(self, name: str, preset: str, **options: Any) -> hrbfnpr.PointSet:
        key = f"{name}-{preset}"
        if key not in self._made:
            file = self._folder / f"{key}.hrbm"
            if not file.exists():
                kinds = {} if preset == "random" else {"preset": preset}
                self.model(name).generate(**kinds, **options).save(str(file))
            self._made[key] = hrbfnpr.PointSet.load(str(file))
        return self._made[key]


def fit_of(shape: shapes.Shape, **options: Any) -> hrbfnpr.Model:
    return hrbfnpr.Model.fit(shape.points, shape.normals, **options)


def mesh_of(shape: shapes.Shape) -> hrbfnpr.Mesh:
    return hrbfnpr.Mesh(shape.points, shape.triangles)


MODELS: Dict[str, Callable[[], hrbfnpr.Model]] = {
    "heart": lambda: fit_of(datasets.heart(400)),
    "tori": lambda: fit_of(datasets.linked_tori(300)),
    "terrain": lambda: fit_of(datasets.terrain(400)).trim(),
    "bush": lambda: hrbfnpr.Model.fit_mesh(mesh_of(bush()), edges="sharp"),
    "roof": lambda: hrbfnpr.Model.fit_mesh(mesh_of(folded_roof()), edges="sharp"),
    "solid": bracket,
}


# ---- Results


def numbers(prefix: str, record: Any) -> Result:
    """Returns the numbers of an info, without times and memory."""
    found = {}
    for name in dir(record):
        value = getattr(record, name)
        if name.startswith("_") or not isinstance(value, (int, float)) or any(word in name for word in ("second", "byte", "residual")):
            continue
        found[f"{prefix}.{name}"] = float(value)
    return found


def drawn(name: str, picture: Any, format: str = "svg") -> Result:
    result: Result = {name: np.asarray(picture.image)[..., :3].copy()}
    for key, model in (("model", picture.model),):
        if model is not None:
            result.update(numbers(f"{name}.{key}", model.info))
            if model.mesh_fit is not None:
                result.update(numbers(f"{name}.mesh_fit", model.mesh_fit))
    result[f"{name}.notes"] = " ".join(sorted(str(note) for note in picture.notes)).encode()
    return result


def page(name: str, drawing: hrbfnpr.Drawing, **options: Any) -> Result:
    to = io.BytesIO()
    info = hrbfnpr.write_page(to, drawing, **options)
    return {f"{name}.file": to.getvalue(), **numbers(name, info)}


def fitted(name: str, model: hrbfnpr.Model) -> Result:
    result = {f"{name}.file": model.to_bytes(), **numbers(name, model.info)}
    if model.mesh_fit is not None:
        result.update(numbers(name, model.mesh_fit))
    return result


def draw(source: Any, style: str, name: str = "", **options: Any) -> Result:
    options = {"size": SIZE, "allow_blank": True, "progress": None, **options}
    return drawn(name or style, hrbfnpr.draw(source, style, **options))


def seen(model: hrbfnpr.Model, azimuth: float = 30.0) -> hrbfnpr.Camera:
    a, e = np.radians(azimuth), np.radians(20.0)
    direction = (-np.sin(a) * np.cos(e), -np.sin(e), -np.cos(a) * np.cos(e))
    return hrbfnpr.Camera.fit(model, direction=direction, size=(SIZE, SIZE))


# ---- Fits of points


@case
def fit_tolerance(kept: Kept) -> Result:
    shape = datasets.knot(1500)
    fine = fit_of(datasets.heart(1500), tolerance=0.002, maximum_centres=1200)
    return {**fitted("knot", fit_of(shape, tolerance=0.01, maximum_centres=900)), **fitted("heart", fine)}


@case
def fit_fine(kept: Kept) -> Result:
    """Fits with several rounds of centres, up to a tolerance or a number, and a fit of a thin plate with two close sides."""
    fine = fit_of(datasets.knot(2500), tolerance=0.003, maximum_centres=2000)
    counted = fit_of(datasets.heart(1500), maximum_centres=400)
    sampled = mesh_of(block([-1, -1, -0.03], [1, 1, 0.03], 0.3)).sample(1500)
    walls = hrbfnpr.Model.fit(np.asarray(sampled.points), np.asarray(sampled.normals), tolerance=0.01, maximum_centres=1000)
    return {**fitted("fine", fine), **fitted("counted", counted), **fitted("walls", walls)}


@case
def fit_noisy(kept: Kept) -> Result:
    shape = datasets.torus(1200)
    points = noisy(shape, 0.004).points
    chosen = hrbfnpr.Model.fit(points, shape.normals, tolerance=0.03, regularization="auto")
    return {**fitted("chosen", chosen), **fitted("all", hrbfnpr.Model.fit(points[:500], shape.normals[:500], regularization="auto"))}


@case
def fit_suspects(kept: Kept) -> Result:
    shape = datasets.torus(500)
    points, normals = shape.points.copy(), shape.normals.copy()
    points[::41] *= 1.4
    normals[7::53] *= -1.0
    dropped = hrbfnpr.Model.fit(points, normals, outliers="drop", flipped_normals="reorient")
    few = datasets.sphere(60)
    kernels = [fitted(k, fit_of(few, kernel=k)) for k in ("gaussian", "wendland-c2")]
    iterative = fit_of(datasets.heart(900), solver="iterative")
    return {**fitted("dropped", dropped), **kernels[0], **kernels[1], **fitted("iterative", iterative)}


@case
def fit_trimmed(kept: Kept) -> Result:
    shape = datasets.terrain(500)
    hole = np.linalg.norm(shape.points - shape.points.mean(axis=0), axis=1) > 0.3
    model = hrbfnpr.Model.fit(shape.points[hole], shape.normals[hole]).trim()
    return {**fitted("terrain", model), **numbers("trim", model.trim_info)}


# ---- Normals


def oriented(name: str, points: Any, **options: Any) -> Result:
    found = hrbfnpr.orient(points, **options)
    return {f"{name}.normals": found.normals.tobytes(), **numbers(name, found.info), f"{name}.sum": float(np.abs(found.normals).sum())}


def against(name: str, shape: shapes.Shape, points: Any = None, **options: Any) -> Result:
    """Returns the result with the share of right normals."""
    found = hrbfnpr.orient(shape.points if points is None else points, **options)
    cosine = np.sum(found.normals * shape.normals, axis=1)
    right = {f"{name}.right": float((cosine > 0).mean()), f"{name}.off": float(np.degrees(np.arccos(np.clip(np.abs(cosine), 0, 1))).mean())}
    return {f"{name}.normals": found.normals.tobytes(), **numbers(name, found.info), **right}


@case
def orient_clean(kept: Kept) -> Result:
    few = against("tori", datasets.linked_tori(400))
    return {**few, **against("sphere", datasets.sphere(100))}


@case
def orient_many(kept: Kept) -> Result:
    return against("knot", datasets.knot(2600))


@case
def orient_noisy(kept: Kept) -> Result:
    a, b = datasets.heart(700), datasets.linked_tori(500)
    return {**against("heart", a, noisy(a, 0.008).points), **against("tori", b, noisy(b, 0.015).points)}


@case
def orient_noisy_edges(kept: Kept) -> Result:
    mesh = mesh_of(block([-1, -0.6, -0.4], [1, 0.6, 0.4]))
    sampled = mesh.sample(1500)
    shape = shapes.Shape(np.asarray(sampled.points), np.asarray(sampled.normals))
    return against("box", shape, noisy(shape, 0.01).points)


@case
def orient_open(kept: Kept) -> Result:
    terrain = datasets.terrain(700)
    thin = datasets.terrain(500)
    both = np.concatenate([thin.points, thin.points + [0, 0.04, 0]])
    return {**against("terrain", terrain), **oriented("sheets", both)}


@case
def orient_given(kept: Kept) -> Result:
    shape = datasets.linked_tori(500)
    mixed = shape.normals.copy()
    mixed[shape.points[:, 0] > 1.2] *= -1.0
    turned = shape.normals * np.where(np.arange(500) % 2 == 0, 1.0, -1.0)[:, None]
    result = against("mixed", shape, normals=mixed)
    result.update(against("inward", shape, normals=-shape.normals))
    result.update(against("unoriented", shape, normals=turned[:, :]))
    wrong = np.random.default_rng(5).normal(size=shape.normals.shape)
    result.update(against("random", shape, normals=wrong))
    return result


@case
def orient_very_noisy(kept: Kept) -> Result:
    """Noise as large as the spacing of the samples, on a shape with flat faces and on a round one."""
    sampled = mesh_of(block([-1, -0.8, -0.6], [1, 0.8, 0.6])).sample(1200)
    box = shapes.Shape(np.asarray(sampled.points), np.asarray(sampled.normals))
    ball = datasets.sphere(1500)
    return {**against("box", box, noisy(box, 0.003).points), **against("ball", ball, noisy(ball, 0.03).points)}


@case
def orient_curves(kept: Kept) -> Result:
    turn = 2 * np.pi * np.arange(80) / 80
    rings = [np.column_stack([np.cos(turn), 0 * turn + y, np.sin(turn)]) * [1 + 0.2 * y, 1, 1] for y in np.linspace(-1, 1, 9)]
    return oriented("sections", np.concatenate(rings))


@case
def depth_image(kept: Kept) -> Result:
    smoothed = hrbfnpr.smooth_depth_image(kinect())
    return {"points": np.asarray(smoothed.points).tobytes(), **numbers("depth", smoothed.info),
            "depth.sum": float(np.nansum(smoothed.points[..., 2])), "depth.normals": float(np.abs(smoothed.normals).sum())}  # fmt: skip


@case
def rays(kept: Kept) -> Result:
    """Many rays on a fit, from one place and grazing."""
    shape = datasets.knot(1500)
    model = hrbfnpr.Model.fit(shape.points, shape.normals)
    random = np.random.default_rng(6)
    ends = random.uniform(-1.5, 1.5, size=(20000, 3))
    seen = model.cast_rays([0.0, 1.0, 8.0], ends - [0.0, 1.0, 8.0], maximum_hits=8)
    at = random.integers(0, len(shape.points), size=20000)
    along = np.cross(shape.normals[at], random.normal(size=(20000, 3)))
    starts = shape.points[at] + shape.normals[at] * random.uniform(-0.01, 0.01, size=(20000, 1)) - along
    grazing = model.cast_rays(starts, along, maximum_hits=8)
    on_mesh = model.cast_rays(starts, along, maximum_hits=8, line_set=hrbfnpr.LineSet(model))
    return {"seen.hits": float(seen.hits.sum()), "grazing.hits": float(grazing.hits.sum()),
            "seen.t": np.round(seen.t, 6).tobytes(), "grazing.t": np.round(grazing.t, 6).tobytes(),
            "on_mesh.t": np.round(on_mesh.t, 12).tobytes()}  # fmt: skip


@case
def shaded(kept: Kept) -> Result:
    """Occlusion and soft shadows of two shapes, one beside the other."""
    shape = datasets.knot(700)
    model = hrbfnpr.Model.fit(shape.points, shape.normals)
    marks = model.generate([hrbfnpr.Layer("stipples", budget=60000)])
    style = hrbfnpr.Style("stipple", ambient_sky=0.4, ambient_ground=0.1, light_space="world", light_shadow=1.0, light_softness=0.1,
                          curvature_contrast=0.4)  # fmt: skip
    other = np.eye(4)
    other[:3, 3] = [-1.5, 1.0, 2.0]
    lines = hrbfnpr.LineSet(model)
    items = [hrbfnpr.Item(marks, style, line_set=lines), hrbfnpr.Item(marks, style, line_set=lines, transform=other)]
    occluders = hrbfnpr.Occluders(items)
    for item in items:
        item.shading = hrbfnpr.Shading(occluders, item)
    drawing = hrbfnpr.Renderer().draw(items, hrbfnpr.Camera.fit(marks, size=(SIZE, SIZE)))
    return {"shaded": np.asarray(drawing.image())[..., :3].copy(), "shaded.shown": float(drawing.info.shown)}


# ---- Meshes


def mesh_case(name: str, shape: shapes.Shape, **options: Any) -> Result:
    mesh = mesh_of(shape)
    edges = mesh.edges(edges=options.get("edges", "auto"))
    model = hrbfnpr.Model.fit_mesh(mesh, **options)
    compared = model.compare(mesh, points=4000)
    return {**numbers(f"{name}.mesh", mesh.info), **numbers(f"{name}.edges", edges.info), **fitted(name, model),
            f"{name}.sharp": np.asarray(edges.sharp).tobytes(), f"{name}.patches": np.asarray(edges.patches).tobytes(),
            **numbers(f"{name}.compare", compared)}  # fmt: skip


@case
def mesh_organic(kept: Kept) -> Result:
    return mesh_case("knot", datasets.knot(600, mesh=True), maximum_centres=700)


@case
def mesh_cad(kept: Kept) -> Result:
    return mesh_case("bush", bush())


@case
def mesh_crossing(kept: Kept) -> Result:
    return mesh_case("crossing", crossing())


@case
def mesh_open(kept: Kept) -> Result:
    return {**mesh_case("roof", folded_roof()), **mesh_case("terrain", datasets.terrain(300, mesh=True), maximum_centres=250)}


@case
def mesh_dirty(kept: Kept) -> Result:
    """A mesh with slivers, doubled corners, noise, and faces that are turned inward."""
    shape = datasets.torus(300, mesh=True)
    points = shape.points[shape.triangles].reshape(-1, 3)
    points = points + 1e-9 * np.random.default_rng(2).normal(size=points.shape)
    faces = np.arange(len(points)).reshape(-1, 3)
    faces[::7] = faces[::7, ::-1]
    faces = np.concatenate([faces[5:], [[0, 1, 1], [0, 4, 8]]])
    sampled = mesh_of(shapes.Shape(points, None, faces)).sample(200)
    thin = block([-1, -1, -0.01], [1, 1, 0.01], 0.2, 6)
    return {**mesh_case("dirty", shapes.Shape(points, None, faces), maximum_centres=300),
            "dirty.samples": np.asarray(sampled.points).tobytes(), **mesh_case("plate", thin)}  # fmt: skip


@case
def mesh_scan(kept: Kept) -> Result:
    shape = datasets.heart(500, mesh=True)
    rough = shape.points + 0.006 * np.random.default_rng(4).normal(size=shape.points.shape)
    return mesh_case("rough", shapes.Shape(rough, None, shape.triangles), maximum_centres=400)


def verdicts(kept: Kept, which: List[int]) -> Result:
    """Returns the number of patches of meshes, their sharp edges and the patch of each face."""
    result: Result = {}
    for number in which:
        mesh = kept.mesh(number)
        edges = mesh.edges()
        result[f"{number}.creases"] = float(edges.info.patches)
        result[f"{number}.sharp"] = np.asarray(edges.sharp).tobytes()
        result[f"{number}.patches"] = np.asarray(edges.patches).tobytes()
    return result


@case
def verdict_smooth(kept: Kept) -> Result:
    return verdicts(kept, [1, 15, 25, 34, 43, 55, 57, 61, 62, 71, 92, 93, 94, 95, 98, 99, 159, 160])


@case
def verdict_flat(kept: Kept) -> Result:
    return verdicts(kept, [100, 101, 102, 103, 104, 105, 106, 107, 108, 110, 112, 129, 157])


@case
def verdict_parts(kept: Kept) -> Result:
    return verdicts(kept, [113, 116, 117, 121, 123, 125, 128, 130, 131, 132, 133, 134, 136, 137, 144, 145, 147, 149, 150, 154])


@case
def verdict_large(kept: Kept) -> Result:
    return verdicts(kept, [5, 58, 59, 79, 82, 85, 119, 135, 156, 158])


def part_case(number: int, **options: Any) -> None:
    def run(kept: Kept) -> Result:
        model = hrbfnpr.Model.fit_mesh(kept.mesh(number), tolerance=0.0, **options)
        return fitted(f"part{number}", model)

    CASES[f"mesh_part_{number}"] = run


for _number in (102, 106, 117, 119, 123, 125, 129, 132, 133, 134, 135, 136, 137, 138, 144, 149, 154, 156, 157):
    part_case(_number, edges="sharp", maximum_centres=600)


# ---- Any source to a picture


@case
def picture_points(kept: Kept) -> Result:
    heart = datasets.heart(500)
    raw = shapes.Shape(np.concatenate([heart.points, [[40.0, 0, 0], [-9999, -9999, -9999]]]))
    return draw(raw, "contour-and-stipple", marks=2000)


@case
def picture_normals(kept: Kept) -> Result:
    tori = datasets.linked_tori(500)
    normals = tori.normals.copy()
    normals[tori.points[:, 0] > 1.3] *= -1.0
    inward = shapes.Shape(tori.points, -tori.normals)
    return {**draw(shapes.Shape(tori.points, normals), "silhouette", "mixed"), **draw(inward, "silhouette", "inward")}


@case
def picture_open_points(kept: Kept) -> Result:
    terrain = datasets.terrain(400)
    return draw(shapes.Shape(terrain.points), "contour-and-stipple", marks=1500, viewpoint=(0, 9, 0))


@case
def picture_depth(kept: Kept) -> Result:
    points = kinect()
    shape = shapes.Shape(points.reshape(-1, 3), is_picture=True, image_shape=points.shape[:2], viewpoint=(0.0, 0.0, 0.0))
    return draw(shape, "contour-and-stipple", samples=500, marks=1500)


@case
def picture_mesh(kept: Kept) -> Result:
    return draw(datasets.knot(400, mesh=True), "engraving", marks=3000)


@case
def picture_cad(kept: Kept) -> Result:
    return {**draw(bush(), "contour-and-stipple", up="z"), **draw(crossing(), "silhouette", up="auto")}


@case
def picture_coarse(kept: Kept) -> Result:
    return draw(datasets.sphere(42, mesh=True), "hatch", marks=2000)


@case
def picture_terrain(kept: Kept) -> Result:
    return draw(datasets.terrain(400, mesh=True), "etching", lines="contour,border,valleys", marks=3000, max_centres=300)


@case
def picture_solid(kept: Kept) -> Result:
    return draw(bracket(), "engraving", marks=3000)


@case
def picture_bar(kept: Kept) -> Result:
    return draw(datasets.heart(300), "archaeological", scale_bar="mm", profile="yes", marks=2000)


@case
def sheet_views(kept: Kept) -> Result:
    from hrbfnpr.cli import main

    with tempfile.TemporaryDirectory() as folder:
        file, out = Path(folder) / "bush.obj", Path(folder) / "bush.svg"
        shape = bush()
        text = "".join(f"v {x} {y} {z}\n" for x, y, z in 20 * shape.points)
        file.write_text(text + "".join("f " + " ".join(str(i + 1) for i in face) + "\n" for face in shape.triangles))
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            main(["sheet-views", str(file), str(out), "--up", "z", "--section", "y", "--centre-lines", "--labels", "-q"])
        return {"sheet.file": out.read_bytes(), "sheet.bytes": float(out.stat().st_size)}


# ---- Marks


@case
def stipples(kept: Kept) -> Result:
    tori = kept.model("tori").generate(preset="stipple", budget=3000)
    heart = kept.model("heart").generate(preset="scientific-stipple", budget=1500)
    return {"tori.file": tori.to_bytes(), "heart.file": heart.to_bytes(), "tori.count": float(len(tori))}


@case
def stipples_open(kept: Kept) -> Result:
    marks = kept.model("terrain").generate(preset="stipple", budget=2000)
    sharp = kept.model("bush").generate(preset="stipple", budget=2000)
    return {"terrain.file": marks.to_bytes(), "bush.file": sharp.to_bytes(), "terrain.count": float(len(marks))}


@case
def hatching(kept: Kept) -> Result:
    heart = kept.model("heart").generate(preset="cross-hatch", budget=8000)
    tori = kept.model("tori").generate(preset="engraving", budget=6000)
    return {"heart.file": heart.to_bytes(), "heart.count": float(len(heart)), "tori.file": tori.to_bytes(), "tori.count": float(len(tori))}


@case
def hatching_sharp(kept: Kept) -> Result:
    bush_marks = kept.model("bush").generate(preset="engraving", budget=6000)
    roof = kept.model("roof").generate(preset="etching", budget=4000)
    return {"bush.file": bush_marks.to_bytes(), "bush.count": float(len(bush_marks)), "roof.file": roof.to_bytes()}


@case
def hatching_solid(kept: Kept) -> Result:
    marks = kept.model("solid").generate(preset="engraving", budget=6000)
    return {"solid.file": marks.to_bytes(), "solid.count": float(len(marks))}


@case
def stipples_many(kept: Kept) -> Result:
    """Many marks, and marks on a solid."""
    many = kept.model("heart").generate("stipples", budget=30000)
    solid = kept.model("solid").generate("stipples", budget=3000)
    return {"many.file": many.to_bytes(), "solid.file": solid.to_bytes(),
            "many.count": float(len(many)), "solid.count": float(len(solid))}  # fmt: skip


@case
def stipples_box(kept: Kept) -> Result:
    """A small surface in a large box."""
    heart = hrbfnpr.Model.from_function(heart_function, bounds=((-2.0, -2.0, -2.0), (2.0, 2.0, 2.0)))
    marks = heart.generate("stipples", budget=1000, seed_source="box", box_resolution=24)
    return {"heart.file": marks.to_bytes(), "heart.count": float(len(marks))}


@case
def stipples_density(kept: Kept) -> Result:
    by_curvature = kept.model("heart").generate("stipples", budget=2000, density="curvature", density_strength=0.9)
    several = kept.model("tori").generate(preset="full", budget=2000, shared_budget=3000, tone_ranges="in_turn")
    return {"heart.file": by_curvature.to_bytes(), "tori.file": several.to_bytes()}


@case
def hatching_guides(kept: Kept) -> Result:
    result: Result = {}
    for guide, weight in (("combing", 1.0), ("sections", 0.5), ("light", 0.7)):
        made = kept.model("heart").generate("hatch", budget=3000, guide=guide, guide_weight=weight)
        result.update({f"{guide}.file": made.to_bytes(), f"{guide}.count": float(len(made))})
    return result


@case
def published_seeds(kept: Kept) -> Result:
    model = kept.model("heart")
    box = model.generate("stipples", distribution="published", seed_source="box", levels=3)
    one = model.generate("stipples", distribution="published", seed_points=[[0.0, 0.0, 1.0]], levels=2)
    lines = model.generate("hatch", distribution="published", levels=2)
    return {"box.file": box.to_bytes(), "one.file": one.to_bytes(), "lines.file": lines.to_bytes()}


@case
def published(kept: Kept) -> Result:
    model = kept.model("tori")
    picture = hrbfnpr.draw(model, "full", size=SIZE, distribution="published", visibility="published", levels=3, allow_blank=True)
    return drawn("full", picture)


# ---- Frames and lines of the models and marks that are made once


def frames(kept: Kept, name: str, preset: str, budget: int, azimuths: Any = (30.0, 30.7), **fields: Any) -> Result:
    model, marks = kept.model(name), kept.marks(name, preset, budget=budget)
    style = hrbfnpr.Style(preset, **fields)
    lines = hrbfnpr.LineSet(model)
    renderer = hrbfnpr.Renderer()
    result: Result = {}
    for azimuth in azimuths:
        drawing = renderer.draw(hrbfnpr.Item(marks, style, line_set=lines), seen(model, azimuth))
        result[f"{name}.{preset}.{azimuth:g}"] = drawing.image()[..., :3].copy()
        result.update(numbers(f"{name}.{preset}.{azimuth:g}", drawing.info))
    return result


def frame_case(name: str, preset: str, budget: int) -> None:
    CASES[f"frame_{name}_{preset.replace('-', '_')}"] = lambda kept: frames(kept, name, preset, budget)


for _name, _preset, _budget in (
    ("heart", "engraving", 8000), ("heart", "cross-hatch", 8000), ("tori", "full", 6000), ("bush", "woodcut", 6000),
    ("terrain", "etching", 6000), ("tori", "sketch", 5000), ("solid", "blueprint", 3000), ("roof", "contour-and-stipple", 3000),
    ("tori", "xray", 2000), ("bush", "silhouette", 2000), ("tori", "combing", 4000), ("heart", "archaeological", 4000),
):  # fmt: skip
    frame_case(_name, _preset, _budget)


def lines_of(kept: Kept, name: str, kinds: Any, hidden: str = "dashed", **more: Any) -> Result:
    model, marks = kept.model(name), kept.marks(name, "xray", budget=2000)
    style = hrbfnpr.Style("xray")
    lines = hrbfnpr.LineSet(model, kinds, with_curvature=True, **more)
    drawing = hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, style, line_set=lines), seen(model))
    lines_drawn = drawing.polylines()
    return {f"{name}.lines": drawing.image()[..., :3].copy(), **numbers(f"{name}.set", lines.info), **numbers(f"{name}.drawing", drawing.info),
            f"{name}.polylines": repr(lines_drawn).encode()}  # fmt: skip


@case
def lines_smooth(kept: Kept) -> Result:
    return lines_of(kept, "heart", ["ridge", "valley", "parabolic"])


@case
def lines_soft(kept: Kept) -> Result:
    model, marks = kept.model("heart"), kept.marks("heart", "xray", budget=2000)
    lines = hrbfnpr.LineSet(model, hrbfnpr.Lines("soft_edge", lower=5.0, upper=10.0, shortest=0.0))
    drawing = hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, hrbfnpr.Style("silhouette"), line_set=lines), seen(model))
    return {"heart.soft": drawing.image()[..., :3].copy(), **numbers("heart.set", lines.info),
            "heart.polylines": repr(drawing.polylines()).encode()}  # fmt: skip


@case
def lines_tori(kept: Kept) -> Result:
    return lines_of(kept, "tori", ["ridge"])


@case
def lines_sharp(kept: Kept) -> Result:
    return lines_of(kept, "bush", [])


@case
def lines_solid(kept: Kept) -> Result:
    return lines_of(kept, "solid", [])


@case
def lines_border(kept: Kept) -> Result:
    return {**lines_of(kept, "roof", [], support=1.5), **lines_of(kept, "terrain", ["valley"], support=3.0)}


@case
def lines_own(kept: Kept) -> Result:
    turn = np.linspace(0, 2 * np.pi, 60)
    ring = 1.02 * np.column_stack([np.cos(turn), np.sin(turn), 0.2 * np.sin(3 * turn)])
    corner = np.array([[1.26, 0, 0.0], [1.0, 0.1, 0.25], [0.9, 0.3, 0.25], [0.8, 0.3, 0.2]])
    own = hrbfnpr.Lines(kind="own", polylines=[ring, corner])
    cut = hrbfnpr.Lines(kind="section", plane=(0, 0, 1), levels=[0.0, 0.1])
    return lines_of(kept, "tori", [own, cut])


@case
def frame_rays(kept: Kept) -> Result:
    """Hidden marks that are found by rays, with both sides of the surface drawn."""
    result: Result = {}
    for name, preset, budget in (("terrain", "etching", 6000), ("tori", "full", 6000)):
        model, marks = kept.model(name), kept.marks(name, preset, budget=budget)
        item = hrbfnpr.Item(marks, hrbfnpr.Style(preset), model=model, line_set=hrbfnpr.LineSet(model), sides="both")
        drawing = hrbfnpr.Renderer().draw(item, seen(model, 200.0))
        result[name] = drawing.image()[..., :3].copy()
        result.update(numbers(name, drawing.info))
    return result


@case
def frame_fields(kept: Kept) -> Result:
    """Styles with fields that presets do not use."""
    marks = kept.marks("tori", "full", budget=6000)
    result: Result = {}
    for name, fields in {
        "attenuated": {"hidden_lines": "attenuate", "attenuation_front": 2.0, "attenuation_back": 1.0},
        "shown": {"hidden_lines": "show", "tone": "none"},
        "published": {"visibility": "published", "tone_rule": "published", "tone_curve": "linear"},
        "overlap": {"splat_overlap": 3, "halo": 6.0, "tone_fade": 0.5},
    }.items():
        with contextlib.suppress(TypeError, AttributeError):
            style = hrbfnpr.Style("full", **fields)
            drawing = hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, style), seen(kept.model("tori")))
            result[name] = drawing.image()[..., :3].copy()
    random_marks = kept.marks("heart", "random", distribution="published", levels=4)
    drawing = hrbfnpr.Renderer().draw(hrbfnpr.Item(random_marks, hrbfnpr.Style("stipple")), seen(kept.model("heart")))
    result["random"] = drawing.image()[..., :3].copy()
    return result


@case
def lines_drawn(kept: Kept) -> Result:
    model = kept.model("heart")
    every = "contour,suggestive,ridges,valleys,apparent,parabolic,isophotes=0.3:0.6,section=x:2"
    return draw(model, "blueprint", lines=every, hidden="dashed", wobble=1.5, outline=1.5, far_lines=0.5, lit_lines=0.7, sharp_lines=2.0)


# ---- Files


@case
def vectors(kept: Kept) -> Result:
    result: Result = {}
    for name, preset in (("heart", "engraving"), ("tori", "full")):
        model, marks = kept.model(name), kept.marks(name, preset, budget=8000 if name == "heart" else 6000)
        drawing = hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, hrbfnpr.Style(preset), line_set=hrbfnpr.LineSet(model)), seen(model))
        result.update(page(f"{name}.svg", drawing, format="svg"))
        result.update(page(f"{name}.classes", drawing, format="pdf", widths="classes", dots="lines"))
        result.update(page(f"{name}.hpgl", drawing, format="hpgl"))
        result.update(page(f"{name}.gcode", drawing, format="gcode", single_pass=True))
        result.update(page(f"{name}.dxf", drawing, format="dxf", pens=[hrbfnpr.Pen("", 0.3)]))
        result.update(page(f"{name}.spirals", drawing, format="svg", dots="spirals", plot_order=True))
    return result


@case
def rasters(kept: Kept) -> Result:
    result: Result = {}
    for name, preset in (("heart", "engraving"), ("tori", "sketch")):
        model, marks = kept.model(name), kept.marks(name, preset, budget=8000 if name == "heart" else 5000)
        drawing = hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, hrbfnpr.Style(preset), line_set=hrbfnpr.LineSet(model)), seen(model))
        result[name] = drawing.image()[..., :3].copy()
        vertices = drawing.vertices()
        result[f"{name}.vertices"] = repr(vertices).encode()
    return result


# ---- Comparison


def summary(result: Result) -> Dict[str, Any]:
    """Returns a short form of a result for comparison: pictures, numbers, and checksums of files."""
    return {name: (zlib.crc32(value), len(value)) if isinstance(value, bytes) else value for name, value in result.items()}


def changes(before: Dict[str, Any], after: Dict[str, Any], least: float = 1e-3) -> List[str]:
    """Returns the differences: those of pictures first, then those of numbers, then those of files."""
    pictures, figures, files = [], [], []
    for name in sorted(before.keys() | after.keys()):
        a, b = before.get(name), after.get(name)
        if isinstance(a, np.ndarray) and isinstance(b, np.ndarray):
            if a.shape != b.shape:
                pictures.append((100.0, f"{name}: another size"))
            elif not np.array_equal(a, b):
                share = 100 * float((np.abs(a.astype(int) - b).max(axis=-1) > 8).mean())
                ink = 100 * (float((255.0 - b).sum()) / max(float((255.0 - a).sum()), 1.0) - 1)
                pictures.append((share, f"{name}: {share:.2g} % of the pixels" + (f", ink {ink:+.1f} %" if abs(ink) > 0.5 else "")))
        elif isinstance(a, float) and isinstance(b, float):
            off = abs(b - a) / max(abs(a), abs(b), 1e-300)
            if a != b and not (a != a and b != b) and off > least:
                figures.append((off, f"{name} {a:.4g} -> {b:.4g}"))
        elif a != b:
            files.append((0.0, f"{name} differs"))
    return [text for _, text in [*sorted(pictures, reverse=True), *sorted(figures, reverse=True), *files]]
