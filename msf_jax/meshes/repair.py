"""Repair on request: from any list of triangles to closed, oriented, manifold surfaces, with every change counted.

The steps are: place vertices that are not finite between their neighbours; weld coincident vertices at open edges;
remove degenerate and duplicate faces, and internal walls; orient faces consistently; separate sheets that share an edge
or a vertex; fill holes without new vertices; remove pieces without volume.

Each vertex of the result is one of the caller's, so that weights, pins and gradients apply to it. Exceptions are the
vertices of an extruded rim, where a lid would cut through the surface (see `rim_extrusion`).
"""

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.base.options import Options, number
from msf_jax.meshes.filling import filled
from msf_jax.meshes.rim_extrusion import extruded
from msf_jax.meshes.sheets import cut_apart, is_double, is_wall, left_alone, oriented, twins
from msf_jax.solid.geometry import signed_volume
from msf_jax.topology import graphs
from msf_jax.topology.half_edges import by_label, edge_codes

FEWEST_VERTICES = 5  # vertices of a piece, at least, to have a skeleton
FEWEST_TO_JOIN = 4  # vertices of a piece, at least, to be joined to another
LARGEST_WELD = 0.01  # median edges: the largest radius of a weld; more would collapse triangles
MOST_NEIGHBOURS = 50  # vertices at rims within the radius of a weld, on average, at most
LONGEST_GAP = 0.005  # diagonals: the longest gap that "join" bridges
NO_VOLUME = 1e-9  # volume over the cube of the largest extent: below it, a piece encloses no volume


@dataclass(frozen=True)
class Repair(Options):
    """Limits of the repair in `skeletonize`. Lengths are fractions of the bounding box's diagonal.

    Attributes:
        weld: vertices at the rim of a hole within this distance are welded; at most a hundredth of the median edge.
        largest_hole: holes whose rim fits into a box of this diagonal are filled; 0 fills none, 1 all.
        smallest_part: pieces whose box has a smaller diagonal are dropped; 0 keeps all that enclose a volume.
        join: closed parts become one solid if they overlap, or if their gap is at most this length, or at most the
            radius of the smaller solid (of the ball with its ratio of volume to area). 0 joins parts that overlap or
            touch, None joins none. ``repair="join"`` means 0.005.
        most_parts: the number of pieces that are kept, the largest, because each needs a run; it does not apply to
            joined pieces. The vertices of dropped pieces go to the nearest node.

    Raises:
        ConfigError: ``most_parts`` is no whole number above 0, or another value is no number from 0 to 1.
    """

    weld: float = number(1e-6, 0, 1)
    largest_hole: float = number(1.0, 0, 1)
    smallest_part: float = number(0.0, 0, 1)
    join: float | None = number(None, 0, 1)
    most_parts: int = number(128, 1, np.inf)


def as_repair(repair: Any) -> Repair | None:
    """The `Repair` that ``repair`` means: for True the defaults, for "join" with joining, for False None.

    Raises:
        ConfigError: ``repair`` is something else, and no `Repair`.
    """
    if isinstance(repair, Repair):
        return repair
    if isinstance(repair, str) and repair == "join":
        return Repair(join=LONGEST_GAP)
    if not isinstance(repair, bool):
        raise ConfigError(f'repair is {repair!r:.80}: expected True, False, "join" or a msf_jax.Repair')
    return Repair() if repair else None


class Repaired(NamedTuple):
    """A mesh after repair.

    vertices: (V, 3). faces: (F, 3). source: (V,) the given vertex of each. is_made: (V,) new vertices of an extruded
    rim, whose source is the vertex of the rim. vertex_of_given: (V_in,) the new vertex for each given one, or -1.
    given: (V_in, 3) the given vertices, all finite. repairs: the changes, a sentence each. rims: the given vertices
    around each filled hole. num_left_out: pieces beyond
    ``most_parts``.
    """

    vertices: np.ndarray
    faces: np.ndarray
    source: np.ndarray
    is_made: np.ndarray
    vertex_of_given: np.ndarray
    given: np.ndarray
    repairs: tuple[str, ...]
    rims: tuple[np.ndarray, ...] = ()
    num_left_out: int = 0


def repaired(vertices: np.ndarray, faces: np.ndarray, options: Repair) -> Repaired:
    """Repair ``vertices`` (V, 3), which may be NaN or infinite, and ``faces`` (F, 3), whose indices are in range.

    Raises:
        MeshError: nothing is left, or no vertex is finite.
    """
    repairs: list[str] = []
    given, placed = placed_between_neighbours(vertices, faces)
    _note(repairs, "placed {} that {was} not finite between {its} neighbours", placed, "vertex", "vertices")
    faces = _without_doubles(faces, repairs)
    welded = np.arange(len(given))
    corners = given[faces.ravel()].reshape(-1, 3, 3)
    diagonal = float(np.linalg.norm(np.ptp(corners.reshape(-1, 3), axis=0))) if len(faces) else 0.0
    edge = float(np.median(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2))) if len(faces) else 0.0
    for radius in (0.0, min(options.weld * diagonal, LARGEST_WELD * edge)):
        rim = np.unique(_rim(faces))
        if len(rim):
            target = _welded(given, rim, radius)
            moved = int((target != np.arange(len(given)))[rim].sum())
            _note(repairs, "welded {} at the rim of a hole to another", moved, "vertex", "vertices")
            welded, faces = target[welded], _without_doubles(target[faces], repairs)
    hidden = is_wall(given, faces)
    _note(repairs, "left out {} of internal walls", int(hidden.sum()), "face", "faces")
    faces = faces[~hidden]
    faces, num_turned = oriented(faces, left_alone(faces))
    _note(repairs, "turned {} round", num_turned, "face", "faces")
    num_faces, num_crowded = len(faces), int((edge_codes(faces)[2] > 2).sum())
    _note(repairs, "separated the sheets that met in {}", num_crowded, "edge", "edges")
    twin = twins(given, faces)
    while (is_crowded := is_double(cut_apart(faces, twin)[0])).any():  # remove faces where a sheet meets itself
        faces = faces[~is_crowded]
        twin = twins(given, faces)
    _note(repairs, "left out {} at edges where a sheet met itself", num_faces - len(faces), "face", "faces")
    faces, source = cut_apart(faces, twin)
    num_cut = len(source) - len(np.unique(source))
    _note(repairs, "doubled {} in which sheets met", num_cut, "vertex", "vertices")
    holes = filled(given[source], faces, options.largest_hole * diagonal)
    _note(repairs, f"filled {{}} with {sum(len(hole.lid) for hole in holes)} faces", len(holes), "hole", "holes")
    closed = extruded(given[source], faces, holes)
    repairs += closed.repairs
    rims = tuple(source[hole.loop] for hole in holes)
    vertices, faces, is_made = closed.vertices, closed.faces, np.arange(len(closed.vertices)) >= len(source)
    source = np.concatenate([source, source[closed.source]])
    fewest = FEWEST_VERTICES if options.join is None else FEWEST_TO_JOIN
    smallest = options.smallest_part * diagonal
    most = options.most_parts if options.join is None else len(faces)
    faces, num_few, num_flat, num_small, num_beyond = with_volume(vertices, faces, smallest, fewest, most)
    _note(repairs, f"left out {{}} of fewer than {fewest} vertices", num_few, "piece", "pieces")
    _note(repairs, "left out {} without volume", num_flat, "piece", "pieces")
    _note(repairs, "left out {} smaller than smallest_part", num_small, "piece", "pieces")
    _note(repairs, f"left out {{}}, the smallest, beyond most_parts = {most}", num_beyond, "piece", "pieces")
    if len(faces) == 0:
        raise MeshError(
            f"after repair no piece is left that encloses a volume and has {fewest} vertices: expected a "
            "solid, if with holes" + (f" (repaired: {'; '.join(repairs)})" if repairs else "")
        )
    used, flat = np.unique(faces, return_inverse=True)
    source = source[used]
    first = np.full(len(given), -1)
    first[source[::-1]] = np.arange(len(source))[::-1]
    target = first[welded]
    faces = flat.reshape(-1, 3)
    return Repaired(vertices[used], faces, source, is_made[used], target, given, tuple(repairs), rims, num_beyond)


def _note(repairs: list[str], sentence: str, count: int, one: str, many: str) -> None:
    if count:
        words = {"was": "was", "its": "its"} if count == 1 else {"was": "were", "its": "their"}
        repairs.append(sentence.format(f"{count} {one if count == 1 else many}", **words))


def placed_between_neighbours(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, int]:
    """Place vertices that are not finite at the mean of their neighbours in faces, starting at finite neighbours.

    Those without a finite neighbour go to the mean of all. Returns all vertices, and how many in a face were placed.
    """
    is_bad = np.logical_not(np.isfinite(vertices).all(axis=1))
    if not is_bad.any():
        return vertices, 0
    if is_bad.all():
        raise MeshError("no vertex is finite: expected coordinates")
    vertices, is_left, num = vertices.copy(), is_bad.copy(), len(vertices)
    onward = faces[:, [1, 2, 0]]
    beside = graphs.weighted(num, np.concatenate([faces, onward]).T.ravel(), np.concatenate([onward, faces]).T.ravel())
    vertices[is_left] = 0.0
    while is_left.any():
        known = (~is_left).astype(float)
        count = beside @ known
        now = is_left & (count > 0)
        if not now.any():
            vertices[is_left] = vertices[~is_left].mean(axis=0)
            break
        vertices[now] = (beside @ (vertices * known[:, None]))[now] / count[now, None]
        is_left &= ~now
    return vertices, int(np.sum(is_bad[np.unique(faces)]))


def _without_doubles(faces: np.ndarray, repairs: list[str]) -> np.ndarray:
    """The faces without those that have a corner twice, and with one of several that have the same three corners."""
    ordered = np.sort(faces, axis=1)
    is_flat = (ordered[:, 0] == ordered[:, 1]) | (ordered[:, 1] == ordered[:, 2])
    _note(repairs, "left out {} with a corner twice", int(is_flat.sum()), "face", "faces")
    faces, ordered = faces[~is_flat], ordered[~is_flat]
    first = np.sort(np.unique(ordered, axis=0, return_index=True)[1])
    _note(repairs, "left out {} that {was} there already", len(faces) - len(first), "face", "faces")
    return faces[first]


def _rim(faces: np.ndarray) -> np.ndarray:
    """The ends of the half-edges without another face."""
    edge, _, count = edge_codes(faces)
    half = np.flatnonzero(count[edge] == 1)
    return np.concatenate([faces.ravel()[half], faces[:, [1, 2, 0]].ravel()[half]])


def _welded(vertices: np.ndarray, rim: np.ndarray, radius: float) -> np.ndarray:
    """(V,) the vertex that each becomes: vertices of ``rim`` within ``radius`` of each other become the first."""
    target = np.arange(len(vertices))
    points, place = np.unique(vertices[rim], axis=0, return_inverse=True)
    tree, num = spatial.KDTree(points), len(points)
    if radius > 0 and tree.count_neighbors(tree, radius) > MOST_NEIGHBOURS * num:
        raise MeshError(f"Repair.weld would merge too many vertices (within {radius:.3g}): expected a smaller one")
    pairs = tree.query_pairs(radius, output_type="ndarray") if radius > 0 else np.empty((0, 2), dtype=np.int64)
    label = graphs.labels(num, *pairs.T)[place.ravel()]
    first = np.unique(label, return_index=True)[1]
    target[rim] = rim[first[label]]
    return target


def with_volume(
    vertices: np.ndarray, faces: np.ndarray, size: float, fewest: int = FEWEST_VERTICES, most: int | None = None
) -> tuple[np.ndarray, int, int, int, int]:
    """Remove pieces of fewer than ``fewest`` vertices, closed ones without volume, those smaller than ``size``, and the
    smallest of more than ``most`` pieces.

    Returns the faces that are left, and how many pieces of each kind were removed.
    """
    if len(faces) == 0:
        return faces, 0, 0, 0, 0
    edge, _, count = edge_codes(faces)
    label = graphs.pieces(faces, len(vertices))
    is_open = np.bincount(label, weights=(count[edge] == 1).reshape(-1, 3).any(axis=1)) > 0
    keep, diagonal = np.ones(len(is_open), dtype=bool), np.zeros(len(is_open))
    num_few = num_flat = num_small = 0
    for piece, rows in enumerate(by_label(label)):
        mine = faces[rows]
        used, local = np.unique(mine, return_inverse=True)
        low, high = vertices[used].min(axis=0), vertices[used].max(axis=0)
        extent = float((high - low).max())
        centred = (vertices[used] - (low + high) / 2) / (extent or 1.0)
        is_hollow = not is_open[piece] and abs(signed_volume(centred, local.reshape(-1, 3))) <= NO_VOLUME
        is_few = len(used) < fewest
        is_flat = not is_few and (extent == 0 or is_hollow)
        diagonal[piece] = np.linalg.norm(high - low)
        is_small = not is_few and not is_flat and diagonal[piece] < size
        keep[piece] = not (is_few or is_flat or is_small)
        num_few, num_flat, num_small = num_few + is_few, num_flat + is_flat, num_small + is_small
    left = np.flatnonzero(keep)
    beyond = left[np.argsort(-diagonal[left], kind="stable")][most:] if most is not None else left[:0]
    keep[beyond] = False
    return faces[keep[label]], num_few, num_flat, num_small, len(beyond)
