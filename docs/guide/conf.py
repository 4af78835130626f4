# SPDX-License-Identifier: MIT
"""Sphinx's settings for the guide.  scripts/guide builds the guide from the pages that stage.py puts together."""

project = "hrbfnpr"
author = "the hrbfnpr authors"
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
html_theme = "furo"
html_title = "hrbfnpr"
html_static_path = ["static"]
html_css_files = ["guide.css"]
html_show_sourcelink = False
html_show_sphinx = False
html_copy_source = False
templates_path = []
# Debian's build of the theme lacks the colours of the theme's dark mode.
html_theme_options = {
    "dark_css_variables": {
        "color-problematic": "#ee5151", "color-foreground-primary": "#ffffffcc", "color-foreground-secondary": "#9ca0a5",
        "color-foreground-muted": "#81868d", "color-foreground-border": "#666666", "color-background-primary": "#131416",
        "color-background-secondary": "#1a1c1e", "color-background-hover": "#1e2124", "color-background-border": "#303335",
        "color-background-hover--transparent": "#1e212400", "color-background-item": "#444444",
        "color-brand-primary": "#5aa7f2", "color-brand-content": "#5aa7f2", "color-highlighted-background": "#083563",
        "color-highlight-on-target": "#333300", "color-admonition-background": "#18181a",
    },
}  # fmt: skip

myst_heading_anchors = 4  # the same anchors as on a forge
myst_enable_extensions = ["colon_fence"]
source_suffix = {".rst": "restructuredtext", ".md": "markdown"}
highlight_language = "none"

autodoc_member_order = "bysource"
autodoc_typehints = "none"  # the docstrings say the types of parameters
autodoc_class_signature = "separated"  # most objects are not made by their constructor
napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_use_ivar = True

# C types that the guide does not document.  Python docstrings describe types in words that are not names.
nitpick_ignore = [("c:identifier", name) for name in ("int32_t", "uint32_t", "int64_t", "uint64_t", "uint8_t", "uint16_t")]
nitpick_ignore_regex = [("py:.*", ".*")]


def keep_colons(app, what, name, thing, options, lines):
    """Keep Napoleon from reading the text before a colon, in the first line of an attribute's docstring, as its type."""
    if what in ("attribute", "data", "property") and lines and ":" in lines[0]:
        lines[0] = f": {lines[0]}"  # an empty type


def setup(app):
    app.connect("autodoc-process-docstring", keep_colons, priority=400)  # before Napoleon
