"""Styles: how a point set is drawn."""
from __future__ import annotations

from typing import Any, Callable, Dict, Generic, Iterable, Mapping, Optional, Sequence, Tuple, TypeVar, Union

from ._arrays import Array, store, vector
from ._callbacks import CallbackState, callback
from ._errors import check, new_error, new_struct
from ._library import ffi, lib
from ._names import (
    GROUPS,
    HIDDEN_LINES,
    LIGHT_SPACES,
    SILHOUETTE_LAWS,
    TONE_CURVES,
    TONE_RULES,
    TONES,
    VISIBILITIES,
    group_bits,
    group_names,
    name_of,
    number_of,
)
from ._numpy import np

Get = TypeVar("Get")
Set = TypeVar("Set")
Color = Union[str, Tuple[float, ...]]
ToneFunction = Callable[[Array, Array], Any]

PRESETS: Tuple[str, ...] = tuple(
    ffi.string(lib.hrbfnpr_style_preset_name(number)).decode()
    for number in range(ffi.integer_const("HRBFNPR_STYLE_COUNT"))
)
"""Names of the styles that `Style` knows."""


def color(argument: str, value: Color) -> Tuple[float, float, float, float]:
    """Straight RGBA in [0, 1] from "#rrggbb", "#rrggbbaa", or 3 or 4 numbers."""
    if isinstance(value, str):
        digits = value.lstrip("#")
        if value[:1] != "#" or len(digits) not in (6, 8) or set(digits.lower()) - set("0123456789abcdef"):
            raise ValueError(f"{argument} must be '#rrggbb' or '#rrggbbaa', not {value!r}")
        value = tuple(byte / 255 for byte in bytes.fromhex(digits))
    numbers = [float(number) for number in value]
    if len(numbers) == 3:
        numbers.append(1.0)
    if len(numbers) != 4:
        raise ValueError(f"{argument} must be 3 or 4 numbers, or '#rrggbb'")
    return numbers[0], numbers[1], numbers[2], numbers[3]


class _Field(Generic[Get, Set]):
    """An attribute that is a field of the struct."""

    def __init__(self, write: Callable[[str, Set], Any], read: Callable[[Any], Get], doc: str) -> None:
        self._write, self._read = write, read
        self.__doc__ = doc

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    def __get__(self, instance: Any, owner: Any = None) -> Get:
        if instance is None:
            return self  # type: ignore[return-value]
        return self._read(getattr(instance._struct, self._name))

    def __set__(self, instance: Any, value: Set) -> None:
        setattr(instance._struct, self._name, self._write(self._name, value))


def _number(doc: str) -> _Field[float, float]:
    return _Field(lambda name, value: float(value), float, doc)


def _color(doc: str) -> _Field[Tuple[float, ...], Color]:
    return _Field(color, tuple, doc)


def _choice(numbers: Dict[str, int], doc: str) -> _Field[str, str]:
    return _Field(lambda name, value: number_of(name, numbers, value), lambda n: name_of(numbers, n), doc)


class _Attributes:
    """Refuses attributes that are not fields: a misspelt name must not pass silently."""

    def __setattr__(self, name: str, value: Any) -> None:
        if not name.startswith("_") and not hasattr(type(self), name):
            raise AttributeError(f"{type(self).__name__} has no field {name!r}")
        object.__setattr__(self, name, value)

    @classmethod
    def fields(cls) -> Tuple[str, ...]:
        """Names of all fields."""
        return tuple(name for name, value in vars(cls).items() if isinstance(value, _Field))


class GroupStyle(_Attributes):
    """One group's ink; the `stipple`, `curvature` or `combing` of a `Style`."""

    shown = _Field[bool, bool](lambda name, value: int(bool(value)), bool, "Whether its front marks are drawn.")
    sets = _Field[int, int](lambda name, value: int(value), int, "Bit 0: first directions, bit 1: second.")
    share = _number("Share of the group's marks that is used at all, 0 to 1.")
    radius = _number("Of a mark, pixels.")
    radius_zoom = _number("0: radius is in pixels at any zoom; 1: grows with the zoom; or between.")
    ink = _color("Straight RGBA in [0, 1], or '#rrggbb'.")

    def __init__(self, struct: Any, style: Style) -> None:
        self._struct = struct
        self._style = style  # owns the memory of the struct

    def _values(self) -> Dict[str, Any]:
        return {name: getattr(self, name) for name in self.fields()}

    def __repr__(self) -> str:
        return "GroupStyle(" + ", ".join(f"{k}={v!r}" for k, v in self._values().items()) + ")"


class Style(_Attributes):
    """How a point set is drawn.  Every field is an attribute and may be changed at any time.

    Parameters
    ----------
    preset : str, optional
        One of `hrbfnpr.PRESETS`; the library's default style if omitted.
    **fields
        Fields to change; a group's as a mapping.

    Examples
    --------
    >>> style = hrbfnpr.Style("hatch", tone_exponent=1.5, ink="#402010", curvature={"radius": 1.5})
    >>> style.stipple.shown = True
    """

    hidden_lines = _choice(HIDDEN_LINES, '"attenuate" (painted over by paper), "hide" or "show" [NPAR 6.1].')
    visibility = _choice(
        VISIBILITIES,
        '"sheets": marks are seen through the sheets of surface in front of them, whatever their number; "painted": '
        "paper and ink from far to near [NPAR 6.1].  One for all styles of a frame.",
    )
    silhouette_threshold = _number(
        'delta in (0, 1): marks with abs(n . v) below it are silhouettes [NPAR 6]; of silhouette_law "width" only a '
        "limit that the line keeps."
    )
    silhouette_law = _choice(
        SILHOUETTE_LAWS, '"width": a line of constant width; "angle": by silhouette_threshold alone, as published.'
    )
    silhouette_width = _number('Of silhouette_law "width": pixels on either side of the contour.')
    attenuation_front = _number("lambda of alpha_f = nu^2 lambda.")
    attenuation_back = _number("lambda of alpha_b = 0.2 (ln(nu - 0.05) + 5) lambda.")
    cover_radius = _number("Of the paper that front marks paint, pixels; 0 = from the marks' spacing.")
    halo_width = _number(
        'Pixels; of visibility "sheets" how far beyond its contour a surface hides what lies behind, else how much '
        "wider the paper of back marks is."
    )
    cover_layers = _number("n > 0: a sheet is as opaque as n overlapping marks; 0: as published.")
    tone_rule = _choice(TONE_RULES, '"share" or "paper": how tone, depth, zoom and share are combined.')
    tone_curve = _choice(
        TONE_CURVES,
        'Of tone_rule "share".  "coverage": marks cover 1 - tau of the paper at any zoom and number of marks; '
        '"linear": the share of marks is 1 - tau [NPAR 6.2].',
    )
    tone_fade = _number(
        "0 to 1: marks grow from nothing to their full area over this share of the marks shown; 0 = they pop."
    )
    light_space = _choice(LIGHT_SPACES, '"world" or "camera".')
    tone_exponent = _number("lambda of the tone law tau = max(0, n . l)^lambda, > 0 [NPAR 6.2].")
    depth_min = _number("Distance from the camera where depth attenuation starts.")
    depth_max = _number("... and where nothing is shown any more; 0 and 0 = off.")
    zoom_reference = _number("Pixels per world unit at which all marks are shown; 0 = off.")
    zoom_exponent = _number("How fast marks vanish below it; 2 keeps the ink per area.")
    paper = _color("Straight RGBA in [0, 1], or '#rrggbb'; alpha 0 = transparent.")
    silhouette_ink = _color("Of silhouette marks.")
    silhouette_radius = _number("Of silhouette marks, pixels.")
    silhouette_radius_zoom = _number("As a group's radius_zoom.")
    light = _Field[Tuple[float, ...], Sequence[float]](vector, tuple, "Towards the light; normalised on use.")
    silhouette_groups = _Field[Tuple[str, ...], Union[str, Iterable[str]]](
        lambda name, value: group_bits(value), group_names, "Groups whose silhouette marks are drawn."
    )

    def __init__(self, preset: Optional[str] = None, **fields: Any) -> None:
        self._preset = preset
        self._tone: Optional[ToneFunction] = None
        self._groups = (1 << len(GROUPS)) - 1
        if preset is None:
            self._struct = new_struct("hrbfnpr_style")
        else:
            self._init_preset(preset)
        self.update(**fields)

    def _init_preset(self, preset: str) -> None:
        if preset not in PRESETS:
            raise ValueError(f"preset must be one of {', '.join(map(repr, PRESETS))}, not {preset!r}")
        self._struct = ffi.new("hrbfnpr_style *")
        groups, error = ffi.new("uint32_t *"), new_error()
        size = ffi.sizeof("hrbfnpr_style")
        status = lib.hrbfnpr_style_init_preset(self._struct, size, PRESETS.index(preset), groups, error)
        check(status, error)
        self._groups = groups[0]

    @property
    def preset(self) -> Optional[str]:
        """The name it was made from."""
        return self._preset

    @property
    def groups(self) -> Tuple[str, ...]:
        """The groups of marks that the preset draws: what to give to `PointSet.generate`."""
        return group_names(self._groups)

    def _group(self, name: str) -> GroupStyle:
        return GroupStyle(self._struct.group[GROUPS[name]], self)

    @property
    def stipple(self) -> GroupStyle:
        """Ink of the stipples."""
        return self._group("stipple")

    @property
    def curvature(self) -> GroupStyle:
        """Ink of the strokes along principal directions."""
        return self._group("curvature")

    @property
    def combing(self) -> GroupStyle:
        """Ink of the combed strokes."""
        return self._group("combing")

    @property
    def tone(self) -> Union[str, ToneFunction]:
        """"none", "light", or any illumination model.

        A function gets world positions and unit normals, float32 (n, 3) each, and returns n numbers:
        1 = light, 0 = dark.
        """
        return self._tone if self._tone is not None else name_of(TONES, self._struct.tone)

    @tone.setter
    def tone(self, value: Union[str, ToneFunction]) -> None:
        if callable(value):
            self._tone, self._struct.tone = value, TONES["callback"]
            return
        number = number_of("tone", TONES, value)
        if number == TONES["callback"]:
            raise ValueError("tone must be 'none', 'light' or a function")
        self._tone, self._struct.tone = None, number

    def set_ink(self, ink: Color) -> None:
        """Give all groups and the silhouette one ink."""
        self.silhouette_ink = ink
        for name in GROUPS:
            self._group(name).ink = ink

    def copy(self, **fields: Any) -> Style:
        """Another style like this one, with some fields changed."""
        copy = Style()
        copy._preset, copy._groups, copy._tone = self._preset, self._groups, self._tone
        copy._struct[0] = self._struct[0]
        copy.update(**fields)
        return copy

    def update(self, **fields: Any) -> None:
        """Change some fields; a group's as a mapping, and `ink` for `set_ink`."""
        for name, value in fields.items():
            if name == "ink":
                self.set_ink(value)
            elif name in GROUPS:
                for field, part in dict(value).items():
                    setattr(self._group(name), field, part)
            elif name in self.fields() or name == "tone":
                setattr(self, name, value)
            else:
                raise TypeError(f"Style has no field {name!r}")

    def _values(self) -> Dict[str, Any]:
        values = {name: getattr(self, name) for name in self.fields()}
        values.update({name: self._group(name)._values() for name in GROUPS})
        return {**values, "tone": self.tone}

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Style) and self._values() == other._values()

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> Any:
        return _restore, (self._preset, self._values())

    def __repr__(self) -> str:
        base = Style(self._preset)._values()
        changed = [f"{k}={v!r}" for k, v in self._values().items() if v != base[k]]
        return f"Style({', '.join([repr(self._preset), *changed])})"

    def _prepared(self) -> Tuple[Any, Optional[CallbackState], Any]:
        """A copy for one frame, the state of its tone function, and what must be kept alive."""
        struct = ffi.new("hrbfnpr_style *", self._struct[0])
        if self._tone is None:
            return struct, None, struct
        state = CallbackState(self._tone)
        user = state.new_handle()
        struct.tone_function, struct.tone_user = _on_tone, user
        return struct, state, (struct, user)


def _restore(preset: Optional[str], values: Mapping[str, Any]) -> Style:
    return Style(preset, **values)


def _vectors(address: Any, count: int) -> Array:
    data = bytearray(ffi.buffer(address, count * 12))
    if np is not None:
        return np.frombuffer(data, dtype="f").reshape(count, 3)
    return memoryview(data).cast("f", shape=[count, 3])


@callback("int32_t(void *, int64_t, const float *, const float *, float *)", failure=1)
def _on_tone(user: Any, count: int, positions: Any, normals: Any, tau: Any) -> int:
    result = ffi.from_handle(user).function(_vectors(positions, count), _vectors(normals, count))
    store("the result of tone", result, count, 1, "f", tau)
    return 0
