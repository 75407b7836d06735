"""The documentation: every block of the README and the guide runs, pages are built without a warning, links lead on."""

import html
import importlib
import inspect
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import pyvista

import msf_jax
from msf_jax.base import layout
from tests.benchmarks import ground_truth

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", *sorted((Path(msf_jax.__file__).parent / "guide").glob("*.md"))]


BLOCKS = [
    pytest.param(number, block, id=f"{page.stem}-{number}")
    for page in PAGES
    for number, block in enumerate(re.findall(r"```python\n(.*?)```", page.read_text(), flags=re.DOTALL))
]


def test_every_benchmark_can_be_imported():
    """The guide names them, most are run by no test, and they use what is inside of the package."""
    for path in sorted((ROOT / "tests" / "benchmarks").glob("*.py")):
        importlib.import_module(f"tests.benchmarks.{path.stem}")


def test_every_task_has_its_page():
    """Each is in the guide that the documentation is built from, and the README leads to it."""
    guide = (Path(msf_jax.__file__).parent / "guide" / "__init__.py").read_text()
    readme = PAGES[0].read_text()
    assert len(PAGES) > 8
    for page in PAGES[1:]:
        assert f".. include:: {page.name}" in guide
        assert f"(msf_jax/guide/{page.name})" in readme


@pytest.mark.system
@pytest.mark.parametrize(("number", "block"), BLOCKS)
def test_every_block_runs(tmp_path, number, block, monkeypatch):
    """Each on its own, where a reader would be after the first command of the README, but with three limbs for a hand.

    Those that take derivatives have a short tube instead, which is compiled in a fifth of the time, and few rows. The
    table of a batch is there for whoever only reads it.
    """
    has_slopes = any(call in block for call in ("jax.grad(", "_grad(", "jacfwd(", "tune("))
    if has_slopes:
        monkeypatch.setattr(layout, "SMALLEST_CAPACITY", 256)
    mesh = ground_truth.make("straight_coarse" if has_slopes else "y_coarse").mesh
    mesh.export(tmp_path / "hand.off")
    (tmp_path / "curves").mkdir()
    (tmp_path / "curves" / "manifest.csv").write_text("path,error,is_sound\na.off,,True\nb.off,open,\n")
    (tmp_path / "meshes").mkdir()
    mesh.export(tmp_path / "meshes" / "small.off")
    monkeypatch.chdir(tmp_path)
    if "__main__" in block:  # a process pool's workers import the program's main file
        Path("block.py").write_text(block)
        subprocess.run([sys.executable, "block.py"], check=True, timeout=300, env=_environment())
    else:
        exec(compile(block, f"block {number}", "exec"), {"__name__": "block"})


def _environment() -> dict[str, str]:
    return os.environ | {"PYTHONPATH": str(ROOT)}


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """The pages, as the guide says that they are built, without a warning."""
    folder = tmp_path_factory.mktemp("pages") / "site"
    command = [sys.executable, "-m", "tests.pages", str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, env=_environment(), cwd=ROOT)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return folder


@pytest.mark.system
def test_the_pages_hold_the_guide_all_that_is_public_and_what_notebooks_left(site):
    public = (site / "msf_jax.html").read_text()
    for name in msf_jax.__all__:
        value = getattr(msf_jax, name)
        page = site / f"{value.__name__.replace('.', '/')}.html" if inspect.ismodule(value) else None
        assert f'id="{name}"' in public or (page is not None and page.exists()) or name == "guide", name
    first = (site / "index.html").read_text()
    for page in PAGES[1:]:
        title = page.read_text().splitlines()[0].removeprefix("# ")
        assert f'href="guide/{page.stem}.html"' in first
        assert html.escape(title, quote=False) in html.unescape((site / "guide" / f"{page.stem}.html").read_text())
        assert f'"guide.{page.stem}"' in (site / "search.js").read_text()
    for path in (ROOT / "notebooks").glob("*.ipynb"):
        text = (site / "notebooks" / f"{path.stem}.html").read_text()
        pictures = re.findall(r"src=.\.\./pictures/([\w-]+\.png)", text)
        assert pictures and all((site / "pictures" / name).stat().st_size > 1000 for name in pictures)


@pytest.mark.system
def test_every_link_of_the_pages_leads_somewhere(site):
    """To a file that is there, and to a place in it; nothing is loaded from elsewhere."""
    texts = {path.resolve(): path.read_text() for path in site.rglob("*.html")}
    anchors = {path: set(re.findall(r"\bid=[\"']([^\"']+)", text)) for path, text in texts.items()}
    broken = []
    for path, text in texts.items():
        fixed = re.sub(r"<script.*?</script>", "", text, flags=re.DOTALL)  # the search makes links of its own
        for kind, link in re.findall(r"<[^>]*?\b(href|src)=[\"']([^\"']*)", fixed):
            where, _, anchor = html.unescape(link).partition("#")
            if where.startswith(("http", "data:")):
                broken += [(path.name, link)] if kind == "src" and where.startswith("http") else []
                continue
            target = (path.parent / where).resolve() if where else path
            if not target.exists() or (anchor and anchor not in anchors[target]):
                broken.append((path.name, link))
    assert not broken


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_every_link_of_the_text_leads_to_a_file(page):
    """As who reads the repository follows them; those to the network are not tried."""
    links = re.findall(r"\]\(([^)\s]+)\)|src=\"([^\"]+)\"", re.sub(r"```.*?```", "", page.read_text(), flags=re.DOTALL))
    folder = ROOT if page == PAGES[0] else ROOT / "msf_jax" / "guide"  # in the repository, wherever it is installed
    for link in (a or b for a, b in links):
        assert link.startswith("https://") or (folder / link.split("#")[0]).exists(), link


@pytest.mark.slow
def test_what_the_migration_page_says_to_call_is_there_and_runs(tmp_path, monkeypatch):
    """Every call in a last column, on a tube; an ellipsis for a setting stands for what it is anyway."""
    monkeypatch.chdir(tmp_path)
    tube = ground_truth.make("straight_coarse").mesh
    pyvista.wrap(tube).save("vessel.vtp")
    names: dict[str, Any] = {name: getattr(msf_jax, name) for name in msf_jax.__all__}
    names |= {"msf_jax": msf_jax, "numpy": np, "mesh": tube}
    names["skeleton"] = msf_jax.skeletonize(tube)
    names |= dict.fromkeys(("root", "node", "v"), 0) | dict.fromkeys(("spacing", "sampling_dist", "tolerance"), 0.05)
    names |= {"reach": 0.1, "radius": 0.1, "slenderness": 1.0, "rounds": 2, "n": 9, "report": names["skeleton"].report}
    num = 0
    for line in (Path(msf_jax.__file__).parent / "guide" / "migrating.md").read_text().splitlines():
        owner = ""
        for span in re.findall(r"`([^`]+)`", line.split(" | ")[-1] if line.startswith("| `") else ""):
            if re.match(r"(\.[a-z_]+|(skeleton|report|numpy|msf_jax)\.|[A-Za-z]+\()", span):
                owner = owner if span[0] == "." else span.partition(").")[0] + ")" * (")." in span)
                owner = "skeleton" if owner.startswith("skeleton.") else owner
                call = (owner if span[0] == "." else "") + span
                while setting := re.search(r"(Config|Weights|Repair|\w+Options)\((?:[^()]*, )?(\w+)=\.\.\.", call):
                    call = call.replace(f"{setting[2]}=...", f"{setting[2]}={setting[1]}().{setting[2]}")
                eval(call, dict(names))
                num += 1
    assert num > 50
