# SPDX-License-Identifier: MIT
"""Runs the commands; failures are one line and an exit code."""
from __future__ import annotations

import dataclasses
import json
import os
import sys
from pathlib import Path
from typing import Any, Dict, List, Optional

from .._context import Context, build_info
from .._errors import Error, OutOfMemoryError
from .._layer import Layer
from .._model import Model
from .._point_set import PointSet
from ._options import build
from ._progress import Reporter


class UsageError(Exception):
    """Options that do not go together; exit code 2."""


def main(argv: Optional[List[str]] = None) -> int:
    """Run a command line.

    Returns
    -------
    int
        0; 1 after a failure; 2 for a wrong command line; 130 after Ctrl-C.
    """
    try:
        arguments = build().parse_args(argv)
        return _run(arguments)
    except SystemExit as end:  # argparse, for --help and wrong options
        return end.code if isinstance(end.code, int) else 0
    except UsageError as error:
        return _fail(str(error), 2)
    except KeyboardInterrupt:
        return _fail("interrupted", 130)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # or Python complains at its end
        return 1
    except OutOfMemoryError as error:
        return _fail(f"out of memory: {error}; fewer --samples or --marks need less", 1)
    except (Error, OSError, ValueError, ImportError) as error:
        return _fail(_in_words(error), 1)
    except MemoryError:
        return _fail("out of memory", 1)


def _fail(message: str, code: int) -> int:
    print(f"hrbfnpr: error: {message}", file=sys.stderr)
    return code


def _in_words(error: BaseException) -> str:
    if isinstance(error, OSError) and error.filename is not None:
        return f"{os.fsdecode(error.filename)}: {error.strerror}"
    return " ".join(str(error).split())


def _run(arguments: Any) -> int:
    context = Context(arguments.threads or 0)
    report = Reporter(arguments.quiet)
    commands = {"draw": _draw, "sheet": _sheet, "fit": _fit, "points": _points, "info": _info}
    commands[arguments.command](arguments, context, report)
    return 0


def _load(arguments: Any, context: Context, report: Reporter) -> Any:
    from ._inputs import load

    path = Path(arguments.input)
    try:
        return load(path, arguments, context, report)
    except (Error, ValueError) as error:
        if isinstance(error, (OutOfMemoryError,)):
            raise
        raise ValueError(f"{path}: {_in_words(error)}") from error


def _draw(arguments: Any, context: Context, report: Reporter) -> None:
    from ._draw import draw

    draw(arguments, _load(arguments, context, report), context, report)


def _sheet(arguments: Any, context: Context, report: Reporter) -> None:
    from ._sheet import draw_sheet, output_of

    output = output_of(arguments)
    model = _load(arguments, context, report)
    if not isinstance(model, Model):
        raise UsageError(f"{arguments.input} holds a point set; a sheet is drawn of samples or of a model")
    draw_sheet(arguments, output, model, context, report)


def _fit(arguments: Any, context: Context, report: Reporter) -> None:
    model = _load(arguments, context, report)
    if not isinstance(model, Model):
        raise UsageError(f"{arguments.input} holds a point set; a model is fitted to samples")
    model.save(arguments.output)
    if not report.quiet:
        info = model.info
        print(f"{arguments.output}: {info.centres} centres, {info.kernel}, {info.seconds_total:.1f} s")


def _points(arguments: Any, context: Context, report: Reporter) -> None:
    from ._draw import generate, make_layers

    model = _load(arguments, context, report)
    if not isinstance(model, Model):
        raise UsageError(f"{arguments.input} holds a point set already")
    layers = [Layer(kind) for kind in arguments.layers or ("stipples",)]
    marks = generate(arguments, model, make_layers(arguments, layers), context, report)
    if arguments.output.lower().endswith(".ply"):
        from ._ply import write_ply

        write_ply(arguments.output, marks)
    else:
        marks.save(arguments.output)
    if not report.quiet:
        print(f"{arguments.output}: {len(marks)} marks, {marks.info.seconds_total:.1f} s")


def _describe(path: Path, context: Context) -> Dict[str, Any]:
    from .. import shapes
    from ._inputs import load_saved

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
            raise ValueError(f"{arguments.input}: {_in_words(error)}") from error
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
