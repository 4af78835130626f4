# SPDX-License-Identifier: MIT
"""Pictures in matplotlib's axes, and a viewer of ipywidgets.  Both are imported when they are used."""
from __future__ import annotations

from typing import Any, Optional, Union

import numpy as np

from ._context import Context
from ._draw_call import draw
from ._drawing import Drawing
from ._names import PRESETS
from ._picture import Picture
from ._report import Progress
from ._style import Style

SIZE = 480  # longer side


def matplotlib_show(picture: Any, ax: Optional[Any] = None, **options: Any) -> Any:
    """Show a picture in matplotlib's axes, without ticks.

    Parameters
    ----------
    picture : Picture, Drawing or array of uint8, shape (height, width, 4)
    ax : matplotlib.axes.Axes, optional
        Where; pyplot's current axes if omitted.
    **options
        Of `Axes.imshow`.

    Returns
    -------
    matplotlib.image.AxesImage

    Raises
    ------
    ImportError
        Without axes and without matplotlib.

    Examples
    --------
    >>> figure, axes = matplotlib.pyplot.subplots(1, 2)
    >>> for ax, style in zip(axes, ("stipple", "hatch")):
    ...     hrbfnpr.matplotlib_show(hrbfnpr.draw("bunny.ply", style, size=600), ax)
    """
    if ax is None:
        try:
            from matplotlib import pyplot
        except ImportError as error:
            raise ImportError("matplotlib_show needs matplotlib (Debian: python3-matplotlib), or axes") from error
        ax = pyplot.gca()
    if isinstance(picture, Picture):
        image: Any = picture.image
    else:
        image = picture.image() if isinstance(picture, Drawing) else np.asarray(picture)
    shown = ax.imshow(image, **options)
    ax.set_axis_off()
    return shown


class Viewer:
    """A drawing with sliders for its camera and a choice of styles, for notebooks.  Needs ipywidgets.

    Attributes
    ----------
    picture : Picture
        What is seen now.
    azimuth, elevation, style, image, message
        The widgets.
    box
        What holds them all, to be put beside others.
    """

    def __init__(self, picture: Picture) -> None:
        try:
            import ipywidgets as widgets
        except ImportError as error:
            raise ImportError("a viewer needs ipywidgets (Debian: python3-ipywidgets)") from error
        own = isinstance(picture._scene.style_given, Style)
        names = ["own", *PRESETS] if own else list(PRESETS)
        self.picture = self._styled = picture
        azimuth, elevation = picture.angles
        self.azimuth = widgets.FloatSlider(azimuth % 360, min=0, max=360, step=5, description="azimuth")
        self.elevation = widgets.FloatSlider(elevation, min=-85, max=85, step=5, description="elevation")
        self.style = widgets.Dropdown(options=names, value="own" if own else picture._scene.preset, description="style")
        self._own = picture.style
        self.image = widgets.Image(value=picture.to_png(), format="png")
        self.message = widgets.Label()
        self.box = widgets.VBox([widgets.HBox([self.azimuth, self.elevation, self.style]), self.image, self.message])
        for slider in (self.azimuth, self.elevation):
            slider.continuous_update = False
            slider.observe(self._turn, "value")
        self.style.observe(self._restyle, "value")

    def _turn(self, change: Any) -> None:
        self._show(lambda: self._styled.seen(self.azimuth.value, self.elevation.value))

    def _restyle(self, change: Any) -> None:
        name = self.style.value

        def make() -> Picture:
            self._styled = self.picture.restyled(self._own if name == "own" else name)
            return self._styled

        self._show(make)

    def _show(self, make: Any) -> None:
        """What fails is said below the picture: a notebook does not show it elsewhere."""
        try:
            self.picture = make()
            self.image.value, self.message.value = self.picture.to_png(), ""
        except (ValueError, ArithmeticError, OSError, MemoryError) as error:
            self.message.value = str(error)

    def _ipython_display_(self) -> None:
        from IPython.display import display

        display(self.box)


def widget(
    source: Any,
    style: Union[str, Style] = "contour-and-stipple",
    *,
    progress: Progress = None,
    context: Optional[Context] = None,
    **options: Any,
) -> Viewer:
    """A drawing to turn and to restyle in a notebook.  Needs ipywidgets.

    Parameters
    ----------
    source, style, progress, context, **options
        As in `draw`; `size` is 480 by default.

    Examples
    --------
    >>> hrbfnpr.widget("bunny.ply", "hatch")
    """
    options.setdefault("size", SIZE)
    return Viewer(draw(source, style, progress=progress, context=context, **options))
