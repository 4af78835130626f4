# SPDX-License-Identifier: MIT
"""hrbfnpr-view: the scene of examples/README.md from settings, and sessions of a user as scripts."""

import ctypes
import io
import json
import os
import re
import shutil
import struct
import sys
import xml.etree.ElementTree

import run

try:
    from PIL import Image
except ImportError:
    Image = None

NAME = "viewer"
ALL_MARKS = True  # because the viewer turns the model

SCENE = {"hrbfnpr-settings": 1, "preset": "contour-and-stipple", "size": [run.WIDTH, run.HEIGHT]}


def version():
    return ""


def draw(work, library, examples):
    program = examples / "viewer" / "hrbfnpr-view"
    if not program.is_file():
        raise run.Missing("the examples were built without it (Debian: libsdl2-dev libimgui-dev libpng-dev nlohmann-json3-dev)")
    if Image is None:
        raise run.Missing("Python has no Pillow here, to look at its pictures with (Debian: python3-pil)")
    view = Viewer(program, work)
    check_schema(program, library)
    check_session(view)
    check_command_line(view, library)
    check_errors(view)
    return draw_scene(view, library)


class Viewer:
    """Runs the program with a script on a virtual screen."""

    def __init__(self, program, work):
        self.program, self.work = program, work

    def run(self, *lines, arguments=()):
        script = self.work / "script.txt"
        script.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return run.on_a_screen([self.program, "--size", "800x600", *arguments, "--script", script], cwd=self.work)

    def pixels(self, name):
        return read(self.work / name)

    def text(self, name):
        return (self.work / name).read_text(encoding="utf-8")


def check(what, holds):
    if not holds:
        raise run.Failed(what)


def read(path):
    """Width, height and RGBA bytes of an image file."""
    with Image.open(path) as image:
        return (*image.size, image.convert("RGBA").tobytes())


def ink_of(picture):
    """The mean darkness of a picture, from 0 to 1."""
    return sum(255 - value for value in picture[2][::4]) / 255 / (picture[0] * picture[1])


def check_schema(program, library):
    """The library reads every setting that the viewer knows."""
    schema = json.loads(run.run([program, "--print-schema"]))
    read = SettingsReader(library)
    for section, fields in schema.items():
        for field, kind in fields.items():
            said = read.error(section, {field: []})
            check(f"{section}.{field} is not known to the library: {said}", "no such field" not in said)
            if isinstance(kind, list) and all(isinstance(word, str) for word in kind):
                check(f"{section}.{field}: {said}", f"one of {', '.join(kind)}" in said)


class SettingsReader:
    """Calls hrbfnpr_settings_load of the library."""

    def __init__(self, library):
        self.library = ctypes.CDLL(str(library))
        self.library.hrbfnpr_layout.restype = ctypes.c_char_p
        layout = json.loads(self.library.hrbfnpr_layout(b"hrbfnpr_error"))
        offsets = {field["name"]: field["offset"] for field in layout["fields"]}
        self.message, self.failure = offsets["message"], ctypes.create_string_buffer(layout["size"])
        self.library.hrbfnpr_error_init(self.failure, layout["size"])
        self.context = ctypes.c_void_p()
        self.library.hrbfnpr_context_create(None, ctypes.byref(self.context), self.failure)

    def error(self, section, fields):
        """The error message for a section with these fields, or "" if the library reads them."""
        part, _, of_list = section.partition(".")
        text = io.BytesIO(json.dumps({"hrbfnpr-settings": 1, part: {of_list: [fields]} if of_list else fields}).encode())

        def give(_, to, size):
            data = text.read(size)
            ctypes.memmove(to, data, len(data))
            return len(data)

        read = ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64)(give)
        made = ctypes.c_void_p()
        if self.library.hrbfnpr_settings_load(self.context, read, None, ctypes.byref(made), self.failure) == 0:
            self.library.hrbfnpr_settings_release(made)
            return ""
        return self.failure.raw[self.message :].split(b"\0")[0].decode()


def python(library, *arguments, **options):
    """Runs Python with the package hrbfnpr on its path."""
    environment = {**os.environ, "HRBFNPR_LIBRARY": str(library), "PYTHONPATH": str(run.ROOT / "bindings" / "python")}
    return run.run([sys.executable, "-B", *arguments], env=environment, **options)


MESH_WORDS = """ply
format ascii 1.0
element vertex 8
property float x
property float y
property float z
element face 6
property list uchar int vertex_indices
end_header
"""


def cube():
    """A PLY file of a cube with six quadrilaterals."""
    corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    lines = [" ".join(map(str, corner)) for corner in corners]
    return MESH_WORDS + "\n".join([*lines, *("4 " + " ".join(map(str, face)) for face in faces)]) + "\n"


# The actions of a user in sequence, with a small model and few marks.
SESSION = """
wait
shot first.png
save first.json
drag 150 250 250 230
wait
save turned.json
save turned.png
brush darken
drag 160 460 380 450
wait
save painted.json
save painted.png
report
undo
brush off
wait
save undone.png
open Light
change style.light -1,0.2,0.1
wait
save lit.png
change style.light_shadow 1
wait
save shadowed.png
change style.occlusion_lights 1
wait
save shaded.json
shot shaded.png
turn 10
style silhouette
wait
save out.svg
save out.pdf
save out.hpgl
save out.gcode
save out.dxf
save out.hrbf
save out.hrbm
record turn-%02d.png 3 120 90
wait
style stipple
published
patches on
wait
report
open Marks
shot patches.png
step 150
wait
report
save published.json
published off
drop cube.ply
wait
report
load noisy.stl
wait-busy
cancel
wait
expect-cancelled
"""


def noisy_stl():
    """A surface with 7200 faces, whose fit takes long enough to be cancelled halfway."""
    sides, faces = 60, []
    height = [[0.3 * ((i * 7919 + j * 104729) % 97) / 97 for j in range(sides + 1)] for i in range(sides + 1)]
    for i in range(sides):
        for j in range(sides):
            a, b, c, d = ((x / 10, y / 10, height[x][y]) for x, y in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
            faces += [(a, b, c), (a, c, d)]
    body = b"".join(struct.pack("<12fH", 0, 0, 0, *sum(face, ()), 0) for face in faces)
    return bytes(80) + struct.pack("<I", len(faces)) + body


def check_session(view):
    (view.work / "cube.ply").write_text(cube(), encoding="ascii")
    (view.work / "noisy.stl").write_bytes(noisy_stl())
    few = {"hrbfnpr-settings": 1, "marks": {"layers": [{"kind": "stipples", "budget": 20000}]}}
    (view.work / "few.json").write_text(json.dumps(few), encoding="ascii")
    printed = view.run(*SESSION.strip().splitlines(), arguments=[run.SAMPLES, "--settings", "few.json"])
    times = re.search(r"frame: window ([\d.]+) ms, library ([\d.]+) ms", printed)
    check(f"there are no times of frames in {printed}", times)
    print(f"viewer: {times.group(0)}")
    first = view.pixels("first.png")
    panel, picture = first[2][4 * 100 :: 4 * first[0]], ink_of(first)  # a column of pixels through the panels
    check(f"the window is blank or black ({picture:.3f})", len(set(panel)) > 5 and 0.03 < picture < 0.6)
    eyes = [eye_of(json.loads(view.text(f"{name}.json"))["camera"]["view"]) for name in ("first", "turned")]
    check("a drag did not turn the model", sum((a - b) ** 2 for a, b in zip(*eyes)) > 0.1)
    check_paint(view, printed)
    check_exports(view)
    check_step(view, printed)
    bounds = [float(number) for number in re.findall(r"bounds: (.*)", printed)[-1].replace("to", "").split()]
    check(f"a cube that was dropped is not what is drawn, but {bounds}",
          all(abs(a - b) < 0.03 for a, b in zip(bounds, (0, 0, 0, 1, 1, 1))))


def eye_of(matrix):
    """The position of the eye for a view matrix in column-major order."""
    return [-sum(matrix[4 * axis + row] * matrix[12 + row] for row in range(3)) for axis in range(3)]


def check_paint(view, printed):
    turned, painted, undone = (view.pixels(f"{name}.png") for name in ("turned", "painted", "undone"))
    check(f"painting changed {ink_of(turned)} to {ink_of(painted)}", ink_of(painted) > 1.01 * ink_of(turned))
    check("undoing it did not bring the picture back", undone == turned)
    lit, shadowed, style = view.pixels("lit.png"), view.pixels("shadowed.png"), json.loads(view.text("shaded.json"))["style"]
    check(f"cast shadows changed {ink_of(lit)} to {ink_of(shadowed)}", ink_of(shadowed) > 1.02 * ink_of(lit))
    check(f"the settings have no shadow, but {style}", style["light_shadow"] == 1 and style["occlusion_lights"] == 1)
    dabs = json.loads(view.text("painted.json"))["paint"]
    check(f"{len(dabs)} dabs of a stroke", len(dabs) > 4 and f"dabs: {len(dabs)}" in printed)


def check_exports(view):
    root = xml.etree.ElementTree.fromstring(view.text("out.svg"))
    check("the SVG has no paths", any(element.tag.endswith("path") for element in root.iter()))
    begins = {"out.pdf": b"%PDF-1.5", "out.hpgl": b"IN", "out.gcode": b"", "out.dxf": b"999\n",
              "out.hrbf": b"\x89HRB", "out.hrbm": b"\x89HRB"}
    for name, begin in begins.items():
        data = (view.work / name).read_bytes()
        check(f"{name} is not what it should be: {data[:20]!r}", data.startswith(begin) and len(data) > 200)
    frames = [view.pixels(f"turn-{i:02d}.png") for i in range(3)]
    check("frames of a turntable are the same", len({frame[2] for frame in frames}) == 3 and frames[0][:2] == (120, 90))
    check("a file was left half written", not list(view.work.glob("*.part")))


def check_step(view, printed):
    """Figure 5: squares on the surface, and a step given by the user."""
    steps = re.findall(r"rho_0: (\S+) estimate (\S+)", printed)
    estimate = float(steps[1][1])
    check(f"no estimate of rho_0 in {steps}", estimate > 0 and float(steps[1][0]) == 0)
    check(f"the step was not set: {steps}", abs(float(steps[2][0]) / estimate - 1.5) < 1e-6)
    check("settings lost the step", json.loads(view.text("published.json"))["marks"]["initial_step"] > 0)
    width, _, pixels = view.pixels("patches.png")
    red = sum(pixels[i] > pixels[i + 1] + 60 and pixels[i] > pixels[i + 2] + 60 for i in range(0, len(pixels), 4))
    check(f"{red} pixels of squares are to be seen", red > 200 and width == 800)


def check_command_line(view, library):
    """With the viewer's settings the command line draws the same picture, bit for bit."""
    for name in ("turned", "painted"):
        picture = view.work / f"{name}-drawn.png"
        python(library, "-m", "hrbfnpr", "draw", run.SAMPLES, picture, "--settings", view.work / f"{name}.json",
               "--keep-marks", "-q")
        here, there = view.pixels(f"{name}.png")[2], read(picture)[2]
        differing = sum(a != b for a, b in zip(here, there))
        check(f"{name}.json: {differing} of {len(there)} bytes differ from the command line's picture",
              len(here) == len(there) and differing == 0)
    saved = view.work / "saved.json"
    python(library, "-m", "hrbfnpr", "draw", run.SAMPLES, view.work / "a.png", "--size", "300x200", "--marks", "5000",
           "--style", "engraving", "--separation", "0.1", "--save-settings", saved, "--keep-marks", "-q")
    view.run("wait", "save b.png", arguments=[run.SAMPLES, "--settings", saved])
    check("the viewer does not draw what the command line saved",
          view.pixels("b.png") == view.pixels("a.png"))


ERRORS = (
    ("short.ply", MESH_WORDS + "0 0 0\n", "line 10, vertex 1: the file ends"),
    ("header.ply", MESH_WORDS.rstrip(), "vertex 0: the file ends"),
    ("face.ply", cube().replace("4 1 3 7 5", "4 1 3 7 8"), "a face names vertex 8"),
    ("word.ply", cube().replace("1 1 1", "1 one 1"), "is not a number"),
    ("face.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "line 4"),
    ("cut.stl", "\0" * 80 + "\x05\0\0\0", "too short"),
    ("words.xyz", "0 0 0\n1 0\n", "line 2"),
    ("what.foo", "x", "python3 -m hrbfnpr"),
    ("what.json", '{"hrbfnpr-settings": 1, "style": {"radiuss": 1}}', "style.radiuss: there is no such field"),
    ("word.json", '{"hrbfnpr-settings": 1, "style": {"tone": "loud"}}', "style.tone: one of none, light"),
    ("type.json", '{"hrbfnpr-settings": 1, "style": {"paper": 3}}', "style.paper: a list of 4 numbers"),
    ("none.json", "{}", "this is not a settings file"),
    ("up.json", '{"hrbfnpr-settings": 1, "camera": {"eye": [0, 0, 1], "target": [0, 0, 0], "up": [0, 0, 1], "near_plane": 1, '
     '"vertical_angle": 1, "far_plane": 2}}', "up (0, 0, 1) is parallel to the direction of view"),
    ("half.json", "{", "this is not JSON"),
)


def check_errors(view):
    """Errors of files name the place and a remedy, and the window stays open."""
    lines = ["wait"]
    for name, text, words in ERRORS:
        (view.work / name).write_text(text, encoding="latin-1")
        lines += [f"drop {name}", "wait", f"expect {words}"]
    lines += ["load nowhere.ply", "wait", "shot message.png", "wait", "expect cannot be read", "save nowhere/x.png",
              "expect cannot be written", "save x.jpg", "expect the name must end in"]  # fmt: skip
    view.run(*lines)
    width, _, pixels = view.pixels("message.png")
    check("the message is not shown", any(pixels[i] > 100 > pixels[i + 1] + 40 for i in range(0, len(pixels) // 4, 4)))


def draw_scene(view, library):
    """Draws the scene with settings whose camera comes from a picture in Python."""
    code = (
        "import json, sys, hrbfnpr, numpy as np\n"
        "camera = hrbfnpr.draw(tuple(np.hsplit(np.loadtxt(sys.argv[1]), 2)), direction=(0, 1, -1), up=(0, 0, 1),\n"
        f"    size=({run.WIDTH}, {run.HEIGHT})).camera\n"
        "print(json.dumps([np.asarray(m).T.ravel().tolist() for m in (camera.view, camera.projection)]))\n"
    )
    matrices = json.loads(python(library, "-c", code, run.SAMPLES))
    settings = {**SCENE, "camera": dict(zip(("view", "projection"), matrices))}
    (view.work / "scene.json").write_text(json.dumps(settings), encoding="ascii")
    view.run("wait", "save scene.png", arguments=[run.SAMPLES, "--settings", "scene.json"])
    picture = view.work / "picture.rgba"
    picture.write_bytes(view.pixels("scene.png")[2])
    shutil.copy(view.work / "scene.png", view.work / "picture.png")
    return picture
