"""Every notebook runs, in a smaller setting; what is committed is what a full run left, and small."""

from pathlib import Path

import matplotlib.pyplot as plt
import nbformat
import pytest
from nbclient import NotebookClient

ROOT = Path(__file__).parents[2]
NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))
FIRST = "quickstart"  # a kernel runs it
LARGEST = 300_000  # bytes, pictures included


@pytest.mark.system
@pytest.mark.parametrize("path", [path for path in NOTEBOOKS if path.stem != FIRST], ids=lambda path: path.stem)
def test_it_runs_without_a_warning(path, monkeypatch, tmp_path):
    """Cell by cell, in this process: a warning is an error, and what other tests have compiled is there already."""
    monkeypatch.setenv("MSF_JAX_SMALL", "1")
    monkeypatch.chdir(tmp_path)
    names = {"__name__": "__main__"}
    try:
        for number, cell in enumerate(nbformat.read(path, as_version=4).cells):
            if cell.cell_type == "code":
                code = "\n".join(line for line in cell.source.splitlines() if not line.startswith("%"))
                exec(compile(code, f"{path.name}, cell {number}", "exec"), names)
    finally:
        plt.close("all")


@pytest.mark.system
@pytest.mark.filterwarnings("ignore")  # of the notebook's own machinery; those of its code would be in its output
def test_a_kernel_runs_the_first(monkeypatch):
    """The way that a reader takes, magics included."""
    monkeypatch.setenv("MSF_JAX_SMALL", "1")
    notebook = nbformat.read(ROOT / "notebooks" / f"{FIRST}.ipynb", as_version=4)
    NotebookClient(notebook, timeout=600, kernel_name="python3").execute()
    assert not _warnings(notebook)


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_it_is_committed_as_it_ran(path):
    """Every cell of code has been run, in order, without a warning, and a picture and words about it are there."""
    notebook = nbformat.read(path, as_version=4)
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert [cell.execution_count for cell in cells] == list(range(1, len(cells) + 1))
    assert not _warnings(notebook)
    assert any("image/png" in output.get("data", {}) for cell in cells for output in cell.outputs)
    assert notebook.cells[0].source.startswith("# ") and notebook.cells[-1].cell_type == "markdown"
    assert len(notebook.cells[-1].source.split()) > 20
    assert path.stat().st_size < LARGEST


def test_the_readme_leads_to_every_notebook():
    readme = (ROOT / "README.md").read_text()
    assert not [path.name for path in NOTEBOOKS if f"(notebooks/{path.name})" not in readme]


def _warnings(notebook: nbformat.NotebookNode) -> list[str]:
    """Standard error, but for XLA's false alarm when it takes a compiled step from the cache (see `cli`)."""
    outputs = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
    streams = [output.text for output in outputs if output.output_type == "stream" and output.name == "stderr"]
    return [line for line in "".join(streams).splitlines() if line.strip() and "cpu_aot_loader" not in line]
