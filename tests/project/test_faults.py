"""Whatever comes in, a curve that is whole or a clear error comes out: a short run of the benchmarks."""

import pytest

import msf_jax
from msf_jax.app.cli import main
from tests.benchmarks import faults, fuzz

SLOW = pytest.mark.slow  # some of it is below
IN_BENCHMARK_ONLY = {  # a second or more each, or the like of another
    "two boxes that share a vertex",  # taken apart, in test_repair; along an edge, here
    "two boxes that share a face",  # test_sheets
    "two boxes that overlap",  # test_joining; of two components that are nested, here
    "a cube",  # of 8 vertices, here
    "scale 1e-06",
    "scale 1e+06",
    "1000 from the origin",
    "1e+06 from the origin",
}


@SLOW  # voids are in test_hollow; that an open mesh is refused without repair is in test_checking
@pytest.mark.parametrize(("kind", "repair"), [("arrays", False), ("topology", True), ("geometry", False)])
def test_arrays_of_every_kind(kind, repair):
    meshes = {name: mesh for name, mesh in faults.KINDS[kind]().items() if name not in IN_BENCHMARK_ONLY}
    found = {name: faults.outcome(mesh, repair=repair) for name, mesh in meshes.items()}
    assert not [f"{name}: {text}" for name, text in found.items() if text.startswith("FAILED")]
    assert len(found) > 20 and {"a curve", "refused"} <= set(found.values())
    if kind == "topology":  # more of the test below
        for name in (
            "a hole",
            "a fin",
            "faces twice",
            "random orientation",
            "unused vertices",
            "250 crumbs",
            "a wall inside",
        ):
            assert found[name] == "a curve", name
        assert found["two boxes that share an edge"] == "a curve"


@pytest.mark.parametrize("name", ["a soup", "one NaN"])
def test_what_repair_is_for_becomes_a_curve(name):
    mesh = (faults.topology_variants() | faults.array_variants())[name]
    assert faults.outcome(mesh, repair=True) == "a curve"


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
