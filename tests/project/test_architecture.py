"""Imports keep their order: chapters downwards, modules in no circle, no JAX on the host, jaxopt in two modules."""

import ast
import re
from collections import defaultdict
from functools import cache
from pathlib import Path

import networkx as nx

import msf_jax

ROOT, TESTS = Path(msf_jax.__file__).parent, Path(__file__).parents[1]
ORDER = ["base", "topology", "numerics", "solid", "meshes", "inside", "meso", "limbs", "curve", "recording"]
HOST = set(ORDER[1:])
GEOMETRY = ORDER[1 : ORDER.index("recording")]
ORDER += ["device", "metrics", "skeleton", "gradients", "flow", "shapes", "ground_truth", "tuning"]
ORDER += ["view", "guide", "app", "__main__"]
FOREIGN = {name: {"jax", "jaxlib", "jaxopt"} for name in HOST} | {"device": {"numpy", "scipy", "trimesh"}}
HANDED_ON = {"msf_jax.skeleton.skeleton.Skeleton", "msf_jax.skeleton.rigging.rig.Rig"}
MOST_ENTRIES, MOST_FILES = 22, 12  # a chapter each, as the table of `architecture.md` has them
TESTED_BY = {  # modules of the geometry without a test file of their own name, and the file that tests them
    "curve/draft": "curve/test_finishing",
    "limbs/outlets": "solid/test_openings",
    "meshes/decoding": "meshes/test_obj",
    "meshes/untangling": "meshes/test_hollow",
    "meso/complex": "meso/test_homology",
    "meso/packing": "base/test_layout",
    "solid/frame": "flow/test_flow",
    "solid/kernels": "solid/test_rays",
    "solid/solid": "solid/test_openings",
    "solid/walks": "solid/test_sections",
}
MOST_HOMES = 3  # modules in which one name may be a number: a reader holds so many apart


@cache
def imports():
    """(file, imported module, whether for type checkers only) for every import, those inside functions included."""
    found = []
    for path in sorted(ROOT.rglob("*.py")):
        parts = path.relative_to(ROOT).with_suffix("").parts
        tree = ast.parse(path.read_text("utf-8"))
        guards = [
            node for node in ast.walk(tree) if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"
        ]
        for_types = {inner for guard in guards for inner in ast.walk(guard)}
        for node in ast.walk(tree) if parts != ("__init__",) else ():
            if isinstance(node, ast.Import):
                names = [alias.name for alias in node.names]
            elif isinstance(node, ast.ImportFrom):
                assert not node.level, f"{path.name}: imports are absolute"
                names = [f"{node.module}.{alias.name}" for alias in node.names]
            else:
                continue
            found += [("/".join(parts), name, node in for_types) for name in names]
    return found


def test_chapters_import_downwards():
    for file, name, _ in imports():
        top, _, rest = name.partition(".")
        if top == "msf_jax" and rest.split(".")[0] in ORDER:
            assert ORDER.index(rest.split(".")[0]) <= ORDER.index(file.split("/")[0]), f"{file} reaches up to {name}"


def test_modules_import_in_no_circle():
    """Not even for types, but for results whose methods hand them to functions that name them as a type."""
    modules = {str(path.relative_to(ROOT).with_suffix("")) for path in ROOT.rglob("*.py")}
    graph = nx.DiGraph()
    for file, name, is_for_types in imports():
        found = name.removeprefix("msf_jax.").replace(".", "/")
        found = found if found in modules else found.rpartition("/")[0]  # else it is a name in a module
        if name.startswith("msf_jax.") and found in modules and not (is_for_types and name in HANDED_ON):
            graph.add_edge(file, found)
    assert len(graph) > 100
    assert not [part for part in nx.strongly_connected_components(graph) if len(part) > 1]


def test_the_page_of_the_source_has_every_module_once_in_the_order_of_imports():
    """In the first column of its table, on its own or within a folder."""
    rows = re.findall(r"^\| (`.*?) \|", (ROOT / "guide" / "architecture.md").read_text("utf-8"), flags=re.MULTILINE)
    named = [name for row in rows for name in re.findall(r"`([^`]+)`", row)]
    assert list(dict.fromkeys(re.split(r"[/.]", name)[0] for name in named)) == ORDER[:-1]
    assert all((ROOT / name).exists() for name in named)
    for path in ROOT.rglob("*.py"):
        file = path.relative_to(ROOT).as_posix()
        if path.stem not in ("__init__", "__main__"):
            assert sum(file == name or (name[-1] == "/" and file.startswith(name)) for name in named) == 1, file


def test_host_and_device_do_not_mix():
    for file, name, _ in imports():
        assert name.split(".")[0] not in FOREIGN.get(file.split("/")[0], ()), f"{file} imports {name}"
    with_jaxopt = {file for file, name, _ in imports() if name.split(".")[0] == "jaxopt"}
    assert {file.split("/")[0] for file in with_jaxopt} == {"device", "tuning"} and len(with_jaxopt) == 2


def test_only_what_makes_runs_knows_a_whole_config():
    """The chapters below get single options, or the settings of a step."""
    knowing = {file.split("/")[0] for file, name, _ in imports() if name == "msf_jax.base.options.Config"}
    assert knowing == {"flow", "gradients", "tuning", "app"}


def test_nothing_private_of_jax_is_used():
    """Not even by name, as a string."""
    for path in ROOT.rglob("*.py"):
        assert "jax._src" not in path.read_text("utf-8"), path.name


def test_a_folder_fits_on_a_page():
    entries = [path for path in ROOT.iterdir() if path.stem not in ("__init__", "__pycache__", "py")]
    assert sorted(path.stem for path in entries) == sorted(ORDER) and len(entries) <= MOST_ENTRIES
    for folder in [ROOT, *(path for path in ROOT.rglob("*") if path.is_dir())]:
        files = list(folder.glob("*.py"))
        assert len(files) <= MOST_FILES, f"{folder.name} holds {len(files)} files"


def test_every_module_of_the_geometry_has_its_tests_in_the_file_of_its_name():
    """In the folder of its chapter; a new one, too. `TESTED_BY` names those that another file tests."""
    files = [path.relative_to(ROOT) for name in GEOMETRY for path in (ROOT / name).rglob("*.py")]
    modules = {(path.parts[0], path.stem) for path in files if path.stem != "__init__"}
    assert len(modules) > 50
    alone = {f"{top}/{name}" for top, name in modules if not (TESTS / top / f"test_{name}.py").exists()}
    assert alone == set(TESTED_BY)
    assert not [name for name in TESTED_BY.values() if not (TESTS / f"{name}.py").exists()]


# Names of 0.3.0 and before, for which the field has terms: see the table in the change log.
PRIVATE = """about_clearance approach chamber chambers course hub hubs look looks passage passages persistence recipe
room rooms rough skirt skirts tooth twig twigs unfold unfolded wave waves way ways wing wings"""
PRIVATE_WORDS = set(PRIVATE.split())
IN_TEXT = r"\b(front doors?|hubs?|chambers?|passages?|persistence|rooms?|skirts?|twigs?|ways|wings?)\b"


def test_names_are_the_fields_own_terms():
    """In names of modules, functions, classes and variables, and in the texts of the package and its guide."""
    for path in sorted([*ROOT.rglob("*.py"), *ROOT.rglob("*.md")]):
        text = path.read_text("utf-8")
        found = re.search(IN_TEXT, text.replace("Sykes, Chambers, Letscher", ""), re.IGNORECASE)
        assert not found, f"{path.relative_to(ROOT)}: {found}"
        nodes = [*ast.walk(ast.parse(text))] if path.suffix == ".py" else []
        names = {node.id for node in nodes if isinstance(node, ast.Name)} | {path.stem}
        names |= {getattr(node, "name", None) or "" for node in nodes}
        names |= {node.arg for node in nodes if isinstance(node, ast.arg)}
        words = {word for name in names for word in (name, *name.lower().split("_"))}
        assert not words & PRIVATE_WORDS, f"{path.relative_to(ROOT)}: {words & PRIVATE_WORDS}"


def homes():
    """The modules of each name that a module defines outside its functions: {name: {file}}; of classes all."""
    found = defaultdict(set)
    for path in sorted(ROOT.rglob("*.py")):
        tree = ast.parse(path.read_text("utf-8"))
        names = [node.name for node in ast.walk(tree) if isinstance(node, ast.ClassDef)]
        for node in tree.body:
            targets = getattr(node, "targets", None) or [getattr(node, "target", None)]
            inner = [each for target in targets if target for each in ast.walk(target)]
            names += [each.id for each in inner if isinstance(each, ast.Name)]
        for name in names:
            found[name].add(path.relative_to(ROOT).as_posix())
    return found
