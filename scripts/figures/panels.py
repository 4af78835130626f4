# SPDX-License-Identifier: MIT
"""Classes of figures and panels, and the options with which each model is seen."""

from typing import NamedTuple, Optional, Tuple

# The options that select the published method.
PUBLISHED = (
    "--distribution published --visibility published --tone-rule published --tone-curve linear --tone-fade 0"
)


class Panel(NamedTuple):
    """One drawing."""

    name: str
    title: str
    model: str
    options: str
    kind: str = "draw"  # a command of hrbfnpr, or "samples", "decay", "svg", "plot"
    # The part of the picture that is shown: left, top, right, bottom, as shares of its size.
    part: Optional[Tuple[float, float, float, float]] = None
    scale: float = 1.0  # factor of the picture's size


class Figure(NamedTuple):
    number: str
    title: str
    caption: str
    settings: str
    panels: Tuple[Panel, ...]


def both(name, title, model, options, ours, **more):
    """Two panels: by the published method, and with the settings of hrbfnpr."""
    return (
        Panel(f"{name}_published", f"{title}, as published", model, f"{PUBLISHED} {options}", **more),
        Panel(f"{name}_ours", f"{title}, hrbfnpr", model, ours, **more),
    )


HEAD = "--azimuth 20 --elevation 5"
KNOT = "--up z --azimuth 20 --elevation 50"
TORI = "--up z --azimuth 25 --elevation 35"
HEART = "--azimuth 20 --elevation 10"
CANYON = "--up z --azimuth 20 --elevation 30"
RAKING = "--light-space world --light -0.8,-0.3,0.8"  # with a steeper light, flat ground would be bright everywhere
MANY = "--levels 4 --mark-radius 0.5"
LAMP = "--azimuth 30 --elevation 15"
BUNNY = "--azimuth 20 --elevation 15"
BOX = "--seeds box --box-resolution 8"
# The first direction of the article is the one in which the surface bends most. The first direction of the library has the
# larger signed curvature; on a convex surface it is the other one.
FIRST, SECOND = "--set hatch.directions=second", "--set hatch.directions=first"
ALONG_FIRST, ALONG_SECOND = "--style hatch", "--style hatch --hatch-angle 90"
