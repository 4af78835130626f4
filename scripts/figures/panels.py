# SPDX-License-Identifier: MIT
"""What figures and panels are, and views of the models."""

from typing import NamedTuple, Optional, Tuple

# The article's own method in all its parts.
PUBLISHED = (
    "--distribution published --visibility published --tone-rule published --tone-curve linear --tone-fade 0"
)


class Panel(NamedTuple):
    """One drawing.  A part is left, upper, right, lower as shares of a larger picture."""

    name: str
    title: str
    model: str
    options: str
    kind: str = "draw"  # or another command; or "samples", "decay", "svg", "plot"
    part: Optional[Tuple[float, float, float, float]] = None
    scale: float = 1.0  # of the size


class Figure(NamedTuple):
    number: str
    title: str
    caption: str
    settings: str
    panels: Tuple[Panel, ...]


def both(name, title, model, options, ours, **more):
    """The article's way and ours, beside it."""
    return (
        Panel(f"{name}_published", f"{title}, as published", model, f"{PUBLISHED} {options}", **more),
        Panel(f"{name}_ours", f"{title}, ours", model, ours, **more),
    )


HEAD = "--azimuth 20 --elevation 5"
KNOT = "--up z --azimuth 20 --elevation 50"
TORI = "--up z --azimuth 25 --elevation 35"
HEART = "--azimuth 20 --elevation 10"
CANYON = "--up z --azimuth 20 --elevation 30"
RAKING = "--light-space world --light -0.8,-0.3,0.8"  # what is flat is bright by any other light
MANY = "--levels 4 --mark-radius 0.5"
LAMP = "--azimuth 30 --elevation 15"
BUNNY = "--azimuth 20 --elevation 15"
BOX = "--seeds box --box-resolution 8"
# By the article's first direction the surface bends most, around a limb; in the library the first is that of the
# larger curvature by sign, which is the other one where the surface is convex.
FIRST, SECOND = "--set hatch.directions=second", "--set hatch.directions=first"
ALONG_FIRST, ALONG_SECOND = "--style hatch", "--style hatch --hatch-angle 90"
