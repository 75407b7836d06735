"""The house keeps its order: chapters import downwards, the two wings do not mix, jaxopt stays in two rooms."""

import ast
from pathlib import Path

import msf_jax

ROOT = Path(msf_jax.__file__).parent
ORDER = ["base", "host", "device", "metrics", "skeleton", "gradients", "flow", "shapes", "ground_truth", "tuning"]
ORDER += ["view", "guide", "app", "__main__"]
FOREIGN = {"host": {"jax", "jaxlib", "jaxopt"}, "device": {"numpy", "scipy", "trimesh"}}
MOST_ENTRIES, MOST_FILES = 14, 12


def imports():
    """(file, chapter, imported module) for every import, those for type checkers and inside functions included."""
    for path in sorted(ROOT.rglob("*.py")):
        parts = path.relative_to(ROOT).with_suffix("").parts
        for node in ast.walk(ast.parse(path.read_text("utf-8"))) if parts != ("__init__",) else ():
            if isinstance(node, ast.Import):
                yield from (("/".join(parts), parts[0], alias.name) for alias in node.names)
            elif isinstance(node, ast.ImportFrom):
                assert not node.level, f"{path.name}: imports are absolute"
                names = [f"{node.module}.{alias.name}" for alias in node.names]
                yield from (("/".join(parts), parts[0], name) for name in names)


def test_chapters_import_downwards():
    for file, chapter, name in imports():
        top, _, rest = name.partition(".")
        if top == "msf_jax" and rest.split(".")[0] in ORDER:
            assert ORDER.index(rest.split(".")[0]) <= ORDER.index(chapter), f"{file} reaches up to {name}"


def test_the_wings_do_not_mix():
    for file, chapter, name in imports():
        assert name.split(".")[0] not in FOREIGN.get(chapter, ()), f"{file} imports {name}"
    with_jaxopt = {file for file, _, name in imports() if name.split(".")[0] == "jaxopt"}
    assert {file.split("/")[0] for file in with_jaxopt} == {"device", "tuning"} and len(with_jaxopt) == 2


def test_a_folder_fits_on_a_page():
    entries = [path for path in ROOT.iterdir() if path.name not in ("__init__.py", "__pycache__", "py.typed")]
    assert sorted(path.stem for path in entries) == sorted(ORDER) and len(entries) <= MOST_ENTRIES
    for folder in [ROOT, *(path for path in ROOT.rglob("*") if path.is_dir())]:
        files = list(folder.glob("*.py"))
        assert len(files) <= MOST_FILES, f"{folder.name} holds {len(files)} files"
