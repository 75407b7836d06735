"""The documentation: every block of the README runs, in order, and the pages are built without a warning."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import msf_jax
from msf_jax import shapes

ROOT = Path(__file__).parents[1]
BLOCKS = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text(), flags=re.DOTALL)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Where a reader would be after the first command of the README, but with a coarser hand."""
    folder = tmp_path_factory.mktemp("reader")
    shapes.hand(0.1).export(folder / "hand.off")
    (folder / "meshes").mkdir()
    shapes.hand(0.1).export(folder / "meshes" / "small.off")
    return folder


@pytest.mark.parametrize("number", range(len(BLOCKS)))
def test_every_block_of_the_readme_runs(folder, number, monkeypatch):
    """Each on its own, but for the imports of those before it; the one with every gradient compiles for minutes."""
    if "tune(" in BLOCKS[number] and not os.environ.get("MSF_JAX_LONG"):
        pytest.skip("MSF_JAX_LONG is not set")
    monkeypatch.chdir(folder)
    before = "\n".join(BLOCKS[:number])
    imports = "\n".join(line for line in before.splitlines() if re.match(r"(import|from) ", line))
    code = compile(f"{imports}\n{BLOCKS[number]}", f"README block {number}", "exec")
    # A process pool's workers import the program's main module: blocks that start one run as a reader would run them.
    if "batch.run" in BLOCKS[number]:
        body = "\n".join(f"    {line}" for line in BLOCKS[number].splitlines())
        (folder / "block.py").write_text(f"{imports}\nif __name__ == '__main__':\n{body}\n")
        subprocess.run([sys.executable, "block.py"], check=True, timeout=300, env=_environment())
    else:
        exec(code, {"__name__": "block"})


def _environment() -> dict[str, str]:
    return os.environ | {"PYTHONPATH": str(ROOT), "JAX_COMPILATION_CACHE_DIR": os.environ["MSF_JAX_TEST_CACHE"]}


def test_the_pages_are_built(tmp_path):
    """By pdoc, from the docstrings and the README, all public names among them."""
    command = [sys.executable, "-W", "error::UserWarning", "-m", "pdoc", "-d", "google", "-o", str(tmp_path), "msf_jax"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, env=_environment(), cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "Warn" not in done.stderr
    page = (tmp_path / "msf_jax.html").read_text()
    for name in msf_jax.__all__:
        assert f'id="{name}"' in page or (tmp_path / "msf_jax" / f"{name}.html").exists(), name
