"""Which numbers decide anything: each constant of the host's geometry by half and by two, and what changes.

    python -m tests.benchmarks.constants [--modules NAME,..] [--names NAME,..] [--shapes NAME,..] [--meshes FOLDER]
        [--output FILE]

Run from the project's root. A constant is a number at the top of a module of `curve`, `solid`, `limbs` or `inside`.
Shapes are names of `msf_jax.ground_truth` and of files in ``--meshes``. Each is run once as it is, and then with every
constant halved and doubled, whole numbers to whole ones of at least 1. Printed are the greatest changes over shapes: of
tips and cycles, off-centre and missed (`msf_jax.metrics.evaluate`), and length over the length; or what was raised.
At the end are the constants that nobody misses: neither half nor double changes tips or cycles, or off-centre by more
than 0.005, missed by 0.002, length by 1 %. They may still bound time or memory, or matter on other shapes.
"""

import argparse
import ast
import importlib
import inspect
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any, NamedTuple

import numpy as np
import trimesh

from tests.benchmarks import curves

MODULES = ("curve", "solid", "limbs", "inside")
SHAPES = ["y_coarse", "comb", "sheet_and_limb", "octopus_low", "hand"]
FIGURES = {"leaves": 0.5, "cycles": 0.5, "off_centre": 0.005, "missed_95": 0.002, "length": 0.01}  # and what is much
Solid = tuple[np.ndarray, np.ndarray]


class Constant(NamedTuple):
    module: str
    name: str
    value: float

    def by(self, factor: float) -> float:
        return max(1, round(self.value * factor)) if isinstance(self.value, int) else self.value * factor


def constants(folders: list[str], names: list[str] | None) -> list[Constant]:
    """The numbers at the top of the modules of these folders."""
    found = []
    for folder in folders:
        for path in sorted((curves.ROOT / "msf_jax" / folder).glob("*.py")):
            module = importlib.import_module(f"msf_jax.{folder}.{path.stem}")
            for node in ast.parse(path.read_text()).body:
                targets = node.targets if isinstance(node, ast.Assign) else []
                for target in (name for each in targets for name in ast.walk(each) if isinstance(name, ast.Name)):
                    value = getattr(module, target.id)
                    if type(value) in (int, float) and (not names or target.id in names):
                        found.append(Constant(module.__name__, target.id, value))
    return found


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


def shapes(names: list[str], folder: Path) -> dict[str, Solid]:
    from msf_jax import ground_truth

    files = curves.mesh_files(folder)
    found = {}
    for name in names:
        mesh = trimesh.load(files[name], process=False) if name in files else ground_truth.make(name).mesh
        found[name] = np.array(mesh.vertices), np.array(mesh.faces)
    return found


def figures_of(mesh: Solid) -> dict[str, float]:
    import msf_jax

    curve = msf_jax.skeletonize(mesh)
    found = msf_jax.metrics.evaluate(mesh, curve) | {"length": curve.length, "cycles": curve.report.cycles}
    return {key: float(found[key]) for key in FIGURES}


def changes(before: dict[str, float], after: dict[str, float]) -> dict[str, float]:
    found = {key: after[key] - before[key] for key in FIGURES}
    return found | {"length": found["length"] / max(before["length"], 1e-300)}


def row_of(constant: Constant, factor: float, meshes: dict[str, Solid], own: dict[str, Any]) -> tuple[list[str], bool]:
    """The cells, and whether anybody misses it."""
    most = dict.fromkeys(FIGURES, 0.0)
    where: list[str] = []
    with changed(constant, constant.by(factor)):
        for name, mesh in meshes.items():
            try:
                found = changes(own[name], figures_of(mesh))
            except Exception as error:  # a constant out of its range: that is missed
                return [f"{name}: {type(error).__name__}: {str(error)[:60]}"], True
            most = {key: max((most[key], found[key]), key=abs) for key in FIGURES}
            if any(abs(found[key]) > much for key, much in FIGURES.items()):
                where.append(name)
    return [*(f"{value:+.3g}" if value else "" for value in most.values()), " ".join(where)], bool(where)


def report(wanted: argparse.Namespace) -> Iterator[str]:
    import msf_jax  # noqa: F401  # all modules are to be there

    numbers = constants(wanted.modules, wanted.names)
    meshes = shapes(wanted.shapes, wanted.meshes)
    own = {name: figures_of(mesh) for name, mesh in meshes.items()}
    yield f"# Constants\n\n{len(numbers)} numbers of {', '.join(wanted.modules)}, on {', '.join(meshes)}.\n\n"
    yield curves.line(["constant", "value", "by", *FIGURES, "on"])
    yield curves.line(["---", *["---:"] * (len(FIGURES) + 2), "---"])
    unmissed = []
    for constant in numbers:
        missed = False
        for factor in (0.5, 2.0):
            cells, is_missed = row_of(constant, factor, meshes, own)
            missed |= is_missed
            name = f"{constant.module.removeprefix('msf_jax.')}.{constant.name}"
            yield curves.line([name, f"{constant.value:g}", f"{factor:g}", *cells])
        if not missed:
            unmissed.append(name)
    yield f"\nNobody misses {len(unmissed)} of {len(numbers)}: {', '.join(unmissed)}.\n"


def words(text: str) -> list[str]:
    return text.split(",")


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.constants", description=__doc__.splitlines()[0])
    parser.add_argument("--modules", type=words, default=list(MODULES), help=",".join(MODULES))
    parser.add_argument("--names", type=words, help="of constants, with commas between")
    parser.add_argument("--shapes", type=words, default=SHAPES, help=",".join(SHAPES))
    parser.add_argument("--meshes", type=Path, default=curves.ROOT.parent / "shared/meshes")
    parser.add_argument("--output", type=Path, help="file for the table")
    wanted = parser.parse_args()
    curves.configure_jax()
    curves.publish(report(wanted), wanted.output)


if __name__ == "__main__":
    main()
