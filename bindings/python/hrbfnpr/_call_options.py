# SPDX-License-Identifier: MIT
"""Options of `hrbfnpr.draw`: those of the command line's draw, by the same names, as Python values."""
from __future__ import annotations

import argparse
import difflib
import re
from typing import Any, Dict, Mapping, Optional

import numpy as np

from ._camera import Camera
from ._style import Style
from .cli import _options, _values

_ACROSS = ("size", "page")  # WIDTHxHEIGHT


class _Grammar:
    """The options of a drawing by the names that a call has for them."""

    def __init__(self) -> None:
        self.parser = _options.of_a_drawing()
        self.actions: Dict[str, argparse.Action] = {}
        for action in self.parser._actions:
            for name in (action.dest, *(word.lstrip("-").replace("-", "_") for word in action.option_strings)):
                self.actions[name] = action

    def action(self, name: str) -> argparse.Action:
        found = self.actions.get(name)
        if found is None:
            near = difflib.get_close_matches(name, self.actions, 3)
            hint = f"did you mean {' or '.join(near)}?" if near else "python3 -m hrbfnpr draw --help lists them"
            raise TypeError(f"a drawing has no option {name!r}: {hint}")
        return found


_grammar: Optional[_Grammar] = None


def _shared() -> _Grammar:
    global _grammar
    if _grammar is None:
        _grammar = _Grammar()
    return _grammar


def namespace(style: Any, camera: Optional[Camera], name: str, options: Mapping[str, Any]) -> argparse.Namespace:
    """What the command line would have made of these options; None stands for the default.

    Raises
    ------
    TypeError
        For an option that is none.
    ValueError
        For a value that it cannot have.
    """
    grammar = _shared()
    arguments: argparse.Namespace = grammar.parser.parse_args([])
    arguments.input, arguments.own_camera = name, None
    for option, value in options.items():
        action = grammar.action(option)
        if action.dest == "assignments":
            arguments.assignments = _assignments(value)
        elif value is not None:
            setattr(arguments, action.dest, _parsed(option, action, value))
    set_style(arguments, style)
    if camera is not None:
        if not isinstance(camera, Camera):
            raise TypeError(f"camera must be a hrbfnpr.Camera, not {type(camera).__name__}")
        arguments.own_camera = camera
    return arguments


def set_style(arguments: argparse.Namespace, style: Any) -> None:
    """A named style, or one that is used as it is."""
    if not isinstance(style, Style):
        arguments.own_style = None
        arguments.style = _parsed("style", _shared().action("style"), style)
        return
    if arguments.mark_radius is not None:
        raise ValueError("mark_radius sizes named styles; a Style has the radii of its layers")
    arguments.own_style, arguments.style = style.copy(), style.preset or arguments.style


def _parsed(option: str, action: argparse.Action, value: Any) -> Any:
    if action.nargs == 0:
        if not isinstance(value, (bool, np.bool_)):
            raise ValueError(f"{option} must be True or False, not {value!r}")
        return bool(value)
    text = _words(value, "x" if action.dest in _ACROSS else ",")
    if action.dest == "lines" and not text:
        text = "none"
    if action.choices is not None:
        names = {str(choice).replace("_", "-"): choice for choice in action.choices}
        if text.replace("_", "-") not in names:
            raise ValueError(f"{option} must be one of {', '.join(map(str, action.choices))}, not {text!r}")
        return names[text.replace("_", "-")]
    try:
        return action.type(text) if callable(action.type) else text
    except (argparse.ArgumentTypeError, ValueError) as error:
        raise ValueError(f"{option}: {error}") from None


def _words(value: Any, between: str) -> str:
    """A value as the command line has it."""
    if isinstance(value, str):
        return value
    if isinstance(value, Mapping):
        return ",".join(f"{name}={_words(part, between)}" for name, part in value.items())
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    if isinstance(value, (list, tuple, np.ndarray)):
        return between.join(_words(part, between) for part in value)
    return str(value)


def _assignments(value: Any) -> Any:
    if not isinstance(value, Mapping):
        raise TypeError("set must be a mapping of fields to values, such as {'principal.ink': '#800000'}")
    try:
        return [_values.assignment(f"{name}={_words(part, ',')}") for name, part in value.items()]
    except argparse.ArgumentTypeError as error:
        raise ValueError(f"set: {error}") from None


_VALUES = ("none", "x", "y", "z")  # others are words of a sentence
_OPTION = re.compile(r"--([a-z][a-z-]*)(?: (?!for\b)([\w.,=:-]*\w))?")


def in_python(text: str) -> str:
    """A message of the command line, with its options as those of a call: --samples 400 is samples=400."""
    return _OPTION.sub(_call_of, text)


def _call_of(found: "re.Match[str]") -> str:
    name, value = found.group(1).replace("-", "_"), found.group(2)
    action = _shared().actions.get(name)
    if action is None:
        return found.group(0)
    after = "" if value is None else f" {value}"
    if action.nargs == 0:
        return f"{name}=True{after}"
    if value is None:
        return name
    part, equals, number = value.partition("=")
    if equals:
        return f"{name}={{{part!r}: {number}}}"
    if action.choices is not None and value in action.choices:
        return f"{name}={value!r}"
    if re.fullmatch(r"-?[\d.]*\d", value) or value == "N":
        return f"{name}={value}"
    return f"{name}={value!r}" if value in _VALUES else name + after
