"""Names of 0.4.0 still work, with a warning that has the new one, and its files are still read."""

import dataclasses
import inspect
import operator
import pickle
import re
import sys
import typing
import warnings

import numpy as np
import pytest
from conftest import blob
from run_cases import flow_of

import msf_jax
from msf_jax import Config, FlowOptions, PreprocessingOptions, SolverOptions, ground_truth
from msf_jax.base import archive
from msf_jax.base.options import flat
from msf_jax.gradients import tape as tapes

# The options of 0.4.0 and their defaults, from its source. `detail` and `max_seconds` came later.
OF_040 = {
    "weights_of": "msf",
    "laplacian": "mean_value",
    "reconstruct_poles": 200,
    "reconstruct_mesh": 0,
    "exact_reconstruction": False,
    "resample": 0.0,
    "coarsen": 0.005,
    "refine": 0.02,
    "use_poles": True,
    "poles": "auto",
    "pole_confidence": False,
    "edit_connectivity": True,
    "t_min": 0.005,
    "t_step": 0.0005,
    "t_max": 0.016,
    "split_angle": 110.0,
    "growth": 1.0,
    "w_H_follows_area": False,
    "max_iterations": 200,
    "volume_tolerance": 1e-4,
    "area_tolerance": 0.01,
    "free_tolerance": 0.01,
    "solve_tolerance": 3e-3,
    "step_tolerance": 0.03,
    "solve_steps": 2000,
    "preconditioner": "jacobi",
    "surgery": False,
    "prune": 1.0,
    "centre": True,
    "extend_tips": True,
    "evaluate": False,
    "check": False,
}
# Other values: of a call with 0.4.0's names.
OTHERS = {
    "weights_of": "tagliasacchi2012",
    "laplacian": "uniform",
    "reconstruct_poles": 50,
    "reconstruct_mesh": 60,
    "exact_reconstruction": True,
    "resample": 0.02,
    "refine": 0.0,
    "use_poles": False,
    "poles": "balls",
    "pole_confidence": True,
    "edit_connectivity": False,
    "t_min": 0.003,
    "t_step": 0.001,
    "t_max": 0.02,
    "split_angle": 120.0,
    "growth": 2.0,
    "w_H_follows_area": True,
    "volume_tolerance": 0.0,
    "area_tolerance": 0.5,
    "free_tolerance": 0.5,
    "solve_tolerance": 1e-5,
    "step_tolerance": 0.5,
    "solve_steps": 7,
    "preconditioner": "factored",
    "surgery": True,
    "prune": 2.5,
    "centre": False,
    "extend_tips": False,
}


def told(name, call):
    """What ``call`` returns; it is deprecated by one message that has ``name``."""
    with pytest.warns(DeprecationWarning, match=name) as found:
        value = call()
    assert len(found) == 1 and found[0].filename == __file__
    return value


def test_every_option_of_040_has_a_place():
    """One for each flat name, and with the defaults of 0.4.0."""
    assert len(set(flat.FLAT.values())) == len(flat.FLAT)
    assert set(flat.FLAT) <= set(OF_040)
    assert {name: operator.attrgetter(flat.FLAT.get(name, name))(Config()) for name in OF_040} == OF_040
    assert {name: path for name, path in flat.FLAT.items() if path.rpartition(".")[2] != name} == {
        "weights_of": "system",
        "t_min": "flow.threshold_min",
        "t_step": "flow.threshold_step",
        "t_max": "flow.threshold_max",
        "growth": "flow.w_L_growth",
        "solve_tolerance": "solver.tolerance",
        "solve_steps": "solver.max_steps",
        "prune": "least_slenderness",
    }


@pytest.mark.parametrize("name", OTHERS)
def test_an_old_keyword_works_and_its_warning_has_the_new_call(name):
    """The call in the warning gives the same config, and the value is read by the old name, too."""
    value, extra = OTHERS[name], {"edit_connectivity": False} if name == "w_H_follows_area" else {}
    with pytest.warns(DeprecationWarning, match=rf"{name}\b.* (is|are) deprecated") as shown:
        found = Config(**{name: value}, **extra)
    assert all(each.filename == __file__ for each in shown)
    with pytest.warns(DeprecationWarning, match=rf"Config.{name} is deprecated: use Config.{flat.FLAT[name]}$"):
        assert getattr(found, name) == value
    if name == "weights_of":
        assert "Config.named('tagliasacchi2012')" in str(shown[0].message)
        assert found.default_weights() == Config.tagliasacchi2012().default_weights()
        return
    call = re.search(r"use (Config\(.*\))$", str(shown[0].message))
    assert call
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert eval(call[1], {**vars(msf_jax.base.options), "Config": Config}) == found
    assert found != Config(**({"flow": FlowOptions(edit_connectivity=False)} if extra else {}))


def test_old_keywords_work_where_a_config_is_changed():
    with pytest.warns(
        DeprecationWarning, match=r"growth of Config.au2008 .* Config.au2008\(flow={'w_L_growth': 1.2}\)"
    ):
        slow = Config.au2008(growth=1.2)
    assert slow == Config.au2008(flow={"w_L_growth": 1.2})
    expected = slow.replace(least_slenderness=2.0, flow={"threshold_min": 0.004})
    with pytest.warns(DeprecationWarning, match=r"use config.replace\(flow={'threshold_min': 0.004}, least_"):
        assert dataclasses.replace(slow, t_min=0.004, prune=2.0) == expected
    with pytest.warns(DeprecationWarning, match=r"Config.named\(solver={'tolerance': 1e-06}\)"):
        assert Config.named("msf", solve_tolerance=1e-6) == Config(solver=SolverOptions(tolerance=1e-6))
    with pytest.raises(AttributeError, match="no attribute 'threshold'"):
        Config().threshold  # noqa: B018


def test_an_old_name_beside_its_new_one_is_refused():
    """Or beside its group, of which either may be meant."""
    with pytest.raises(msf_jax.ConfigError, match=r"prune is the old name of least_slenderness: expected no least_sl"):
        Config(prune=0.2, least_slenderness=3)  # pyright: ignore[reportCallIssue]
    for call in (Config, Config().replace, Config.au2008):
        with pytest.raises(msf_jax.ConfigError, match=r"t_min is the old name of flow.threshold_min: expected no flow"):
            call(t_min=0.003, flow={"threshold_min": 0.004})


def test_old_names_together_are_in_one_message():
    with pytest.warns(
        DeprecationWarning, match=r"^t_min, prune of Config are deprecated: use Config\(flow=FlowOptions"
    ):
        Config(t_min=0.01, prune=0.4)  # pyright: ignore[reportCallIssue]


def test_a_warning_is_at_the_line_that_called_copy_replace():
    """Of Python 3.13: a function of the module ``copy`` calls one of ``dataclasses``."""
    copy = {"__name__": "copy", "__replace__": dataclasses.replace}
    exec("def replace(value, /, **changes): return __replace__(value, **changes)", copy)
    assert told(r"prune of config.replace is", lambda: copy["replace"](Config(), prune=2.0)).least_slenderness == 2.0


def test_a_pickle_of_flat_values_is_read():
    """0.4.0 kept its values as attributes; a copy of today's keeps its groups."""
    assert pickle.loads(pickle.dumps(Config.au2008(detail=0.6))) == Config.au2008(detail=0.6)
    old = object.__new__(Config)
    old.__setstate__(OF_040 | {"t_min": 0.002, "weights_of": "au2008"})
    assert old.flow.threshold_min == 0.002 and old.system == "au2008" and old.detail == 0.5
    assert hash(old) == hash(old.replace())


@pytest.fixture(scope="module")
def short():
    return msf_jax.contract(blob(2), config=Config(max_iterations=2, preprocessing=PreprocessingOptions(refine=0.0)))


def test_a_tape_of_040_is_read(short, tmp_path):
    """Its header names the options flat, without those that came later."""
    short.tape.save(tmp_path / "now.npz")
    with archive.reading(tmp_path / "now.npz", tapes.KIND, tapes.FORMAT_VERSION, "") as (header, arrays):
        held = header["tape"]["members"]["config"]
        assert held["record"] == "Config"
        held["members"] = OF_040 | {"max_iterations": 2, "refine": 0.0, "t_step": 0.001}
        del header["format"], header["version"]
        archive.write(tmp_path / "old.npz", tapes.KIND, tapes.FORMAT_VERSION, header, arrays, compress=True)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        again = msf_jax.Tape.load(tmp_path / "old.npz")
    assert again.config == short.config.replace(flow={"threshold_step": 0.001})
    held["members"]["t_min"] = -1.0
    archive.write(tmp_path / "bad.npz", tapes.KIND, tapes.FORMAT_VERSION, header, arrays, compress=True)
    with pytest.raises(msf_jax.ConfigError, match=r"damaged .*threshold_min is -1.0"):
        msf_jax.Tape.load(tmp_path / "bad.npz")


@pytest.fixture(scope="module")
def tube():
    return flow_of("straight_coarse").skeleton


def test_old_methods_of_a_skeleton_work(tube, monkeypatch):
    """Those that were meant for the package, and the table that was one type or another."""
    curve = tube
    same = told("Skeleton.changed is", lambda: curve.changed)(
        curve.vertices, curve.edges, np.arange(len(curve.vertices))
    )
    np.testing.assert_array_equal(same.edges, curve.edges)
    inside = told("metrics.evaluate", lambda: curve.inside_of)(curve.vertices, curve.edges, curve.radii)
    assert inside == curve.report.inside
    assert len(told("Skeleton.source", lambda: curve.surface).vertex) == len(curve.mesh_map)
    table = told("Skeleton.columns, .* Skeleton.to_pandas", lambda: curve.table)("nodes")
    assert table.equals(curve.to_pandas("nodes"))
    monkeypatch.setitem(sys.modules, "pandas", None)
    assert list(told("columns", lambda: curve.table)()) == list(curve.columns())
    with pytest.raises(AttributeError, match="'Skeleton' object has no attribute 'tables'"):
        curve.tables  # noqa: B018
    assert not hasattr(curve, "_asdict")  # an old name is asked for by nobody else


def test_other_old_names_work(tube):
    batch = msf_jax.stack([tube])
    ((binding, vertices),) = told(r"Batch.members\(\)", batch.unstack)
    assert binding.live.nodes == len(tube.vertices) and vertices.shape == (len(tube.mesh_map), 3)
    with pytest.raises(msf_jax.ConfigError, match="jittered_runs is -1: expected a number of runs"):
        told(r"skeletonize\(jittered_runs=-1\)", lambda: msf_jax.skeletonize(blob(2), spread=-1))


README_040 = """
import jax
import msf_jax

jax.config.update("jax_enable_x64", True)  # float64; without it everything runs in float32
msf_jax.cache_compilations()  # keep compiled programs on disk, for later processes

skeleton = msf_jax.skeletonize("hand.off")  # or a trimesh.Trimesh, or (vertices, faces); repair=True, repair="join"
print(skeleton.report)  # converged? cycles = genus? how much of the curve is inside?
skeleton.vertices, skeleton.edges, skeleton.radii  # (N, 3) in the mesh's units, (E, 2), (N,)
skeleton.mesh_map  # (V,) the node of every input vertex
skeleton.save("hand.swc")  # or .csv, .vtp, .obj, .ply, .npz, .json, .glb (the mesh on a rig of bones), ...
skeleton.table()  # a row for each branch: length, radii, volume, angle to its parent, ...
skeleton.view("hand.off", "hand.html")  # an interactive page of the mesh and its curve
"""


@pytest.mark.slow  # its names are in the other tests
def test_the_script_of_the_readme_of_040_runs(tmp_path, monkeypatch):
    """With a deprecation at its own line, that has the new names."""
    monkeypatch.setattr(msf_jax, "cache_compilations", lambda: None)  # the user's folder is not a test's
    ground_truth.make("y_coarse").mesh.export(tmp_path / "hand.off")
    monkeypatch.chdir(tmp_path)
    with pytest.warns(
        DeprecationWarning, match=r"Skeleton.table is .* Skeleton.columns, .* Skeleton.to_pandas"
    ) as found:
        exec(compile(README_040, "readme.py", "exec"), {"__name__": "block"})
    lines = README_040.splitlines()
    assert [lines[each.lineno - 1].split("(")[0] for each in found if each.filename == "readme.py"] == [
        "skeleton.table"
    ]


@pytest.mark.parametrize("take", [msf_jax.skeletonize, msf_jax.contract, msf_jax.read_mesh, msf_jax.metrics.evaluate])
def test_functions_say_what_a_mesh_is(take):
    assert typing.get_type_hints(take)["mesh"] == msf_jax.MeshLike
    assert "mesh: 'MeshLike'" in str(inspect.signature(take))  # the union would take half a page of `help`
