"""Vertex layouts."""
from __future__ import annotations

from typing import Any, List, Sequence, Tuple

from ._arrays import Array
from ._errors import new_struct
from ._library import ffi
from ._numpy import np

# Attribute -> type code, components.
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
}
_SCALARS = {"f": ("FLOAT32", 4), "B": ("UINT8", 1), "I": ("UINT32", 4)}

Fields = List[Tuple[str, str, int]]


def layout_of(attributes: Sequence[str]) -> Tuple[Any, Fields]:
    """The library's layout, packed but for padding to 4 bytes, and the same as fields."""
    layout = new_struct("hrbfnpr_vertex_layout")
    fields: Fields = []
    if isinstance(attributes, str):
        attributes = (attributes,)
    if not 1 <= len(attributes) <= len(layout.attributes):
        raise ValueError(f"attributes must be 1 to {len(layout.attributes)} names")
    offset = 0
    for target, name in zip(layout.attributes, attributes):
        if name not in _TYPES:
            raise ValueError(f"attributes must be of {', '.join(map(repr, _TYPES))}, not {name!r}")
        code, components = _TYPES[name]
        scalar, size = _SCALARS[code]
        offset = (offset + size - 1) // size * size
        target.attribute = ffi.integer_const(f"HRBFNPR_VERTEX_{name.upper()}")
        target.scalar = ffi.integer_const(f"HRBFNPR_SCALAR_{scalar}")
        target.offset = offset
        fields.append((name, code, components))
        offset += size * components
    layout.attribute_count = len(fields)
    layout.stride = (offset + 3) // 4 * 4
    return layout, fields


def vertex_array(count: int, layout: Any, fields: Fields) -> Tuple[Array, Any]:
    """An array for `count` vertices, and its address."""
    if np is not None:
        dtype = np.dtype(
            {
                "names": [name for name, _, _ in fields],
                "formats": [(code, (n,)) if n > 1 else code for _, code, n in fields],
                "offsets": [layout.attributes[i].offset for i in range(len(fields))],
                "itemsize": layout.stride,
            }
        )
        array = np.zeros(count, dtype)
        return array, ffi.cast("void *", array.__array_interface__["data"][0])
    memory = bytearray(max(count, 1) * layout.stride)
    view = memoryview(memory).cast("B", shape=[max(count, 1), layout.stride])
    return view, ffi.from_buffer(memory)
