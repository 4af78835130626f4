# SPDX-License-Identifier: MIT
"""Moves each tuning constant of a room to half and to twice its value, and prints what changes in the room's benchmarks.

    ablate.py ROOM [--only=TEXT] [BENCH [OPTIONS]]

ROOM is a folder of src with a tuning.h, such as `curves` or `mesh/pieces`.  The benchmarks are those of BENCHES, or BENCH
with its options.  --only takes the constants whose name contains TEXT.  The sources are copied to build/ablate first, and
compiled there: the working tree stays as it is.  Times are not compared.
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Dict, Iterator, List, NamedTuple, Tuple

ROOT = Path(__file__).resolve().parent.parent
COPY = ROOT / "build" / "ablate"
BENCHES: Dict[str, List[List[str]]] = {
    "creases": [["edges", "--only=pieces"]],
    "curves": [["lines", "--only=truth,views"]],
    "features": [["lines", "--only=features"]],
    "fit": [["fit"]],
    "frame/hatch": [["strokes", "--only=screen,ends,tone"]],
    "frame/lines": [["lines", "--only=truth,flicker"]],
    "frame/scene": [["frame", "--only=tone"]],
    "frame/depth_layers": [["frame", "--only=tone,pops"]],
    "generate": [["support"]],
    "hatching": [["strokes", "--only=surface"]],
    "marks": [["strokes", "--only=surface"], ["frame", "--only=tone"]],
    "mesh": [["edges", "--only=verdict,pieces"]],
    "mesh/fit": [["edges", "--only=pieces"]],
    "mesh/pieces": [["edges", "--only=verdict,pieces"]],
    "orient": [["orient", "--only=clean,noisy"]],
    "output/raster": [["frame", "--only=tone"]],
    "output/vector": [["vector", "--only=dots,curves,lines"]],
    "stipples": [["sample"], ["frame", "--only=tone"]],
    "visibility": [["lines", "--only=truth,views"]],
}
# Names of values that depend on the machine and not on the picture.
TIMES = re.compile(r"(_ms|_s|seconds|_ns|ns_a_|_us|speed|growth|beside|bytes|fps|threads|time)")
MEMBER = re.compile(
    r"^(?P<before>\s+(?P<type>double|float|int|std::u?int\w+_t|std::size_t) (?P<name>\w+) = )"
    r"(?P<value>[-+\d.'e]+)(?P<after>f?U?L?L?;.*)$"
)
LEAST_CHANGE = 1e-3  # relative; smaller ones are not told


class Constant(NamedTuple):
    """A member of a tuning struct."""

    file: Path
    line: int
    name: str
    is_whole: bool
    value: float

    def moved(self, factor: float) -> str:
        """The value times the factor, as C++ has it; whole numbers stay whole and above 0."""
        value = self.value * factor
        if self.is_whole:
            return str(max(1, int(value)))
        return repr(value)


def constants_of(file: Path) -> Iterator[Constant]:
    for number, line in enumerate(file.read_text().splitlines()):
        found = MEMBER.match(line)
        if found:
            is_whole = found["type"] not in ("double", "float")
            yield Constant(file, number, found["name"], is_whole, float(found["value"].replace("'", "")))


def replaced(text: str, constant: Constant, value: str) -> str:
    """The text of the constant's file with another value."""
    lines = text.split("\n")
    found = MEMBER.match(lines[constant.line])
    assert found and found["name"] == constant.name
    lines[constant.line] = found["before"] + value + found["after"]
    return "\n".join(lines)


def pairs(output: str) -> Dict[str, float]:
    """The "name value" lines of a benchmark, but for times."""
    found = {}
    for line in output.splitlines():
        words = line.split()
        if len(words) == 2 and "." in words[0] and not TIMES.search(words[0]):
            try:
                found[words[0]] = float(words[1])
            except ValueError:
                pass
    return found


def changes(before: Dict[str, float], after: Dict[str, float]) -> List[str]:
    told = []
    for name in sorted(before.keys() | after.keys()):
        a, b = before.get(name, float("nan")), after.get(name, float("nan"))
        if a == b or abs(b - a) <= LEAST_CHANGE * max(abs(a), abs(b)):
            continue
        told.append(f"{name} {a:.4g} -> {b:.4g}")
    return told


def run(command: List[str], **options: object) -> Tuple[int, str]:
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, **options)
    return done.returncode, done.stdout


def measured(benches: List[List[str]]) -> Dict[str, float]:
    """Builds the benchmarks and runs them; raises RuntimeError with what went wrong."""
    found: Dict[str, float] = {}
    for name, *options in benches:
        status, output = run(["cmake", "--build", str(COPY / "build"), "--target", f"bench_{name}"])
        if status != 0:
            raise RuntimeError("does not compile")
        status, output = run([str(COPY / "build" / "bench" / f"bench_{name}"), *options])
        if status != 0:
            raise RuntimeError(f"bench/{name} ends with status {status}: {output.splitlines()[-1:]}")
        found.update(pairs(output))
    return found


def prepare() -> None:
    """Copies the sources and configures a build of the benchmarks."""
    for folder in ("src", "include", "bench", "tests", "cmake", "bindings"):
        shutil.copytree(ROOT / folder, COPY / folder, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__"))
    for file in ("CMakeLists.txt", "CMakePresets.json"):
        shutil.copy(ROOT / file, COPY / file)
    status, output = run(
        ["cmake", "--preset", "release", "-B", str(COPY / "build"), "-DHRBFNPR_BENCH=ON", "-DHRBFNPR_TESTS=OFF",
         "-DHRBFNPR_EXAMPLES=OFF", "-DPython3_EXECUTABLE=/usr/bin/python3"], cwd=COPY)  # fmt: skip
    if status != 0:
        raise RuntimeError(output)


def main(arguments: List[str]) -> int:
    wanted = [a[len("--only=") :] for a in arguments if a.startswith("--only=")][:1]
    rest = [a for a in arguments if not (wanted and a == f"--only={wanted[0]}")]
    if not rest or rest[0] in ("-h", "--help"):
        print(__doc__)
        return 0 if rest else 1
    room, bench = rest[0], rest[1:]
    files = sorted((ROOT / "src" / room).glob("*tuning*.h"))
    if not files:
        print(f"src/{room} has no tuning.h", file=sys.stderr)
        return 1
    benches = [bench] if bench else BENCHES.get(room)
    if not benches:
        print(f"no benchmark is known for {room}: name one", file=sys.stderr)
        return 1
    prepare()
    constants = [c for file in files for c in constants_of(COPY / file.relative_to(ROOT)) if not wanted or wanted[0] in c.name]
    before = measured(benches)
    print(f"{len(constants)} constants of src/{room}; {len(before)} values of {', '.join(' '.join(b) for b in benches)}")
    idle = []
    for constant in constants:
        text = constant.file.read_text()
        told = []
        for factor in (0.5, 2.0):
            constant.file.write_text(replaced(text, constant, constant.moved(factor)))
            try:
                found = changes(before, measured(benches))
                told.append("; ".join(found) if found else "-")
            except RuntimeError as problem:
                told.append(str(problem))
            finally:
                constant.file.write_text(text)
        print(f"{constant.name} = {constant.value:g}\n    half:  {told[0]}\n    twice: {told[1]}", flush=True)
        if told == ["-", "-"]:
            idle.append(constant.name)
    print(f"\nwithout effect on these: {', '.join(idle) if idle else 'none'}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
