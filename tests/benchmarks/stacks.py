"""Value and gradient of `follow` for many meshes: compilations, seconds, bits, slopes; files.

usage: python -m tests.benchmarks.stacks [--meshes 64] [--closed 4] [--keep FOLDER]

Meshes of 500 to 12,000 vertices, made in code. Five variants: a function jitted for each skeleton (``--closed`` of
them, scaled up to all), one that is jitted over bindings, a batch for each capacity, by ``vmap`` and by ``lax.map``,
and one batch for all. Seconds of CPU stand beside seconds of the clock, which other work on the machine delays.
``--keep`` holds the curves for the next run. Equinox and Orbax take part if they are installed.
"""

import argparse
import pickle
import tempfile
import time
from collections import defaultdict
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np

import msf_jax
from msf_jax import shapes
from msf_jax.base.binding import padded, unpadded

jax.config.update("jax_enable_x64", True)
STEPS = 5  # that are timed; the middle one counts
SLOPE_STEP = 1e-6  # of central differences, in the units of the meshes, whose limbs are 2 long


def star(seed: int, num: int) -> msf_jax.Skeleton:
    """The curve of three to five limbs of random directions, in a mesh of about ``num`` vertices."""
    random = np.random.default_rng(seed)
    directions = random.normal(size=(int(random.integers(3, 6)), 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    points = np.concatenate([np.zeros((1, 3)), directions * random.uniform(1.5, 3.0, (len(directions), 1))])
    edges = np.stack([np.zeros(len(directions), dtype=int), np.arange(1, len(points))], axis=1)
    radii = random.uniform(0.25, 0.4, len(points))
    spacing = 0.12
    for _ in range(2):
        mesh = shapes.solid_around(points, edges, radii, spacing)
        spacing *= np.sqrt(len(mesh.vertices) / num)
    return msf_jax.skeletonize(mesh)


def value(binding, vertices):
    nodes, radii = msf_jax.follow(binding, vertices)
    return (nodes**2).sum() + (radii**2).sum()


one = jax.jit(jax.value_and_grad(value, argnums=1))
every = jax.jit(jax.vmap(jax.value_and_grad(value, argnums=1)))
in_turn = jax.jit(lambda *batch: jax.lax.map(lambda pair: jax.value_and_grad(value, argnums=1)(*pair), batch))


def clocks() -> np.ndarray:
    return np.array([time.perf_counter(), time.process_time()])


def report(name: str, step, compilations: list) -> None:
    """Seconds of the first call and of a later one, by the clock and of CPU, and what was compiled."""
    compilations.clear()
    start = clocks()
    jax.block_until_ready(step())
    first, seconds = clocks() - start, []
    count = len(compilations)
    for _ in range(STEPS):
        start = clocks()
        jax.block_until_ready(step())
        seconds.append(clocks() - start)
    wall, cpu = np.median(seconds, axis=0)
    print(f"| {name} | {count} | {first[0]:.1f} | {first[1]:.1f} | {wall:.3f} | {cpu:.3f} |", flush=True)


def show_variants(skeletons: list, closed: int, compilations: list) -> None:
    bindings = [jax.device_put(skeleton.binding) for skeleton in skeletons]
    rows = [jnp.asarray(msf_jax.stack([skeleton]).vertices[0]) for skeleton in skeletons]
    counts = [len(skeleton.mesh_map) for skeleton in skeletons]
    print(f"{len(skeletons)} meshes of {min(counts)} to {max(counts)} vertices, {jax.devices()[0].platform}")
    print(
        "| run | compilations | first, s | of CPU | a step for all, s | of CPU |\n| --- | --- | --- | --- | --- | --- |"
    )
    chosen = range(0, len(skeletons), max(1, len(skeletons) // max(1, closed)))[:closed]
    alone = [jax.jit(jax.value_and_grad(lambda v, k=k: value(skeletons[k], v))) for k in chosen]
    own = [rows[k][: counts[k]] for k in chosen]
    if alone:
        report(f"jitted for each skeleton, {len(alone)} of them",
               lambda: [f(v) for f, v in zip(alone, own, strict=True)], compilations)  # fmt: skip
    report("jitted over bindings", lambda: [one(b, v) for b, v in zip(bindings, rows, strict=True)], compilations)
    alike = defaultdict(list)
    for skeleton in skeletons:
        alike[skeleton.binding.capacity].append(skeleton)
    batches = [msf_jax.stack(some) for some in alike.values()]
    for name, way in (("vmap", every), ("lax.map", in_turn)):
        report(f"{len(batches)} batches, {name}",
               lambda way=way: [way(some.bindings, some.vertices) for some in batches], compilations)  # fmt: skip
    whole = msf_jax.stack(skeletons)
    report("one batch", lambda: every(whole.bindings, whole.vertices), compilations)


def show_bits(skeletons: list) -> None:
    """Numbers of the live parts that are not the same bits: moved, alone, with twice the capacity, and in one batch."""
    batch = msf_jax.stack(skeletons)
    moved = batch.vertices + 0.03 * jnp.sin(3 * batch.vertices[..., jnp.array([1, 2, 0])])
    many = [*jax.vmap(msf_jax.follow)(batch.bindings, moved), every(batch.bindings, moved)[1]]
    total, unlike = 0, {"in a batch": 0, "with twice the capacity": 0}
    for k, skeleton in enumerate(skeletons):
        binding, live = skeleton.binding, unpadded(skeleton.binding).live
        twice = live._replace(**{name: 2 * capacity for name, capacity in binding.capacity._asdict().items()})
        count = live.nodes, live.nodes, live.vertices

        def found(binding, k=k, live=live):
            rows = np.zeros((binding.num_vertices, 3))
            rows[: live.vertices] = moved[k, : live.vertices]
            return [*jax.jit(msf_jax.follow)(binding, rows), one(binding, rows)[1]]

        alone = [np.asarray(part)[:num] for part, num in zip(found(binding), count, strict=True)]
        others = {"in a batch": [part[k] for part in many]}
        others["with twice the capacity"] = found(padded(unpadded(binding), twice))
        total += sum(part.size for part in alone)
        for name, parts in others.items():
            unlike[name] += sum(
                int((np.asarray(part)[:num] != own).sum()) for part, own, num in zip(parts, alone, count, strict=True)
            )
    for name, count in unlike.items():
        print(f"Numbers that are not those of the curve alone, {name}: {count} of {total}", flush=True)


def show_slopes(skeletons: list) -> None:
    """Slopes of a batch along random directions, beside central differences: the largest relative error."""
    batch = msf_jax.stack(skeletons)
    at = batch.vertices + 0.03 * jnp.sin(3 * batch.vertices[..., jnp.array([1, 2, 0])])
    direction = jnp.asarray(np.random.default_rng(5).normal(size=at.shape))
    direction = direction / jnp.sqrt((direction**2).sum(axis=(1, 2), keepdims=True))

    def total(bindings, vertices):
        return jax.vmap(value)(bindings, vertices).sum()

    @jax.jit  # with bindings for an argument: XLA takes a minute to fold them as constants
    def twice(bindings, at):
        return jax.jvp(lambda at: jax.grad(total, argnums=1)(bindings, at), (at,), (direction,))

    slopes = every(batch.bindings, at)[1]
    (ahead, slope_ahead), (behind, slope_behind) = (
        every(batch.bindings, at + sign * SLOPE_STEP * direction) for sign in (1, -1)
    )
    off = (ahead - behind) / (2 * SLOPE_STEP) - (slopes * direction).sum(axis=(1, 2))
    size = jnp.sqrt((slopes**2).sum(axis=(1, 2)) / at[0].size)
    print(f"Slopes off central differences, over what a random direction has: {float(jnp.abs(off / size).max()):.1e}")
    first, second = twice(batch.bindings, at)
    off = jnp.abs(first - slopes).max()
    print(f"grad of vmap off vmap of grad: {float(off):.1e} of {float(jnp.abs(slopes).max()):.1e}")
    expected = (slope_ahead - slope_behind) / (2 * SLOPE_STEP)
    off = jnp.sqrt(((second - expected) ** 2).sum(axis=(1, 2)) / (expected**2).sum(axis=(1, 2)))
    print(f"Second derivatives off differences of slopes: {float(jnp.median(off)):.1e}, at most {float(off.max()):.1e}")


def show_files(skeleton: msf_jax.Skeleton) -> None:
    """A skeleton, its binding and a batch, through what JAX's users pass trees through."""

    def by_equinox(tree, folder):
        import equinox

        equinox.tree_serialise_leaves(folder / "tree.eqx", tree)
        return equinox.tree_deserialise_leaves(folder / "tree.eqx", jax.tree.map(np.zeros_like, tree))

    def by_orbax(tree, folder):
        from orbax import checkpoint

        keeper = checkpoint.StandardCheckpointer()
        keeper.save(folder / "orbax", tree)
        keeper.wait_until_finished()
        return keeper.restore(folder / "orbax", jax.tree.map(np.zeros_like, tree))

    variants = {
        "jit": lambda tree, _: jax.jit(lambda same: same)(tree),
        "tree.map": lambda tree, _: jax.tree.map(jnp.asarray, tree),
        "pickle": lambda tree, _: pickle.loads(pickle.dumps(tree)),
        "Equinox": by_equinox,
        "Orbax": by_orbax,
    }
    for name, round_trip in variants.items():
        for tree in (skeleton, skeleton.binding, msf_jax.stack([skeleton])):
            with tempfile.TemporaryDirectory() as folder:
                try:
                    back = round_trip(tree, Path(folder))
                except ImportError as error:
                    print(f"{name}: {error}")
                    break
            leaves = zip(jax.tree.leaves(tree), jax.tree.leaves(back), strict=True)
            is_same = all(np.array_equal(a, b) and a.dtype == b.dtype for a, b in leaves)
            print(f"{type(tree).__name__} through {name}: {'the same' if is_same else 'CHANGED'}", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--meshes", type=int, default=64)
    parser.add_argument("--closed", type=int, default=4)
    parser.add_argument("--keep", type=Path)
    options = parser.parse_args()
    compilations: list[str] = []
    jax.monitoring.register_event_duration_secs_listener(
        lambda event, _, **__: compilations.append(event) if event.endswith("backend_compile_duration") else None
    )
    skeletons = []
    for seed, num in enumerate(np.geomspace(500, 12_000, options.meshes).astype(int)):
        path = options.keep and options.keep / f"{seed}-{num}.pkl"
        if path and path.exists():
            skeletons.append(pickle.loads(path.read_bytes()))
            continue
        skeletons.append(star(seed, int(num)))
        if path:
            path.write_bytes(pickle.dumps(skeletons[-1]))
    show_variants(skeletons, options.closed, compilations)
    show_bits(skeletons[:: max(1, len(skeletons) // 16)])
    show_slopes(skeletons[:: max(1, len(skeletons) // 8)])
    show_files(skeletons[0])


if __name__ == "__main__":
    main()
