# SPDX-License-Identifier: MIT
"""Runs the commands.  A failure prints one line and returns an exit status."""
from __future__ import annotations

import dataclasses
import importlib
import json
import os
import sys
import time
from pathlib import Path
from typing import Any, Dict, List, Optional

import numpy as np

from .._context import Context, build_info
from .._errors import Error, OutOfMemoryError
from .._model import Model
from .._point_set import PointSet
from .._scene import BlankError
from .._sources import load_saved
from .._values import words_of
from ._clock import process_start
from ._grammar import build, options_of
from ._outputs import UsageError
from ._progress import Reporter


def main(argv: Optional[List[str]] = None) -> int:
    """Run a command line.

    Returns
    -------
    int
        The exit status: 0 after success, 1 after a failure, 2 if the command line is wrong, 3 if the picture would be
        blank, 130 after Ctrl-C.  `check` returns 0 if the file is fine, 1 with warnings, 2 if the file cannot be used.
    """
    start = process_start() if argv is None else time.monotonic()
    report = Reporter(quiet=True)
    try:
        arguments = build().parse_args(argv)
        work, context = _function_of(arguments.command), Context(arguments.threads or 0)
        report = Reporter(arguments.quiet, start, arguments.verbose)
        with np.errstate(all="ignore"):  # no warnings of NumPy: notes and errors report odd numbers
            return work(arguments, options_of(arguments), context, report) or 0
    except SystemExit as end:  # from argparse, after --help or wrong options
        return end.code if isinstance(end.code, int) else 0
    except UsageError as error:
        return _fail(str(error), 2)
    except BlankError as error:
        report.finish()
        return _fail(str(error), 3)
    except KeyboardInterrupt:
        return _fail("interrupted", 130)
    except BrokenPipeError:
        # Without this, Python prints an error when it flushes stdout at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except OutOfMemoryError as error:
        return _fail(f"out of memory: {error}; try fewer --samples or --marks", 1)
    except (Error, OSError, ValueError, ImportError) as error:
        return _fail(words_of(error), 1)
    except MemoryError:
        return _fail("out of memory", 1)


def _fail(message: str, code: int) -> int:
    print(f"hrbfnpr: error: {message}", file=sys.stderr)
    return code


def _function_of(name: str) -> Any:
    """The function that runs a command.  Its module is imported only now, which makes the start quick."""
    module, function = {
        "draw": ("_draw", "draw"), "csg": ("_draw", "draw"), "turntable": ("_turntable", "turn"),
        "sheet": ("_sheet", "draw_sheet"), "sheet-views": ("_surfaces", "views"), "fit": ("_surfaces", "fit"),
        "points": ("_surfaces", "points"), "info": ("_main", "_info"), "check": ("_main", "_check"),
    }[name]  # fmt: skip
    return getattr(importlib.import_module(f".{module}", __package__), function)


def _check(arguments: Any, options: Any, context: Context, report: Reporter) -> int:
    from ._check import check

    return check(Path(arguments.input), arguments.json, context, arguments.verbose)


def _describe(path: Path, context: Context) -> Dict[str, Any]:
    """The facts that `info` prints about a file."""
    from .. import shapes

    saved = load_saved(path, context)
    if saved is not None:
        kind = "model" if isinstance(saved, Model) else "point set"
        facts: Dict[str, Any] = {"file": str(path), "kind": kind, **dataclasses.asdict(saved.info)}
        if isinstance(saved, PointSet):
            facts["layers"] = [dataclasses.asdict(layer.info) for layer in saved.layers]
        return facts
    shape = shapes.read(path)
    return {
        "file": str(path),
        "kind": "mesh" if shape.is_mesh else "points",
        "format": shape.format,
        "points": len(shape.points),
        "triangles": 0 if shape.triangles is None else len(shape.triangles),
        "normals": shape.normals is not None,
        "bounds_min": shape.points.min(axis=0).tolist(),
        "bounds_max": shape.points.max(axis=0).tolist(),
    }


def _info(arguments: Any, options: Any, context: Context, report: Reporter) -> None:
    if arguments.input is None:
        facts = {**build_info(), **dataclasses.asdict(context.info)}
    else:
        try:
            facts = _describe(Path(arguments.input), context)
        except (Error, ValueError) as error:
            raise ValueError(f"{arguments.input}: {words_of(error)}") from error
    if arguments.json:
        print(json.dumps(facts, indent=2))
    else:
        _print_facts(facts, "")


def _print_facts(facts: Dict[str, Any], indent: str) -> None:
    for name, value in facts.items():
        if isinstance(value, dict):
            print(f"{indent}{name}:")
            _print_facts(value, indent + "  ")
        elif isinstance(value, (list, tuple)) and value and isinstance(value[0], dict):
            for i, part in enumerate(value):
                print(f"{indent}{name} {i}: " + ", ".join(f"{k} {v}" for k, v in part.items() if v))
        elif isinstance(value, (list, tuple)):
            print(f"{indent}{name}: " + ", ".join(f"{v:.6g}" if isinstance(v, float) else str(v) for v in value))
        else:
            print(f"{indent}{name}: {value:.6g}" if isinstance(value, float) else f"{indent}{name}: {value}")
