"""Numbers that texts repeat are those of the code or of the page that has them, and every file they name is there."""

import ast
import inspect
import re
import warnings
from pathlib import Path

import pytest
import yaml
from test_architecture import MOST_FILES

import msf_jax
from msf_jax import Config, Repair, Weights
from msf_jax.app import batch
from msf_jax.base.version import VERSION
from msf_jax.curve import finishing
from msf_jax.device import cg, laplacian
from msf_jax.flow import curves, loop, stepping
from msf_jax.flow import skeletonize as running
from msf_jax.gradients import holding, replay
from msf_jax.inside import thickness
from msf_jax.limbs import caps, ends, fronts
from msf_jax.meshes import repair
from msf_jax.skeleton import report
from msf_jax.skeleton.formats import swc

ROOT = Path(__file__).parents[2]
PACKAGE = Path(msf_jax.__file__).parent
GUIDE = PACKAGE / "guide"
TEXTS = [ROOT / "README.md", ROOT / ".github" / "CONTRIBUTING.md", *sorted(GUIDE.glob("*.md"))]
WORDS = {
    1 / 3: "a third",
    1 / 10: "a tenth",
    1 / 2: "half",
    2: "twice",
    12: "twelve",
    30: "thirty",
    0.3: "three tenths",
}
CONFIG, WEIGHTS = Config(), Weights()


def text_of(page: str) -> str:
    """On one line, so that a phrase may be wrapped anywhere."""
    return " ".join((GUIDE / page if (GUIDE / page).exists() else ROOT / page).read_text("utf-8").split())


def percent(share: float) -> str:
    return f"{100 * share:g} %"


def found(page: str, pattern: str) -> str:
    """The group of the only match of the pattern in a page."""
    (number,) = re.findall(pattern, text_of(page))
    return number


FIRST = found("speed.md", r"A new process skeletonises homer in (\S+) s with an empty")
MILLION = found("speed.md", r"\| hand \| 1,004,192 \| (\S+) \|")

# Of each page a phrase, written with the number's owner: who changes the number changes the phrase.
FACTS = [
    ("README.md", f"a new process takes {FIRST} s, because it compiles"),
    ("README.md", f"a million vertices take {MILLION} s"),
    (".github/CONTRIBUTING.md", f"A folder holds at most {WORDS[MOST_FILES]} modules"),
    ("speed.md", f"Of the {MILLION} s,"),
    ("speed.md", f"solves stop at a residual of {CONFIG.solver.tolerance:.0e}".replace("e-0", "e-")),
    ("speed.md", f"Tighter solves (below {cg.LOOSE:.0e})".replace("e-0", "e-")),
    ("differences.md", f"limited** to {laplacian.LARGEST_ENTRY:g} times their row's unit"),
    (
        "differences.md",
        f"threshold starts at {CONFIG.flow.threshold_min:g} and rises by {CONFIG.flow.threshold_step:g}.**",
    ),
    ("differences.md", f"the projection on {CONFIG.preprocessing.reconstruct_poles} eigenvectors"),
    ("differences.md", f"Edges below {CONFIG.coarsen:g} of the diagonal are collapsed"),
    ("differences.md", f"At most {percent(loop.SETTLED)} of the volume is left; or up to {percent(loop.MEMBRANES)} is"),
    ("differences.md", f"at most {WORDS[loop.THINNED]} as thick as the solid was"),
    ("report.md", f"neither volume nor area fell over {WORDS[loop.STALL_ITERATIONS]} iterations"),
    ("report.md", f"with more than {WORDS[curves.MOST_VOLUME]} left, the curve is coarse"),
    ("report.md", f"over {WORDS[report.MOST_STUBS]} of the limbs, and at least {report.MANY}, are stubs"),
    ("report.md", f"{report.MOST_UNEXPLAINED} of the length (`unexplained`)"),
    ("report.md", f"{report.MOST_IN_SHEETS} of the length (`in_sheets`)"),
    ("report.md", f"at least {report.LEAST_ELONGATION:g} median diameter (`elongation`)"),
    ("weights.md", f"`w_L` ({WEIGHTS.w_L})"),
    ("weights.md", f"`w_H` ({WEIGHTS.w_H})"),
    ("weights.md", f"`w_M` ({WEIGHTS.w_M})"),
    ("weights.md", f"`smoothing` ({WEIGHTS.smoothing})"),
    ("branches.md", f"has at least `Config(least_slenderness={CONFIG.least_slenderness})` is a limb"),
    ("branches.md", f"less than {percent(caps.SMALL_CAP)} of the surface"),
    ("branches.md", f"must be {WORDS[1 / fronts.SMALLER]} as slender"),
    ("branches.md", f"keeps the parts from {caps.BLUNT} of `least_slenderness` on"),
    ("branches.md", f"a `least_slenderness` below {caps.ROUND_END} acts as {caps.ROUND_END}"),
    ("branches.md", f"a mesh with fewer than {caps.SPLIT_BELOW:,} vertices are split"),
    ("branches.md", f"Edges are refined to {WORDS[finishing.SPACING]} a radius"),
    ("branches.md", f"a distance of {WORDS[ends.GAP]} of the radius of the limb's end from the surface"),
    ("repair.md", f"keeps the largest {Repair().most_parts} pieces"),
    ("repair.md", f"gaps up to {repair.LONGEST_GAP} of the diagonal"),
    ("repair.md", f"limbs thinner than {thickness.THIN} of the diagonal"),
    ("repair.md", f"is repeated with {WORDS[stepping.SHORTER]} of `w_L`"),
    ("batches.md", f"A worker is replaced after {batch.TASKS:,} meshes"),
    ("gradients.md", "relative residual of {:.0e} where only the value".format(replay.TOLERANCE["float64"][0])),
    ("gradients.md", "They end at {:.0e}".format(replay.TOLERANCE["float64"][1]).replace("e-0", "e-")),
    ("following.md", f"more runs with noise of {running.JITTER:.0e} diagonals".replace("e-0", "e-")),
    ("following.md", f"whether a ball has shrunk by {WORDS[1 - holding.PINCHED]}"),
    ("cookbook.md", f"the curve stops {ends.GAP} radii before its end"),
    ("cookbook.md", f"labels {swc.SOMA} soma, {swc.FORK} fork, {swc.END} end, {swc.OTHER} other"),
]


@pytest.mark.parametrize(("page", "phrase"), FACTS)
def test_a_number_in_a_text_is_its_owners(page, phrase):
    assert phrase in text_of(page)


@pytest.mark.parametrize("path", TEXTS, ids=lambda path: path.stem)
def test_files_that_a_text_names_are_there(path):
    """In the repository, the package or beside the text: modules, pages, and what `python -m` runs."""
    text = path.read_text("utf-8")
    names = re.findall(r"(?<![\w./*-])([\w.-]+(?:/[\w.-]+)*\.(?:py|md|ll))\b", text)
    assert not [name for name in names if not any((at / name).exists() for at in (ROOT, PACKAGE, path.parent))]
    programs = [ROOT / name.replace(".", "/") for name in re.findall(r"python -m (tests\.[\w.]*\w)", text)]
    assert not [name for name in programs if not (name.is_dir() or name.with_suffix(".py").exists())]


RESULTS = [value for value in (getattr(msf_jax, name) for name in msf_jax.__all__) if inspect.isclass(value)]
OF_RESULTS = {name for kind in RESULTS for name in (*dir(kind), *getattr(kind, "__annotations__", ()))} - {"save"}


def is_of_a_module(node: ast.Attribute) -> bool:
    return ast.unparse(node.value).removeprefix("msf_jax.") in ("msf_jax", "np", "jnp", "jax", "metrics", "losses")


@pytest.mark.parametrize("path", TEXTS, ids=lambda path: path.stem)
def test_a_page_names_what_its_recipes_read(path):
    """Attributes and methods of a result, in its text or in a comment in that line; `save` speaks for itself."""
    text = path.read_text("utf-8")
    prose = re.sub(r"```.*?```", "", text, flags=re.DOTALL)
    for block in re.findall(r"```python\n(.*?)```", text, flags=re.DOTALL):
        lines = block.splitlines()
        for node in ast.walk(ast.parse(block)):
            if isinstance(node, ast.Attribute) and node.attr in OF_RESULTS and not is_of_a_module(node):
                is_told = any("#" in line for line in lines[node.lineno - 1 : node.end_lineno])
                assert is_told or re.search(rf"\b{node.attr}\b", prose), f"{path.name}: {ast.unparse(node)}"


def test_two_pages_say_what_the_table_of_tuning_shows():
    rows = re.findall(r"^\| \w+ \| [\d.]+ \|(.*)\|$", (GUIDE / "tuning.md").read_text("utf-8"), flags=re.MULTILINE)
    medians = [[float(cell.strip(" *").split(",")[0].strip("*")) for cell in row.split("|")] for row in rows]
    assert len(medians) == 6 and {len(row) for row in medians} == {4}
    num_best = sum(row[0] == min(row) < min(row[1:]) for row in medians)
    assert num_best == 3
    for page in ("tuning.md", "claims.md"):
        (most,) = re.findall(
            r"is the best on three(?: shapes)?, and within ([\d.]+) % of the best on all", text_of(page)
        )
        assert max(row[0] / min(row) for row in medians) <= 1 + float(most) / 100


def test_the_workflow_has_the_oldest_and_the_newest_python_of_the_classifiers():
    project = text_of("pyproject.toml")
    minors = sorted(int(minor) for minor in re.findall(r"Python :: 3\.(\d+)", project))
    assert f'requires-python = ">=3.{minors[0]}"' in project and minors == [*range(minors[0], minors[-1] + 1)]
    assert f'python: ["3.{minors[0]}", "3.{minors[-1]}"]' in text_of(".github/workflows/ci.yml")
    assert f"with Python 3.{minors[0]} or newer" in text_of("README.md")


def test_the_citation_is_of_this_version():
    cited = yaml.safe_load((ROOT / ".github" / "CITATION.cff").read_text("utf-8"))
    assert (cited["title"], cited["version"], cited["license"]) == ("msf_jax", VERSION, "Apache-2.0")
    links = {f"https://doi.org/{one['doi']}" for one in cited["references"] if "doi" in one}
    assert len(links) == 2 and all(link in text_of("README.md") and link in text_of("pyproject.toml") for link in links)


@pytest.mark.parametrize("path", sorted((ROOT / ".github" / "workflows").glob("*.yml")), ids=lambda path: path.stem)
def test_what_a_workflow_names_is_there(path):
    """Jobs, files, programs of the tests, and what one job uploads for another."""
    jobs = yaml.safe_load(path.read_text("utf-8"))["jobs"]
    steps = [step for job in jobs.values() for step in job.get("steps", [])]
    needs = [name for job in jobs.values() for name in [job.get("needs", [])]]
    assert {name for each in needs for name in ([each] if isinstance(each, str) else each)} <= set(jobs)
    assert all((ROOT / job["uses"]).exists() for job in jobs.values() if "uses" in job)
    runs = " ".join(step.get("run", "") for step in steps)
    assert all((ROOT / name).exists() for name in re.findall(r"bash (\S+)", runs))
    assert all((ROOT / f"{name.replace('.', '/')}.py").exists() for name in re.findall(r"-m (tests\.\S+)", runs))
    kept = {
        kind: [step["with"]["name"] for step in steps if f"/{kind}-artifact@" in step.get("uses", "")]
        for kind in ("upload", "download")
    }
    assert set(kept["download"]) <= set(kept["upload"])


def test_a_release_is_tested_and_its_tag_is_the_version():
    jobs = yaml.safe_load((ROOT / ".github" / "workflows" / "release.yml").read_text("utf-8"))["jobs"]
    assert jobs["tests"] == {"uses": "./.github/workflows/ci.yml"} and jobs["publish"]["needs"] == ["tests", "build"]
    assert [name for name, job in jobs.items() if "permissions" in job] == ["publish"]
    (check,) = [step["run"] for step in jobs["build"]["steps"] if "GITHUB_REF_NAME" in step.get("run", "")]
    name = check.partition("#v}")[0].partition("dist/")[2].partition("-$")[0]
    assert check.startswith("test -f") and f'name = "{name}"' in text_of("pyproject.toml")


@pytest.mark.parametrize("kind", [DeprecationWarning, FutureWarning])
def test_what_others_deprecate_among_themselves_fails_no_test(kind):
    """By the filters of `pyproject.toml`: a call from this project's code does."""
    for module in ("msf_jax.flow.loop", "tests.pages", "test_facts", "conftest", "curve_cases", "block"):
        with pytest.raises(kind):
            warnings.warn_explicit("old", kind, "file.py", 1, module)
    with warnings.catch_warnings(record=True) as shown:
        warnings.warn_explicit("old", kind, "file.py", 1, "scipy.spatial")
    assert [str(each.message) for each in shown] == ["old"]
    with pytest.raises(RuntimeWarning):
        warnings.warn_explicit("overflow", RuntimeWarning, "file.py", 1, "scipy.spatial")
