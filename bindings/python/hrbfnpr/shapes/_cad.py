# SPDX-License-Identifier: MIT
"""Reads the formats of CAD programs (STEP, IGES, BREP) as triangles, with DRAW, the test program of Open CASCADE."""
from __future__ import annotations

import os
import re
import shutil
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Dict, Optional

from ._optional import run
from ._shape import Shape, ShapeError, Vector
from ._stl import read_stl

UP: Vector = (0.0, 0.0, 1.0)
ENDINGS = {".step": "STEP", ".stp": "STEP", ".iges": "IGES", ".igs": "IGES", ".brep": "BREP", ".brp": "BREP"}
OTHERWISE = "FreeCAD exports it as STL"
_OFF = 5e-4  # largest distance between triangles and surface that is asked for, in diagonals
_BEND, _OTHERS = 12, (16, 20, 28)  # largest angle between triangles, in degrees; others to try if faces get no triangles
_READ = {
    "STEP": "ReadStep D model; XGetOneShape shape D",
    "IGES": "ReadIges D model; XGetOneShape shape D",
    "BREP": "restore model shape",
}
_SCRIPT = """pload MODELING XDE
{read}
if {{![isdraw shape]}} {{exit 2}}
lassign [bounding shape] a b c d e f
set across [expr {{sqrt(($d - $a)**2 + ($e - $b)**2 + ($f - $c)**2)}}]
proc meshed {{bend deflection}} {{
  global shape
  tclean shape
  incmesh shape $deflection -a $bend -parallel
  return [expr {{[regexp {{([0-9]+) empty}} [trinfo shape] all empty] ? $empty : 0}}]
}}
set deflection [expr {{{off} * $across}}]
set empty [meshed {bend} $deflection]
foreach other {{{others}}} {{
  if {{$empty == 0}} break
  set fewer [meshed $other $deflection]
  if {{$fewer < $empty}} {{set empty $fewer; break}}
  if {{$other == {last}}} {{meshed {bend} $deflection}}
}}
puts "without triangles: $empty"
if {{[regexp {{Maximal deflection ([-+.0-9e]+)}} [trinfo shape] all off]}} {{puts "off by: [expr {{100 * $off / $across}}]"}}
writestl shape model.stl
"""
_SAID = re.compile(rb"(?:\*+ *ERR\w*|Error|.*Exception|.*Could not open|Cannot|File was not)[^\n]*", re.I)


def read(path: Path) -> Shape:
    """Read a file as triangles."""
    with open(path, "rb") as file:
        form = _by_content(file.read(65536)) or ENDINGS[path.suffix.lower()]
    program = _program()
    if program is None:
        raise ShapeError(f"reading {form} files needs DRAW of Open CASCADE (occt-draw); without it, {OTHERWISE}")
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        shutil.copyfile(path, work / "model")  # a name without characters that are special in Tcl
        others = " ".join(map(str, _OTHERS))
        script = _SCRIPT.format(read=_READ[form], off=_OFF, bend=_BEND, others=others, last=_OTHERS[-1])
        (work / "read.tcl").write_text(script, "ascii")
        command = [program, "-b", "-f", "read.tcl"]
        done = run("Open CASCADE", command, OTHERWISE, folder, _with_plugins(program, work / "plugins"))
        made = work / "model.stl"
        if b"Mesh writing has been failed" in done.stdout:
            raise ShapeError("it has no faces: curves alone are not read from CAD files")
        if not made.exists():
            raise ShapeError(f"Open CASCADE cannot turn it into triangles{_reason(done.stdout + done.stderr)}; {OTHERWISE}")
        shape = read_stl(made.read_bytes())
    off = re.search(rb"off by: ([-+.0-9e]+)", done.stdout)
    how_near = f", at most {float(off[1]):.2g}% of the diagonal off" if off else ""
    notes = [*shape.notes, f"its surfaces were turned into triangles{how_near}"]
    empty = re.search(rb"without triangles: ([1-9]\d*)", done.stdout)
    if empty:
        notes.append(f"surfaces missing, as Open CASCADE fails on them: {int(empty[1])}; {OTHERWISE}")
    return replace(shape, format=form, up=UP, notes=tuple(notes))


def _by_content(head: bytes) -> Optional[str]:
    """The format by the first bytes, because the ending may be wrong; None if they do not tell."""
    if head.startswith(b"ISO-10303-21"):
        return "STEP"
    return "BREP" if b"CASCADE Topology" in head[:200] else None


def _program() -> Optional[str]:
    """The path of DRAW, or None.  Debian's program has its version in its name."""
    for name in ("DRAWEXE", "occt-draw"):
        if shutil.which(name):
            return shutil.which(name)
    folders = os.environ.get("PATH", os.defpath).split(os.pathsep)
    found = (str(path) for folder in folders if folder for path in sorted(Path(folder).glob("occt-draw-[0-9]*"), reverse=True))
    return next(found, None)


def _with_plugins(program: str, folder: Path) -> Dict[str, str]:
    """The environment in which DRAW finds its plugins.  It asks for names that Debian has only in a developer package."""
    environment = dict(os.environ)
    ldd = shutil.which("ldd")
    if ldd is None:
        return environment
    linked = re.search(rb"=> (\S+)/libTKDraw\.so", run("ldd", [ldd, program], OTHERWISE).stdout)
    if linked is None:
        return environment
    folder.mkdir()
    for library in sorted(Path(os.fsdecode(linked[1])).glob("libTK*.so.*")):
        name = folder / (library.name.split(".so.")[0] + ".so")
        if not name.exists():
            name.symlink_to(library)
    environment["LD_LIBRARY_PATH"] = os.pathsep.join(filter(None, [str(folder), os.environ.get("LD_LIBRARY_PATH")]))
    return environment


def _reason(said: bytes) -> str:
    found = _SAID.search(said)
    return "" if found is None else ": " + " ".join(found[0].decode(errors="replace").strip("* ").split())[:200]
