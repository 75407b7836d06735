"""What an accelerator would run: bytes moved, steps and seconds of one `move`, of `follow` and of a batch.

``python -m tests.benchmarks.device`` measures all of it on the first device that JAX has, a CPU where it has no other,
for a tube of ``--rows`` vertices. Bytes are counted from shapes, with each array once for each use, so that GB/s is a
lower bound of what the memory delivers. ``--float32`` leaves float64 off.
"""

import argparse
import time
from collections.abc import Callable
from typing import Any

import jax
import numpy as np

import msf_jax
from msf_jax import Config, PreprocessingOptions, Weights, ground_truth
from msf_jax.base.clock import Clock
from msf_jax.base.layout import Layout
from msf_jax.flow import programs, starting, stepping
from msf_jax.meshes import checking

TIMES = 3  # calls that are timed; the fastest counts
MEMBERS = 4  # of a batch


def tube(rows: int) -> Any:
    """A bent tube of about ``rows`` vertices of nearly equilateral triangles."""
    turn = np.linspace(0, 3.6, 401)
    points = np.stack([0.8 * np.cos(turn), 0.8 * np.sin(turn), 0 * turn], axis=1)
    sides = round((rows / 4.4) ** 0.5)  # rings are 2 pi / sides * 0.87 radii apart, on a length of 24
    return ground_truth.swept_tube(points, np.full(401, 0.12), sides)


def bytes_of_step(layout: Layout, real: int) -> int:
    """Of a CG step on (n, 3): two products with L, each over all slots, and the vector operations."""
    product = layout.num_slots * (real + 4 + 3 * real) + layout.capacity * 7 * real
    return 2 * product + layout.capacity * (3 * 14 + 1) * real


def fastest(function: Callable[[], Any]) -> tuple[float, float]:
    """Seconds of the first call, which compiles, and of the fastest later one."""
    seconds = []
    for _ in range(TIMES + 1):
        begin = time.perf_counter()
        jax.block_until_ready(function())
        seconds.append(time.perf_counter() - begin)
    return seconds[0], min(seconds[1:])


def show(what: str, steps: str, moved: float, function: Callable[[], Any], compiling: float = 0.0) -> None:
    first, later = fastest(function)
    first += compiling
    print(
        f"| {what} | {steps} | {moved / 1e6:,.0f} | {first:.1f} | {later:.3f} | {moved / later / 1e9:.1f} |", flush=True
    )


def show_move(mesh: Any, config: Config, name: str, real: int) -> None:
    """One iteration: assembly, contraction, smoothing."""
    state = starting.init(checking.prepare(mesh).components[0], 0, config, Clock())
    packed = stepping._pack(state, Weights(), Clock())
    begin = time.perf_counter()
    program = programs.compiled_move(config.on_device, packed.layout, False)
    compiling = time.perf_counter() - begin
    weights = jax.tree.map(lambda weight: np.asarray(weight, packed.buffers.positions.dtype), packed.weights)
    buffers = jax.device_put((packed.buffers, weights))
    steps = int(program(*buffers).solves.steps.sum())
    real = 4 if config.solver.tolerance >= 1e-3 else real  # loose solves run in float32
    what = f"`move`, {name}, {packed.layout.capacity:,} rows, {packed.layout.num_slots:,} slots"
    moved = steps * bytes_of_step(packed.layout, real)
    show(what, f"{steps:,} of CG", moved, lambda: program(*buffers).positions, compiling)


def show_follow(mesh: Any) -> None:
    """The finished curve in the moved mesh, its gradient, and a batch."""
    skeleton = msf_jax.skeletonize(mesh)
    batch = jax.device_put(msf_jax.stack([skeleton] * MEMBERS))
    one = jax.tree.map(lambda values: values[0], batch)
    moved = sum(np.asarray(values).nbytes for values in jax.tree.leaves((one.bindings, one.vertices)))

    def value(binding: Any, vertices: Any) -> Any:
        nodes, radii = msf_jax.follow(binding, vertices)
        return (nodes**2).sum() + (radii**2).sum()

    follow, slope = jax.jit(msf_jax.follow), jax.jit(jax.grad(value, argnums=1))
    every = jax.jit(jax.vmap(msf_jax.follow))
    what = f"{one.vertices.shape[0]:,} rows of vertices, {one.node_mask.shape[0]:,} of nodes"
    show(f"`follow`, {what}", "pairs in blocks", moved, lambda: follow(one.bindings, one.vertices))
    show("its gradient", "the same", 2 * moved, lambda: slope(one.bindings, one.vertices))
    show(f"`vmap` of {MEMBERS}", "the most of any", MEMBERS * moved, lambda: every(batch.bindings, batch.vertices))
    stacked = fastest(lambda: msf_jax.stack([skeleton] * MEMBERS).vertices)[1]
    print(f"| `stack` of {MEMBERS}, on the host | - | {MEMBERS * moved / 1e6:,.0f} | - | {stacked:.3f} | - |")


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rows", type=int, default=100_000, help="vertices of the tube")
    parser.add_argument("--float32", action="store_true", help="JAX's default type")
    arguments = parser.parse_args()
    jax.config.update("jax_enable_x64", not arguments.float32)
    mesh, real = tube(arguments.rows), 4 if arguments.float32 else 8
    device = jax.devices()[0]
    print(f"{device.platform} ({device.device_kind}), jax {jax.__version__}, {len(mesh.vertices):,} vertices\n")
    print("| what | steps | MB moved | first call, s | later, s | GB/s |\n| --- | --- | ---: | ---: | ---: | ---: |")
    whole = Config(coarsen=0.0, preprocessing=PreprocessingOptions(refine=0.0))
    show_move(mesh, whole, "default solves", real)
    show_move(mesh, whole.tight(), "tight solves", real)
    show_follow(mesh)
    memory = device.memory_stats() or {}
    if "peak_bytes_in_use" in memory:
        print(f"\npeak memory of the device: {memory['peak_bytes_in_use'] / 1e9:.2f} GB")


if __name__ == "__main__":
    main()
