"""The documentation: every block of the README and the guide runs, pages are built without a warning, links lead on."""

import html
import importlib
import inspect
import os
import re
import subprocess
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import nbformat
import pytest

import msf_jax
from msf_jax.base import layout
from tests.benchmarks import ground_truth

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", *sorted((Path(msf_jax.__file__).parent / "guide").glob("*.md"))]
NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))
BLOCKS = [
    pytest.param(number, block, id=f"{page.stem}-{number}")
    for page in PAGES
    for number, block in enumerate(re.findall(r"```python\n(.*?)```", page.read_text(), flags=re.DOTALL))
]


def test_every_benchmark_can_be_imported():
    """The guide names them, most are run by no test, and they use what is inside of the package."""
    for path in sorted((ROOT / "tests" / "benchmarks").glob("*.py")):
        importlib.import_module(f"tests.benchmarks.{path.stem}")


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
    for folder in ("curves", "meshes"):
        (tmp_path / folder).mkdir()
    mesh.export(tmp_path / "hand.off")
    mesh.export(tmp_path / "meshes" / "small.off")
    (tmp_path / "curves" / "manifest.csv").write_text("path,error,is_sound\na.off,,True\nb.off,open,\n")
    monkeypatch.chdir(tmp_path)
    if "__main__" in block:  # a process pool's workers import the program's main file
        Path("block.py").write_text(block)
        subprocess.run([sys.executable, "block.py"], check=True, timeout=300, env=_environment())
    else:
        exec(compile(block, f"block {number}", "exec"), {"__name__": "block"})


def _environment() -> dict[str, str]:
    return os.environ | {"PYTHONPATH": str(ROOT)}


@pytest.mark.system
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_every_notebook_runs_without_a_warning(path, monkeypatch, tmp_path):
    """In a smaller setting, cell by cell, in this process; what is committed was run in order."""
    monkeypatch.setenv("MSF_JAX_SMALL", "1")
    monkeypatch.chdir(tmp_path)
    names = {"__name__": "__main__"}
    cells = [cell for cell in nbformat.read(path, as_version=4).cells if cell.cell_type == "code"]
    assert [cell.execution_count for cell in cells] == list(range(1, len(cells) + 1))
    try:
        for number, cell in enumerate(cells):
            code = "\n".join(line for line in cell.source.splitlines() if not line.startswith("%"))
            exec(compile(code, f"{path.name}, cell {number}", "exec"), names)
    finally:
        plt.close("all")


@pytest.mark.system
def test_the_pages_hold_all_that_is_public_and_every_link_leads_somewhere(tmp_path):
    """To a file that is there, and to a place in it; nothing is loaded from elsewhere."""
    command = [sys.executable, "-m", "tests.pages", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, env=_environment(), cwd=ROOT)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    texts = {path.resolve(): path.read_text() for path in tmp_path.rglob("*.html")}
    for name in msf_jax.__all__:
        value = getattr(msf_jax, name)
        page = tmp_path / f"{value.__name__.replace('.', '/')}.html" if inspect.ismodule(value) else None
        is_there = f'id="{name}"' in texts[tmp_path.resolve() / "msf_jax.html"] or (page is not None and page.exists())
        assert is_there or name == "guide", name
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
