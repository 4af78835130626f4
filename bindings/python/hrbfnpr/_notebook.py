# SPDX-License-Identifier: MIT
"""Pictures in matplotlib axes, and a viewer with ipywidgets.  Both packages are imported on first use."""
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

SIZE = 480  # longer side, in pixels


def matplotlib_show(picture: Any, ax: Optional[Any] = None, **options: Any) -> Any:
    """Show a picture in matplotlib axes, without ticks.

    Parameters
    ----------
    picture : Picture, Drawing or array of uint8, shape (height, width, 4)
        What to show.
    ax : matplotlib.axes.Axes, optional
        The axes to draw in; None: pyplot's current axes.
    **options
        Options of `Axes.imshow`.

    Returns
    -------
    matplotlib.image.AxesImage
        The result of `Axes.imshow`.

    Raises
    ------
    ImportError
        If no axes are given and matplotlib is not installed.

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
    """A drawing with sliders for its camera and a list of styles, for notebooks.  Needs ipywidgets.

    Attributes
    ----------
    picture : Picture
        The picture that is shown now.
    azimuth, elevation, style, image, message
        The widgets.
    box
        The widget that contains all of them, to put beside other widgets.
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
        """Show the picture that `make` returns, or its error below the old picture: a notebook hides errors of callbacks."""
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
    """Draw a source with controls to turn and to restyle it in a notebook.  Needs ipywidgets.

    Parameters
    ----------
    source, style, progress, context, **options
        As in `draw`, except that `size` is 480 by default.

    Returns
    -------
    Viewer
        The drawing with its controls; it shows itself in a notebook.

    Raises
    ------
    ImportError
        If ipywidgets is not installed.

    Examples
    --------
    >>> hrbfnpr.widget("bunny.ply", "hatch")
    """
    options.setdefault("size", SIZE)
    return Viewer(draw(source, style, progress=progress, context=context, **options))
