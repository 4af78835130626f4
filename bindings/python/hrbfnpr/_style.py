# SPDX-License-Identifier: MIT
"""Styles: how a point set is drawn."""
from __future__ import annotations

from typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

from ._arrays import Array, store, vector
from ._callbacks import CallbackState, callback
from ._errors import check, new_error, new_struct
from ._fields import Attributes, Color, Field, choice, color_field, flag, integer, number
from ._kind_style import KindStyle
from ._layer import new_list
from ._library import ffi, lib
from ._line_style import LineStyle
from ._names import (
    HIDDEN_LINES,
    LAYER_KINDS,
    LIGHT_SPACES,
    PRESETS,
    SHAPES,
    SILHOUETTE_LAWS,
    TONE_CURVES,
    TONE_RULES,
    TONES,
    VISIBILITIES,
    name_of,
    number_of,
)
from ._numpy import np

ToneFunction = Callable[[Array, Array], Any]


def _directions(name: str, value: Union[int, str, Iterable[str]]) -> int:
    """Bits of directions: the bits themselves, or names."""
    if isinstance(value, int):
        return value
    names = {"first": 1, "second": 2}
    return sum({number_of(name, names, part) for part in ([value] if isinstance(value, str) else value)})


class LayerStyle(KindStyle):
    """How layers of marks are drawn; an element of `Style.layers`.

    Parameters
    ----------
    kind : {"any", "stipples", "principal", "combing", "field", "own"}
        The layers that this is for ...
    name : str, optional
        ... and are called so; None: whatever they are called.
    **fields
        Other fields to change.
    """

    kind = choice(LAYER_KINDS, "The layers that this is for: a kind of them, or \"any\" ...")
    shown = flag("Whether front marks are drawn.")
    contours = flag("Whether marks near a contour draw it.")
    directions = Field[Tuple[str, ...], Union[int, str, Iterable[str]]](
        _directions,
        lambda bits: tuple(name for bit, name in enumerate(("first", "second")) if bits >> bit & 1),
        'Of strokes: those of ("first", "second") that are drawn.',
    )
    shape = choice(
        SHAPES,
        '"dots", "strokes": marks that follow each other along a stroke are one line, or "hatch": strokes are lines '
        "whose width makes the tone, drawn where it is dark enough.",
    )
    share = number("Share of the layer's marks that is used at all, 0 to 1.")
    radius = number("Of a mark, half the width of a stroke, pixels.")
    radius_zoom = number("0: radius is in pixels at any zoom; 1: grows with the zoom; or between.")
    ink = color_field("Straight RGBA in [0, 1], or '#rrggbb'.")
    hatch_tone_begin = number("Of shape \"hatch\": darkness (1 - tau) from which on there are lines, 0 to 1.")
    hatch_tone_end = number("Darkness from which on they get no wider, above hatch_tone_begin, to 1.")
    hatch_coverage_begin = number("Share of the paper that is covered at hatch_tone_begin, above 0, to 1.")
    hatch_coverage_end = number("Share of the paper that is covered at hatch_tone_end, above 0, to 1.")
    hatch_spacing = number("Least from line to line, pixels.")
    hatch_pen = number("Least width of a line, pixels.")
    hatch_white = number("Left between lines at least, pixels.")
    hatch_taper = number("Over which a line narrows where it ends by its tone, pixels.")
    hatch_shortest = number("Shorter pieces are not drawn, those up to twice as long are thinner; pixels.")
    hatch_wobble = number("How far a line may stray to either side, as of an unsteady hand, in hatch_pens.")
    hatch_overshoot = number(
        "Lines run on past the tone that they end at by up to this, each by another length; pixels."
    )
    hatch_seed = integer("Of these two: any number.")

    _c_type = "hrbfnpr_layer_style"

    def __init__(self, kind: str = "any", name: Optional[str] = None, **fields: Any) -> None:
        super().__init__(kind, name, fields)

    def _is_for(self, kind: str, name: Optional[str]) -> bool:
        return self.kind in ("any", kind) and self.name in (None, name)


class Style(Attributes):
    """How a point set is drawn.  Every field is an attribute and may be changed at any time.

    Parameters
    ----------
    preset : str, optional
        One of `hrbfnpr.PRESETS`; the library's default style if omitted.
    **fields
        Fields to change; `ink` is that of all layers and contours, and a kind of layers (`stipples`,
        `principal`, ...) takes a mapping of fields of its `LayerStyle`.

    Attributes
    ----------
    layers : list of LayerStyle
        A layer of marks takes the first that is for it, or the defaults.
    lines : list of LineStyle
        What is drawn of the lines of items that have a `LineSet`.

    Examples
    --------
    >>> style = hrbfnpr.Style("hatch", tone_exponent=1.5, ink="#402010", principal={"radius": 1.5})
    >>> style.layer("stipples").shown = True
    >>> style.layers.insert(0, hrbfnpr.LayerStyle(name="fur", shape="strokes", ink="#402010"))
    """

    hidden_lines = choice(
        HIDDEN_LINES, '"attenuate" (seen faintly through what is in front), "hide" or "show" [NPAR 6.1].'
    )
    visibility = choice(
        VISIBILITIES,
        '"depth_layers": marks are seen through the layers of surface in front of them, whatever the number of marks; '
        '"published": paper and ink from far to near [NPAR 6.1].  One for all styles of a drawing.',
    )
    silhouette_threshold = number(
        'delta in (0, 1): marks with abs(n . v) below it are silhouettes [NPAR 6]; of silhouette_law "width" only a '
        "limit that the line keeps."
    )
    silhouette_law = choice(
        SILHOUETTE_LAWS, '"width": a line of constant width; "angle": by silhouette_threshold alone, as published.'
    )
    silhouette_width = number('Of silhouette_law "width": pixels on either side of the contour.')
    attenuation_front = number("lambda of alpha_f = nu^2 lambda.")
    attenuation_back = number("lambda of alpha_b = 0.2 (ln(nu - 0.05) + 5) lambda.")
    splat_radius = number("Of the piece of surface that a mark stands for, pixels; 0 = from the marks' spacing.")
    halo_width = number(
        'Pixels; of visibility "depth_layers" how far beyond its contour a surface hides what lies behind, else how '
        "much wider the paper of back marks is."
    )
    splat_overlap = number("n > 0: a depth layer is as opaque as n overlapping splats; 0: as published.")
    tone_rule = choice(TONE_RULES, '"share" or "published": how tone, depth, zoom and share are combined.')
    tone_curve = choice(
        TONE_CURVES,
        'Of tone_rule "share".  "coverage": marks cover 1 - tau of the paper at any zoom and number of marks; '
        '"linear": the share of marks is 1 - tau [NPAR 6.2].',
    )
    tone_fade = number(
        "0 to 1: marks grow from nothing to their full area over this share of the marks shown; 0 = they pop."
    )
    light_space = choice(LIGHT_SPACES, '"world" or "camera".')
    tone_exponent = number("lambda of the tone law tau = max(0, n . l)^lambda, > 0 [NPAR 6.2].")
    fill_light = number(
        "0 to 1: light from the side opposite to `light`, so that what is turned away keeps its form; tau = fill_light "
        "(n . l)^2 where n . l < 0.  Not as published."
    )
    depth_min = number("Distance from the camera where depth attenuation starts.")
    depth_max = number("... and where nothing is shown any more; 0 and 0 = off.")
    zoom_reference = number("Pixels per world unit at which all marks are shown; 0 = off.")
    zoom_exponent = number("How fast marks vanish below it; 2 keeps the ink per area.")
    paper = color_field("Straight RGBA in [0, 1], or '#rrggbb'; alpha 0 = transparent.")
    silhouette_ink = color_field("Of silhouette marks.")
    silhouette_radius = number("Of silhouette marks, pixels.")
    silhouette_radius_zoom = number("As radius_zoom of a `LayerStyle`.")
    light = Field[Tuple[float, ...], Sequence[float]](vector, tuple, "Towards the light; normalised on use.")

    def __init__(self, preset: Optional[str] = None, **fields: Any) -> None:
        self._preset = preset
        self._tone: Optional[ToneFunction] = None
        self._layers: List[LayerStyle] = []
        self._lines: List[LineStyle] = []
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
        """Lists of the struct as lists of Python, which can be changed."""
        struct = self._struct
        self._layers = [LayerStyle._from_struct(each) for each in _elements(struct, "layer")]
        self._lines = [LineStyle._from_struct(each) for each in _elements(struct, "line")]
        for name in ("layer", "line"):
            setattr(struct, f"{name}s", ffi.NULL)
            setattr(struct, f"{name}_count", 0)
            setattr(struct, f"{name}_stride", 0)

    @classmethod
    def _from_struct(cls, struct: Any, preset: str, tone: Optional[ToneFunction]) -> Style:
        """A hrbfnpr_style of the library's; `tone` is its function of tone, if it is one of Python."""
        style = cls()
        style._struct[0], style._preset = struct[0], preset
        style._copy_lists()
        if style._struct.tone == TONES["callback"]:
            style._tone, style._struct.tone = tone, TONES["light" if tone is None else "callback"]
        return style

    @property
    def preset(self) -> Optional[str]:
        """The name it was made from: what to give to `PointSet.generate`."""
        return self._preset

    @property
    def layers(self) -> List[LayerStyle]:
        """A layer of marks takes the first that is for it, or the defaults of `LayerStyle`."""
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
        """What is drawn of the lines of items that have a `LineSet`."""
        return self._lines

    @lines.setter
    def lines(self, value: Iterable[Union[LineStyle, str]]) -> None:
        lines = [LineStyle(line) if isinstance(line, str) else line for line in value]
        for line in lines:
            if not isinstance(line, LineStyle):
                raise TypeError(f"lines must be hrbfnpr.LineStyle objects or kinds, not {type(line).__name__}")
        self._lines = lines

    def layer(self, which: str) -> LayerStyle:
        """The element of `layers` for a kind of layers ("any": those that no other is for), or for a name.

        If what they take so far is for others too, a copy of it for them alone is put in front of it.
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
        """What a layer of marks takes: the first of `layers` that is for it, or defaults."""
        return next((style for style in self._layers if style._is_for(kind, name)), LayerStyle(kind))

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
        """Give all layers, lines and the contours one ink."""
        self.silhouette_ink = ink
        for line in self._lines:
            line.ink = ink
        self.layer("any")
        for style in self._layers:
            style.ink = ink

    def copy(self, **fields: Any) -> Style:
        """Another style like this one, with some fields changed."""
        copy = Style()
        copy._preset, copy._tone = self._preset, self._tone
        copy._layers = [style.copy() for style in self._layers]
        copy._lines = [style.copy() for style in self._lines]
        copy._struct[0] = self._struct[0]
        copy.update(**fields)
        return copy

    def update(self, **fields: Any) -> None:
        """Change some fields; those of a kind of layers as a mapping, and `ink` for `set_ink`."""
        for name, value in fields.items():
            if name == "ink":
                self.set_ink(value)
            elif name in LAYER_KINDS:
                layer = self.layer(name)
                for field, part in dict(value).items():
                    setattr(layer, field, part)
            elif name in self.fields() or name in ("tone", "layers", "lines"):
                setattr(self, name, value)
            else:
                raise TypeError(f"Style has no field {name!r}")

    def _values(self) -> Dict[str, Any]:
        values = {name: getattr(self, name) for name in self.fields()}
        return {**values, "tone": self.tone, "layers": [style.copy() for style in self._layers],
                "lines": [style.copy() for style in self._lines]}

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
        """A copy for one drawing, the state of its tone function, and what must be kept alive."""
        struct = ffi.new("hrbfnpr_style *", self._struct[0])
        layers = new_list("hrbfnpr_layer_style", len(self._layers))
        keep = [struct, layers]
        for i, style in enumerate(self._layers):
            keep.append(style._fill(ffi.addressof(layers, i)))
        struct.layers, struct.layer_count = layers, len(self._layers)
        lines = new_list("hrbfnpr_line_style", len(self._lines))
        keep.append(lines)
        for i, line in enumerate(self._lines):
            keep.append(line._fill(ffi.addressof(lines, i)))
        struct.lines, struct.line_count = lines, len(self._lines)
        if self._tone is None:
            return struct, None, keep
        state = CallbackState(self._tone)
        user = state.new_handle()
        struct.tone_function, struct.tone_user = _on_tone, user
        return struct, state, [*keep, user]


def _elements(style: Any, name: str) -> List[Any]:
    """The structs of a list of a style's."""
    first, count = getattr(style, f"{name}s"), getattr(style, f"{name}_count")
    stride = getattr(style, f"{name}_stride") or (first.struct_size if count else 0)
    kind = f"hrbfnpr_{name}_style *"
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
