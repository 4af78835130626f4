# SPDX-License-Identifier: MIT
"""Checks before the work starts that its results can be written."""
from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Optional, Sequence, Union

from .. import _page, _pictures
from ..shapes._read import ENDINGS


class UsageError(Exception):
    """The command line is wrong, such as options that do not go together.  The exit status is 2."""


_SAVED = {"model": ".hrbf", "point set": ".hrbm"}


def check(path: Union[str, Path]) -> None:
    """Raise an OSError if the file cannot be written.  The error names the file as the user typed it."""
    target = Path(os.path.realpath(path))
    if target.is_dir():
        raise IsADirectoryError(21, "it is a folder: give a file name", str(path))
    if not target.parent.is_dir():
        raise FileNotFoundError(2, f"there is no folder {os.path.dirname(path) or '.'}", str(path))
    writable = os.access(target, os.W_OK) if target.exists() else True
    if not (writable and (os.access(target.parent, os.W_OK) or target.exists() and not target.is_file())):
        raise PermissionError(13, "the file cannot be written", str(path))


def check_picture(path: Union[str, Path]) -> None:
    """Raise an error if the file cannot be written as a picture in the format of its ending."""
    _pictures.format_of(path)
    check(path)


def check_drawing(path: Union[str, Path]) -> None:
    """Raise an error if the file cannot be written as a picture or as vectors in the format of its ending."""
    if _page.format_of(path) is None:
        _pictures.format_of(path)
    check(path)


def check_saved(path: Optional[str], kind: str, also: str = "") -> None:
    """Raise an error if a model or point set cannot be saved there.  None is not checked.

    Endings of formats for shapes are refused, except `also`.
    """
    if path is None:
        return
    ending = os.path.splitext(path)[1].lower()
    if ending in ENDINGS and ending != also:
        other = f", or {also}" if also else ""
        raise ValueError(f"{path}: a {kind} cannot be saved as {ending}: use {_SAVED[kind]}{other}")
    check(path)


def check_all(arguments: Any, drawings: Sequence[Path]) -> None:
    """Check all files that `draw` and `csg` write."""
    for path in drawings:
        check_drawing(path)
    check_saved(getattr(arguments, "save_model", None), "model")
    check_saved(getattr(arguments, "save_points", None), "point set")
    if getattr(arguments, "save_settings", None):
        check(arguments.save_settings)
