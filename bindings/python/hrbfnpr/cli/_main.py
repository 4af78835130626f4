# SPDX-License-Identifier: MIT
"""Runs the commands; failures are one line and an exit code."""
from __future__ import annotations

import dataclasses
import json
import os
import sys
import time
from pathlib import Path
from typing import Any, Dict, List, Optional

import numpy as np

from .._context import Context, build_info
from .._errors import Error, OutOfMemoryError
from .._layer import Layer
from .._model import Model
from .._point_set import PointSet
from ._blank import BlankError
from ._clock import process_start
from ._inputs import Loaded, load, load_saved
from ._options import build
from ._outputs import check as check_output
from ._outputs import check_all, check_drawing, check_picture, check_saved
from ._progress import Reporter
from ._values import words_of


class UsageError(Exception):
    """Options that do not go together; exit code 2."""


def main(argv: Optional[List[str]] = None) -> int:
    """Run a command line.

    Returns
    -------
    int
        0; 1 after a failure; 2 for a wrong command line; 3 where a picture would be blank; 130 after Ctrl-C.
        Of `check`: 0, 1 with warnings, 2 if the file cannot be used.
    """
    start = process_start() if argv is None else time.monotonic()
    report = Reporter(quiet=True)
    try:
        arguments = build().parse_args(argv)
        report = Reporter(arguments.quiet, start=start)
        return _run(arguments, report)
    except SystemExit as end:  # argparse, for --help and wrong options
        return end.code if isinstance(end.code, int) else 0
    except UsageError as error:
        return _fail(str(error), 2)
    except BlankError as error:
        report.finish()
        return _fail(str(error), 3)
    except KeyboardInterrupt:
        return _fail("interrupted", 130)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # or Python complains at its end
        return 1
    except OutOfMemoryError as error:
        return _fail(f"out of memory: {error}; fewer --samples or --marks need less", 1)
    except (Error, OSError, ValueError, ImportError) as error:
        return _fail(words_of(error), 1)
    except MemoryError:
        return _fail("out of memory", 1)


def _fail(message: str, code: int) -> int:
    print(f"hrbfnpr: error: {message}", file=sys.stderr)
    return code


def _run(arguments: Any, report: Reporter) -> int:
    context = Context(arguments.threads or 0, log=report.logged, log_level="warning")
    commands = {"draw": _draw, "csg": _draw, "turntable": _turntable, "sheet": _sheet, "sheet-views": _sheet_views,
                "fit": _fit, "points": _points, "info": _info, "check": _check}  # fmt: skip
    with np.errstate(all="ignore"):  # what comes of odd numbers is said in words
        return commands[arguments.command](arguments, context, report) or 0


def _load(arguments: Any, context: Context, report: Reporter) -> Loaded:
    path = Path(arguments.input)
    try:
        return load(path, arguments, context, report)
    except (Error, ValueError) as error:
        if isinstance(error, (OutOfMemoryError,)):
            raise
        raise ValueError(f"{path}: {words_of(error)}") from error


def _draw(arguments: Any, context: Context, report: Reporter) -> None:
    from ._draw import draw, outputs_of
    from ._settings_use import apply
    from ._vectors import given, is_vector

    outputs = outputs_of(arguments)
    check_all(arguments, outputs)
    if arguments.settings:
        apply(arguments)
    if not any(is_vector(path) for path in outputs) and (unused := given(arguments)):
        raise UsageError(f"{', '.join(unused)} is of vectors, and no file is: name one that ends in .svg, .pdf, .hpgl or "
                         ".gcode")  # fmt: skip
    draw(arguments, _load(arguments, context, report), context, report)


def _turntable(arguments: Any, context: Context, report: Reporter) -> None:
    from .._movies import check_movie
    from ._turntable import output_of, turn

    output = output_of(arguments)
    check_movie(output, arguments.fps)
    check_output(output)
    turn(arguments, output, _load(arguments, context, report), context, report)


def _sheet(arguments: Any, context: Context, report: Reporter) -> None:
    from ._sheet import draw_sheet, output_of

    output = output_of(arguments)
    check_picture(output)
    loaded = _load(arguments, context, report)
    if not isinstance(loaded.content, Model):
        raise UsageError(f"{arguments.input} holds a point set; a sheet is drawn of samples or of a model")
    arguments.up, arguments.input_shape = loaded.up, loaded.shape
    arguments.has_end = isinstance(loaded.content, Model) and loaded.content.trim_info.is_trimmed
    draw_sheet(arguments, output, loaded.content, context, report)


def _sheet_views(arguments: Any, context: Context, report: Reporter) -> None:
    from ._sheet_views import draw_views, output_of

    output = output_of(arguments)
    check_drawing(output)
    loaded = _load(arguments, context, report)
    if not isinstance(loaded.content, Model):
        raise UsageError(f"{arguments.input} holds a point set; views are drawn of samples or of a model")
    draw_views(arguments, output, loaded, loaded.content, context, report)


def _fit(arguments: Any, context: Context, report: Reporter) -> None:
    check_saved(arguments.output, "model")
    model = _load(arguments, context, report).content
    if not isinstance(model, Model):
        raise UsageError(f"{arguments.input} holds a point set; a model is fitted to samples")
    with report.stage("write", "writing") as stage:
        model.save(arguments.output)
        stage.says = arguments.output
    report.summary(f"{arguments.output}: {model.info.centres} centres, {model.info.kernel}")


def _points(arguments: Any, context: Context, report: Reporter) -> None:
    from .._scene import generate, make_layers

    check_saved(arguments.output, "point set", ".ply")
    model = _load(arguments, context, report).content
    if not isinstance(model, Model):
        raise UsageError(f"{arguments.input} holds a point set already")
    layers = [Layer(kind) for kind in arguments.layers or ("stipples",)]
    marks = generate(arguments, model, make_layers(arguments, layers), context, report)
    with report.stage("write", "writing") as stage:
        if arguments.output.lower().endswith(".ply"):
            from ._ply import write_ply

            write_ply(arguments.output, marks)
        else:
            marks.save(arguments.output)
        stage.says = arguments.output
    report.summary(f"{arguments.output}: {len(marks)} marks")


def _check(arguments: Any, context: Context, report: Reporter) -> int:
    from ._check import check

    return check(Path(arguments.input), arguments.json, context)


def _describe(path: Path, context: Context) -> Dict[str, Any]:
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


def _info(arguments: Any, context: Context, report: Reporter) -> None:
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
