"""Settings of Sphinx for the site. tools/site copies this file and the pages into a folder beside the site and runs Sphinx there."""
project = html_title = "wythe"
extensions = ["myst_parser"]
myst_heading_anchors = 4
highlight_language = "none"  # a fence without a language is a command or what a program printed
html_theme = "furo"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sourcelink = False
html_show_sphinx = False
html_show_copyright = False
html_show_search_summary = False  # a page from a file may not fetch others
html_use_index = False
smartquotes = False  # "60 s" and --out are to be typed as they stand
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#9a4a1c", "color-brand-content": "#8a4218"},
    "dark_css_variables": {"color-brand-primary": "#e8a06a", "color-brand-content": "#e8a06a"},
}
