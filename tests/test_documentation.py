"""The documentation: every block of the README and the guide runs, and the pages are built without a warning."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import msf_jax
from msf_jax import ground_truth, shapes

ROOT = Path(__file__).parents[1]
PAGES = [ROOT / "README.md", *sorted((Path(msf_jax.__file__).parent / "guide").glob("*.md"))]
DOCUMENTED = ["msf_jax", "msf_jax.app.batch", "msf_jax.tuning.objectives"]


def is_long(block: str) -> bool:
    """Whether it differentiates or repeats whole runs, or starts processes."""
    return any(call in block for call in ("msf_jax.replay(", "sensitivity(", "tune(", "__main__"))


BLOCKS = [
    pytest.param(number, block, id=f"{page.stem}-{number}", marks=[pytest.mark.slow] * is_long(block))
    for page in PAGES
    for number, block in enumerate(re.findall(r"```python\n(.*?)```", page.read_text(), flags=re.DOTALL))
]


def test_every_task_has_its_page():
    """Each is in the guide that the documentation is built from, and the README leads to it."""
    guide = (Path(msf_jax.__file__).parent / "guide" / "__init__.py").read_text()
    readme = PAGES[0].read_text()
    assert len(PAGES) > 8
    for page in PAGES[1:]:
        assert f".. include:: {page.name}" in guide
        assert f"(msf_jax/guide/{page.name})" in readme


@pytest.mark.parametrize(("number", "block"), BLOCKS)
def test_every_block_runs(tmp_path, number, block, monkeypatch):
    """Each on its own, where a reader would be after the first command of the README, but with a coarser hand.

    Those that take derivatives have a short tube instead, which is compiled in a fifth of the time.
    """
    has_slopes = "jax.grad(" in block or "sensitivity(" in block or "tune(" in block
    mesh = ground_truth.make("straight_coarse").mesh if has_slopes else shapes.hand(0.1)
    mesh.export(tmp_path / "hand.off")
    (tmp_path / "meshes").mkdir()
    shapes.hand(0.1).export(tmp_path / "meshes" / "small.off")
    monkeypatch.chdir(tmp_path)
    if "__main__" in block:  # a process pool's workers import the program's main file
        Path("block.py").write_text(block)
        subprocess.run([sys.executable, "block.py"], check=True, timeout=300, env=_environment())
    else:
        exec(compile(block, f"block {number}", "exec"), {"__name__": "block"})


def _environment() -> dict[str, str]:
    return os.environ | {"PYTHONPATH": str(ROOT), "JAX_COMPILATION_CACHE_DIR": os.environ["MSF_JAX_TEST_CACHE"]}


def test_the_pages_are_built(tmp_path):
    """By pdoc, from the docstrings and the README, all public names among them."""
    environment = _environment() | {"PDOC_ALLOW_EXEC": "1"}  # an older SciPy asks for the processor as it is imported
    command = [
        sys.executable,
        "-W",
        "error::UserWarning",
        "-m",
        "pdoc",
        "-d",
        "google",
        "-o",
        str(tmp_path),
        *DOCUMENTED,
    ]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, env=environment, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "Warn" not in done.stderr
    page = (tmp_path / "msf_jax.html").read_text()
    for name in msf_jax.__all__:
        module = (tmp_path / "msf_jax" / msf_jax._MODULES.get(name, name).replace(".", "/")).with_suffix(".html")
        assert f'id="{name}"' in page or module.exists(), name
    guide = (tmp_path / "msf_jax" / "guide.html").read_text()
    for page in PAGES[1:]:
        assert page.read_text().splitlines()[0].removeprefix("# ") in guide
