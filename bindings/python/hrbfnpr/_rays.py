# SPDX-License-Identifier: MIT
"""Arrays of rays: origins and directions for the library, and the hits of each ray from it."""
from __future__ import annotations

from dataclasses import replace
from typing import Dict, Tuple

from ._arrays import Array, Block, block_in, output_field, reshaped
from ._errors import new_struct
from ._numpy import np

# For each array of hrbfnpr_ray_hits: the numbers for each hit (0: one number for the ray), and the type ("": the caller's).
_OUTPUTS = {
    "count": (0, "I"),
    "t": (1, ""),
    "position": (3, ""),
    "normal": (3, ""),
    "entering": (1, "B"),
    "status": (0, "B"),
}


def _repeated(argument: str, block: Block, like: Block) -> Block:
    rows = np.broadcast_to(block.keep, (like.count, 3))
    return replace(block_in(argument, rows, 3, block.code), shape=like.shape)


def pairs(origins: Array, directions: Array) -> Tuple[Block, Block]:
    """Origins and directions of the same shape.  A single origin or direction is repeated for all rays."""
    start, along = block_in("origins", origins), block_in("directions", directions)
    if start.shape == along.shape:
        return start, along
    if np is not None and start.shape == ():
        return _repeated("origins", start, along), along
    if np is not None and along.shape == ():
        return start, _repeated("directions", along, start)
    raise ValueError(
        f"directions must have the shape of origins, {(*start.shape, 3)}, or (3,), not {(*along.shape, 3)}"
    )


class HitArrays:
    """The output arrays for `count` rays, with room for `room` hits of each."""

    def __init__(self, count: int, room: int, code: str) -> None:
        self.struct = new_struct("hrbfnpr_ray_hits")
        self._arrays: Dict[str, Array] = {
            name: output_field(self.struct, name, (count,), max(1, size * room), kind or code)
            for name, (size, kind) in _OUTPUTS.items()
        }

    def shaped(self, rays: Tuple[int, ...], hits: Tuple[int, ...]) -> Dict[str, Array]:
        """The arrays by name.  Those with one number for a ray get the shape `rays`, the others `hits`."""
        result = {}
        for name, (size, _) in _OUTPUTS.items():
            shape = rays if size == 0 else hits if size == 1 else (*hits, size)
            array = reshaped(self._arrays[name], shape)
            result["hits" if name == "count" else name] = array[()] if np is not None and shape == () else array
        return result
