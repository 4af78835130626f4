# SPDX-License-Identifier: MIT
"""Styles: how a point set is drawn."""
from __future__ import annotations

from typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

from ._arrays import Array, store
from ._callbacks import CallbackState, callback
from ._errors import check, new_error, new_list, new_struct
from ._fields import Color, Field, color
from ._library import ffi, lib
from ._light import Light
from ._line_style import LineStyle
from ._names import LAYER_KINDS, PRESETS, TONES, name_of, number_of
from ._numpy import np
from ._records import LayerStyleFields, StyleFields, text_in
from ._style_part import KindStyle, StylePart

ToneFunction = Callable[[Array, Array], Any]

# The fields of a hrbfnpr_layer_style that name fields of a point set.
_NAMED = ("density_field", "tone_field", "width_field", "ink_field", "mask_field")

# The lists of a hrbfnpr_style, without the plural's "s", each with the type of its elements.
_LISTS = {"layer": "hrbfnpr_layer_style", "line": "hrbfnpr_line_style", "light": "hrbfnpr_light"}


def _directions(name: str, value: Union[int, str, Iterable[str]]) -> int:
    """The bits of directions, from the bits themselves or from names."""
    if isinstance(value, int):
        return value
    names = {"first": 1, "second": 2}
    return sum({number_of(name, names, part) for part in ([value] if isinstance(value, str) else value)})


def _named(name: str, doc: str) -> Any:
    """An attribute that names a field of the point set."""

    def write(self: LayerStyle, value: Optional[str]) -> None:
        if value is not None and not isinstance(value, str):
            raise TypeError(f"{name} must be the name of a field of the point set, not {type(value).__name__}")
        self._names[name] = value

    return property(lambda self: self._names.get(name), write, doc=doc)


class LayerStyle(LayerStyleFields, KindStyle):
    """How layers of marks are drawn; an element of `Style.layers`.

    Parameters
    ----------
    kind : {"any", "stipples", "hatch", "own"}
        The kind of layers that the style is for.
    name : str, optional
        The name of the layers that the style is for; None: any name.
    **fields
        Other fields to change.
    """

    directions = Field[Tuple[str, ...], Union[int, str, Iterable[str]]](
        _directions,
        lambda bits: tuple(name for bit, name in enumerate(("first", "second")) if bits >> bit & 1),
        'For strokes: the directions that are drawn, of ("first", "second").',
    )
    density_field: Optional[str] = _named("density_field", "Name of the field by which the share of marks is multiplied.")
    tone_field: Optional[str] = _named("tone_field", "Name of the field that is the tone, or scales it; see `tone_field_rule`.")
    width_field: Optional[str] = _named("width_field", "Name of the field by which radii and widths are multiplied.")
    ink_field: Optional[str] = _named("ink_field", "Name of the field of colours for which marks take inks of `Style.palette`.")
    mask_field: Optional[str] = _named("mask_field", "Name of the field that leaves marks out where it is below 0.5.")
    _c_type = "hrbfnpr_layer_style"

    def __init__(self, kind: str = "any", name: Optional[str] = None, **fields: Any) -> None:
        self._names: Dict[str, Optional[str]] = {}
        super().__init__(kind, name, fields)

    @classmethod
    def _from_struct(cls, struct: Any) -> LayerStyle:
        made = super()._from_struct(struct)
        for name in _NAMED:
            given = getattr(struct, name)
            made._names[name] = None if given == ffi.NULL else ffi.string(given).decode()
            setattr(made._struct, name, ffi.NULL)
        return made

    def _values(self) -> Dict[str, Any]:
        return {**super()._values(), **{name: self._names.get(name) for name in _NAMED}}

    def _fill(self, target: Any) -> Any:
        keep: List[Any] = super()._fill(target)
        for name in _NAMED:
            setattr(target, name, text_in(keep, self._names.get(name)))
        return keep

    def _is_for(self, kind: str, name: Optional[str]) -> bool:
        return self.kind in ("any", kind) and self.name in (None, name)


class Style(StyleFields):
    """How a point set and its lines are drawn.  Every field is an attribute, and may be changed at any time.

    Parameters
    ----------
    preset : str, optional
        A named style of `hrbfnpr.PRESETS`; None: the library's default style.
    **fields
        Fields to change, as in `update`.

    Attributes
    ----------
    layers : list of LayerStyle
        How layers of marks are drawn.  A layer takes the first element that is for it, or the defaults.
    lines : list of LineStyle
        Which lines are drawn, and how, for items that have a `LineSet`.
    lights : list of Light
        The lights, up to 8.  An empty list is one light with the fields `light` and `light_space`.
    palette : list of colours
        Up to 8 inks for layers with an `ink_field`.

    Examples
    --------
    >>> style = hrbfnpr.Style("hatch", tone_exponent=1.5, ink="#402010", stipples={"radius": 1.5})
    >>> style.layer("stipples").shown = True
    >>> style.layers.insert(0, hrbfnpr.LayerStyle(name="fur", shape="strokes", ink="#402010"))
    """

    def __init__(self, preset: Optional[str] = None, **fields: Any) -> None:
        self._preset = preset
        self._tone: Optional[ToneFunction] = None
        self._layers: List[LayerStyle] = []
        self._lines: List[LineStyle] = []
        self._lights: List[Light] = []
        self._palette: List[Tuple[float, ...]] = []
        if preset is None:
            self._struct = new_struct("hrbfnpr_style")
        else:
            self._init_preset(preset)
        self.update(**fields)

    def _init_preset(self, preset: str) -> None:
        if preset not in PRESETS:
            raise ValueError(f"preset must be one of {', '.join(map(repr, PRESETS))}, not {preset!r}")
        self._struct = struct = ffi.new("hrbfnpr_style *")
        error = new_error()
        status = lib.hrbfnpr_style_init_preset(struct, ffi.sizeof("hrbfnpr_style"), PRESETS.index(preset), error)
        check(status, error)
        self._copy_lists()

    def _copy_lists(self) -> None:
        """Copy the lists of the struct to lists of Python, which can be changed."""
        struct = self._struct
        self._layers = [LayerStyle._from_struct(each) for each in _elements(struct, "layer")]
        self._lines = [LineStyle._from_struct(each) for each in _elements(struct, "line")]
        self._lights = [Light._from_struct(each) for each in _elements(struct, "light")]
        inks = ffi.unpack(struct.palette, 4 * struct.palette_count) if struct.palette_count else []
        self._palette = [tuple(inks[i : i + 4]) for i in range(0, len(inks), 4)]
        struct.palette, struct.palette_count = ffi.NULL, 0
        for name in _LISTS:
            setattr(struct, f"{name}s", ffi.NULL)
            setattr(struct, f"{name}_count", 0)
            setattr(struct, f"{name}_stride", 0)

    @classmethod
    def _from_struct(cls, struct: Any, preset: str, tone: Optional[ToneFunction]) -> Style:
        """A style from a hrbfnpr_style of the library.  `tone` is its tone function, if that is one of Python."""
        style = cls()
        style._struct[0], style._preset = struct[0], preset
        style._copy_lists()
        if style._struct.tone == TONES["callback"]:
            style._tone, style._struct.tone = tone, TONES["light" if tone is None else "callback"]
        return style

    @property
    def preset(self) -> Optional[str]:
        """The named style from which this style was made; give it to `PointSet.generate`.  None: the default style."""
        return self._preset

    @property
    def layers(self) -> List[LayerStyle]:
        """How layers of marks are drawn.  A layer takes the first element that is for it, or the defaults of `LayerStyle`."""
        return self._layers

    @layers.setter
    def layers(self, value: Iterable[LayerStyle]) -> None:
        layers = list(value)
        for layer in layers:
            if not isinstance(layer, LayerStyle):
                raise TypeError(f"layers must be hrbfnpr.LayerStyle objects, not {type(layer).__name__}")
        self._layers = layers

    @property
    def lines(self) -> List[LineStyle]:
        """Which lines are drawn, and how, for items that have a `LineSet`.  A kind alone means its default `LineStyle`."""
        return self._lines

    @lines.setter
    def lines(self, value: Iterable[Union[LineStyle, str]]) -> None:
        lines = [LineStyle(line) if isinstance(line, str) else line for line in value]
        for line in lines:
            if not isinstance(line, LineStyle):
                raise TypeError(f"lines must be hrbfnpr.LineStyle objects or kinds, not {type(line).__name__}")
        self._lines = lines

    @property
    def lights(self) -> List[Light]:
        """The lights, up to 8.  An empty list is one light with the fields `light` and `light_space`."""
        return self._lights

    @lights.setter
    def lights(self, value: Iterable[Light]) -> None:
        lights = list(value)
        for light in lights:
            if not isinstance(light, Light):
                raise TypeError(f"lights must be hrbfnpr.Light objects, not {type(light).__name__}")
        self._lights = lights

    @property
    def palette(self) -> List[Tuple[float, ...]]:
        """The inks for layers with an `ink_field`, as straight RGBA in [0, 1]; up to 8.

        It may be set to colours such as ["#202020", "#b03020"]; set it whole, as changes of this list have no effect.
        """
        return list(self._palette)

    @palette.setter
    def palette(self, value: Iterable[Color]) -> None:
        self._palette = [color("palette", ink) for ink in value]

    def layer(self, which: str) -> LayerStyle:
        """Return the element of `layers` for a kind of layers or for a name, to change it.

        If these layers share an element with others, a copy for them alone is inserted before it.

        Parameters
        ----------
        which : str
            A kind of layers ("stipples", "hatch", "own"), "any" for the layers that have no other element, or a name.
        """
        if which.replace("-", "_") not in LAYER_KINDS:
            for style in self._layers:
                if style.name == which:
                    return style
            self._layers.insert(0, self.style_of("any", which).copy(name=which))
            return self._layers[0]
        kind = which.replace("-", "_")
        for place, style in enumerate(self._layers):
            if style.name is None and style.kind == kind:
                return style
            if style.name is None and style.kind == "any":
                self._layers.insert(place, style.copy(kind=kind))
                return self._layers[place]
        self._layers.append(LayerStyle(kind))
        return self._layers[-1]

    def style_of(self, kind: str, name: Optional[str] = None) -> LayerStyle:
        """Return the style of a layer of marks: the first of `layers` that is for it, or the defaults."""
        return next((style for style in self._layers if style._is_for(kind, name)), LayerStyle(kind))

    @property
    def tone(self) -> Union[str, ToneFunction]:
        """The source of the tone: "none", "light" (default), or a function.

        The function gets positions in the world and unit normals, float32 (n, 3) each, and returns n numbers: 1 = light,
        0 = dark.
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
        """Give all layers, lines and contours the same ink."""
        self.silhouette_ink = ink
        for line in self._lines:
            line.ink = ink
        self.layer("any")
        for style in self._layers:
            style.ink = ink

    def copy(self, **fields: Any) -> Style:
        """Return a copy with some fields changed, as in `update`."""
        copy = Style()
        copy._preset, copy._tone = self._preset, self._tone
        copy._layers = [style.copy() for style in self._layers]
        copy._lines = [style.copy() for style in self._lines]
        copy._lights = [light.copy() for light in self._lights]
        copy._palette = list(self._palette)
        copy._struct[0] = self._struct[0]
        copy.update(**fields)
        return copy

    def update(self, **fields: Any) -> None:
        """Change some fields.

        Parameters
        ----------
        **fields
            Names of fields with their values.  `ink` sets the ink of all layers, lines and contours.  A kind of layers
            (`stipples`, `hatch`, `own`, `any`) takes a mapping of fields of its `LayerStyle`.
        """
        for name, value in fields.items():
            if name == "ink":
                self.set_ink(value)
            elif name in LAYER_KINDS:
                layer = self.layer(name)
                for field, part in dict(value).items():
                    setattr(layer, field, part)
            elif name in self.fields() or name in ("tone", "layers", "lines", "lights", "palette"):
                setattr(self, name, value)
            else:
                raise TypeError(f"Style has no field {name!r}")

    def _values(self) -> Dict[str, Any]:
        values = {name: getattr(self, name) for name in self.fields()}
        return {**values, "tone": self.tone, "layers": [style.copy() for style in self._layers],
                "lines": [style.copy() for style in self._lines], "lights": [light.copy() for light in self._lights],
                "palette": self.palette}

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
        """A copy for one drawing, the state of its tone function, and the objects to keep alive."""
        struct = ffi.new("hrbfnpr_style *", self._struct[0])
        keep = [struct]
        lists: Tuple[Sequence[StylePart], ...] = (self._layers, self._lines, self._lights)
        for (name, kind), parts in zip(_LISTS.items(), lists):
            structs = new_list(kind, len(parts))
            keep += [structs, *(part._fill(ffi.addressof(structs, i)) for i, part in enumerate(parts))]
            setattr(struct, f"{name}s", structs)
            setattr(struct, f"{name}_count", len(parts))
        inks = ffi.new("float[]", [number for ink in self._palette for number in ink])
        keep.append(inks)
        struct.palette, struct.palette_count = inks if self._palette else ffi.NULL, len(self._palette)
        if self._tone is None:
            return struct, None, keep
        state = CallbackState(self._tone)
        user = state.new_handle()
        struct.tone_function, struct.tone_user = _on_tone, user
        return struct, state, [*keep, user]


def _elements(style: Any, name: str) -> List[Any]:
    """The structs of a list in a hrbfnpr_style."""
    first, count = getattr(style, f"{name}s"), getattr(style, f"{name}_count")
    stride = getattr(style, f"{name}_stride") or (first.struct_size if count else 0)
    kind = f"{_LISTS[name]} *"
    return [ffi.cast(kind, ffi.cast("char *", first) + i * stride)[0] for i in range(count)]


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
