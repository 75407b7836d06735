"""Repair on request: from any list of triangles to closed, oriented, manifold surfaces, with every change counted.

The steps are: remove degenerate and duplicate faces; weld coincident vertices at open edges; remove internal walls;
orient faces consistently; separate sheets that share an edge or a vertex; fill holes without new vertices; remove
pieces without volume, and specks. Each vertex of the result is one of the caller's, so that weights, pins and gradients
apply to it, except those of an extruded rim (see `holes`).

Sheets: a mesh of cells, or of bodies that share faces, has internal walls, and at an edge as many faces as cells.
Around an edge, the side of a face is connected to the facing side of the next face. Connected sides form a shell. The
shell of a cell encloses its volume; the outer shell encloses the sum of all volumes, with the opposite sign. A face
with neither side in the outer shell is a wall. (Shells of cells around an edge: Zhou et al. 2016.)
"""

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from scipy import spatial
from trimesh.triangles import closest_point

from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.base.options import Options, number
from msf_jax.base.writing import counted
from msf_jax.meshes.holes import extruded, filled
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import signed_volume, triangle_areas
from msf_jax.solid.solid import nested
from msf_jax.topology import graphs
from msf_jax.topology.graphs import by_label, edge_codes

FEWEST_VERTICES = 5  # vertices of a piece, at least, to have a skeleton
FEWEST_TO_JOIN = 4  # vertices of a piece, at least, to be joined to another
WELD = 1e-6  # diagonals: vertices at rims within this distance are welded
LARGEST_WELD = 0.01  # median edges: the largest radius of a weld; more would collapse triangles
MOST_NEIGHBOURS = 50  # vertices at rims within the radius of a weld, on average, at most
LONGEST_GAP = 0.005  # diagonals: the longest gap that "join" bridges
SMALLEST_PART = 0.001  # of the largest part's volume: below it, a part may be a speck
MOST_NAMED = 4  # specks whose places are told
BELOW = 1e-6  # diagonals of a speck: depth below the surface beside it at which the way through the solid begins
NO_VOLUME = 1e-9  # volume over the cube of the largest extent: below it, a piece encloses no volume


@dataclass(frozen=True)
class Repair(Options):
    """Limits of the repair in `skeletonize`. Lengths are fractions of the bounding box's diagonal.

    Attributes:
        largest_hole: holes whose rim fits into a box of this diagonal are filled; 0 fills none, 1 all.
        smallest_part: closed pieces of a smaller share of the largest one's volume are dropped if they are also
            smaller than the radius of the solid where they lie: specks. 0 keeps all that enclose a volume.
        join: closed parts become one solid if they overlap, or if their gap is at most this length, or at most the
            radius of the smaller solid (of the ball with its ratio of volume to area). 0 joins parts that overlap or
            touch, None joins none. ``repair="join"`` means 0.005.
        most_parts: the number of pieces that are kept, the largest, because each needs a run; it does not apply to
            joined pieces. The vertices of dropped pieces go to the nearest node.

    Raises:
        ConfigError: ``most_parts`` is no whole number above 0, or another value is no number from 0 to 1.
    """

    largest_hole: float = number(1.0, 0, 1)
    smallest_part: float = number(SMALLEST_PART, 0, 1)
    join: float | None = number(None, 0, 1)
    most_parts: int = number(128, 1, np.inf)


def as_repair(repair: Any) -> Repair | None:
    """The `Repair` that ``repair`` means: for True the defaults, for "join" with joining, for False None; a
    `ConfigError` if it is something else, and no `Repair`."""
    if isinstance(repair, str) and repair == "join":
        return Repair(join=LONGEST_GAP)
    if not isinstance(repair, bool | Repair):
        raise ConfigError(f'repair is {repair!r:.80}: expected True, False, "join" or a msf_jax.Repair')
    return repair if isinstance(repair, Repair) else Repair() if repair else None


class Repaired(NamedTuple):
    """A mesh after repair.

    vertices: (V, 3). faces: (F, 3). source: (V,) the given vertex of each. is_made: (V,) new vertices of an extruded
    rim, whose source is the vertex of the rim. vertex_of_given: (V_in,) the new vertex for each given one, or -1.
    repairs: the changes, a sentence each. rims: the given vertices around each filled hole. num_left_out: pieces beyond
    ``most_parts``."""

    vertices: np.ndarray
    faces: np.ndarray
    source: np.ndarray
    is_made: np.ndarray
    vertex_of_given: np.ndarray
    repairs: tuple[str, ...]
    rims: tuple[np.ndarray, ...]
    num_left_out: int


def repaired(vertices: np.ndarray, faces: np.ndarray, options: Repair) -> Repaired:
    """Repair ``vertices`` (V, 3) and ``faces`` (F, 3), whose indices are in range.

    Raises:
        MeshError: nothing is left.
    """
    repairs: list[str] = []

    def note(sentence: str, num: int, one: str) -> None:
        if num:
            many = "vertices" if one == "vertex" else f"{one}s"
            repairs.append(sentence.format(f"{num} {one if num == 1 else many}", was="was" if num == 1 else "were"))

    def without_doubles(faces: np.ndarray) -> np.ndarray:
        """The faces without those that have a corner twice, and with one of several with the same three corners."""
        is_flat = has_corner_twice(faces)
        note("left out {} with a corner twice", int(is_flat.sum()), "face")
        faces = faces[~is_flat]
        first = np.sort(np.unique(np.sort(faces, axis=1), axis=0, return_index=True)[1])
        note("left out {} that {was} there already", len(faces) - len(first), "face")
        return faces[first]

    given, faces = vertices, without_doubles(faces)
    welded = np.arange(len(given))
    corners = given[faces.ravel()].reshape(-1, 3, 3)
    diagonal = float(np.linalg.norm(np.ptp(corners.reshape(-1, 3), axis=0))) if len(faces) else 0.0
    edge = float(np.median(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2))) if len(faces) else 0.0
    for radius in (0.0, min(WELD * diagonal, LARGEST_WELD * edge)):
        edge_of, _, count = edge_codes(faces)
        is_single = (count[edge_of] == 1).reshape(-1, 3)
        if is_single.any():
            rim = np.unique(np.stack([faces, faces[:, [1, 2, 0]]])[:, is_single])
            target = _welded(given, rim, radius)
            moved = int((target != np.arange(len(given)))[rim].sum())
            note("welded {} at the rim of a hole to another", moved, "vertex")
            welded, faces = target[welded], without_doubles(target[faces])
    hidden = is_wall(given, faces)
    note("left out {} of internal walls", int(hidden.sum()), "face")
    faces, num_turned = oriented(faces[~hidden])
    note("turned {} round", num_turned, "face")
    num_faces = len(faces)
    note("separated the sheets that met in {}", int((edge_codes(faces)[2] > 2).sum()), "edge")
    while True:
        parted, source = cut_apart(faces, twins(given, faces))
        edge_of, _, count = edge_codes(parted)
        is_crowded = (count[edge_of] > 2).reshape(-1, 3).any(axis=1)
        if not is_crowded.any():
            break
        faces = faces[~is_crowded]  # a sheet meets itself there
    note("left out {} at edges where a sheet met itself", num_faces - len(faces), "face")
    note("doubled {} in which sheets met", len(source) - len(np.unique(source)), "vertex")
    holes = filled(given[source], parted, options.largest_hole * diagonal)
    note(f"filled {{}} with {sum(len(hole.lid) for hole in holes)} faces", len(holes), "hole")
    vertices, faces, of_rim = extruded(given[source], parted, holes, repairs)
    rims, is_made = tuple(source[hole.loop] for hole in holes), np.arange(len(vertices)) >= len(source)
    source = np.concatenate([source, source[of_rim]])
    fewest = FEWEST_VERTICES if options.join is None else FEWEST_TO_JOIN
    most = options.most_parts if options.join is None else np.inf
    faces, left_out, num_beyond = with_volume(vertices, faces, options.smallest_part, fewest, most)
    repairs += left_out
    if len(faces) == 0:
        raise MeshError(
            f"after repair no piece is left that encloses a volume and has {fewest} vertices: expected a "
            "solid, if with holes" + (f" (repaired: {'; '.join(repairs)})" if repairs else "")
        )
    used, flat = np.unique(faces, return_inverse=True)
    source = source[used]
    first = np.full(len(given), -1)
    first[source[::-1]] = np.arange(len(source))[::-1]
    return Repaired(
        vertices=vertices[used],
        faces=flat.reshape(-1, 3),
        source=source,
        is_made=is_made[used],
        vertex_of_given=first[welded],
        repairs=tuple(repairs),
        rims=rims,
        num_left_out=num_beyond,
    )


def has_corner_twice(faces: np.ndarray) -> np.ndarray:
    """(F,) whether a face of ``faces`` (F, 3) has the same corner twice."""
    return (faces == np.roll(faces, 1, axis=1)).any(axis=1)


def _welded(vertices: np.ndarray, rim: np.ndarray, radius: float) -> np.ndarray:
    """(V,) the vertex that each becomes: vertices of ``rim`` within ``radius`` of each other become the first."""
    target = np.arange(len(vertices))
    points, place = np.unique(vertices[rim], axis=0, return_inverse=True)
    tree, num = spatial.KDTree(points), len(points)
    if radius > 0 and tree.count_neighbors(tree, radius) > MOST_NEIGHBOURS * num:
        raise MeshError(f"too many vertices lie within {radius:.3g} of others at rims of holes: expected fewer")
    pairs = tree.query_pairs(radius, output_type="ndarray") if radius > 0 else np.empty((0, 2), dtype=np.int64)
    label = graphs.labels(num, *pairs.T)[place.ravel()]
    first = np.unique(label, return_index=True)[1]
    target[rim] = rim[first[label]]
    return target


def with_volume(
    vertices: np.ndarray, faces: np.ndarray, smallest: float = 0.0, fewest: int = FEWEST_VERTICES, most: float = np.inf
) -> tuple[np.ndarray, list[str], int]:
    """Remove pieces of fewer than ``fewest`` vertices, closed ones without volume, `specks` below the share
    ``smallest`` of the largest volume, and the smallest of more than ``most`` pieces. Returns the faces that are left,
    a sentence for each reason, and how many pieces were beyond ``most``."""
    if len(faces) == 0:
        return faces, [], 0
    edge, _, count = edge_codes(faces)
    label = graphs.pieces(faces, len(vertices))
    is_open = np.bincount(label, weights=(count[edge] == 1).reshape(-1, 3).any(axis=1)) > 0
    low, high = (end(vertices[faces.ravel()], axis=0) for end in (np.min, np.max))
    middle, size = (low + high) / 2, float((high - low).max()) or 1.0
    parts = []
    for rows in by_label(label):
        used, local = np.unique(faces[rows], return_inverse=True)
        parts.append(Enclosure((vertices[used] - middle) / size, local.reshape(-1, 3)))
    extent = np.array([part.extent for part in parts])
    is_few = np.array([len(part.vertices) < fewest for part in parts])
    is_flat = np.array([abs(volume_of(part)) for part in parts]) <= NO_VOLUME * extent**3
    is_flat = (extent == 0) | (is_flat & ~is_open)
    keep = ~(is_few | is_flat)
    closed = np.flatnonzero(keep & ~is_open)
    speck = closed[specks([parts[k] for k in closed], smallest)]
    keep[speck] = False
    places = (middle + size * middle_of(parts[k]) for k in speck[:MOST_NAMED])
    at = ", ".join("({:.4g}, {:.4g}, {:.4g})".format(*place) for place in places)
    kept, diagonals = np.flatnonzero(keep), np.array([np.linalg.norm(np.ptp(part.vertices, axis=0)) for part in parts])
    num_beyond = int(max(len(kept) - most, 0))
    keep[kept[np.argsort(-diagonals[kept], kind="stable")][len(kept) - num_beyond :]] = False
    reasons = (
        (int(is_few.sum()), f" of fewer than {fewest} vertices"),
        (int((is_flat & ~is_few).sum()), " without volume"),
        (len(speck), f" smaller than smallest_part, at {at}" + ", ..." * (len(speck) > MOST_NAMED)),
        (num_beyond, f", the smallest, beyond most_parts = {most}"),
    )
    sentences = [f"left out {counted(num, 'piece')}{reason}" for num, reason in reasons if num]
    return faces[keep[label]], sentences, num_beyond


def volume_of(part: Enclosure) -> float:
    """The signed volume of a closed part, which may be far from the origin."""
    return signed_volume(part.vertices - middle_of(part), part.faces)


def radius_of(part: Enclosure) -> float:
    """The radius of the ball with the ratio of volume to area of a closed part."""
    return 3 * abs(volume_of(part)) / float(triangle_areas(part.triangles).sum())


def middle_of(part: Enclosure) -> np.ndarray:
    """(3,) the middle of the box of a part."""
    return (part.vertices.min(axis=0) + part.vertices.max(axis=0)) / 2


def specks(parts: list[Enclosure], smallest: float = SMALLEST_PART) -> np.ndarray:
    """(k,) which of closed ``parts`` are specks: solids of less than ``smallest`` of the largest part's volume, whose
    box's diagonal is less than the radius at which they lie: a hair is thin, but long.

    The radius is that of the nearest other solid that is larger and no speck, as a part of a twig lies at the twig:
    half of the way through it there, or `radius_of` it if this is less."""
    volume = np.array([volume_of(part) for part in parts])
    size = np.abs(volume)
    is_speck = size < smallest * size.max(initial=0.0)
    if not is_speck.any():
        return is_speck
    is_solid = nested(parts, volume)[0] == np.arange(len(parts))
    is_speck &= is_solid
    low, high = (np.array([end(part.vertices, axis=0) for part in parts]) for end in (np.min, np.max))
    for each in np.flatnonzero(is_speck)[np.argsort(-size[is_speck], kind="stable")].tolist():
        middle, diagonal = middle_of(parts[each])[None], float(np.linalg.norm(high[each] - low[each]))
        others = np.flatnonzero(is_solid & ~is_speck & (size > size[each]))
        least = np.linalg.norm(np.maximum(np.maximum(low[others] - middle, middle - high[others]), 0), axis=1)
        away, number, face = np.inf, each, 0
        for k in np.argsort(least, kind="stable").tolist():
            if least[k] >= away:
                break
            distance, at = parts[others[k]].nearest(middle)
            if distance[0] < away:
                away, number, face = float(distance[0]), int(others[k]), int(at[0])
        nearest = parts[number]
        inward = -np.sign(volume[number]) * nearest.normals[[face]]
        foot = closest_point(nearest.triangles[[face]], middle) + BELOW * diagonal * inward
        is_speck[each] = nearest.ray_lengths(foot, inward, np.array([2 * radius_of(nearest)]))[0] > 2 * diagonal
    return is_speck


def _pairs(edge: np.ndarray, is_meant: np.ndarray) -> np.ndarray:
    """(n, 2) half-edges of the same ``edge`` (3F,), at the edges that have exactly two half-edges that ``is_meant``."""
    num = np.bincount(edge[is_meant], minlength=int(edge.max(initial=-1)) + 1)
    half = np.flatnonzero(is_meant & (num[edge] == 2))
    return half[np.argsort(edge[half], kind="stable")].reshape(-1, 2)


def _patches(edge: np.ndarray, count: np.ndarray) -> np.ndarray:
    """(F,) the patch of each face; patches are connected across edges of two faces."""
    return graphs.labels(len(edge) // 3, *(_pairs(edge, count[edge] == 2) // 3).T)


def _in_crowds(edge: np.ndarray, count: np.ndarray) -> list[np.ndarray]:
    """The half-edges at each edge of more than two faces."""
    half = np.flatnonzero(count[edge] > 2)
    half = half[np.argsort(edge[half], kind="stable")]
    return np.split(half, np.cumsum(count[count > 2])[:-1]) if len(half) else []


def left_alone(faces: np.ndarray) -> np.ndarray:
    """(3F,) half-edges, at an edge of more than two faces, that are not paired with the others there.

    These are the faces of open patches, such as a fin, if the other faces are an even number. Of an odd number of faces
    it is the one of the smallest patch, preferably an open one, which is more likely a wall than part of a solid."""
    edge, _, count = edge_codes(faces)
    patch = _patches(edge, count)
    size = np.bincount(patch)
    is_open = np.bincount(patch, weights=(count[edge] == 1).reshape(-1, 3).any(axis=1)) > 0
    alone = np.zeros(len(edge), dtype=bool)
    for halves in _in_crowds(edge, count):
        own = patch[halves // 3]
        num_closed = int((~is_open[own]).sum())
        if num_closed and num_closed % 2 == 0:
            alone[halves[is_open[own]]] = True
        elif len(halves) % 2:
            alone[halves[np.lexsort((size[own], ~is_open[own]))[0]]] = True
    return alone


def oriented(faces: np.ndarray) -> tuple[np.ndarray, int]:
    """Orient faces consistently across edges with two faces that are not left alone. Returns how many were turned.

    In each connected patch, the smaller number of faces is turned. Each face is twice in a graph, as it is and turned,
    and faces that fit are connected. A patch is then two components, one of which is used. A patch with one side only
    is a single component, and is not changed."""
    half, num = _pairs(edge_codes(faces)[0], ~left_alone(faces)), len(faces)
    one, other = half.T // 3
    is_same = np.equal(*faces.ravel()[half.T]).astype(np.int64)
    tail, head = [one, one + num], [other + num * is_same, other + num * (1 - is_same)]
    as_is, turned = graphs.labels(2 * num, np.concatenate(tail), np.concatenate(head)).reshape(2, -1)
    is_turned = as_is > turned
    patch = np.minimum(as_is, turned)
    share = np.bincount(patch, weights=is_turned) / np.maximum(np.bincount(patch), 1)
    is_turned ^= (share[patch] > 0.5) & (as_is != turned)
    return np.where(is_turned[:, None], faces[:, ::-1], faces), int(is_turned.sum())


def twins(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """(3F,) the twin of each half-edge, or -1.

    At an edge of more than two faces, half-edges of opposite directions are paired, those that enclose the smallest
    angle of the inside first. Half-edges that are left alone are paired only within their patch."""
    edge, _, count = edge_codes(faces)
    origin, twin = faces.ravel(), np.full(faces.size, -1)
    pair = _pairs(edge, count[edge] == 2)
    pair = pair[origin[pair[:, 0]] != origin[pair[:, 1]]]
    twin[pair], crowds = pair[:, ::-1], _in_crowds(edge, count)
    if not crowds:
        return twin
    alone, patch = left_alone(faces), _patches(edge, count)
    angles, is_forward = _angles_around_edges(vertices, faces)
    for halves in crowds:
        ahead, back = halves[is_forward[halves]], halves[~is_forward[halves]]
        wedge = (angles[ahead][:, None] - angles[back]) % (2 * np.pi)  # inside is in the direction of smaller angles
        is_barred = (alone[ahead][:, None] | alone[back]) & (patch[ahead // 3][:, None] != patch[back // 3])
        wedge[is_barred] = np.inf
        for _ in range(min(wedge.shape)):
            i, j = np.unravel_index(np.argmin(wedge), wedge.shape)
            if wedge[i, j] < np.inf:
                twin[ahead[i]], twin[back[j]] = back[j], ahead[i]
            wedge[i], wedge[:, j] = np.inf, np.inf
    return twin


def _angles_around_edges(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(3F,) angles of the faces around the edges of their half-edges, seen along the edge from its vertex of smaller
    number, counter-clockwise; and (3F,) whether the half-edge starts there."""
    origin, target, apex = (np.roll(faces, -k, axis=1).ravel() for k in range(3))
    start, end = vertices[np.minimum(origin, target)], vertices[np.maximum(origin, target)]
    axis = end - start
    length = np.linalg.norm(axis, axis=1, keepdims=True)
    axis = np.where(length > 0, axis / np.maximum(length, 1e-300), [0.0, 0.0, 1.0])
    u = np.cross(axis, np.eye(3)[np.abs(axis).argmin(axis=1)])
    away, v = vertices[apex] - start, np.cross(axis, u)
    angles = np.arctan2(np.einsum("ij,ij->i", away, v), np.einsum("ij,ij->i", away, u))
    return angles, origin < target


def cut_apart(faces: np.ndarray, twin: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """One vertex for each fan of faces around it: new faces, and the old vertex of each new one."""
    half = np.flatnonzero(twin >= 0)
    after = twin - twin % 3 + (twin + 1) % 3  # the corner at the end of the twin
    fan = graphs.labels(len(twin), half, after[half])
    owner = faces.ravel()[np.flatnonzero(np.diff(np.maximum.accumulate(fan), prepend=-1))]  # at its first corner
    order = np.argsort(owner, kind="stable")
    return np.argsort(order)[fan].reshape(-1, 3), owner[order]


def is_wall(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """(F,) whether each of ``faces`` (F, 3) is an internal wall of its edge-connected piece.

    There are none if a hole connects inside and outside, or if no edge has more than two faces."""
    num = len(faces)
    edge, _, count = edge_codes(faces)
    if not (count > 2).any():
        return np.zeros(num, dtype=bool)
    angle, is_forward = _angles_around_edges(vertices, faces)
    order = np.lexsort((angle, edge))
    is_last = np.append(edge[order][1:] != edge[order][:-1], True)
    first = np.concatenate([[0], np.flatnonzero(is_last)[:-1] + 1])
    following = np.append(order[1:], 0)
    following[is_last] = order[first]
    # The side that the normal of face f points to has the id f, the other side f + F.
    ahead = order // 3 + num * ~is_forward[order]
    back = following // 3 + num * is_forward[following]
    shell = graphs.labels(2 * num, ahead, back)
    chunk = graphs.labels(shell.max() + 1, shell[:num], shell[num:])
    a, b, c = (vertices[corner] - vertices[faces].mean(axis=(0, 1)) for corner in faces.T)
    volume = np.einsum("fi,fi->f", a, np.cross(b, c)) / 6
    enclosed = np.bincount(shell[num:], weights=volume, minlength=len(chunk))
    enclosed -= np.bincount(shell[:num], weights=volume, minlength=len(chunk))
    by_chunk = np.lexsort((enclosed, chunk))
    is_outer = np.zeros(len(chunk), dtype=bool)
    is_outer[by_chunk[np.append(True, chunk[by_chunk][1:] != chunk[by_chunk][:-1])]] = True
    return ~(is_outer[shell[:num]] | is_outer[shell[num:]])
