"""One solid of a closed part that crosses itself: the set of points around which its surface winds at least once.

The library Manifold unites solids, but not a solid with itself. So a box is put around each place where the part
crosses itself. Inside it, the limbs that cross are pieces of their own. These pieces, and what is outside of the boxes,
are united. A place where a piece still crosses itself, a fold of the surface for example, is left as it is.
"""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from msf_jax.solid.enclosure import Enclosure
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from manifold3d import Manifold

MARGINS = (0.1, 0.3, 1.0)  # sizes of the place: by which its box is larger on each side; the first that serves is taken
MOST_PLACES = 100  # places of a part that are tried; each costs some unions

MeshArrays = tuple[np.ndarray, np.ndarray]


class Untangled(NamedTuple):
    """vertices and faces; num: places that were resolved; num_left: places that were not."""

    vertices: np.ndarray
    faces: np.ndarray
    num: int = 0
    num_left: int = 0


def untangled(vertices: np.ndarray, faces: np.ndarray) -> Untangled:
    """Resolve where the closed part ``vertices`` (V, 3), ``faces`` (F, 3) crosses itself."""
    from manifold3d import Manifold, OpType  # imported here, because most runs do not need it

    shape = Enclosure(vertices, faces)
    crossed = shape.crossed
    if not crossed.num:
        return Untangled(vertices, faces)
    places = _places(shape, crossed.pairs)
    whole, boxes, strands = solid_of(vertices, faces), [], []
    for low, high in places[:MOST_PLACES]:
        for margin in MARGINS:
            size = (1 + 2 * margin) * (high - low)
            box = Manifold.cube(size.tolist(), True).translate(((low + high) / 2).tolist())
            pieces = (whole ^ box).decompose()
            if len(pieces) > 1 and all(map(_is_simple, pieces)):
                boxes.append(box)
                strands += pieces
                break
    if not boxes:
        return Untangled(vertices, faces, 0, len(places))
    rest = Manifold.batch_boolean([whole, *boxes], OpType.Subtract)
    found = arrays_of(Manifold.batch_boolean([rest, *strands], OpType.Add))
    return Untangled(*found, len(boxes), len(places) - len(boxes))


def solid_of(vertices: np.ndarray, faces: np.ndarray) -> "Manifold":
    from manifold3d import Manifold, Mesh64

    return Manifold(Mesh64(np.ascontiguousarray(vertices), np.ascontiguousarray(faces, dtype=np.uint64)))


def arrays_of(solid: "Manifold") -> MeshArrays:
    mesh = solid.to_mesh64()
    return np.array(mesh.vert_properties)[:, :3], np.array(mesh.tri_verts).astype(np.int64)


def _is_simple(piece: "Manifold") -> bool:
    """Whether a piece is a solid, no cavity, and does not cross itself."""
    return piece.volume() > 0 and not Enclosure(*arrays_of(piece)).crossed.num


def _places(shape: Enclosure, pairs: np.ndarray) -> list[tuple[np.ndarray, np.ndarray]]:
    """The boxes (low, high) around the places where faces cross, those that overlap united, largest first."""
    face, row = np.unique(pairs, return_inverse=True)
    one, other = row.reshape(pairs.shape).T
    # Faces that cross, and faces with a corner in common, are of one place.
    corner, of_face = shape.faces[face].ravel(), np.repeat(np.arange(len(face)), 3)
    ends = np.concatenate([one, of_face]), np.concatenate([other, len(face) + corner])
    num = len(face) + len(shape.vertices)
    label = graphs.labels(num, *ends)
    corners = shape.triangles[face]
    boxes = []
    for number in np.unique(label[: len(face)]):
        own = corners[label[: len(face)] == number].reshape(-1, 3)
        boxes.append((own.min(axis=0), own.max(axis=0)))
    while True:
        low, high = (np.array(each) for each in zip(*boxes, strict=True))
        reach = MARGINS[0] * (high - low)
        meet = ((low - reach)[:, None] <= (high + reach)[None]).all(axis=2)
        meet &= meet.T
        group = graphs.labels(len(low), *np.nonzero(meet))
        boxes = [(low[group == number].min(axis=0), high[group == number].max(axis=0)) for number in np.unique(group)]
        if len(boxes) == len(low):
            return sorted(boxes, key=lambda box: -float(np.prod(box[1] - box[0])))
