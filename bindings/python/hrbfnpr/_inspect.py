# SPDX-License-Identifier: MIT
"""Findings of the library about a source, without drawing it."""
from __future__ import annotations

from typing import Any, List, Optional, Tuple

from ._callbacks import CallbackState, check
from ._context import Context, resolve
from ._errors import new_error, new_struct
from ._library import ffi, lib
from ._operation import running
from ._report import Note
from ._request import fill_source
from ._scene import on_event


def inspect(source: Any, wording: int, context: Optional[Context] = None) -> Tuple[Any, List[Note]]:
    """A hrbfnpr_source_info of a Shape, a Model or a PointSet, and the library's findings."""
    notes: List[Note] = []
    state = CallbackState(lambda event: notes.append(Note.of(event.note)) if event.note != ffi.NULL else None)
    user, struct = state.new_handle(), new_struct("hrbfnpr_picture_source")
    keep = fill_source(struct, source, None)
    info, error, handle = new_struct("hrbfnpr_source_info"), new_error(), resolve(context)._handle
    with running(None, None, handle) as (operation, running_state):
        status = lib.hrbfnpr_source_inspect(handle, struct, wording, on_event, user, operation, info, error)
        check(status, error, running_state, state)
    del keep
    return info, notes
