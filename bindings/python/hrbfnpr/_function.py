# SPDX-License-Identifier: MIT
"""Implicit functions written in Python."""
from __future__ import annotations

from typing import Any, Callable, Dict, Optional

from ._arrays import store
from ._callbacks import CallbackState, callback, plain_callback
from ._library import ffi
from ._numpy import np

Function = Callable[[Any], Any]

# The `user` handles of the functions whose models are alive, by address.
_alive: Dict[int, Any] = {}


class FunctionState(CallbackState):
    """The functions of one model, and the exception of the call that failed."""

    def __init__(self, value: Function, gradient: Optional[Function], hessian: Optional[Function]) -> None:
        super().__init__(value)
        self.gradient = gradient
        self.hessian = hessian

    def flags(self, thread_safe: bool) -> int:
        bits = {"GRADIENT": self.gradient, "HESSIAN": self.hessian}
        flags: int = sum(ffi.integer_const(f"HRBFNPR_CUSTOM_HAS_{name}") for name, given in bits.items() if given)
        if thread_safe:
            flags |= ffi.integer_const("HRBFNPR_CUSTOM_THREAD_SAFE")
        return flags

    def keep(self) -> Any:
        """The `user` pointer, kept until `on_release` is called with it."""
        user = self.new_handle()
        _alive[int(ffi.cast("intptr_t", user))] = user
        return user


def points_of(address: Any, count: int) -> Any:
    """The points as a new array, which the function may keep or change."""
    data = bytearray(ffi.buffer(address, count * 24))
    if np is not None:
        return np.frombuffer(data).reshape(count, 3)
    return memoryview(data).cast("d", shape=[count, 3])


def _fill(name: str, target: Any, result: Any, count: int, width: int) -> None:
    if np is not None and width == 6 and np.ndim(result) == 3 and np.shape(result)[1:] == (3, 3):
        result = np.asarray(result)[:, (0, 0, 0, 1, 1, 2), (0, 1, 2, 1, 2, 2)]
    store(f"the result of {name}", result, count, width, "d", target)


@callback("int32_t(void *, int64_t, const double *, double *, double *, double *)", failure=1)
def on_evaluate(user: Any, count: int, points: Any, value: Any, gradient: Any, hessian: Any) -> int:
    state = ffi.from_handle(user)
    _fill("value", value, state.function(points_of(points, count)), count, 1)
    if gradient:
        _fill("gradient", gradient, state.gradient(points_of(points, count)), count, 3)
    if hessian:
        _fill("hessian", hessian, state.hessian(points_of(points, count)), count, 6)
    return 0


@plain_callback("void(void *)")
def on_release(user: Any) -> None:
    _alive.pop(int(ffi.cast("intptr_t", user)), None)
