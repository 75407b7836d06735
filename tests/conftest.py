"""Shared by all tests: float64, meshes made in code, and the research meshes where they are at hand."""

import gc
import os
import shutil
import signal
import sys
import tempfile
from pathlib import Path

# There is a process for each core: threads of dense algebra beside it wait for each other: 40 s for 4.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

# For `tests.benchmarks` and `tests.translate`. Last, so that the package is the one that is installed.
sys.path.append(str(Path(__file__).parents[1]))

import hypothesis
import jax
import matplotlib
import numpy as np
import pytest
import trimesh

from msf_jax.base import layout

hypothesis.settings.register_profile("same", derandomize=True)  # the same examples in every run
hypothesis.settings.load_profile("same")
jax.config.update("jax_enable_x64", True)
matplotlib.use("Agg")
gc.set_threshold(100_000, 50, 100)  # a sixth of the time of tracing was the search for cycles among JAX's objects

# A surface of a few hundred vertices is in 1024 rows, not in 2048: short runs take two thirds of the time. Curves of
# six meshes were the same to the last bit in both.
OWN_SMALLEST_CAPACITY, layout.SMALLEST_CAPACITY = layout.SMALLEST_CAPACITY, 1024

# What one process has compiled the others need not, nor the next run: most of the time of the tests is compiling.
CACHE = "MSF_JAX_TEST_CACHE"
LARGEST_CACHE = 2 * 10**9  # bytes, after which it begins anew


def pytest_configure(config: pytest.Config) -> None:
    """Keep what is compiled in pytest's own cache folder, or where another process of this run keeps it."""
    if CACHE not in os.environ:
        keeper = getattr(config, "cache", None)
        folder = Path(keeper.mkdir("compiled") if keeper else tempfile.mkdtemp(prefix="msf_jax-tests-"))
        if sum(path.stat().st_size for path in folder.iterdir()) > LARGEST_CACHE:
            shutil.rmtree(folder)
        os.environ[CACHE] = str(folder)
    os.environ["JAX_COMPILATION_CACHE_DIR"] = os.environ[CACHE]  # for the processes that tests start
    jax.config.update("jax_compilation_cache_dir", os.environ[CACHE])
    jax.config.update("jax_persistent_cache_min_compile_time_secs", 0.0)


# The research meshes are not part of the project; tests that want them skip where the folder is absent.
MESHES = Path(os.environ.get("MSF_JAX_MESHES", Path(__file__).parents[2] / "shared" / "meshes"))


def two_levels(capacity: int, largest_degree: int) -> layout.Layout:
    """8 slots for all rows, and 12 more, or what it takes, for an eighth of them."""
    wide = layout.Level(max(12, largest_degree - 8), capacity // 8, 8 * capacity)
    return layout.Layout(capacity, (layout.Level(8, capacity, 0), wide))


def fewer_rows():
    """A surface of a few hundred vertices is in as many rows: a replay takes time for each. A program has a part for
    each slot of each level, too: with 20 slots in two levels, the gradient of a replay compiles in three quarters of
    the time that it takes with 20 in four. An iteration's gradient with the package's own levels is in test_padding."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(layout, "SMALLEST_CAPACITY", 256)
        patch.setattr(layout, "staircase", two_levels)
        yield


few_rows = pytest.fixture(fewer_rows, scope="module")  # for all tests of a file, and runs that they share
few_rows_once = pytest.fixture(fewer_rows)  # for one test


@pytest.fixture
def ctrl_c():
    """Ctrl-C as at a terminal: a suite that is started in the background inherits a SIGINT that is ignored."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture(scope="session")
def research_mesh():
    """A function from a name to ``(vertices, faces)`` of that research mesh; skips where it is absent."""

    def load(name: str) -> tuple[np.ndarray, np.ndarray]:
        path = MESHES / f"{name}.off"
        if not path.exists():
            pytest.skip(f"no research mesh {path.name} in the folder of MSF_JAX_MESHES")
        mesh = trimesh.load(path, process=False)
        return np.array(mesh.vertices, dtype=np.float64), np.array(mesh.faces, dtype=np.int64)

    return load


@pytest.fixture
def compilations():
    """A list that gets an entry for everything that XLA compiles."""
    seen = []

    def listen(event: str, _: float, **__) -> None:
        if event == "/jax/core/compile/backend_compile_duration":
            seen.append(event)

    jax.monitoring.register_event_duration_secs_listener(listen)
    yield seen
    jax.monitoring.unregister_event_duration_listener(listen)


def torus(major: float = 1.0, minor: float = 0.35, around: int = 24, across: int = 12) -> trimesh.Trimesh:
    """A torus in the xy plane: genus 1, every vertex of degree 6."""
    u, v = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    phi, psi = 2 * np.pi * u.ravel() / around, 2 * np.pi * v.ravel() / across
    ring = major + minor * np.cos(psi)
    vertices = np.stack([ring * np.cos(phi), ring * np.sin(phi), minor * np.sin(psi)], axis=1)

    def index(i, j):
        return ((i % around) * across + j % across).ravel()

    a, b, c, d = index(u, v), index(u + 1, v), index(u + 1, v + 1), index(u, v + 1)
    faces = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    mesh = trimesh.Trimesh(vertices, faces, process=False)
    if mesh.volume < 0:
        mesh.invert()
    return mesh


def blob(seed: int, subdivisions: int = 3) -> trimesh.Trimesh:
    """A sphere with random smooth bumps: genus 0, triangles of many shapes."""
    mesh = trimesh.creation.icosphere(subdivisions)
    random = np.random.default_rng(seed)
    bumps = sum(0.25 * np.cos(mesh.vertices @ (3 * random.normal(size=3)) + random.uniform(0, 6)) for _ in range(4))
    return trimesh.Trimesh(mesh.vertices * (1 + 0.5 * bumps[:, None]), mesh.faces, process=False)
