"""The manual as web pages that need no network: `cmake --build --preset release --target manual`."""

import pathlib
import re
import shutil

ROOT = pathlib.Path(__file__).resolve().parent.parent
MATHJAX = pathlib.Path("/usr/share/javascript/mathjax")  # Debian's libjs-mathjax
USED_OF_MATHJAX = ["MathJax.js", "config/TeX-AMS_CHTML-full.js", "fonts/HTML-CSS/TeX/woff", "jax/output/CommonHTML",
                   "jax/element", "extensions"]

project = "floe"
copyright = "the authors of floe"
version = release = re.search(r"project\(floe VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)

extensions = ["myst_parser", "sphinx.ext.mathjax"]
source_suffix = {".md": "markdown"}
master_doc = "index"
myst_enable_extensions = ["dollarmath", "amsmath"]
myst_heading_anchors = 4  # the anchors that GitHub makes
highlight_language = "none"

html_theme = "alabaster"
html_title = f"floe {release}"
html_show_sourcelink = False
html_copy_source = False
html_static_path = ["style"]
html_sidebars = {"**": ["about.html", "searchbox.html", "navigation.html"]}
html_theme_options = {
    "description": "Hydroelastic response of very large floating structures in waves",
    "page_width": "1180px", "sidebar_width": "270px", "fixed_sidebar": True, "show_powered_by": False,
    "font_family": "system-ui, 'DejaVu Sans', sans-serif",
    "head_font_family": "system-ui, 'DejaVu Sans', sans-serif",
}
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_CHTML-full"
mathjax2_config = {"showMathMenu": False, "messageStyle": "none",
                   "tex2jax": {"processClass": "tex2jax_process|mathjax_process|math"}}
myst_update_mathjax = False  # its settings are those of MathJax 3


def copy_mathjax(app, exception):
    """Puts the parts of MathJax that the pages use beside them."""
    if exception or app.builder.format != "html":
        return
    for part in USED_OF_MATHJAX:
        source, target = MATHJAX / part, pathlib.Path(app.outdir) / "_static" / "mathjax" / part
        target.parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            shutil.copytree(source, target, dirs_exist_ok=True)
        else:
            shutil.copy(source, target)


def setup(app):
    app.connect("build-finished", copy_mathjax)
