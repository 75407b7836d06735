"""Whatever comes in, a curve that is whole or a clear error comes out: a short run of the benchmarks."""

import pytest

import msf_jax
from msf_jax.app.cli import main
from tests.benchmarks import faults, fuzz


@pytest.mark.slow  # voids are in test_hollow; that an open mesh is refused without repair is in test_checking
@pytest.mark.parametrize(("kind", "repair"), [("arrays", False), ("topology", True), ("geometry", False)])
def test_arrays_of_every_kind(kind, repair):
    found = {name: faults.outcome(mesh, repair=repair) for name, mesh in faults.KINDS[kind]().items()}
    assert not [f"{name}: {text}" for name, text in found.items() if text.startswith("FAILED")]
    assert len(found) > 20 and {"a curve", "refused"} <= set(found.values())


def test_files_that_are_not_what_they_say(tmp_path, capfd):
    """On the command line: exit code 2, one line that says why, no traceback."""
    files = faults.file_variants(tmp_path)
    assert len(files) > 25
    for name, path in files.items():
        code = main(["skeletonize", str(path), "-o", str(tmp_path / "out.swc"), "--repair"])
        output = capfd.readouterr()
        lines = output.err.splitlines()
        assert code == 2 and len(lines) == 1 and lines[0].startswith("msf-jax: ") and not output.out, (name, output)
    assert not (tmp_path / "out.swc").exists()


def test_mutated_files_are_read_or_refused():
    lines, wrong = fuzz.fuzz(300, seed=1, seconds=10)
    assert not wrong
    assert len(lines) == 2 + len(fuzz.originals())


def test_the_outcome_is_not_always_well(monkeypatch):
    """The judge of all these: an exception of another kind, or numbers that are none, do not pass."""
    monkeypatch.setattr(msf_jax, "skeletonize", lambda *_, **__: 1 / 0)
    assert faults.outcome(None, repair=False).startswith("FAILED: Traceback")
