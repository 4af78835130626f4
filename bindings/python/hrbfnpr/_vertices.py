# SPDX-License-Identifier: MIT
"""Layouts of vertices."""
from __future__ import annotations

from typing import Any, List, Sequence, Tuple

from ._arrays import Array
from ._errors import new_list, new_struct
from ._library import ffi
from ._numpy import np

# For each attribute: the type code, and the number of components.
_TYPES = {
    "position": ("f", 3),
    "window": ("f", 3),
    "radius": ("f", 1),
    "color": ("B", 4),
    "normal": ("f", 3),
    "direction": ("f", 3),
    "id": ("I", 1),
    "class": ("B", 1),
    "is_paper": ("B", 1),
    "layer": ("I", 1),
    "length": ("f", 1),
    "line": ("I", 1),
    "hidden_layers": ("I", 1),
    "hidden_by": ("I", 1),
}
_SCALARS = {"f": ("FLOAT32", 4), "B": ("UINT8", 1), "I": ("UINT32", 4)}

Fields = List[Tuple[str, str, int, int]]  # name, type code, components, offset


def layout_of(primitive: int, attributes: Sequence[str]) -> Tuple[Any, Fields, Any]:
    """The library's layout, packed except for padding to 4 bytes; the same as fields; and the objects to keep alive."""
    layout = new_struct("hrbfnpr_vertex_layout")
    fields: Fields = []
    if isinstance(attributes, str):
        attributes = (attributes,)
    if len(attributes) < 1:
        raise ValueError("attributes must be at least one name")
    targets = new_list("hrbfnpr_vertex_attribute", len(attributes))
    offset = 0
    for target, name in zip(targets, attributes):
        if name not in _TYPES:
            raise ValueError(f"attributes must be of {', '.join(map(repr, _TYPES))}, not {name!r}")
        code, components = _TYPES[name]
        scalar, size = _SCALARS[code]
        offset = (offset + size - 1) // size * size
        target.attribute = ffi.integer_const(f"HRBFNPR_VERTEX_ATTRIBUTE_{name.upper()}")
        target.scalar = ffi.integer_const(f"HRBFNPR_SCALAR_{scalar}")
        target.offset = offset
        fields.append((name, code, components, offset))
        offset += size * components
    layout.primitive = primitive
    layout.attributes, layout.attribute_count = targets, len(fields)
    layout.stride = (offset + 3) // 4 * 4
    return layout, fields, targets


def vertex_array(count: int, layout: Any, fields: Fields) -> Tuple[Array, Any]:
    """An array for `count` vertices, and its address."""
    if np is not None:
        dtype = np.dtype(
            {
                "names": [name for name, _, _, _ in fields],
                "formats": [(code, (n,)) if n > 1 else code for _, code, n, _ in fields],
                "offsets": [offset for _, _, _, offset in fields],
                "itemsize": layout.stride,
            }
        )
        array = np.zeros(count, dtype)
        return array, ffi.cast("void *", array.__array_interface__["data"][0])
    memory = bytearray(max(count, 1) * layout.stride)
    view = memoryview(memory).cast("B", shape=[max(count, 1), layout.stride])
    return view, ffi.from_buffer(memory)
