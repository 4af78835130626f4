# SPDX-License-Identifier: MIT
"""Scripts of solids, in the subset of Python's grammar that docs/csg.md describes.  They are interpreted, never executed.

A script consists of lines ``name = expression``.  The value of the last line is the solid.
"""
from __future__ import annotations

import ast
import math
import operator
from typing import Any, Callable, Dict, Optional

from . import csg
from ._context import Context
from ._errors import Error
from ._model import Model

MOST_REPEATS = 10_000  # largest number of repeats of all loops of a script
METHODS = ("blend", "difference", "intersection", "offset", "rotated", "scaled", "shell", "transformed", "translated",
           "union")  # fmt: skip
_NUMBERS: Dict[str, Any] = {"pi": math.pi}
_FUNCTIONS: Dict[str, Callable[..., Any]] = {
    "sqrt": math.sqrt, "sin": lambda degrees: math.sin(math.radians(degrees)),
    "cos": lambda degrees: math.cos(math.radians(degrees)),
}  # fmt: skip
_OPERATORS: Dict[type, Callable[[Any, Any], Any]] = {
    ast.BitOr: operator.or_, ast.BitAnd: operator.and_, ast.Sub: operator.sub, ast.Add: operator.add,
    ast.Mult: operator.mul, ast.Div: operator.truediv,
}  # fmt: skip
_SIGNS: Dict[type, Callable[[Any], Any]] = {
    ast.Invert: operator.invert, ast.USub: operator.neg, ast.UAdd: operator.pos,
}  # fmt: skip


class ScriptError(ValueError):
    """A script is wrong.  The message names the line and the fault."""


def run(text: str, load: Callable[[str], Model], context: Optional[Context] = None) -> Model:
    """The solid that a script describes.  `load` makes a model from a file that the script names."""
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        line = getattr(error, "lineno", None) or 1
        raise ScriptError(f"line {line}: {getattr(error, 'msg', error)}") from None
    return _Script(load, context).run(tree)


class _Script:
    def __init__(self, load: Callable[[str], Model], context: Optional[Context]) -> None:
        def made(primitive: Callable[..., Model]) -> Callable[..., Model]:
            return lambda *given, **named: primitive(*given, **named, context=context)

        self._functions: Dict[str, Callable[..., Any]] = {
            **_FUNCTIONS, **{name: made(getattr(csg, name)) for name in csg.__all__}, "load": load,
            **{name: getattr(Model, name) for name in ("union", "intersection", "difference")},
        }  # fmt: skip
        self._names: Dict[str, Any] = dict(_NUMBERS)
        self._repeats = 0

    def run(self, tree: ast.Module) -> Model:
        value = None
        for statement in tree.body:
            value = self._guarded(statement, self._statement)
        if not isinstance(value, Model):
            raise ScriptError("the last line must be a solid")
        return value

    def _guarded(self, node: Any, work: Callable[[Any], Any]) -> Any:
        """Run a step, and add the line to its errors."""
        try:
            return work(node)
        except ScriptError:
            raise
        except (Error, TypeError, ValueError, ArithmeticError, OSError, RecursionError) as error:
            raise ScriptError(f"line {node.lineno}: {error}") from error

    def _statement(self, node: ast.stmt) -> Any:
        if isinstance(node, ast.Expr):
            return self._value(node.value)
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name):
            value = self._names[node.targets[0].id] = self._value(node.value)
            return value
        raise ScriptError(f"line {node.lineno}: a line must be `name = solid` or a solid")

    def _value(self, node: ast.expr) -> Any:
        work = getattr(self, "_" + type(node).__name__.lower(), None)
        if work is None:
            raise ScriptError(f"line {node.lineno}: {type(node).__name__} cannot be used in these scripts")
        return self._guarded(node, work)

    def _constant(self, node: ast.Constant) -> Any:
        if isinstance(node.value, (int, float)) and not isinstance(node.value, bool):
            return float(node.value) if abs(node.value) > 2**53 else node.value
        if isinstance(node.value, str):
            return node.value
        raise ScriptError(f"line {node.lineno}: {node.value!r} is not a number")

    def _name(self, node: ast.Name) -> Any:
        if node.id not in self._names:
            known = ", ".join(sorted({*self._names, *self._functions}))
            raise ScriptError(f"line {node.lineno}: there is no {node.id!r}; there are {known}")
        return self._names[node.id]

    def _tuple(self, node: ast.Tuple) -> Any:
        return tuple(self._value(element) for element in node.elts)

    def _list(self, node: ast.List) -> Any:
        return [self._value(element) for element in node.elts]

    def _binop(self, node: ast.BinOp) -> Any:
        work = _OPERATORS.get(type(node.op))
        if work is None:
            raise ScriptError(f"line {node.lineno}: {type(node.op).__name__} cannot be used in these scripts")
        left, right = self._value(node.left), self._value(node.right)
        if any(isinstance(side, (str, tuple, list)) for side in (left, right)):
            raise ScriptError(f"line {node.lineno}: only solids and numbers can be combined")
        return work(left, right)

    def _unaryop(self, node: ast.UnaryOp) -> Any:
        work = _SIGNS.get(type(node.op))
        if work is None:
            raise ScriptError(f"line {node.lineno}: {type(node.op).__name__} cannot be used in these scripts")
        return work(self._value(node.operand))

    def _listcomp(self, node: Any) -> Any:
        """A loop such as ``[... for i in range(6)]``."""
        loop = node.generators[0]
        simple = len(node.generators) == 1 and isinstance(loop.target, ast.Name) and not loop.ifs
        call = loop.iter
        if not (simple and isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.func.id == "range"):
            raise ScriptError(f"line {node.lineno}: write a loop as `for i in range(n)`")
        values = []
        for i in range(*(int(self._value(argument)) for argument in call.args)):
            self._repeats += 1
            if self._repeats > MOST_REPEATS:
                raise ScriptError(f"line {node.lineno}: a loop repeats more than {MOST_REPEATS} times")
            self._names[loop.target.id] = i
            values.append(self._value(node.elt))
        return values

    _generatorexp = _listcomp

    def _call(self, node: ast.Call) -> Any:
        given = []
        for argument in node.args:
            starred = isinstance(argument, ast.Starred)
            value = self._value(argument.value if isinstance(argument, ast.Starred) else argument)
            given += list(value) if starred else [value]
        named = {}
        for keyword in node.keywords:
            if keyword.arg is None or keyword.arg == "context":
                raise ScriptError(f"line {node.lineno}: write options as name=value")
            named[keyword.arg] = self._value(keyword.value)
        return self._function(node.func)(*given, **named)

    def _function(self, node: ast.expr) -> Callable[..., Any]:
        if isinstance(node, ast.Name):
            if node.id not in self._functions:
                raise ScriptError(f"line {node.lineno}: there is no {node.id}(); there are "
                                  f"{', '.join(sorted(self._functions))}")  # fmt: skip
            return self._functions[node.id]
        if isinstance(node, ast.Attribute) and node.attr in METHODS:
            solid = self._value(node.value)
            if isinstance(solid, Model):
                return getattr(solid, node.attr)  # type: ignore[no-any-return]
            raise ScriptError(f"line {node.lineno}: only solids have .{node.attr}()")
        raise ScriptError(f"line {node.lineno}: this is not a function; solids have .{', .'.join(METHODS)}")
