# SPDX-License-Identifier: MIT
"""Draws the scene of examples/README.md with a client and compares its picture with that of the plain C program.

    run.py CLIENT WORK LIBRARY REFERENCE EXAMPLES

CLIENT is a module of this folder, LIBRARY the shared library, REFERENCE the program of reference.c, and EXAMPLES the
folder with the built examples. Clients with BY_STEPS draw the scene that the C program makes step by step, those with
ALL_MARKS its scene with all marks. The last line of the output is `client NAME VERSION: RESULT`. The status is 77 if the
client is not installed.
"""

import importlib.util
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"
SAMPLES = EXAMPLES / "torus.xyzn"
WIDTH, HEIGHT = 640, 480
SKIPPED = 77  # CTest's SKIP_RETURN_CODE
PATIENCE = 120  # seconds after which a program counts as hanging


class Missing(Exception):
    """The client is not installed. The message names the package to install."""


class Failed(Exception):
    """The client is installed but fails."""


def need(program, package):
    """The path of a program; raises Missing if it is not installed."""
    path = shutil.which(program)
    if path is None:
        raise Missing(f"there is no {program} here (Debian: {package})")
    return path


def run(command, **options):
    """Runs a command; returns its output, or raises Failed with it. A hanging command is killed with its children."""
    command = [str(part) for part in command]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True,
                          **options) as process:
        try:
            printed, _ = process.communicate(timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            raise Failed(f"{' '.join(command)} still ran after {PATIENCE} seconds") from None
    if process.returncode != 0:
        raise Failed(f"{' '.join(command)} ended with {process.returncode}:\n{printed}")
    return printed


def on_a_screen(command, **options):
    """Runs a program with a window on its own virtual screen, rendered in software."""
    server = need("xvfb-run", "xvfb xauth")
    values = {**options.pop("env", os.environ), "LIBGL_ALWAYS_SOFTWARE": "1"}
    values.pop("WAYLAND_DISPLAY", None)
    # Without -noreset the server resets when its last window closes, which can make xvfb-run leave it running.
    return run([server, "-a", "-s", "-screen 0 800x600x24 -noreset", *command], env=values, **options)


def module(path):
    """Loads a module of another folder of tests."""
    path = ROOT / "tests" / path
    spec = importlib.util.spec_from_file_location(f"{path.parent.name}_{path.stem}", path)
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


def difference(picture, reference):
    """The difference of two pictures in words, or "" if they are equal."""
    if len(picture) != len(reference):
        return f"{len(picture)} bytes in place of {len(reference)}"
    differing = [i for i in range(len(picture)) if picture[i] != reference[i]]
    if not differing:
        return ""
    x, y = differing[0] // 4 % WIDTH, differing[0] // 4 // WIDTH
    return f"{len(differing)} of {len(picture)} bytes differ, the first at pixel {x}, {y}"


def main():
    name, work, library, reference, examples = sys.argv[1], *map(Path, sys.argv[2:6])
    sys.dont_write_bytecode = True
    client = importlib.import_module(name)
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    title = client.NAME
    try:
        title = f"{client.NAME} {client.version()}".strip()
        scene = ["steps"] if getattr(client, "BY_STEPS", False) else ["all"] if getattr(client, "ALL_MARKS", False) else []
        run([reference, SAMPLES, work / "reference.rgba", *scene])
        picture = client.draw(work, library.resolve(), examples)
    except Missing as missing:
        print(f"client {title}: skipped, {missing}")
        return SKIPPED
    except Failed as failed:
        print(failed)
        print(f"client {title}: failed")
        return 1
    differs = difference(Path(picture).read_bytes(), (work / "reference.rgba").read_bytes())
    print(f"client {title}: {differs or f'{WIDTH} x {HEIGHT}, equal byte for byte'}")
    return 1 if differs else 0


if __name__ == "__main__":
    sys.modules["run"] = sys.modules["__main__"]  # clients import run
    sys.exit(main())
