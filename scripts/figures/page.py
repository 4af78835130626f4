# SPDX-License-Identifier: MIT
"""Writes the page of the gallery as HTML."""

from html import escape

HEAD = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Figures drawn again</title>
<style>
body { font: 1rem/1.5 Georgia, serif; margin: 0 auto; max-width: 75rem; padding: 0 1rem; color: #111; background: #fff }
section { margin: 2rem 0; border-top: 1px solid #bbb }
.panels { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 20rem), 1fr)); gap: 1rem }
figure { margin: 0 }
img { max-width: 100%; height: auto; display: block; margin: 0 auto }
figcaption { font-size: 0.9rem; text-align: center }
code { font-size: 0.8rem; overflow-wrap: anywhere }
</style>
</head>
<body>
<h1>Figures drawn again</h1>
<p>Figures of E. Vital Brazil, I. Macêdo, M. Costa Sousa, L. Velho, L. H. de Figueiredo: <cite>A Few Good Samples: Shape
&amp; Tone Depiction for Hermite RBF Implicits</cite>, NPAR 2010, drawn by hrbfnpr twice: by the published method, and with the settings of hrbfnpr.  Drawings on other subjects follow.</p>
"""


def _panel(name, title, command):
    code = f"<details><summary>command</summary><code>{escape(command)}</code></details>" if command else ""
    return (
        f'<figure><img src="{escape(name)}" alt="{escape(title)}" loading="lazy">'
        f"<figcaption>{escape(title)}{code}</figcaption></figure>\n"
    )


def _section(figure, drawn, left_out):
    heading = f"Figure {figure.number}: {figure.title}" if figure.number.isdigit() else figure.title
    yield f'<section id="figure-{figure.number}">\n<h2>{escape(heading)}</h2>\n<p>{escape(figure.caption)}</p>\n'
    if figure.settings:
        yield f"<p><em>Here:</em> {escape(figure.settings)}</p>\n"
    for reason in dict.fromkeys(left_out):
        yield f"<p><strong>Left out:</strong> {escape(reason)}</p>\n"
    yield '<div class="panels">\n'
    yield from (_panel(*panel) for panel in drawn)
    yield "</div>\n</section>\n"


def page(results, credits):
    """`results` has a tuple for each figure: the figure, its drawn panels (file, title, command), and the reasons why panels are
    left out."""
    parts = [HEAD]
    for figure, drawn, left_out in results:
        parts += _section(figure, drawn, left_out)
    parts.append("<section>\n<h2>Credits</h2>\n<ul>\n")
    parts += [f"<li>{escape(credit)}</li>\n" for credit in sorted(credits)]
    parts.append("</ul>\n</section>\n</body>\n</html>\n")
    return "".join(parts)
