"""The command line as a user meets it: files, exit codes, one clear line for what is wrong."""

import re
import subprocess
import sys

import jax
import jax.numpy as jnp
import numpy as np
import pytest
import trimesh
from jax.experimental.compilation_cache import compilation_cache

import msf_jax
from msf_jax.app.cli import main
from msf_jax.app.parser import HELP, whole_parser
from tests.benchmarks import ground_truth


@pytest.fixture
def cache_as_before():
    """JAX's cache is where it was, after the test."""
    names = ("jax_compilation_cache_dir", "jax_persistent_cache_min_compile_time_secs")
    before = {name: getattr(jax.config, name) for name in names}
    yield
    for name, value in before.items():
        jax.config.update(name, value)
    compilation_cache.reset_cache()


def test_what_is_compiled_is_kept_where_it_is_said(tmp_path, monkeypatch, cache_as_before):
    """In a folder that is made, once said so; else where JAX keeps it already; else in the user's cache folder."""
    folder = tmp_path / "a" / "b"
    monkeypatch.setattr("msf_jax.flow.programs.WORTH_KEEPING", 0.0)
    assert msf_jax.cache_compilations(folder) == folder
    jax.jit(lambda x: jnp.sin(x) + 12345.678)(jnp.ones(3))
    assert any(folder.iterdir())
    assert msf_jax.cache_compilations() == folder
    jax.config.update("jax_compilation_cache_dir", None)
    monkeypatch.setattr("platformdirs.user_cache_path", lambda *_, **__: tmp_path / "user")
    assert msf_jax.cache_compilations() == tmp_path / "user"
    (tmp_path / "file").write_text("")
    with pytest.raises(msf_jax.ConfigError, match="expected a folder for compiled programs"):
        msf_jax.cache_compilations(tmp_path / "file")
    jax.config.update("jax_compilation_cache_dir", None)
    monkeypatch.setattr("platformdirs.user_cache_path", lambda *_, **__: tmp_path / "file")
    assert msf_jax.cache_compilations() is None


@pytest.fixture(autouse=True)
def own_cache(tmp_path_factory, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.getbasetemp() / "cache"))


@pytest.fixture
def limb(tmp_path):
    path = tmp_path / "limb.off"
    ground_truth.make("straight_coarse").mesh.export(path)
    return path


def test_a_curve_goes_beside_its_mesh_and_over_nothing_that_was_not_named(limb, tmp_path, capsys):
    curve = tmp_path / "limb.swc"
    assert main(["skeletonize", str(limb), "--units", "mm", "--scale", "2"]) == 0
    out = capsys.readouterr().out
    assert f"wrote {curve}" in out and "converged" in out and "0 cycles for genus 0" in out
    assert "# units: mm" in curve.read_text()
    for command, there in (("skeletonize", curve), ("view", limb.with_suffix(".html"))):
        there.write_text("mine")
        assert main([command, str(limb)]) == 2
        assert there.read_text() == "mine" and "exists already" in capsys.readouterr().err
    assert main(["skeletonize", str(limb), "-q", "-o", str(curve)]) == 0
    assert curve.read_text() != "mine"


def test_the_suffix_says_what_is_written(limb, tmp_path):
    for name, start in (("a.png", b"\x89PNG"), ("a.html", b"<!doctype html>"), ("a.obj", b"#")):
        assert main(["view", str(limb), "-o", str(tmp_path / name), "-q"]) == 0
        assert (tmp_path / name).read_bytes().startswith(start)


def open_box():
    box = trimesh.creation.box()
    box.update_faces(np.arange(len(box.faces)) > 0)
    return box


BAD = {
    "missing.off": (None, "no file"),
    "other.txt": (b"hello", "unknown suffix"),
    "garbage.off": (b"\x00\x01 not a mesh", "cannot read"),
    "empty.off": (b"", "expected OFF"),
    "nan.off": (b"OFF\n4 4 0\n0 0 nan\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n", "not finite"),
    "range.off": (b"OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 9\n", "range"),
    "tetrahedron.off": (b"OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n", "tetrahedron"),
    "open.off": (open_box(), "open"),
    "flat.off": (trimesh.creation.box((1, 1, 0)), "no volume"),
    "limb\ud800.off": (None, "no bytes for the name"),
    "": (None, "is no file"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_input_is_one_clear_line_and_exit_2(name, tmp_path, capsys, monkeypatch):
    content, message = BAD[name]
    monkeypatch.chdir(tmp_path)
    if isinstance(content, bytes):
        (tmp_path / name).write_bytes(content)
    elif content is not None:
        content.export(tmp_path / name)
    for output in (["-o", "out.swc"], []):
        assert main(["skeletonize", name, *output]) == 2
        err = capsys.readouterr().err
        assert err.startswith("msf-jax: ") and err.count("\n") == 1 and message in err
    assert not list(tmp_path.glob("*.swc"))


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--w-L", "-1"], "Weights.w_L is -1.0"),
        (["--system", "cgal"], "unknown system 'cgal'"),
        (["--max-iterations", "0"], "max_iterations"),
        (["-o", "out.xyz"], "no format"),
        (["-o", "nowhere/out.swc"], "cannot write 'nowhere/out.swc'"),
        (["-o", "link.swc"], "cannot write 'link.swc'"),
        (["-o", "copy.obj"], "is the mesh, which would be overwritten"),
    ],
)
def test_bad_options_are_one_clear_line_and_exit_2_before_the_flow(options, message, limb, capsys, monkeypatch):
    monkeypatch.setattr("msf_jax.flow.loop.skeletonize", pytest.fail)
    monkeypatch.chdir(limb.parent)
    (limb.parent / "link.swc").symlink_to("nowhere/out.swc")
    trimesh.load(limb, process=False).export("copy.obj")
    before = (limb.parent / "copy.obj").read_bytes()
    assert main(["skeletonize", "copy.obj", "-o", "out.swc", *options]) == 2
    err = capsys.readouterr().err
    assert message in err and err.count("\n") == 1
    assert (limb.parent / "copy.obj").read_bytes() == before


@pytest.mark.parametrize("option", ["--scale=0", "--resample=inf", "--heal=nan", "--root=1,2", "--root=1,2,inf"])
def test_lengths_and_places_are_finite(option, capsys):
    with pytest.raises(SystemExit, match="2"):
        main(["skeletonize", "a.off", option])
    assert f"argument {option.split('=')[0]}: {option.split('=')[1]}: expected" in capsys.readouterr().err


@pytest.mark.system
@pytest.mark.parametrize(
    ("arguments", "code"),
    [(["--help"], 0), (["--version"], 0), (["batch", "--help"], 0), (["skeletonize", "open.off", "-o", "a.swc"], 2)],
)
def test_help_and_refusals_do_not_wait_for_jax(arguments, code, tmp_path):
    """Nor help for anything that is slow to import."""
    open_box().export(tmp_path / "open.off")
    lines = [
        "import sys",
        "from msf_jax.app.cli import main",
        "try: code = main(sys.argv[1:])",
        "except SystemExit as end: code = end.code",
        "print(code, sorted({'jax', 'jaxopt', 'trimesh', 'scipy', 'networkx', 'matplotlib'} & set(sys.modules)))",
    ]
    done = subprocess.run(
        [sys.executable, "-c", "\n".join(lines), *arguments], capture_output=True, text=True, check=True, cwd=tmp_path
    )
    found = done.stdout.splitlines()[-1]
    assert "jax" not in found
    assert found == f"{code} []" if code == 0 else found.startswith(str(code))


@pytest.mark.parametrize("suffix", [".swc", ".npz"])
def test_a_report_is_printed_again_from_the_curves_file(suffix, tmp_path, capsys):
    skeleton = msf_jax.skeletonize(ground_truth.make("straight_coarse").mesh)
    skeleton.save(tmp_path / f"a{suffix}")
    assert main(["report", str(tmp_path / f"a{suffix}")]) == 0
    lines = skeleton.report.lines() if suffix == ".swc" else str(skeleton.report).splitlines()
    assert capsys.readouterr().out.splitlines() == lines


@pytest.mark.system
def test_nothing_on_standard_error_where_there_is_no_terminal(tmp_path):
    """No progress bar; and, the second time, nothing about the compiled steps that come from the cache."""
    limb = tmp_path / "limb.off"
    trimesh.creation.capsule(6.0, 1.0, [12, 12]).export(limb)  # of a ball, it would say that it has no limbs
    command = [sys.executable, "-m", "msf_jax", "skeletonize", str(limb), "-o", str(tmp_path / "a.swc"), "--float32"]
    for _ in range(2):
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0 and done.stderr == "" and "wrote" in done.stdout


def test_ctrl_c_before_the_files_writes_nothing_and_exits_130(limb, tmp_path, capsys, monkeypatch):
    def interrupt(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr("msf_jax.view.picture", interrupt)  # after the flow, before the files
    assert main(["skeletonize", str(limb), "-o", str(tmp_path / "a.png")]) == 130
    assert "interrupted" in capsys.readouterr().err
    assert sorted(path.name for path in tmp_path.iterdir()) == ["limb.off"]


@pytest.mark.parametrize("command", HELP)
def test_the_examples_of_the_help_are_accepted(command, capsys):
    """Help teaches by examples; a line of them that the parser refuses would teach nothing."""
    if not command:
        assert main([]) == 0 and "first steps" in capsys.readouterr().out
    below = re.split(r"^(?:first steps|then|examples?)", HELP[command], flags=re.MULTILINE)[1]
    examples = re.findall(r"msf-jax ((?:\S+ ?)+)", below)  # what follows two spaces, or is not typed, explains
    typed = [example.split(" > ")[0].split() for example in examples if "COMMAND" not in example]
    assert typed
    for arguments in typed:
        whole_parser().parse_args(arguments)
    with pytest.raises(SystemExit, match="0"):
        main([command, "--help"] if command else ["--help"])
