# SPDX-License-Identifier: MIT
"""Sphinx's settings of the guide; scripts/guide builds it from the pages that stage.py puts together."""

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
# Debian's build of the theme has lost its own of the dark mode.
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

myst_heading_anchors = 4  # as forges make them
myst_enable_extensions = ["colon_fence"]
source_suffix = {".rst": "restructuredtext", ".md": "markdown"}
highlight_language = "none"

autodoc_member_order = "bysource"
autodoc_typehints = "none"  # the docstrings say what parameters are
autodoc_class_signature = "separated"  # most objects come from other calls
napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_use_ivar = True

# Names of C that are nobody's here.  Docstrings of Python say types in words, which are no names.
nitpick_ignore = [("c:identifier", name) for name in ("int32_t", "uint32_t", "int64_t", "uint64_t", "uint8_t", "uint16_t")]
nitpick_ignore_regex = [("py:.*", ".*")]
