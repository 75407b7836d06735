"""Where the curve of a limb ends, and the rings of its surface that lead there.

On a limb, let u be the mean exit time: -Laplacian u = 1 on its surface, and u = 0 beyond its base. The level lines of u
run across the limb, and u is largest in the middle of its end. That also holds in a sheet, where the points at the
largest distance are corners. In a limb of constant size, u falls with the square of the distance d from the end, so

    d = sqrt(2 (u_max - u))

measures along the limb. The middles of the rings of equal d, half a limb's radius apart, are the limb's curve.

A solid with one branch has no base. There the first eigenfunction of the surface's Laplacian decides: it is positive at
one end and negative at the other, and its zero line runs across. A ball, a cube or a square plate has several, and no
direction in which it is long. Of their sums, the one with the shortest zero line decides: the ends of a cube are in the
middle of two faces.
"""

import itertools
from typing import NamedTuple

import numpy as np
from scipy import optimize, sparse
from scipy.sparse import linalg

from msf_jax.limbs.levels import levels
from msf_jax.numerics.factors import surface_factor
from msf_jax.solid import sections
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import RESOLUTION, ROUNDING, cross, triangle_areas, unit

SPACING = 0.5  # widths of a limb between its rings, and radii between the nodes of a curve
LAST = 3.0  # widths of a limb: the last stretch of its branch, which is laid on its rings; a shorter limb has as many
WHOLE = 0.8  # of the usual ball in a ring of its size: the least in one around the limb, and of an even limb's rings
GAP = 0.3  # of the largest ball near the limb's end: the ball around the end of the curve
DEEP = 1.2  # widths of a limb: so near to its end; half a ball's radius is 1.18 of its width
# Of two that are alike, the smaller one over the larger: eigenvalues, as in a ball, a cube or a square plate, 0.25 in a
# plate of 2 : 1; rings around a flat part of a limb, a foot, 0.89 in a corner; the mean normal of a plane and 1;
# distances from two ends.
ALIKE = 0.9


class LimbAxis(NamedTuple):
    """The curve of a limb. places: (k, 3) from its end to its base, the middles of rings. width: the radius of a tube
    of the limb's area and length. reach: from its end, that of the stretch of a branch that is laid on it."""

    places: np.ndarray
    width: float
    reach: float


def laplacian(vertices: np.ndarray, faces: np.ndarray) -> tuple[sparse.csr_array, np.ndarray]:
    """The Laplacian (V, V) with cotangent weights, positive semidefinite, and a third of the area (V,) around each
    vertex."""
    corners, num = vertices[faces], len(vertices)
    area, side = triangle_areas(corners), np.roll(corners, -1, axis=1) - corners
    # A triangle without area, such as one of a lid's in a line, counts as a sliver.
    least = RESOLUTION * (side**2).sum(axis=2).max(axis=1) + 1e-300
    cotangent = -np.einsum("fki,fki->fk", side, np.roll(side, 1, axis=1)) / np.maximum(4 * area, least)[:, None]
    i, j = np.roll(faces, -1, axis=1).ravel(), np.roll(faces, 1, axis=1).ravel()  # the edge opposite to each corner
    entries = np.tile(cotangent.ravel(), 2), (np.append(i, j), np.append(j, i))
    weight = sparse.coo_array(entries, (num, num)).tocsr()
    degree = np.asarray(weight.sum(axis=1)).ravel()
    return (sparse.diags_array(degree) - weight).tocsr(), np.bincount(faces.ravel(), np.repeat(area / 3, 3), num)


def exit_times(vertices: np.ndarray, faces: np.ndarray, owner: np.ndarray) -> np.ndarray:
    """(V,) the mean exit time from the part of the surface that has the same ``owner`` (V,); 0 where that is 0."""
    matrix, share = laplacian(vertices, faces)
    inner = np.flatnonzero(owner)
    if not len(inner):
        return np.zeros(len(vertices))
    own = matrix[inner][:, inner].tocoo()
    # A weight between two parts stays on the diagonal only: each sees the other as its base.
    is_same = owner[inner[own.row]] == owner[inner[own.col]]
    own = sparse.coo_matrix((own.data[is_same], (own.row[is_same], own.col[is_same])), own.shape).tocsc()
    found = np.zeros(len(vertices))
    found[inner] = surface_factor(own).solve(share[inner])
    return found


def halves(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """The first eigenfunction (V,) of a connected surface; of several, the sum of them with the shortest zero line."""
    matrix, share = laplacian(vertices, faces)
    mass, whole = sparse.diags_array(share).tocsc(), float(share.sum())
    start = np.cos(np.arange(len(vertices)))
    # Shifted by a part of 1 / area, the order of the first eigenvalues, so that the matrix is not singular.
    value, vector = linalg.eigsh(matrix.tocsc(), 4, mass, sigma=-0.1 / whole, v0=start)
    order = np.argsort(value)[1:]
    vector = vector[:, order[value[order] * ALIKE <= value[order[0]]]]

    def length(parts: tuple[float, ...] | np.ndarray) -> float:
        """Of the line on which the sum of the eigenfunctions is 0; infinite where that is 0 all over."""
        corners, height = vertices[faces], (vector @ np.array(parts))[faces]
        onward = np.roll(height, -1, axis=1)
        share = height / np.where(height == onward, 1.0, height - onward)
        points = corners + share[:, :, None] * (np.roll(corners, -1, axis=1) - corners)
        is_cut = (height > 0) != (onward > 0)
        points = points[is_cut.any(axis=1)][is_cut[is_cut.any(axis=1)]].reshape(-1, 2, 3)
        return float(np.linalg.norm(points[:, 1] - points[:, 0], axis=1).sum()) or np.inf

    start = min(itertools.product((-1.0, 0.0, 1.0), repeat=vector.shape[1]), key=length)
    found = optimize.minimize(length, start, method="Nelder-Mead", options={"xatol": 1e-3})
    return vector @ found.x


def axis(shape: Enclosure, vertices: np.ndarray, faces: np.ndarray, time: np.ndarray, region: np.ndarray) -> LimbAxis:
    """The curve of the limb ``region`` (r,), vertices of a surface ``(vertices (V, 3), faces (F, 3))`` of the solid
    ``shape``. ``time`` (V,) is the mean exit time."""
    is_in = np.zeros(len(vertices), dtype=bool)
    is_in[region[time[region] > 0]] = True
    near, local = np.unique(faces[is_in[faces].any(axis=1)], return_inverse=True)  # the limb and its base
    x, local, u = vertices[near], local.reshape(-1, 3), np.where(is_in[near], time[near], 0.0)
    away = np.sqrt(2 * np.maximum(u.max() - u, 0.0))
    longest = max(float(away.max()), 1e-300)
    width = float(triangle_areas(x[local]).sum()) / (2 * np.pi * longest)
    found = levels(x, local, away, SPACING * min(width, longest / LAST))
    # From the piece with the end on, over the longest ring of each piece. The last one, at the base, leans aside.
    rings, piece = list[int](), int(found.piece[away.argmin()])
    while len(above := np.flatnonzero(found.below == piece)):
        rings.append(int(above[found.perimeter[above].argmax()]))
        piece = int(found.above[rings[-1]])
    rings = rings[: max(len(rings) - 1, 3)]
    perimeter, size = found.perimeter[rings], found.size[rings]
    middles, last = _held_in(shape, found.centre[rings], size), len(rings) - 1
    # The curve begins with the first ring around the limb. The first of all is on the end itself. One in a corner of
    # the end is beside the limb's middle, and has a small ball. So has one around a foot, which is as long as the next.
    part = shape.clearance(middles) / np.maximum(size, 1e-300)
    is_around = part >= WHOLE * min(float(np.median(part)), 1.0)
    is_around |= (part >= GAP) & (perimeter >= ALIKE * np.append(perimeter[1:], 0.0))
    is_around &= part > ROUNDING  # else its middle is on the surface
    is_around[: min(max(1, _cut_off(x, local, away, middles, perimeter, found.step)), last)] = False
    if not is_around.any():  # the middles of a channel are outside
        return LimbAxis(middles, width, LAST * width)
    first = int(is_around.argmax())
    # The end is ahead on the line through two rings, a radius apart if there are such: a section of a nail's head that
    # is a little oblique has its middle far aside. One behind a hole in the end is alone: there it is across the ring.
    is_far = np.linalg.norm(middles[first:] - middles[first], axis=1) >= size[first]
    onward = middles[first] - middles[first + int(is_far.argmax()) if is_far.any() else min(first + 1, last)]
    heading = unit(onward) if np.linalg.norm(onward) >= found.step / 4 else -found.normal[rings[first]]
    reach = np.array([(2 * first + 3) * found.step])
    ahead = float(shape.ray_lengths(middles[[first]], heading[None], reach)[0])
    depth = min(DEEP * width, longest) * np.linspace(0.0, 1.0, 65) ** 2  # denser near the end of a sheet
    ball = shape.clearance(middles[first] + (ahead - depth)[:, None] * heading)
    along = ahead - depth[(ball >= GAP * ball.max()).argmax()]
    is_behind = (middles[first:] - middles[first]) @ heading < along
    places = np.concatenate([[middles[first] + along * heading], middles[first:][is_behind]])
    return LimbAxis(places, width, LAST * width)


def _held_in(shape: Enclosure, middles: np.ndarray, size: np.ndarray) -> np.ndarray:
    """The ``middles`` (k, 3) of rings of that ``size`` (k,), but of the first, in the material of an angle or channel:
    see `sections.held_in`. Those that are outside, most of them, say how the limb runs. That of a bent ring can be in
    a flange."""
    middles, row = middles.copy(), np.arange(min(1, len(middles) - 1), len(middles))
    out = row[~shape.contains(middles[row])]
    if 2 * len(out) <= len(row):  # those are in a hole in the end
        return middles
    near = np.searchsorted(out, row)
    heading = unit(middles[out[np.minimum(near + 1, len(out) - 1)]] - middles[out[np.clip(near - 1, 0, len(out) - 2)]])
    row, heading = row[heading.any(axis=1)], heading[heading.any(axis=1)]
    found = sections.cut(shape, middles[row], heading, size[row])
    held = sections.held_in(shape, heading, found).middle
    is_own = np.linalg.norm(found.centroid - middles[row], axis=1) < found.size
    middles[row] = np.where((is_own & (held != found.centroid).any(axis=1))[:, None], held, middles[row])
    return middles


def _cut_off(
    points: np.ndarray, faces: np.ndarray, away: np.ndarray, rings: np.ndarray, perimeter: np.ndarray, step: float
) -> int:
    """How many of the ``rings``, with middles (k, 3) and a ``perimeter`` (k,), ``step`` apart, are beside the axis of a
    straight limb that is cut off obliquely: their middles lead to the acute edge. 0 if it is not.

    Such a limb is even. Of its surface ``(points (v, 3), faces (f, 3))``, all that is nearer to the end than a far
    ring, by ``away`` (v,), lies in the tube around the line there, and what faces ahead is a plane. A foot leaves the
    tube, as do a hook and an arm of an elbow, and a finger's end is round."""
    deep = min(int(LAST / SPACING), len(rings) - 2)
    if deep < 2 or (perimeter[deep - 1 : deep + 1] < WHOLE * perimeter[deep + 1]).any():
        return 0
    line, here = unit(rings[deep] - rings[deep + 1]), (deep + 0.5) * step

    def beside(places: np.ndarray) -> float:
        beyond = places - rings[deep]
        return np.linalg.norm(beyond - (beyond @ line)[:, None] * line, axis=1).max(initial=0.0)

    tube = beside(points[(away >= here) & (away <= here + 2 * step)])
    a, b, c = np.moveaxis(points[faces[(away[faces] < here).all(axis=1)]], 1, 0)
    normal = cross(b - a, c - a)
    normal = normal[normal @ line > np.linalg.norm(normal, axis=1) / 4]
    is_plane = np.linalg.norm(normal.sum(axis=0)) > ALIKE * np.linalg.norm(normal, axis=1).sum()
    is_aside = beside(rings[1:deep]) > step / 4
    return deep if is_aside and is_plane and ALIKE * beside(points[away < here]) <= tube else 0
