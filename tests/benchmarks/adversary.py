"""What somebody tries whose aim is to break it: frames beyond a curve, files that were altered, files that unpack.

    python -m tests.benchmarks.adversary [frames] [files] [texts] [bombs] [--seed N] [--each N] [--files N]

Frames: bends, noise, limbs in limbs and new limbs, by seed, on shapes made in code. Which are wrong is told by how they
were made and by solid angles of all faces, which nothing of `msf_jax.track` computes: a bend is wrong if a hundredth of
the surface is in another part of the solid, or if it winds around a node otherwise than once. A wrong frame that is
not flagged is a failure, and so is more than one in twenty of the right ones that is. The thresholds were chosen on
`CHOSEN`; what counts are the `JUDGED`.
"""

import argparse
import sys
import time
from collections.abc import Callable, Iterator
from typing import NamedTuple

import jax
import numpy as np
import trimesh
from scipy import spatial
from scipy.spatial.transform import Rotation

import msf_jax
from msf_jax import Skeleton, ground_truth, shapes
from msf_jax.gradients.track import Tracker
from tests.benchmarks import tampering, texts

MOST_FLAGGED = 0.05  # of the right frames
TORN = 2.0  # times its length, that a side of a face has at most in a right bend, or the inverse
CROSSED = 0.01  # of the surface in another part of the solid: wrong, whatever made it. Less is the fold inside a bend

NEARLY = 1e-3  # diagonals: nodes this near to the surface may be on either side

SAMPLED = 600  # faces that are asked: a quarter of them or more


def capsule(height: float = 3.0) -> trimesh.Trimesh:
    """One straight limb of radius 0.3 along z."""
    path = np.linspace([0, 0, 0], [0, 0, height], 60)
    return ground_truth.swept_tube(path, np.full(60, 0.3), 16, "round")


def capsules() -> trimesh.Trimesh:
    """Two of them in one mesh, their axes 1.5 apart."""
    one = capsule(2.0)
    return trimesh.util.concatenate([one, one.copy().apply_translation([1.5, 0, 0])])


def u_tube() -> trimesh.Trimesh:
    """Two legs along z at x of -0.8 and 0.8, of radius 0.25, and a half circle between them."""
    turn, leg = np.linspace(0, np.pi, 60)[1:], np.linspace(-2, 0, 60)
    path = [[-0.8, 0, z] for z in leg] + [[-0.8 * np.cos(t), 0, 0.8 * np.sin(t)] for t in turn]
    path += [[0.8, 0, z] for z in leg[::-1][1:]]
    return ground_truth.swept_tube(np.array(path, dtype=float), np.full(len(path), 0.25), 16, "round")


CHOSEN: dict[str, Callable[[], trimesh.Trimesh]] = {
    "capsule": capsule,
    "hand": lambda: shapes.hand(0.12),
    "y_coarse": lambda: ground_truth.make("y_coarse").mesh,
}
JUDGED: dict[str, Callable[[], trimesh.Trimesh]] = {
    "s_curve": lambda: ground_truth.make("s_curve").mesh,
    "tree_coarse": lambda: ground_truth.make("tree_coarse").mesh,
    "octopus_low": lambda: ground_truth.make("octopus_low").mesh,
}


class Subject(NamedTuple):
    """A shape, its curve, and what tracks it."""

    vertices: np.ndarray
    faces: np.ndarray
    skeleton: Skeleton
    tracker: Tracker


def subject(mesh: trimesh.Trimesh) -> Subject:
    """Of a mesh, by one run."""
    skeleton = msf_jax.skeletonize(mesh)
    return Subject(np.array(mesh.vertices), np.array(mesh.faces), skeleton, Tracker(skeleton))


def limbs(skeleton: Skeleton) -> list[np.ndarray]:
    """The nodes of every branch that ends, its root first, and is long enough to be bent."""
    degree = np.bincount(skeleton.edges.ravel(), minlength=len(skeleton.vertices))
    paths = [np.asarray(path) for one in skeleton.branches for path in (one.nodes, one.nodes[::-1])]
    return [
        path for path in paths if degree[path[-1]] == 1 and _along(skeleton, path)[-1] > 5 * _radius(skeleton, path)
    ]


def _along(skeleton: Skeleton, path: np.ndarray) -> np.ndarray:
    return np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(skeleton.vertices[path], axis=0), axis=1))]


def _radius(skeleton: Skeleton, path: np.ndarray) -> float:
    return float(np.median(skeleton.radii[path]))


def bent(of: Subject, random: np.random.Generator, angle: float, width: float) -> np.ndarray:
    """One limb bent by ``angle`` degrees over a length of ``width`` radii, as a rod is: sections keep their shape."""
    skeleton, vertices = of.skeleton, of.vertices
    paths = limbs(skeleton)
    path = paths[random.integers(len(paths))]
    stop, radius = _along(skeleton, path), _radius(skeleton, path)
    thick = np.flatnonzero(skeleton.radii[path] > 1.3 * radius)  # where the path is still in the body
    low = max(1.5 * skeleton.radii[path[0]], stop[thick.max()] + radius if len(thick) else 0.0)
    start = low + max(stop[-1] - (1 + width / 2) * radius - low, 0) * random.uniform(0.1, 0.8)
    s = np.linspace(0, stop[-1], 800)
    line = np.stack([np.interp(s, stop, skeleton.vertices[path, axis]) for axis in range(3)], axis=1)
    nearest = spatial.KDTree(line).query(vertices)[1]
    share = np.clip((s - start) / (width * radius), 0, 1)
    begin = min(np.searchsorted(s, start), len(line) - 1)
    axis = np.cross(line[begin] - line[max(begin - 20, 0)], random.normal(size=3))
    turn = np.radians(angle) * axis / np.linalg.norm(axis)
    steps = Rotation.from_rotvec(share[:-1, None] * turn).apply(np.diff(line, axis=0))
    moved = np.vstack([line[:1], line[0] + np.cumsum(steps, axis=0)])
    spoke = Rotation.from_rotvec(share[nearest, None] * turn).apply(vertices - line[nearest])
    is_own = np.isin(skeleton.mesh_map, path)
    return np.where(is_own[:, None], moved[nearest] + spoke, vertices)


def _strain(of: Subject, moved: np.ndarray) -> float:
    """The largest change of the length of a side of a face, as a factor above 1."""
    before, after = (
        np.linalg.norm(each[of.faces] - np.roll(each[of.faces], 1, axis=1), axis=2) for each in (of.vertices, moved)
    )
    return float(np.maximum(after / before, before / after).max())


def noisy(vertices: np.ndarray, random: np.random.Generator, amount: float) -> np.ndarray:
    """With Gaussian noise of ``amount`` diagonals along each axis."""
    return vertices + random.normal(0, amount * np.linalg.norm(np.ptp(vertices, axis=0)), vertices.shape)


def grown(of: Subject, random: np.random.Generator, radii: float) -> np.ndarray:
    """With a limb of that many radii pulled out of the surface somewhere."""
    normal = trimesh.Trimesh(of.vertices, of.faces, process=False).vertex_normals
    top = random.integers(len(of.vertices))
    radius = max(of.skeleton.radii[of.skeleton.mesh_map[top]], 0.5 * np.median(of.skeleton.radii))
    away = np.linalg.norm(of.vertices - of.vertices[top], axis=1)
    bump = np.clip(1 - (away / (radius * random.uniform(0.5, 1.2))) ** 2, 0, 1) ** 2
    bump[normal @ normal[top] < -0.2] = 0
    bump[top] = 1
    return of.vertices + radii * radius * bump[:, None] * normal[top]


def pushed(of: Subject, random: np.random.Generator, push: float) -> np.ndarray:
    """The U-tube with each leg moved by ``push`` towards the other."""
    t = np.clip((-of.vertices[:, 2] - 0.1) / 0.8, 0, 1)
    share = t * t * (3 - 2 * t) * np.sign(of.vertices[:, 0])
    return of.vertices - share[:, None] * [push, random.uniform(-0.1, 0.1), 0]


def neared(of: Subject, random: np.random.Generator, gap: float) -> np.ndarray:
    """The capsules with their axes ``gap`` apart, the second one turned about and along its own."""
    half = len(of.vertices) // 2
    turn = Rotation.from_rotvec([random.uniform(-0.3, 0.3), 0, 0]) * Rotation.from_rotvec([0, 0, random.uniform(0, 6)])
    other = turn.apply(of.vertices[half:] - [1.5, 0, 0]) + [gap, 0, random.uniform(-0.5, 0.5)]
    return np.concatenate([of.vertices[:half], other])


def crushed(of: Subject, random: np.random.Generator) -> np.ndarray:
    """With all within two radii of a node drawn into it; a mesh inside out; vertices shuffled."""
    kind = random.integers(3)
    if kind == 0:
        return of.vertices * np.where(np.arange(3) == random.integers(3), -1.0, 1.0)
    if kind == 1:
        return random.permutation(of.vertices)
    node = random.integers(len(of.skeleton.vertices))
    middle, reach = of.skeleton.vertices[node], 2 * max(of.skeleton.radii[node], np.median(of.skeleton.radii))
    is_near = np.linalg.norm(of.vertices - middle, axis=1) < reach
    return np.where(is_near[:, None], middle + 0.01 * (of.vertices - middle), of.vertices)


def crossed(vertices: np.ndarray, faces: np.ndarray) -> float:
    """Share of the surface just inside of which the winding number is not 1, by the solid angles of all faces
    (van Oosterom and Strackee 1983)."""
    corners = vertices[faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(normal, axis=1)
    rows = np.arange(0, len(faces), max(1, len(faces) // SAMPLED))
    area, inwards = area[rows], normal[rows] / np.maximum(area[rows], 1e-300)[:, None]
    points = corners[rows].mean(axis=1) - 1e-4 * np.linalg.norm(np.ptp(vertices, axis=0)) * inwards
    return float(area[np.abs(wound(points, corners) - 1) > 0.5].sum() / area.sum())


def wound(points: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """(P,) winding number of the triangles (F, 3, 3) around each point."""
    winding = np.empty(len(points))
    for first in range(0, len(points), 64):
        rows = slice(first, first + 64)
        a, b, c = np.moveaxis(corners[None] - points[rows, None, None], 2, 0)
        la, lb, lc = (np.sqrt(np.einsum("pfi,pfi->pf", x, x)) for x in (a, b, c))
        ab, bc, ca = (np.einsum("pfi,pfi->pf", x, y) for x, y in ((a, b), (b, c), (c, a)))
        cross = np.stack([b[..., i] * c[..., j] - b[..., j] * c[..., i] for i, j in ((1, 2), (2, 0), (0, 1))], axis=-1)
        above = np.einsum("pfi,pfi->pf", a, cross)
        winding[rows] = np.arctan2(above, la * lb * lc + ab * lc + bc * la + ca * lb).sum(axis=1) / (2 * np.pi)
    return winding


def is_wrong(of: Subject, moved: np.ndarray) -> bool:
    """Whether the solid is in itself, and not only folded a little inside of a bend."""
    if crossed(moved, of.faces) > CROSSED:
        return True
    nodes = of.tracker.frame(0, moved).nodes
    there = nodes[np.isfinite(nodes).all(axis=1)]
    bad = there[np.abs(wound(there, moved[of.faces]) - 1) > 0.5]
    # A node close to the surface, such as a leaf, may be on either side. It is bad only if all points around it are.
    around = NEARLY * np.linalg.norm(np.ptp(moved, axis=0)) * np.concatenate([np.eye(3), -np.eye(3)])
    beside = wound((bad[:, None] + around).reshape(-1, 3), moved[of.faces]).reshape(-1, 6)
    return bool((np.abs(beside - 1) > 0.5).all(axis=1).any())


class Made(NamedTuple):
    """A frame: what was done, whether it is right (None: nobody can say), and where the vertices are."""

    kind: str
    is_right: bool | None
    vertices: np.ndarray


def frames(name: str, of: Subject, random: np.random.Generator, each: int) -> Iterator[Made]:
    """Right and wrong ones of a shape."""
    if name in ("capsules", "u_tube"):
        for _ in range(4 * each):
            moved = neared(of, random, random.uniform(0, 0.59)) if name == "capsules" else None
            moved = pushed(of, random, random.uniform(0.56, 0.95)) if moved is None else moved
            yield Made("in each other", False if crossed(moved, of.faces) > CROSSED else None, moved)
        for _ in range(each):
            moved = neared(of, random, random.uniform(0.75, 2)) if name == "capsules" else None
            moved = pushed(of, random, random.uniform(0.05, 0.45)) if moved is None else moved
            yield Made("near each other", True if crossed(moved, of.faces) == 0 else None, moved)
        return
    for _ in range(each):
        moved = bent(of, random, random.uniform(5, 60), random.uniform(2, 4))
        # Fingers that touch are nobody's right frame, and neither is a surface that is torn.
        is_right = True if crossed(moved, of.faces) == 0 and _strain(of, moved) < TORN else None
        yield Made("bent to 60", is_right, moved)
        yield Made("bent to 60, noise", is_right, noisy(moved, random, random.uniform(0, 1e-3)))
        yield Made("noise", True, noisy(of.vertices, random, random.uniform(0, 1e-3)))
        stretch = Rotation.random(random_state=random).as_matrix() * random.uniform(0.6, 1.6, 3)
        yield Made("stretched", True, of.vertices @ stretch.T)
        moved = bent(of, random, random.uniform(90, 180), random.uniform(0.5, 2))
        yield Made("bent from 90", False if is_wrong(of, moved) else None, moved)
        yield Made("grown", False, grown(of, random, random.uniform(2, 10)))
        yield Made("crushed", False, crushed(of, random))


def try_frames(seed: int, each: int) -> list[str]:
    """Print a table; returns what is wrong."""
    wrong, all_shapes = [], {**CHOSEN, **JUDGED, "capsules": capsules, "u_tube": u_tube}
    print("| shape | frames | right | of those flagged | wrong | of those not flagged | doubtful, flagged | ms |")
    print("| --- " * 8 + "|")
    total = np.zeros(6, dtype=int)
    for number, (name, make) in enumerate(all_shapes.items()):
        of, random, counts, seconds = subject(make()), np.random.default_rng([seed, number]), np.zeros(6, int), 0.0
        for made in frames(name, of, random, each):
            start = time.perf_counter()
            frame = of.tracker.frame(0, made.vertices)
            seconds += time.perf_counter() - start
            column = {True: 0, False: 2, None: 4}[made.is_right]
            is_counted = frame.wants_run if made.is_right is not False else not frame.wants_run
            counts[[column, column + 1]] += [1, is_counted]
            if is_counted and made.is_right is not None:
                print(f"{name}, {made.kind}, {'right' if made.is_right else 'WRONG'}: {frame}", file=sys.stderr)
        right, flagged, bad, missed, doubtful, doubted = counts
        print(
            f"| {name} | {right + bad + doubtful} | {right} | {flagged} | {bad} | {missed} | {doubtful}, {doubted} "
            f"| {1e3 * seconds / (right + bad + doubtful):.0f} |",
            flush=True,
        )
        if name not in CHOSEN:
            total += counts
    print(f"judged: {total[1]} of {total[0]} right frames flagged, {total[3]} of {total[2]} wrong ones not")
    if total[3]:
        wrong.append(f"{total[3]} wrong frames were not flagged")
    if total[1] > MOST_FLAGGED * total[0]:
        wrong.append(f"{total[1]} of {total[0]} right frames were flagged")
    return wrong


def main() -> int:
    """Run what is named, or all."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("what", nargs="*", choices=["frames", "files", "texts", "bombs", []], help="all if not given")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--each", type=int, default=20, help="frames of a kind and a shape")
    parser.add_argument("--files", type=int, default=500, help="altered files")
    arguments = parser.parse_args()
    jax.config.update("jax_enable_x64", True)
    parts: dict[str, Callable[[], list[str]]] = {
        "frames": lambda: try_frames(arguments.seed, arguments.each),
        "files": lambda: tampering.try_files(arguments.seed, arguments.files),
        "texts": lambda: texts.try_texts(arguments.seed, arguments.files),
        "bombs": tampering.try_bombs,
    }
    wrong = [line for name, part in parts.items() if not arguments.what or name in arguments.what for line in part()]
    print("\n".join(wrong) or "nothing got through")
    return min(len(wrong), 1)


if __name__ == "__main__":
    sys.exit(main())
