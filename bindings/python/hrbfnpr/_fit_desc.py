# SPDX-License-Identifier: MIT
"""The descriptor of a fit."""
from __future__ import annotations

from typing import Any, List, Optional, Tuple, Union

from ._arrays import Array, block_in
from ._errors import new_struct
from ._library import ffi
from ._names import KERNELS, NORMALS, REPAIRS, SOLVERS, TRIMS, number_of


def fill_normals(desc: Any, points: Array, normals: Optional[Array]) -> List[Any]:
    """Put points, and normals if they are given, into a descriptor.  The result must be kept alive with it."""
    keep = [block_in("points", points).fill(desc.points)]
    if normals is not None:
        keep.append(block_in("normals", normals).fill(desc.normals))
    return keep


def normal_mode_number(normals: Optional[Array], normal_mode: Optional[str]) -> int:
    """The number of a normal mode.  None means "given", or "none" without normals."""
    if normal_mode is None:
        normal_mode = "none" if normals is None else "given"
    return number_of("normal_mode", NORMALS, normal_mode)


def fit_desc(
    points: Array, normals: Optional[Array], normal_mode: Optional[str], kernel: str,
    regularization: Union[float, str], outliers: str, flipped_normals: str, solver: str, trim: str,
    **numbers: Any,
) -> Tuple[Any, List[Any]]:  # fmt: skip
    """A hrbfnpr_fit_desc, and the objects to keep alive with it.  `numbers` are fields of the same names."""
    desc = new_struct("hrbfnpr_fit_desc")
    keep = fill_normals(desc, points, normals)
    desc.normal_mode = normal_mode_number(normals, normal_mode)
    desc.kernel = number_of("kernel", KERNELS, kernel)
    if regularization == "auto":
        desc.regularization_mode = ffi.integer_const("HRBFNPR_REGULARIZATION_AUTO")
    else:
        desc.regularization = regularization
    desc.outliers = number_of("outliers", REPAIRS, outliers)
    desc.flipped_normals = number_of("flipped_normals", REPAIRS, flipped_normals)
    desc.solver = number_of("solver", SOLVERS, solver)
    desc.trim = number_of("trim", TRIMS, trim)
    for name, number in numbers.items():
        setattr(desc, name, number)
    return desc, keep
