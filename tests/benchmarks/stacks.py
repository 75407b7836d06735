"""Value and gradient of `follow` for many meshes: compilations, the first time, and a step; alone and in batches.

usage: python -m tests.benchmarks.stacks [--meshes 64] [--closed 4]

Meshes of 500 to 12,000 vertices, made in code. Four ways: a function that is jitted for each skeleton (``--closed`` of
them, times so many as there are), one that is jitted over bindings, a batch for each number of vertices that there is
room for, and one batch for all.
"""

import argparse
import time
from collections import defaultdict

import jax
import jax.numpy as jnp
import numpy as np

import msf_jax
from msf_jax import shapes

jax.config.update("jax_enable_x64", True)
STEPS = 5  # that are timed; the middle one counts


def star(seed: int, num: int) -> msf_jax.Skeleton:
    """The curve of three to five limbs of random directions, in a mesh of about ``num`` vertices."""
    random = np.random.default_rng(seed)
    ways = random.normal(size=(int(random.integers(3, 6)), 3))
    ways /= np.linalg.norm(ways, axis=1)[:, None]
    points = np.concatenate([np.zeros((1, 3)), ways * random.uniform(1.5, 3.0, (len(ways), 1))])
    edges = np.stack([np.zeros(len(ways), dtype=int), np.arange(1, len(points))], axis=1)
    radii = random.uniform(0.25, 0.4, len(points))
    spacing = 0.12
    for _ in range(4):
        mesh = shapes.solid_around(points, edges, radii, spacing)
        spacing *= np.sqrt(len(mesh.vertices) / num)
    return msf_jax.skeletonize(mesh)


def value(binding, vertices):
    nodes, radii = msf_jax.follow(binding, vertices)
    return (nodes**2).sum() + (radii**2).sum()


def report(name: str, step, compilations: list) -> None:
    """Seconds of the first call and of a later one, and what was compiled."""
    compilations.clear()
    start = time.perf_counter()
    jax.block_until_ready(step())
    first, seconds = time.perf_counter() - start, []
    count = len(compilations)
    for _ in range(STEPS):
        start = time.perf_counter()
        jax.block_until_ready(step())
        seconds.append(time.perf_counter() - start)
    print(f"| {name} | {count} | {first:.1f} | {np.median(seconds):.3f} |", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--meshes", type=int, default=64)
    parser.add_argument("--closed", type=int, default=4)
    options = parser.parse_args()
    compilations: list[str] = []
    jax.monitoring.register_event_duration_secs_listener(
        lambda event, _, **__: compilations.append(event) if event.endswith("backend_compile_duration") else None
    )
    sizes = np.geomspace(500, 12_000, options.meshes).astype(int)
    skeletons = [star(seed, int(num)) for seed, num in enumerate(sizes)]
    bindings = [jax.device_put(skeleton.binding) for skeleton in skeletons]
    rows = [jnp.asarray(msf_jax.stack([skeleton]).vertices[0]) for skeleton in skeletons]
    counts = [len(skeleton.mesh_map) for skeleton in skeletons]
    print(f"{len(skeletons)} meshes of {min(counts)} to {max(counts)} vertices, {jax.devices()[0].platform}")
    print("| way | compilations | first, s | a step for all, s |\n| --- | --- | --- | --- |")

    chosen = range(0, len(skeletons), max(1, len(skeletons) // max(1, options.closed)))
    closed = [jax.jit(jax.value_and_grad(lambda v, k=k: value(skeletons[k], v))) for k in chosen]
    own = [rows[k][: counts[k]] for k in chosen]
    report(f"jitted for each skeleton, {len(closed)} of them", lambda: [f(v) for f, v in zip(closed, own, strict=True)],
           compilations)  # fmt: skip
    one = jax.jit(jax.value_and_grad(value, argnums=1))
    report("jitted over bindings", lambda: [one(b, v) for b, v in zip(bindings, rows, strict=True)], compilations)
    every = jax.jit(jax.vmap(jax.value_and_grad(value, argnums=1)))
    alike = defaultdict(list)
    for skeleton in skeletons:
        alike[skeleton.binding.capacity.vertices].append(skeleton)
    batches = [msf_jax.stack(some) for some in alike.values()]
    report(
        f"{len(batches)} batches", lambda: [every(batch.bindings, batch.vertices) for batch in batches], compilations
    )
    whole = msf_jax.stack(skeletons)
    report("one batch", lambda: every(whole.bindings, whole.vertices), compilations)


if __name__ == "__main__":
    main()
