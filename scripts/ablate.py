# SPDX-License-Identifier: MIT
"""Moves each tuning constant of a room to half and to twice its value, and prints what changes.

    ablate.py ROOM [--only=TEXT] [--seconds=1] [--threads=2] [--benches] [BENCH [OPTIONS]]

ROOM is a folder of src with a tuning.h, such as `curves` or `mesh/pieces`, or `all`. --only chooses the constants whose names
contain TEXT. The sources are copied to build/ablate and compiled there once, with constants that can be set
(ablation_copy.py). The working tree is not changed.

Each constant is moved in the small cases of ablation_cases.py that read it, until one of them changes or --seconds are over.
Cases of the constant's room and quick cases come first. The constants that changed no case are then moved together in all
cases. With BENCH, the "name value" lines of that benchmark are compared instead of cases. With --benches, constants that change
no case are also moved in the benchmarks of their room (BENCHES).
"""

import json
import os
import re
import select
import subprocess
import sys
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import ablation_copy
from ablation_copy import Constant

ROOT = Path(__file__).resolve().parent.parent
COPY = ROOT / "build" / "ablate"
KEPT = COPY / "kept"
MESHES = KEPT / "meshes"
LIBRARY = COPY / "build" / "src" / "libhrbfnpr.so"
BENCHES: Dict[str, List[List[str]]] = {
    "creases": [["edges", "--only=pieces"]],
    "curves": [["lines", "--only=truth"]],
    "features": [["lines", "--only=features"]],
    "fit": [["fit"]],
    "frame/hatch": [["strokes", "--only=screen,ends"]],
    "frame/lines": [["lines", "--only=truth"]],
    "generate": [["support"]],
    "hatching": [["strokes", "--only=surface"]],
    "mesh": [["edges", "--only=pieces"]],
    "mesh/fit": [["edges", "--only=pieces"]],
    "mesh/pieces": [["edges", "--only=pieces"]],
    "orient": [["orient", "--only=clean"]],
    "output/raster": [["frame", "--only=tone"]],
    "output/vector": [["vector", "--only=dots,curves,lines"]],
    "stipples": [["sample"]],
    "surface": [["points"]],
    "visibility": [["lines", "--only=truth"]],
}
# The names of the cases of a room begin with one of these.
OWN_CASES: Dict[str, Tuple[str, ...]] = {
    "creases": ("lines_s", "hatching_s"),
    "curves": ("lines",),
    "features": ("lines",),
    "fit": ("fit",),
    "frame/depth_layers": ("frame",),
    "frame/hatch": ("frame",),
    "frame/lines": ("frame", "lines"),
    "frame/scene": ("frame",),
    "generate": ("stipples", "hatching"),
    "geometry": ("vectors",),
    "hatching": ("hatching",),
    "implicit": ("lines_s", "mesh"),
    "light": ("shaded",),
    "marks": ("hatching", "stipples", "frame"),
    "mesh": ("mesh", "verdict"),
    "mesh/fit": ("mesh",),
    "mesh/pieces": ("verdict", "mesh"),
    "orient": ("orient", "depth_image"),
    "output/raster": ("rasters", "frame"),
    "output/vector": ("vectors",),
    "picture": ("picture", "sheet"),
    "published": ("published",),
    "stipples": ("stipples",),
    "surface": ("rays",),
    "visibility": ("lines", "frame"),
}
# Matches names of values that depend on the machine, not on the picture.
TIMES = re.compile(r"(_ms|_s|seconds|_ns|ns_a_|_us|speed|growth|beside|bytes|fps|threads|time)")
LEAST_CHANGE = 1e-3  # smaller relative changes are not reported
# The time of a case is reported if it changes by more than this factor and by more than SLOWER_SECONDS.
SLOWER = 1.5
SLOWER_SECONDS = 0.05
TOGETHER = 20.0  # time limit of moving constants together, as a multiple of --seconds
PATIENCE = 8.0  # a case is killed after this many times its usual time, plus this many seconds


def value_of(text: str) -> float:
    """Returns the value of a constant that is written in C++."""
    plain = re.sub(r"(?<=[\d.])(F|L|U|UL|ULL)\b", "", text.replace("'", ""), flags=re.I)
    plain = re.sub(r"std::numbers::pi\b", "3.14159265358979", plain)
    plain = re.sub(r"std::size_t\{(\d+)\}", r"\1", plain)
    if "0x" in plain:
        return float.fromhex(plain)
    return float(eval(plain, {"__builtins__": {}}))  # only numbers and operators from the project's own sources


def moved(constant: Constant, factor: float) -> float:
    """Returns the value times the factor. Whole numbers stay whole and above 0."""
    value = value_of(constant.text) * factor
    return float(max(1, int(value))) if constant.is_whole else value


def pairs(output: str) -> Dict[str, float]:
    """Returns the "name value" lines of a benchmark, without times."""
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


def run(command: List[str], **options: Any) -> Tuple[int, str]:
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, **options)
    return done.returncode, done.stdout


class Built(NamedTuple):
    constants: List[Constant]
    fixed: Dict[str, List[str]]  # for each room, the constants that the compiler needs as constants


def prepare(benches: List[str]) -> Built:
    """Copies the sources, rewrites them and builds them."""
    stamp = COPY / "stamp"
    newest = max(file.stat().st_mtime for folder in ("src", "include", "bench") for file in (ROOT / folder).rglob("*"))
    if not stamp.exists() or stamp.stat().st_mtime < newest:
        ablation_copy.copy(ROOT, COPY)
        built = Built(*ablation_copy.rewrite(COPY / "src"))
        stamp.write_text(json.dumps(built))
        for file in KEPT.glob("*.*"):
            file.unlink()
    constants, fixed = json.loads(stamp.read_text())
    KEPT.mkdir(exist_ok=True)
    targets = sorted({"hrbfnpr", "bench_edges", *(f"bench_{bench}" for bench in benches)})
    for command in (
        ["cmake", "--preset", "release", "-S", str(COPY), "-B", str(COPY / "build"), "-DHRBFNPR_BENCH=ON",
         "-DHRBFNPR_TESTS=OFF", "-DHRBFNPR_EXAMPLES=OFF", "-DHRBFNPR_WERROR=OFF"],
        ["cmake", "--build", str(COPY / "build"), "--target", *targets],
    ):  # fmt: skip
        status, output = run(command, cwd=COPY)
        if status != 0:
            raise RuntimeError(output)
    if not MESHES.exists():
        MESHES.mkdir()
        run([str(COPY / "build" / "bench" / "bench_edges"), "--only=verdict", f"--save={MESHES}"])
    return Built([Constant(*row) for row in constants], fixed)


# ---- Cases


def environment(**more: str) -> Dict[str, str]:
    paths = os.pathsep.join([str(ROOT / "bindings" / "python"), str(ROOT / "scripts")])
    return {**os.environ, "HRBFNPR_LIBRARY": str(LIBRARY), "PYTHONPATH": paths, "OMP_WAIT_POLICY": "passive", **more}


class Worker:
    """A process that runs cases. It is started again after it was killed."""

    def __init__(self, threads: int) -> None:
        self._threads = threads
        self._process: Optional["subprocess.Popen[str]"] = None

    def ask(self, case: str, constants: List[Constant], factor: float) -> Dict[str, Any]:
        """Returns what changes in a case if these constants are moved."""
        if self._process is None:
            command = [sys.executable, "-B", str(ROOT / "scripts" / "ablation_worker.py"), str(KEPT), str(self._threads)]
            self._process = subprocess.Popen(
                command, env=environment(), text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE
            )
        assert self._process.stdin and self._process.stdout
        values = {c.name: moved(c, factor) for c in constants}
        asked = {"case": case, "set": values, "back": {c.name: value_of(c.text) for c in constants}}
        self._process.stdin.write(json.dumps(asked) + "\n")
        self._process.stdin.flush()
        patience = PATIENCE * usual_seconds([case])[case] + PATIENCE
        ready, _, _ = select.select([self._process.stdout], [], [], patience)
        line = self._process.stdout.readline() if ready else ""
        if line:
            answer: Dict[str, Any] = json.loads(line)
            return answer
        self.close()
        return {"changes": [f"{case}: " + ("ends with a crash" if ready else "does not end")], "seconds": 0.0, "usual": 0.0}

    def close(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            self._process = None


def used_by_cases(names: List[str]) -> Dict[str, List[str]]:
    """Returns the names of the constants that each case reads, and caches them in a file."""
    file = KEPT / "used.json"
    used: Dict[str, List[str]] = json.loads(file.read_text()) if file.exists() else {}
    for name in names:
        if name in used:
            continue
        worker = [sys.executable, "-B", str(ROOT / "scripts" / "ablation_worker.py"), str(KEPT), "--used", name]
        run(worker, env=environment())  # the first run makes the kept models, which read other constants
        done = subprocess.run(worker, env=environment(), stdout=subprocess.PIPE, text=True, check=True)
        used[name] = done.stdout.split()
        file.write_text(json.dumps(used))
    return used


def usual_seconds(cases: List[str]) -> Dict[str, float]:
    import pickle

    found = {}
    for case in cases:
        file = KEPT / f"{case}.pickle"
        found[case] = pickle.loads(file.read_bytes())["seconds"] if file.exists() else 1.0
    return found


class Moved(NamedTuple):
    """The effect of moving a constant."""

    changes: List[str]
    cases: int  # how many cases were run
    slower: float  # the largest ratio of a case's time to its usual time


def by_cases(worker: Worker, constant: Constant, factor: float, cases: List[str], seconds: float) -> Moved:
    """Runs cases until one changes or the time is over."""
    spent, slower, count = 0.0, 1.0, 0
    for case in cases:
        if spent > seconds:
            break
        answer = worker.ask(case, [constant], factor)
        count += 1
        spent += answer["seconds"] + answer["usual"]
        if answer["usual"] > 0.0 and abs(answer["seconds"] - answer["usual"]) > SLOWER_SECONDS:
            times = answer["seconds"] / answer["usual"]
            if max(times, 1.0 / times) > max(slower, 1.0 / slower):
                slower = times
        if answer["changes"]:
            return Moved([f"{case}: {text}" for text in answer["changes"][:3]], count, slower)
    return Moved([], count, slower)


def movers(worker: Worker, case: str, constants: List[Constant], factor: float) -> Dict[str, str]:
    """Returns the constants that change a case, by name, each with one change. Finds them by bisection."""
    if not constants:
        return {}
    found = worker.ask(case, constants, factor)["changes"]
    if not found:
        return {}
    if len(constants) == 1:
        return {constants[0].name: f"{case}: {found[0]}"}
    half = len(constants) // 2
    return {**movers(worker, case, constants[:half], factor), **movers(worker, case, constants[half:], factor)}


def by_all_cases(
    worker: Worker, idle: List[Constant], factor: float, used: Dict[str, List[str]], seconds: float
) -> Dict[str, str]:
    """Returns for each constant a change in the first case that it changes. Runs quick cases first, until the time is over."""
    found: Dict[str, str] = {}
    cost = usual_seconds(list(used))
    spent = 0.0
    for case in sorted(used, key=lambda name: cost[name]):
        spent += cost[case]
        if spent > seconds:
            break
        left = [c for c in idle if c.name not in found and c.name in used[case] and moved(c, factor) != value_of(c.text)]
        found.update(movers(worker, case, left, factor))
    return found


def by_benches(constant: Optional[Constant], value: float, benches: List[List[str]]) -> Dict[str, float]:
    """Returns the values of benchmarks with a constant moved. Raises RuntimeError if a benchmark fails."""
    found: Dict[str, float] = {}
    more = {"HRBFNPR_TUNE": f"{constant.name}={value!r}"} if constant else {}
    for name, *options in benches:
        status, output = run([str(COPY / "build" / "bench" / f"bench_{name}"), *options], env=environment(**more))
        if status != 0:
            raise RuntimeError(f"bench/{name} failed with status {status}: {output.splitlines()[-1:]}")
        found.update(pairs(output))
    return found


def told(result: Moved) -> str:
    text = "; ".join(result.changes) or "-"
    if max(result.slower, 1.0 / result.slower) > SLOWER:
        text += f" (time x {result.slower:.2g})"
    return text


def main(arguments: List[str]) -> int:
    options = dict(a[2:].split("=", 1) for a in arguments if re.match(r"--(only|seconds|threads)=", a))
    rest = [a for a in arguments if not re.match(r"--(only|seconds|threads)=", a)]
    if options.get("only") and len(rest) > 1:  # a later --only is an option of the benchmark
        mine = next(a for a in arguments if a.startswith("--only="))
        rest = [a for a in arguments if a != mine and not re.match(r"--(seconds|threads)=", a)]
        options["only"] = mine[len("--only=") :]
    with_benches = "--benches" in rest
    rest = [a for a in rest if a != "--benches"]
    if not rest or rest[0] in ("-h", "--help"):
        print(__doc__)
        return 0 if rest else 1
    room, bench = rest[0], rest[1:]
    benches = [bench] if bench else BENCHES.get(room, []) if with_benches else []
    seconds = float(options.get("seconds", "1"))
    built = prepare(sorted({name for name, *_ in benches}))
    constants = [c for c in built.constants if room in (c.room, "all") and options.get("only", "") in c.name]
    if not constants:
        print(f"ablate.py: src/{room} has no such constants; see --help", file=sys.stderr)
        return 1
    names = cases_there()
    used = {} if bench else used_by_cases(names)
    before = by_benches(None, 0.0, benches) if bench else {}
    confirmed: Dict[str, Dict[str, float]] = {}
    worker = Worker(int(options.get("threads", "2")))
    idle: List[Constant] = []
    print(f"{len(constants)} constants of {room}", flush=True)
    for constant in constants:
        if f"{constant.instance}.{constant.member}" in built.fixed.get(constant.room, []):
            print(f"{constant.name} = {constant.text}\n    not moved, because the compiler needs it as a constant", flush=True)
            continue
        own = OWN_CASES.get(constant.room, ())
        cost = usual_seconds(names)
        mine = sorted(
            (case for case in used if constant.name in used[case]),
            key=lambda case: (not case.startswith(own), cost[case]),  # noqa: B023
        )
        texts = []
        for factor in (0.5, 2.0):
            value = moved(constant, factor)
            if value == value_of(constant.text):
                texts.append("-")
            elif bench:
                try:
                    texts.append("; ".join(changes(before, by_benches(constant, value, benches))) or "-")
                except RuntimeError as problem:
                    texts.append(str(problem))
            else:
                texts.append(told(by_cases(worker, constant, factor, mine, seconds)))
        if not bench and all(text.startswith("-") for text in texts) and benches:
            key = json.dumps(benches)
            if key not in confirmed:
                confirmed[key] = by_benches(None, 0.0, benches)
            for k, factor in enumerate((0.5, 2.0)):
                try:
                    found = changes(confirmed[key], by_benches(constant, moved(constant, factor), benches))
                    texts[k] = "; ".join(found) or texts[k]
                except RuntimeError as problem:
                    texts[k] = str(problem)
        seen = "" if bench else f", read by {len(mine)} cases"
        print(f"{constant.name} = {constant.text}{seen}\n    half:  {texts[0]}\n    twice: {texts[1]}", flush=True)
        if all(text == "-" for text in texts):
            idle.append(constant)
    if idle and not bench:
        print("\nin all cases:", flush=True)
        for factor, word in ((0.5, "half"), (2.0, "twice")):
            for name, text in by_all_cases(worker, idle, factor, used, TOGETHER * seconds).items():
                print(f"{name} {word}: {text}", flush=True)
                idle = [c for c in idle if c.name != name]
    worker.close()
    print(f"\nconstants without effect: {', '.join(c.name for c in idle) or 'none'}", flush=True)
    return 0


def cases_there() -> List[str]:
    """Returns the names of all cases."""
    code = "import ablation_cases; print(*ablation_cases.CASES)"
    done = subprocess.run([sys.executable, "-B", "-c", code], env=environment(), stdout=subprocess.PIPE, text=True, check=True)
    return done.stdout.split()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
