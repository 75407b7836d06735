"""The documentation as pages: the README, the guide, the notebooks as they were run, and all that is public.

    python -m tests.pages FOLDER

Open ``index.html`` in ``FOLDER``. Built by pdoc, for which a page of text is a module that has nothing but its
docstring: so all of them have the same frame, and one search. Nothing is fetched, neither now nor by who reads.
"""

import base64
import os
import re
import shutil
import sys
import types
import warnings
from pathlib import Path

import jinja2
import nbformat

import msf_jax

os.environ["PDOC_ALLOW_EXEC"] = "1"  # an older SciPy asks for the processor as it is imported
import pdoc
import pdoc.doc
import pdoc.extract
import pdoc.render

ROOT = Path(__file__).parents[1]
GUIDE = Path(msf_jax.__file__).parent / "guide"
MODULES = [
    "msf_jax",
    "msf_jax.app.batch",
    "msf_jax.gradients.losses",
    "msf_jax.gradients.torch",
    "msf_jax.tuning.objectives",
    "!msf_jax.guide",
]  # its pages stand for it
LINK = re.compile(r"""(?P<before>\]\(|src=")(?P<path>[^)"\s:#]+\.(?:md|ipynb|png))(?P<after>[)"#])""")
FRAME = """\
{% extends "default/module.html.jinja2" %}
{% set root = "../" * module.modulename.count(".") %}
{% block title %}{{ titles.get(module.modulename, module.modulename) }}{% endblock %}
{% block module_list_link %}<a class="pdoc-button" href="{{ root }}index.html">msf_jax</a>{% endblock %}
{% macro module_name() %}{% if module.modulename not in titles %}
<h1 class="modulename">{{ module.modulename }}</h1>{% endif %}{% endmacro %}
{% block nav_submodules %}{% for chapter, names in chapters.items() %}<h2>{{ chapter }}</h2><ul>
{% for name in names %}<li><a href="{{ root }}{{ name.replace(".", "/") }}.html">{{ titles.get(name, name) }}</a></li>
{% endfor %}</ul>{% endfor %}{% endblock %}
"""
STYLE = """\
main.pdoc img { max-width: 100%; height: auto; }
main.pdoc table { display: block; overflow-x: auto; }
"""


def sources() -> dict[Path, str]:
    """The files that become pages of text, and the names of those: the README first, then the guide in its order."""
    ordered = re.findall(r"^\.\. include:: (\S+)\.md$", (GUIDE / "__init__.py").read_text(), flags=re.MULTILINE)
    notebooks = sorted((ROOT / "notebooks").glob("*.ipynb"))
    found = {ROOT / "README.md": "index"} | {GUIDE / f"{name}.md": f"guide.{name}" for name in ordered}
    return found | {path: f"notebooks.{path.stem}" for path in notebooks}


def build(folder: Path) -> None:
    """Write all pages into ``folder``."""
    warnings.simplefilter("error", UserWarning)
    pictures = folder / "pictures"
    pictures.mkdir(parents=True, exist_ok=True)
    names = sources()
    modules, searched, titles = {}, {}, {}
    for path, name in names.items():
        text = _of_notebook(path, pictures) if path.suffix == ".ipynb" else path.read_text("utf-8")
        modules[name] = _as_module(name, _with_links(text, path, names, pictures))
        searched[name] = _as_module(name, re.sub(r"<img[^>]*>|(?<=\])\([^()\s]*\)", "", text))  # shown on any page
        titles[name] = text.splitlines()[0].removeprefix("# ")
    public = list(pdoc.extract.walk_specs(MODULES))
    documented = {name: pdoc.doc.Module.from_name(name) for name in public}
    modules |= documented
    pdoc.render.configure(docformat="google")
    pdoc.render.env.loader = jinja2.ChoiceLoader(
        [jinja2.DictLoader({"module.html.jinja2": FRAME, "custom.css": STYLE}), *filter(None, [pdoc.render.env.loader])]
    )
    chapters = {
        part: [name for name in names.values() if name.startswith(part.lower())] for part in ("Guide", "Notebooks")
    }
    pdoc.render.env.globals |= {"titles": titles, "chapters": chapters | {"All that is public": public}}
    for name, module in modules.items():
        target = folder / f"{name.replace('.', '/')}.html"
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(pdoc.render.html_module(module, modules), "utf-8")
    (folder / "search.js").write_text(pdoc.render.search_index(searched | documented), "utf-8")


def _as_module(name: str, text: str) -> pdoc.doc.Module:
    module = types.ModuleType(name, text)
    module.__dict__["__docformat__"] = "markdown"
    return pdoc.doc.Module(module)


def _with_links(text: str, path: Path, names: dict[Path, str], pictures: Path) -> str:
    """``text`` of the file at ``path`` with its links to other files leading to their pages, and to copied pictures."""
    up = "../" * names[path].count(".")

    def leading(found: re.Match[str]) -> str:
        target = Path(os.path.normpath(path.parent / found["path"]))
        if target.suffix == ".png":
            shutil.copyfile(target, pictures / target.name)
            place = f"pictures/{target.name}"
        else:
            place = f"{names[target].replace('.', '/')}.html"
        return f"{found['before']}{up}{place}{found['after']}"

    return LINK.sub(leading, text)


def _of_notebook(path: Path, pictures: Path) -> str:
    """A notebook as Markdown: text, code, and what it printed, drew and tabled."""
    parts, number = [], 0
    for cell in nbformat.read(path, as_version=4).cells:
        if cell.cell_type == "markdown":
            parts.append(cell.source)
            continue
        parts.append(f"```python\n{cell.source}\n```")
        for output in cell.outputs:
            data = output.get("data", {})
            if "image/png" in data:
                number += 1
                picture = pictures / f"{path.stem}-{number}.png"
                picture.write_bytes(base64.b64decode(data["image/png"]))
                parts.append(f"<img src='../pictures/{picture.name}' alt='picture {number}'>")  # no link to lead
            elif "text/html" in data:
                table = re.sub(r"<style.*?</style>", "", data["text/html"], flags=re.DOTALL)
                parts.append(re.sub(r"\n\s*", "\n", table).strip())
            elif text := output.get("text", data.get("text/plain", "")):
                parts.append(f"```text\n{text.rstrip()}\n```")
    return "\n\n".join(parts) + "\n"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("expected a folder: python -m tests.pages FOLDER")
    build(Path(sys.argv[1]))
