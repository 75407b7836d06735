"""Which numbers decide anything: each constant of the host's geometry by half and by two, and what changes.

    python -m tests.benchmarks.constants [--modules NAME,..] [--names NAME,..] [--shapes NAME,..] [--output FILE]

Run from the project's root. A constant is a number at the top of a module of `curve`, `limbs`, `solid` or `inside`,
which are folders, or modules such as `curve.centring`. Each is halved and doubled, whole numbers to whole ones of at
least 1, and tried on one of `SHAPES` after the other, until one misses it: the row says by what. A curve is another one
if a limb, a junction, a cycle or a doubt more or less is in it, if it is no longer sound, or by `MUCH`: its length, the
place of an end over the radius of its branch, or the mean distance between both curves over the median radius.

At the end are the constants that nobody misses, and those that are not tried: budgets, which bound time or memory, and
numbers in kernels, which `tests.translate` has compiled. The flow is run once for each shape where the constant acts
after it.
"""

import argparse
import ast
import importlib
import inspect
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any, NamedTuple
from unittest import mock

import numpy as np
import trimesh

from tests.benchmarks import curves, machined, solids, voids

MODULES = ("curve", "limbs", "solid", "inside")
AFTER_FLOW = ("curve", "limbs")
BUDGETS = ("MOST", "AT_ONCE", "AT_FIRST", "CHUNK", "CAPACITY", "VISITS", "TRIES")  # parts of names
MUCH = {"length": 0.01, "tip": 0.1, "curve": 0.02}
COUNTS = ("limbs", "junctions", "cycles", "is_sound", "doubts")
SHARED = Path(os.environ.get("MSF_JAX_MESHES", curves.ROOT.parent / "shared/meshes")).parent  # with wild and cases
Solid = tuple[np.ndarray, np.ndarray]


def known(name: str) -> Solid:
    from msf_jax import ground_truth

    return arrays(ground_truth.make(name).mesh)


def machined_solid(name: str) -> Solid:
    return arrays(machined.SOLIDS[name](solids.size_of(name, 0)).mesh("coarse"))


def shared(name: str) -> Solid:
    from msf_jax.meshes import reading

    return reading.read(SHARED / name)


def plant() -> Solid:
    """A stem with side branches of a third of its radius, each from its middle on."""
    stem = solids.rod(16.0, 0.6, sides=12)
    for height, turn in ((-4.0, 0.0), (0.0, 140.0), (4.0, 250.0)):
        side = solids.at(solids.rod(5.0, 0.2, sides=12), 0, 0, 2.5).rotate((0.0, 50.0, turn))
        stem += solids.at(side, 0, 0, height)
    mesh = stem.refine_to_length(0.6).to_mesh64()
    return mesh.vert_properties[:, :3], mesh.tri_verts.astype(np.int64)


def arrays(mesh: trimesh.Trimesh) -> Solid:
    return np.array(mesh.vertices), np.array(mesh.faces)


def thin() -> Solid:
    """Three rods with four sides that meet, so thin that wavefronts make the curve."""
    from msf_jax import ground_truth

    lines = [np.linspace([0, 0, 0], end, 100) for end in THIN_ENDS]
    return arrays(
        trimesh.util.concatenate([ground_truth.swept_tube(line, np.full(100, 0.015), 4, "flat") for line in lines])
    )


THIN_ENDS = [[0, 0, -2.0], [1.2, 0, 1.5], [-1.1, 0.4, 1.4]]
SHAPES: dict[str, Callable[[], Solid]] = {
    "octopus_low": partial(known, "octopus_low"),
    "hammer": partial(machined_solid, "hammer"),
    "spot-control": partial(shared, "wild/spot-control.obj"),  # a cow
    "wolf": partial(shared, "answers/wolf.obj"),  # ears that only stand out
    "short-outlet": partial(shared, "cases/short-outlet.off"),  # three openings
    "plant": plant,
    "table": partial(machined_solid, "table"),
    "thin": thin,
    "bar-2-bores": partial(machined_solid, "bar-2-bores"),
    "u-channel": partial(machined_solid, "u-channel"),
    "y_coarse": partial(known, "y_coarse"),
    "helix_coarse": partial(known, "helix_coarse"),
    "end-hole-bar": partial(machined_solid, "end-hole-bar"),
    "plate-holes-4": partial(machined_solid, "plate-holes-4"),
    "i-beam": partial(machined_solid, "i-beam"),
    "figure": partial(shared, "cases/figure.obj"),  # of parts that overlap
    "hollow": lambda: arrays(voids.hollow(0)[0]),
    "camel": partial(shared, "meshes/camel-pinched.off"),
    "sheet_and_limb": partial(known, "sheet_and_limb"),
}


class Constant(NamedTuple):
    module: str
    name: str
    value: float
    is_compiled: bool = False

    def by(self, factor: float) -> float:
        if self.name == "RATIO":  # of radii that grow: its excess over 1, or they never would
            return 1.0 + factor * (self.value - 1.0)
        return max(1, round(self.value * factor)) if isinstance(self.value, int) else self.value * factor

    @property
    def is_left_out(self) -> bool:
        return self.is_compiled or any(part in self.name for part in BUDGETS)

    def __str__(self) -> str:
        return f"{self.module.removeprefix('msf_jax.')}.{self.name}"


def constants(folders: list[str], names: list[str] | None) -> list[Constant]:
    """The numbers at the top of the modules of these folders."""
    found = []
    for folder in folders:
        place, _, only = folder.partition(".")
        for path in sorted((curves.ROOT / "msf_jax" / place).glob(f"{only or '*'}.py")):
            module = importlib.import_module(f"msf_jax.{place}.{path.stem}")
            tree = ast.parse(path.read_text())
            compiled = names_in_kernels(tree)
            for node in tree.body:
                targets = node.targets if isinstance(node, ast.Assign) else []
                for target in (name for each in targets for name in ast.walk(each) if isinstance(name, ast.Name)):
                    value = getattr(module, target.id)
                    if type(value) in (int, float) and (not names or target.id in names):
                        found.append(Constant(module.__name__, target.id, value, target.id in compiled))
    return found


def names_in_kernels(tree: ast.Module) -> set[str]:
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    kernels = [each for each in functions if {ast.unparse(name) for name in each.decorator_list} & {"kernel", "part"}]
    return {node.id for each in kernels for node in ast.walk(each) if isinstance(node, ast.Name)}


def places(constant: Constant) -> Iterator[tuple[ModuleType, FunctionType | None, int]]:
    """Where the value is: in modules, and in defaults of their functions, with the place among those."""
    owner = constant.module.rpartition(".")[2]
    for name, module in list(sys.modules.items()):
        if not name.startswith("msf_jax.") or not getattr(module, "__file__", None):
            continue
        tree = ast.parse(Path(str(module.__file__)).read_text())
        is_named = name == constant.module or any(
            isinstance(node, ast.ImportFrom) and node.module == constant.module and constant.name in _names(node)
            for node in tree.body
        )
        if is_named:
            yield module, None, 0
        for node in tree.body:
            for place, default in enumerate(node.args.defaults if isinstance(node, ast.FunctionDef) else []):
                here = isinstance(default, ast.Name) and default.id == constant.name and is_named
                there = isinstance(default, ast.Attribute) and ast.unparse(default) == f"{owner}.{constant.name}"
                function = getattr(module, node.name) if isinstance(node, ast.FunctionDef) else None
                if (here or there) and inspect.isfunction(function):
                    yield module, function, place


def _names(node: ast.ImportFrom) -> set[str]:
    return {each.name for each in node.names}


@contextmanager
def changed(constant: Constant, value: float) -> Iterator[None]:
    """The constant has another value, wherever it is."""
    found = list(places(constant))

    def put(new: float) -> None:
        for module, function, place in found:
            if function is None:
                setattr(module, constant.name, new)
            else:
                defaults = list(function.__defaults__ or ())
                function.__defaults__ = (*defaults[:place], new, *defaults[place + 1 :])

    put(value)
    try:
        yield
    finally:
        put(constant.value)


class Run:
    """The curve of a mesh, from the start or, ``after_flow``, from where the flow had ended."""

    def __init__(self, mesh: Solid):
        from msf_jax.flow import assembly, loop

        self.mesh, self.given, self.states = mesh, (), []
        curve_of, assemble = loop.curve_of, assembly.assemble

        def kept_curve(state: Any, *others: Any) -> Any:
            self.states.append((replace(state), state.caps.result().shape))
            return curve_of(state, *others)

        def kept_end(*given: Any) -> Any:
            self.given = given
            return assemble(*given)

        with mock.patch.object(loop, "curve_of", kept_curve), mock.patch.object(assembly, "assemble", kept_end):
            self.before = self.curve(after_flow=False)

    def curve(self, *, after_flow: bool) -> Any:
        import msf_jax
        from msf_jax.base.clock import Clock
        from msf_jax.flow import assembly, curves, starting

        if not after_flow:
            return msf_jax.skeletonize(self.mesh, repair="join")
        clock, states = Clock(), []
        checked, solid, pins, _, reasons, _, weights, config, *_ = self.given
        for state, shape in self.states:
            caps = clock.begin(starting._with_limbs, shape, config.least_slenderness, config.detail)
            states.append(replace(state, caps=caps))
        parts = [curves.curve_of(state, config, clock) for state in states]
        return assembly.assemble(checked, solid, pins, states, reasons, parts, weights, config, clock, []).skeleton


def counts_of(curve: Any) -> dict[str, int]:
    degree = np.bincount(curve.edges.ravel(), minlength=len(curve.vertices))
    report = curve.report
    found = (degree == 1).sum(), (degree > 2).sum(), report.cycles, report.is_sound, len(report.doubts)
    return dict(zip(COUNTS, map(int, found), strict=True))


def changes(before: Any, after: Any) -> dict[str, float]:
    """What is different, and by how much, where that is not 0."""
    from msf_jax import metrics
    from msf_jax.topology import graphs

    old, new = counts_of(before), counts_of(after)
    found: dict[str, float] = {name: new[name] - old[name] for name in COUNTS}
    found["length"] = after.length / before.length - 1
    leaves = after.vertices[np.bincount(after.edges.ravel()) == 1]
    tips = [0.0]
    for path in graphs.trace(len(before.vertices), before.edges) if len(leaves) else ():
        for end in {path[0], path[-1]}:
            if (before.edges == end).sum() == 1:
                away = np.linalg.norm(leaves - before.vertices[end], axis=1).min()
                tips.append(away / np.median(before.radii[path]))
    away = []
    for one, other in ((before, after), (after, before)):
        points, weight = metrics.sample_curve(one.vertices, one.edges, before.length / 500)
        away.append(np.average(metrics.curve_distance(points, other.vertices, other.edges), weights=weight))
    found |= {"tip": max(tips), "curve": max(away) / np.median(before.radii)}
    return {name: float(value) for name, value in found.items() if value}


def row_of(constant: Constant, factor: float, runs: dict[str, Run]) -> tuple[list[str], bool]:
    """The cells, and whether anybody misses it: of the first shape that does, or the largest changes."""
    most: dict[str, float] = {}
    after_flow = constant.module.split(".")[1] in AFTER_FLOW and constant.name != "SPLIT_BELOW"
    with changed(constant, constant.by(factor)):
        for name, run in runs.items():
            try:
                found = changes(run.before, run.curve(after_flow=after_flow))
            except Exception as error:  # a constant out of its range: that is missed
                return [f"{name}: {type(error).__name__}: {str(error)[:60]}", ""], True
            if any(abs(value) > MUCH.get(key, 0.0) for key, value in found.items()):
                return [name, texts(found)], True
            most |= {key: value for key, value in found.items() if abs(value) > abs(most.get(key, 0.0))}
    return ["", texts(most)], False


def texts(found: dict[str, float]) -> str:
    return ", ".join(f"{name} {value:+.2g}" for name, value in found.items())


def report(wanted: argparse.Namespace) -> Iterator[str]:
    import msf_jax  # noqa: F401  # all modules are to be there

    numbers = constants(wanted.modules, wanted.names)
    tried = [each for each in numbers if not each.is_left_out or wanted.names]
    runs = {name: Run(SHAPES[name]()) for name in wanted.shapes}
    yield f"# Constants\n\n{len(numbers)} numbers of {', '.join(wanted.modules)}, on {', '.join(runs)}.\n\n"
    yield curves.line(["constant", "value", "by", "missed by", "changes"])
    yield curves.line(["---", "---:", "---:", "---", "---"])
    unmissed = []
    for constant in tried:
        missed = False
        for factor in (0.5, 2.0):
            cells, is_missed = row_of(constant, factor, runs)
            missed |= is_missed
            yield curves.line([str(constant), f"{constant.value:g}", f"{factor:g}", *cells])
            if missed:
                break
        if not missed:
            unmissed.append(str(constant))
    yield f"\nNobody misses {len(unmissed)} of {len(tried)}: {', '.join(unmissed)}.\n"
    yield f"\nNot tried: {', '.join(str(each) for each in numbers if each not in tried)}.\n"


def words(text: str) -> list[str]:
    return text.split(",")


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.constants", description=__doc__.splitlines()[0])
    parser.add_argument("--modules", type=words, default=list(MODULES), help=",".join(MODULES))
    parser.add_argument("--names", type=words, help="of constants, with commas between")
    parser.add_argument("--shapes", type=words, default=list(SHAPES), help=",".join(SHAPES))
    parser.add_argument("--output", type=Path, help="file for the table")
    wanted = parser.parse_args()
    curves.configure_jax()
    curves.publish(report(wanted), wanted.output)


if __name__ == "__main__":
    main()
