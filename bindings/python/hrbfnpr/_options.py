# SPDX-License-Identifier: MIT
"""The options of a drawing: the rows of `_options.json`, which bindings/generate makes from ../../picture_options.py."""
import json
from pathlib import Path
from typing import NamedTuple, Optional, Tuple


class Option(NamedTuple):
    """A row of the table.  ../../picture_options.py explains its columns; `type` is the type of `draw`'s argument."""

    name: str
    target: str
    kind: str
    metavar: str
    group: str
    choices: Tuple[str, ...]
    alias: str
    words: str
    type: str

    @property
    def default(self) -> Optional[bool]:
        """The default of `draw`'s argument."""
        return False if self.kind == "flag" else None


_ROWS = json.loads(Path(__file__).with_name("_options.json").read_text(encoding="utf-8"))
OPTIONS = tuple(Option(*row)._replace(choices=tuple(row[5])) for row in _ROWS)
