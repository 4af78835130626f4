# SPDX-License-Identifier: MIT
"""Arrays for the library and from it, without copies: NumPy arrays if NumPy is installed, else the buffer protocol."""
from __future__ import annotations

import array
import sys
from dataclasses import dataclass
from typing import Any, Iterable, List, Sequence, Tuple

from ._errors import check, new_error
from ._handles import own
from ._library import ffi
from ._numpy import np

Array = Any
"""A NumPy array; without NumPy, a memoryview of the same shape and type."""

# For each type code of the buffer protocol: HRBFNPR_SCALAR_..., and its size in bytes.
_SCALARS = {
    "f": (ffi.integer_const("HRBFNPR_SCALAR_FLOAT32"), 4),
    "d": (ffi.integer_const("HRBFNPR_SCALAR_FLOAT64"), 8),
    "B": (ffi.integer_const("HRBFNPR_SCALAR_UINT8"), 1),
    "I": (ffi.integer_const("HRBFNPR_SCALAR_UINT32"), 4),
    "i": (ffi.integer_const("HRBFNPR_SCALAR_INT32"), 4),
    "q": (ffi.integer_const("HRBFNPR_SCALAR_INT64"), 8),
}
_CODES = {number: code for code, (number, _) in _SCALARS.items()}
_NUMPY_CODES = {"f4": "f", "f8": "d", "u1": "B", "u4": "I", "i4": "i", "i8": "q"}
FLOATS = "fd"
INDICES = "iIq"


@dataclass(frozen=True)
class Block:
    """Elements in the caller's memory."""

    address: int
    count: int
    stride: int
    code: str
    components: int
    shape: Tuple[int, ...]  # the input's shape without its last axis
    keep: Any  # the owner of the memory

    def fill(self, target: Any) -> Any:
        """Write a hrbfnpr_array or hrbfnpr_array_out.  The result must be kept alive as long as the struct is used."""
        target.data = ffi.cast("void *", self.address)
        target.count = self.count
        target.stride = self.stride
        target.scalar = _SCALARS[self.code][0]
        target.components = self.components
        return self.keep

    def view(self, kind: str = "hrbfnpr_array") -> Any:
        """A new struct that describes the block."""
        struct = ffi.new(f"{kind} *")
        self.fill(struct)
        return struct


def _element_shape(argument: str, shape: Sequence[int], components: int) -> Tuple[int, ...]:
    """The shape without its last axis.  A flat array of `components` * n numbers counts as n elements."""
    if components == 1:
        return tuple(shape)
    if len(shape) == 1 and shape[0] % components == 0:
        return () if np is not None and shape[0] == components else (shape[0] // components,)
    if len(shape) < 2 or shape[-1] != components:
        raise ValueError(f"{argument} must have the shape (n, {components}), not {tuple(shape)}")
    return tuple(shape[:-1])


def _product(shape: Iterable[int]) -> int:
    result = 1
    for size in shape:
        result *= size
    return result


def _numpy_code(dtype: Any) -> str:
    """The type code of a dtype on every platform; "" for another type or byte order."""
    return _NUMPY_CODES.get(f"{dtype.kind}{dtype.itemsize}", "") if dtype.isnative else ""


def _numpy_block(argument: str, value: Any, components: int, codes: str) -> Block:
    data = np.asarray(value)
    if data.dtype.kind not in "fiub":
        raise TypeError(f"{argument} must be an array of numbers, not of {data.dtype}")
    if not _numpy_code(data.dtype) or _numpy_code(data.dtype) not in codes:
        data = data.astype(codes[-1])
    shape = _element_shape(argument, data.shape, components)
    rows = data.reshape((_product(shape), components))
    packed = components * rows.itemsize
    stride = rows.strides[0] if len(rows) > 1 else packed
        # The library reads a stride of 0 as "packed", so rows with a stride of 0 (broadcast rows) are copied.
    if stride == 0 or (components > 1 and rows.strides[1] != rows.itemsize):
        rows = np.ascontiguousarray(rows)
        stride = packed
    address = rows.__array_interface__["data"][0]
    return Block(address, len(rows), stride, _numpy_code(rows.dtype), components, shape, rows)


def _flatten(argument: str, value: Any) -> Tuple[List[float], List[int]]:
    """The numbers and the shape of nested sequences."""
    if not isinstance(value, Iterable) or isinstance(value, (str, bytes)):
        try:
            return [float(value)], []
        except (TypeError, ValueError):
            raise TypeError(f"{argument} must be an array of numbers, not of {type(value).__name__}") from None
    parts = [_flatten(argument, item) for item in value]
    shapes = {tuple(shape) for _, shape in parts}
    if len(shapes) > 1:
        raise ValueError(f"{argument} must be rectangular: its rows differ in length")
    inner = list(shapes.pop()) if shapes else []
    return [number for numbers, _ in parts for number in numbers], [len(parts), *inner]


def _buffer_block(argument: str, value: Any, components: int, codes: str) -> Block:
    try:
        data = memoryview(value)
    except TypeError:
        data = None
    native = "<" if sys.byteorder == "little" else ">"
    code = data.format.lstrip("@=" + native) if data is not None else ""
    if data is None or code not in codes or not data.c_contiguous:
        numbers, sizes = _flatten(argument, value if data is None else data.tolist())
        code, shape_in = codes[-1], tuple(sizes)
        data = memoryview(array.array(code, numbers if code in FLOATS else [int(n) for n in numbers]))
    else:
        shape_in = tuple(data.shape or ())
    shape = _element_shape(argument, shape_in, components)
    keep = ffi.from_buffer(data)
    address = int(ffi.cast("intptr_t", keep))
    stride = components * _SCALARS[code][1]
    return Block(address, _product(shape), stride, code, components, shape, (keep, data))


def block_in(argument: str, value: Any, components: int = 3, codes: str = FLOATS) -> Block:
    """Input elements of `components` numbers each.  They are copied only if their type or layout requires it.

    `codes` are the types that the library takes; other types are converted to the last of them.
    """
    make = _buffer_block if np is None else _numpy_block
    return make(argument, value, components, codes)


def store(argument: str, value: Any, count: int, components: int, code: str, target: Any) -> None:
    """Copy the result of a callback to the library's packed memory."""
    block = block_in(argument, value, components, code)
    if block.count != count:
        raise ValueError(f"{argument} must have {count} elements, not {block.count}")
    size = components * _SCALARS[code][1]
    if block.stride != size:
        block = block_in(argument, np.ascontiguousarray(block.keep), components, code)
    ffi.memmove(target, ffi.cast("void *", block.address), count * size)


def new_array(shape: Sequence[int], code: str) -> Array:
    """A new array of zeros."""
    if np is not None:
        return np.zeros(tuple(shape), dtype=code)
    data = memoryview(bytearray(_product(shape) * _SCALARS[code][1]))
    if _product(shape) == 0:
        return data.cast(code)
    return data.cast(code, shape=list(shape)) if shape else data.cast(code)


def reshaped(data: Array, shape: Sequence[int]) -> Array:
    """A new array from the library in another shape with the same number of elements, without a copy."""
    if np is not None:
        return data.reshape(tuple(shape))
    if _product(shape) == 0 or not shape:
        return data
    return data.cast("B").cast(data.format, shape=list(shape))


def block_out(argument: str, value: Any, shape: Sequence[int], components: int, codes: str) -> Block:
    """The caller's array to write to.  It must have exactly this shape and one of these types."""
    if np is not None and isinstance(value, np.ndarray):
        if not _numpy_code(value.dtype) or _numpy_code(value.dtype) not in codes:
            raise TypeError(f"{argument} must have a dtype of {' or '.join(codes)}, not {value.dtype}")
        flags_writeable = value.flags.writeable
    else:
        value = memoryview(value)
        flags_writeable = not value.readonly
        if value.format not in codes:
            raise TypeError(f"{argument} must have items of type {' or '.join(codes)}, not {value.format}")
    wanted = tuple(shape) if components == 1 else (*shape, components)
    if tuple(value.shape) != wanted:
        raise ValueError(f"{argument} must have the shape {wanted}, not {tuple(value.shape)}")
    if not flags_writeable:
        raise ValueError(f"{argument} is read-only")
    block = block_in(argument, value, components, codes)
    if not _same_memory(block, value):
        raise ValueError(f"{argument} has a layout that cannot be written in place")
    return block


def _same_memory(block: Block, value: Any) -> bool:
    if np is not None:
        return bool(block.count == 0 or np.may_share_memory(block.keep, np.asarray(value)))
    return bool(value.c_contiguous)


def output(argument: str, given: Any, shape: Sequence[int], components: int, code: str) -> Tuple[Array, Any]:
    """An output array, new or given by the caller, and the hrbfnpr_array_out for it."""
    if given is None:
        given = new_array(shape if components == 1 else (*shape, components), code)
        block = block_in(argument, given, components, code)
    else:
        block = block_out(argument, given, shape, components, FLOATS if code in FLOATS else code)
    return given, block.view("hrbfnpr_array_out")


def output_field(result: Any, field: str, shape: Sequence[int], components: int, code: str) -> Array:
    """Create an output array and put it into a field of a result struct."""
    array, view = output(field, None, shape, components, code)
    setattr(result, field, view[0])
    return array


def wrap(view: Any, owner: Any) -> Array:
    """A read-only array on the library's memory, without a copy.  It keeps `owner` alive."""
    code = _CODES[view.scalar]
    size = _SCALARS[code][1]
    count, components = view.count, view.components
    shape = [count] if components == 1 else [count, components]
    if count == 0:
        return new_array(shape, code)
    stride = view.stride or components * size
    pointer = own(ffi.cast("char *", view.data), lambda pointer: None, owner)
    memory = memoryview(ffi.buffer(pointer, (count - 1) * stride + components * size)).toreadonly()
    if np is not None:
        strides = (stride,) if components == 1 else (stride, size)
        return np.ndarray(shape, dtype=code, buffer=memory, strides=strides)
    if stride == components * size:
        return memory.cast(code, shape=shape)
    rows = b"".join(memory[i * stride : i * stride + components * size] for i in range(count))
    return memoryview(rows).cast(code, shape=shape)


def view(kind: str, attribute: str, doc: str) -> Any:
    """A property that is a read-only array on the library's memory, for HRBFNPR_(kind)_ATTRIBUTE_(attribute).

    Its class has `_handle` and `_view`: the function that gives the view, and its arguments before the attribute.
    """
    constant = ffi.integer_const(f"HRBFNPR_{kind}_ATTRIBUTE_{attribute}")

    def get(self: Any) -> Array:
        (function, *place), result, error = self._view, ffi.new("hrbfnpr_array *"), new_error()
        check(function(*place, constant, result, error), error)
        return wrap(result, self._handle)

    return property(get, doc=doc)


def matrix_in(argument: str, value: Any) -> List[float]:
    """A 4 x 4 matrix that is given as rows, in the library's column-major order."""
    block = block_in(argument, value, 1, "d")
    if block.shape != (4, 4):
        raise ValueError(f"{argument} must be a 4 x 4 matrix, not of shape {block.shape}")
    first = ffi.cast("char *", block.address)
    numbers = [ffi.cast("double *", first + i * block.stride)[0] for i in range(16)]
    return [numbers[4 * row + column] for column in range(4) for row in range(4)]


def matrix_out(numbers: Any) -> Array:
    """A column-major matrix from the library as a 4 x 4 array; without NumPy, a memoryview."""
    matrix = new_array((4, 4), "d")
    for row in range(4):
        for column in range(4):
            matrix[row, column] = numbers[4 * column + row]
    return matrix


def vector(argument: str, value: Any, length: int = 3) -> List[float]:
    """A list of `length` floats."""
    try:
        numbers = [float(number) for number in value]
    except (TypeError, ValueError):
        raise TypeError(f"{argument} must be {length} numbers, not {value!r}") from None
    if len(numbers) != length:
        raise ValueError(f"{argument} must be {length} numbers, not {len(numbers)}")
    return numbers


def scalar(values: Array, shape: Tuple[int, ...]) -> Any:
    """The number, if the values are those of a single point; else the array."""
    return values[()] if np is not None and shape == () else values


def float_code(dtype: Any) -> str:
    """The type code of a float dtype or of its name."""
    name = dtype if isinstance(dtype, str) else np.dtype(dtype).name
    codes = {"float64": "d", "float32": "f", "d": "d", "f": "f"}
    if name not in codes:
        raise ValueError(f"dtype must be 'float64' or 'float32', not {dtype!r}")
    return codes[name]
