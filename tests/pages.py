"""The documentation as pages: the README, the guide, and all that is public. Nothing is fetched by who reads them.

    python -m tests.pages FOLDER

Open ``index.html`` in ``FOLDER``. Built by pdoc, for which a page of text is a module that has nothing but its
docstring: so all of them have the same frame, and one search.
"""

import os
import re
import shutil
import sys
import types
import warnings
from pathlib import Path

import msf_jax

os.environ["PDOC_ALLOW_EXEC"] = "1"  # an older SciPy asks for the processor as it is imported
import pdoc
import pdoc.doc
import pdoc.extract
import pdoc.render

ROOT = Path(__file__).parents[1]
GUIDE = Path(msf_jax.__file__).parent / "guide"
PUBLIC = ["msf_jax", "msf_jax.app.batch", "msf_jax.gradients.losses", "msf_jax.gradients.measures"]
PUBLIC += ["msf_jax.gradients.torch", "!msf_jax.guide"]  # its pages stand for the guide
LINK = re.compile(r"""(?P<before>\]\(|src=")(?P<path>[^)"\s:#]+\.(?:md|ipynb|png))(?P<after>[)"#])""")


def build(folder: Path) -> None:
    """Write all pages into ``folder``."""
    warnings.simplefilter("error", UserWarning)
    pages = {ROOT / "README.md": "index"} | {path: f"guide.{path.stem}" for path in sorted(GUIDE.glob("*.md"))}
    public = list(pdoc.extract.walk_specs(PUBLIC))
    modules, searched = {}, {}
    for path, name in pages.items():
        text = path.read_text("utf-8")
        listed = "".join(f"- [{each}]({each.replace('.', '/')}.html)\n" for each in public) if name == "index" else ""
        modules[name] = _as_module(name, f"{_with_links(text, path, pages, folder)}\n\n{listed}")
        searched[name] = _as_module(name, re.sub(r"<img[^>]*>|(?<=\])\([^()\s]*\)", "", text))  # shown on any page
    documented = {name: pdoc.doc.Module.from_name(name) for name in public}
    pdoc.render.configure(docformat="google")
    for name, module in (modules | documented).items():
        target = folder / f"{name.replace('.', '/')}.html"
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(pdoc.render.html_module(module, modules | documented), "utf-8")
    (folder / "search.js").write_text(pdoc.render.search_index(searched | documented), "utf-8")


def _as_module(name: str, text: str) -> pdoc.doc.Module:
    module = types.ModuleType(name, text)
    module.__dict__["__docformat__"] = "markdown"
    return pdoc.doc.Module(module)


def _with_links(text: str, path: Path, pages: dict[Path, str], folder: Path) -> str:
    """``text`` of the file at ``path`` with its links leading to pages, and to copies of notebooks and pictures."""
    up = "../" * pages[path].count(".")

    def leading(found: re.Match[str]) -> str:
        target = Path(os.path.normpath(path.parent / found["path"]))
        place = f"{pages[target].replace('.', '/')}.html" if target in pages else f"files/{target.name}"
        if target not in pages:
            (folder / "files").mkdir(parents=True, exist_ok=True)
            shutil.copyfile(target, folder / place)
        return f"{found['before']}{up}{place}{found['after']}"

    return LINK.sub(leading, text)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("expected a folder: python -m tests.pages FOLDER")
    build(Path(sys.argv[1]))
