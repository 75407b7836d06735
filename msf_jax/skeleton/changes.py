"""Other curves of the same mesh: pruned, with other nodes, smoothed, or with radii of another kind."""

import numbers
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from scipy import spatial

from msf_jax import metrics
from msf_jax.base.errors import ConfigError
from msf_jax.curve import finishing, resampling
from msf_jax.inside import containment
from msf_jax.limbs import one_branch, pruning
from msf_jax.limbs.caps import Caps
from msf_jax.skeleton import centrelines
from msf_jax.skeleton.report import assessed
from msf_jax.skeleton.source import known
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

NEAREST = 16  # nearest old nodes whose balls bound the radius of a new node, if the solid is not known
TRIED = 0.1  # share of the tolerance of `simplified`, within which nodes are tried
MOST_NODES = 10_000_000  # most nodes of a resampled curve; a spacing that gives more is in a wrong unit


def changed(skeleton: "Skeleton", vertices: np.ndarray, edges: np.ndarray, node_of_old: np.ndarray) -> "Skeleton":
    """A skeleton of the same mesh with another curve, and an updated report.

    ``node_of_old`` (N,) is the new node for each node of ``skeleton``.
    """
    edges = finishing.in_order(edges)
    components, cycles = graphs.cycle_count(len(vertices), edges)
    report = replace(skeleton.report, components=components, cycles=cycles, loops=None, figures={})
    if skeleton.source is not None:
        solid = skeleton.source.solid
        radii = solid.radii(vertices)
        of_input, vertex = node_of_old[skeleton.mesh_map], skeleton.source.input_of_vertex
        followed = None if vertex is None else of_input[vertex]
        report = replace(report, **assessed(solid.shape, solid.enter(vertices), edges, followed, report.wavefronts > 0))
        report = replace(report, inside=inside_of(skeleton, vertices, edges, radii))
    else:  # radius of the largest ball inside one of the old balls
        found = spatial.KDTree(skeleton.vertices).query(vertices, k=min(NEAREST, len(skeleton.radii)))
        away, near = (np.reshape(each, (len(vertices), -1)) for each in found)
        radii = np.maximum((skeleton.radii[near] - away).max(axis=1), 0.0)
    roots, openings = (tuple(node_of_old[list(nodes)].tolist()) for nodes in (skeleton.roots, skeleton.openings))
    of = skeleton.radius_of
    parts = {"vertices": vertices, "edges": edges, "radii": radii, "mesh_map": node_of_old[skeleton.mesh_map]}
    found = replace(skeleton, **parts, report=report, roots=roots, openings=openings, radius_of="ball")
    return found if of == "ball" or skeleton.source is None else with_radii(found, of)


def inside_of(skeleton: "Skeleton", vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray) -> float:
    """The fraction of a curve's length inside the skeleton's mesh; the report's if the mesh is not known."""
    if skeleton.source is None:
        return skeleton.report.inside
    solid = skeleton.source.solid
    return metrics.inside_fraction(solid.shape, solid.enter(vertices), edges, radii / solid.diagonal)


def pruned(skeleton: "Skeleton", slenderness: float, detail: float | None, is_held: np.ndarray) -> "Skeleton":
    """See `Skeleton.prune`."""
    if not (isinstance(slenderness, numbers.Real) and float(slenderness) >= 0):
        raise ConfigError(f"slenderness is {slenderness!r}: expected a number of 0 or more")
    if not (detail is None or (isinstance(detail, numbers.Real) and 0 <= float(detail) <= 1)):
        raise ConfigError(f"detail is {detail!r}: expected a number from 0 to 1")
    x, edges, least = skeleton.vertices, skeleton.edges, float(slenderness)
    report, grown = skeleton.report, 0
    if skeleton.source is not None and not report.wavefronts and least:
        solid = skeleton.source.solid
        caps = Caps(solid.outside) if detail is None else Caps(solid.outside, float(detail))
        choice = one_branch.choose(caps, solid.shape, solid.enter(x), edges, is_held, least)
        if detail is not None and (grown := choice.leaf.count(-1)):
            new, edges = one_branch.grown(solid.shape, solid.enter(x), edges, choice)
            new, edges = containment.contain(solid.shape, new, edges, np.pad(is_held, (0, len(new) - len(x))))
            x = np.concatenate([x, solid.leave(new[len(x) :])])
        added = 0, len(x) - len(is_held)
        worth = np.pad(choice.worth, added, constant_values=np.inf)
        stays, target = one_branch.kept(x, edges, worth, np.pad(is_held, added))
        note = "the search for limbs ended early; branches that it did not try are kept"
        report = replace(report, notes=report.notes + (note,) * choice.was_hit)
    elif detail is None:
        stays, target = pruning.prune(len(x), edges, pruning.by_balls(x, skeleton.radii), least, is_held)
    else:
        raise ConfigError(
            f"detail is {detail!r}, and limbs are not known: expected a skeleton with its mesh, not made by "
            "wavefronts, and a slenderness above 0; leave detail out"
        )
    rank = np.cumsum(stays) - 1
    found = changed(skeleton, x[stays], rank[edges[stays[edges].all(axis=1)]], rank[target][: len(is_held)])
    gone = skeleton.num_leaves + grown - found.num_leaves
    counts = {"pruned": report.pruned + gone, "grown": report.grown + grown, "notes": report.notes}
    return replace(found, report=replace(found.report, **counts))


def resampled(skeleton: "Skeleton", spacing: float, is_held: np.ndarray) -> "Skeleton":
    """See `Skeleton.resample`."""
    if not (isinstance(spacing, numbers.Real) and 0 < spacing < np.inf):
        raise ConfigError(f"spacing is {spacing!r}: expected a length above 0")
    if skeleton.length > MOST_NODES * float(spacing):
        raise ConfigError(
            f"spacing is {spacing!r}, and the curve {skeleton.length:.3g} long: expected a spacing that gives at most "
            f"{MOST_NODES} nodes; is it in the mesh's units?"
        )
    solid = None if skeleton.source is None else skeleton.source.solid
    found = resampling.resample(skeleton.vertices, skeleton.edges, spacing, is_held, solid)
    return changed(skeleton, *found)


def smoothed(skeleton: "Skeleton", rounds: int, is_held: np.ndarray) -> "Skeleton":
    """See `Skeleton.smooth`."""
    if isinstance(rounds, bool) or not isinstance(rounds, numbers.Integral) or rounds < 0:
        raise ConfigError(f"rounds is {rounds!r}: expected a whole number of 0 or more")
    solid = None if skeleton.source is None else skeleton.source.solid
    x, edges = resampling.smooth(skeleton.vertices, skeleton.edges, skeleton.radii, int(rounds), is_held, solid)
    return changed(skeleton, x, edges, np.arange(len(x)))


def with_radii(skeleton: "Skeleton", of: str) -> "Skeleton":
    """See `Skeleton.with_radii`."""
    if of not in ("ball", "section"):
        raise ConfigError(f'of is {of!r}: expected "ball" or "section"')
    source = known(skeleton.source)
    balls = replace(skeleton, radii=source.solid.radii(skeleton.vertices), radius_of="ball")
    if of == "ball":
        return balls
    area = centrelines.node_columns(balls)["area"]
    radii = np.where(np.isfinite(area), np.sqrt(np.maximum(area, 0.0) / np.pi), balls.radii)
    return replace(balls, radii=radii, radius_of=of)


def simplified(skeleton: "Skeleton", tolerance: float, is_held: np.ndarray) -> "Skeleton":
    """See `Skeleton.simplify`."""
    if not (isinstance(tolerance, numbers.Real) and not isinstance(tolerance, bool) and 0 < float(tolerance) < np.inf):
        raise ConfigError(f"tolerance is {tolerance!r}: expected a length above 0")
    num = len(skeleton.vertices)
    stays = is_held | (np.bincount(skeleton.edges.ravel(), minlength=num) != 2)
    stays[list(skeleton.roots) + list(skeleton.openings)] = True
    chains, node_of_old = [], np.arange(num)
    for path in graphs.trace(num, skeleton.edges):
        nodes = np.array(path)
        is_kept = stays[nodes]
        is_kept[[0, -1]] = True
        if nodes[0] == nodes[-1] and is_kept[1:-1].sum() < 2:  # a loop needs three nodes
            is_kept[[len(nodes) // 3, 2 * len(nodes) // 3]] = True
        kept = np.flatnonzero(is_kept)
        is_kept |= _needed(skeleton.vertices[nodes], kept, float(tolerance))
        kept = np.flatnonzero(is_kept)
        chains.append(nodes[kept])
        stays[nodes[kept]] = True
        node_of_old[nodes[1:-1]] = nodes[kept[resampling.nearest_of(kept, np.arange(1, len(nodes) - 1))]]
    rank = np.cumsum(stays) - 1
    ends = [np.stack([chain[:-1], chain[1:]], axis=1) for chain in chains if len(chain) > 1]
    edges = rank[np.concatenate([np.empty((0, 2), dtype=np.int64), *ends])]
    return changed(skeleton, skeleton.vertices[stays], edges, rank[node_of_old])


def _needed(points: np.ndarray, kept: np.ndarray, tolerance: float) -> np.ndarray:
    """(n,) which of ``points`` (n, 3) are kept between those of ``kept``: the fewest such that none is farther than
    ``tolerance`` from the line of those, and of as few the ones nearest to it (Imai and Iri 1988).

    Tried are the points that Douglas and Peucker (1973) keep within a tenth of it.
    """
    found = np.zeros(len(points), dtype=bool)
    for first, last in pairwise(kept.tolist()):
        places = [first, *_far(points, first, last, TRIED * tolerance), last]
        cost: list[tuple[int, float, int]] = [
            (0, 0.0, 0)
        ]  # number of lines to a place, their distances, the one before
        for k in range(1, len(places)):
            tried = []
            for j in range(k):
                away = _away(points[places[j] : places[k] + 1]).max()
                if away <= tolerance or j == k - 1:
                    tried.append((cost[j][0] + 1, cost[j][1] + float(away), j))
            cost.append(min(tried))
        k = cost[-1][2]
        while k > 0:
            found[places[k]] = True
            k = cost[k][2]
    return found


def _far(points: np.ndarray, first: int, last: int, tolerance: float) -> list[int]:
    """The points between two that are farthest from the line, until none is farther than ``tolerance``."""
    found, stack = [], [(first, last)]
    while stack:
        a, b = stack.pop()
        away = _away(points[a : b + 1])
        if away.max() > tolerance:
            middle = a + int(away.argmax())
            found.append(middle)
            stack += [(a, middle), (middle, b)]
    return sorted(found)


def _away(points: np.ndarray) -> np.ndarray:
    """(n,) the distance of ``points`` (n, 3) from the segment between the first and the last."""
    along, offset = points[-1] - points[0], points - points[0]
    t = np.clip(offset @ along / max(float(along @ along), 1e-300), 0.0, 1.0)
    return np.linalg.norm(offset - t[:, None] * along, axis=1)
