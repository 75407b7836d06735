"""Chapters import downwards, no JAX on the host, jaxopt in two modules at most; what is public has a docstring."""

import ast
import inspect
from functools import cache
from pathlib import Path

import msf_jax

ROOT = Path(msf_jax.__file__).parent
ORDER = ["base", "topology", "numerics", "solid", "meshes", "inside", "meso", "limbs", "curve", "recording"]
FOREIGN = {name: {"jax", "jaxlib", "jaxopt"} for name in ORDER[1:]} | {"device": {"numpy", "scipy", "trimesh"}}
ORDER += ["device", "metrics", "preprocessing", "view", "skeleton", "gradients", "flow", "shapes", "tuning", "guide"]
ORDER += ["app", "__main__"]


@cache
def imports() -> list[tuple[str, str]]:
    """The file and the imported module of every import, those inside functions and for type checkers included."""
    pairs = []
    for path in sorted(ROOT.rglob("*.py")):
        file = path.relative_to(ROOT).with_suffix("").as_posix()
        for node in ast.walk(ast.parse(path.read_text("utf-8"))) if file != "__init__" else ():
            if isinstance(node, ast.Import):
                pairs += [(file, alias.name) for alias in node.names]
            elif isinstance(node, ast.ImportFrom):
                assert not node.level, f"{file}: imports are absolute"
                pairs += [(file, f"{node.module}.{alias.name}") for alias in node.names]
    return pairs


def test_chapters_import_downwards():
    assert {path.stem for path in ROOT.iterdir()} - {"__init__", "__pycache__", "py"} == set(ORDER)
    for file, name in imports():
        top, _, rest = name.partition(".")
        if top == "msf_jax" and rest.split(".")[0] in ORDER:
            assert ORDER.index(rest.split(".")[0]) <= ORDER.index(file.split("/")[0]), f"{file} reaches up to {name}"


def test_host_and_device_do_not_mix():
    for file, name in imports():
        assert name.split(".")[0] not in FOREIGN.get(file.split("/")[0], ()), f"{file} imports {name}"
    assert 0 < len({file for file, name in imports() if name.split(".")[0] == "jaxopt"}) <= 2


def test_what_is_public_has_a_docstring():
    """Each public name, and what it has."""
    bare = []
    for name in msf_jax.__all__:
        value = getattr(msf_jax, name)
        bare += [] if inspect.getdoc(value) else [name]
        module = getattr(value, "__name__", name)
        for key, member in vars(value).items() if inspect.isclass(value) or inspect.ismodule(value) else ():
            is_own = callable(member) or isinstance(member, property | classmethod | staticmethod)
            is_own &= not inspect.ismodule(value) or getattr(member, "__module__", "") == module
            bare += [f"{name}.{key}"] if key[0] != "_" and is_own and not inspect.getdoc(member) else []
    assert not bare
