"""The connectivity surgery of Au et al. 2008: half-edge collapses down to a curve, and the recentring of its nodes.

A half-edge collapse i -> j merges vertex i, with all its edges, into j. Its cost is

    F(i, j) = F_a + 0.1 F_b,    F_a = sum over the edges gathered in i and in j of |a x (v_j - v)|^2,
                                F_b = |v_i - v_j| sum over the neighbours k of i of |v_i - v_k|,

The shape cost F_a is a quadric: the distance of v_j from the lines of edges (through v, with direction a) that were
contracted into the two. The sampling cost F_b penalises long edges. The cheapest edge with a face is collapsed first.
"""

import heapq

import numpy as np
from scipy import spatial

from msf_jax.meso.complex import Complex

SAMPLING = 0.1  # weight of the sampling cost
STALE = 1e-9  # relative rise of a cost, above which an entry of the heap is inserted again
CHEAPER = 0.9  # ratio of a vertex's edge lengths to those before, below which its entries are inserted again

Quadric = tuple[float, ...]  # xx, xy, xz, yy, yz, zz of M, then M v, and v . M v, summed over lines


def operate(complex_: Complex, positions: np.ndarray, a: np.ndarray, b: np.ndarray) -> None:
    """Collapse, in place, all edges with a face, for vertices at ``positions`` (n, 3) and all edges ab (E,). An edge
    that would pinch a loop of the solid waits until no others are left. Then one face is opened, or, without classes,
    one edge is collapsed."""
    work = _Costs(positions, a, b)
    heap = [(work.cost(i, j), i, j) for u, v in zip(a.tolist(), b.tolist(), strict=True) for i, j in ((u, v), (v, u))]
    heapq.heapify(heap)
    waiting: list[tuple[int, int]] = []
    has_moved = True
    while heap or waiting:
        if not heap:
            if not has_moved and complex_.has_classes and not complex_.open_face(waiting):
                return
            if not has_moved and not complex_.has_classes:
                i, j = waiting.pop()
                complex_.merge(j, i, force=True)
                waiting += work.merge(i, j)
            heap = [(work.cost(i, j), i, j) for i, j in waiting if _is_open(complex_, i, j)]
            heapq.heapify(heap)
            waiting, has_moved = [], False
            continue
        cost, i, j = heapq.heappop(heap)
        if not _is_open(complex_, i, j):
            continue
        now = work.cost(i, j)  # the cost may have risen since the entry was inserted
        if now > cost * (1 + STALE):
            heapq.heappush(heap, (now, i, j))
        elif complex_.merge(j, i, force=False):
            has_moved = True
            for k, m in work.merge(i, j):
                if _is_open(complex_, k, m):
                    heapq.heappush(heap, (work.cost(k, m), k, m))
        else:
            waiting.append((i, j))


def _is_open(complex_: Complex, i: int, j: int) -> bool:
    """Whether i and j still exist, with an edge between them that has a face."""
    return complex_.root[i] == i and complex_.root[j] == j and bool(complex_.apexes[i].get(j))


class _Costs:
    """Positions, neighbours and quadrics of vertices that are merged one into the other."""

    def __init__(self, positions: np.ndarray, a: np.ndarray, b: np.ndarray) -> None:
        ends, others = np.concatenate([a, b]), np.concatenate([b, a])
        along = positions[others] - positions[ends]
        length = np.linalg.norm(along, axis=1)
        along /= np.where(length > 0, length, 1.0)[:, None]
        M = np.eye(3) - along[:, :, None] * along[:, None, :]
        M[length == 0] = 0  # an edge without length has no line
        Mv = np.einsum("eij,ej->ei", M, positions[ends])
        columns = [M[:, i, j] for i in range(3) for j in range(i, 3)]
        columns += [*Mv.T, np.einsum("ei,ei->e", Mv, positions[ends])]
        num = len(positions)
        summed = [np.bincount(ends, weights=column, minlength=num) for column in columns]
        self.quadric: list[Quadric] = list(map(tuple, np.stack(summed, axis=1).tolist()))
        self.position: list[tuple[float, float, float]] = list(map(tuple, positions.tolist()))
        self.reach = np.bincount(ends, weights=length, minlength=num).tolist()  # sum of a vertex's edge lengths
        self.around: list[set[int]] = [set() for _ in range(num)]
        for i, j in zip(ends.tolist(), others.tolist(), strict=True):
            self.around[i].add(j)

    def cost(self, i: int, j: int) -> float:
        """The cost of the collapse of i into j."""
        x, y, z = self.position[j]
        shape = 0.0
        for xx, xy, xz, yy, yz, zz, bx, by, bz, c in (self.quadric[i], self.quadric[j]):
            shape += x * (xx * x + 2 * (xy * y + xz * z - bx)) + y * (yy * y + 2 * (yz * z - by))
            shape += z * (zz * z - 2 * bz) + c
        return max(shape, 0.0) + SAMPLING * self._length(i, j) * self.reach[i]

    def merge(self, i: int, j: int) -> list[tuple[int, int]]:
        """Merge i into j; returns the half-edges that are new, or may be much cheaper than before."""
        around, own = self.around[i], self.around[j]
        fresh, cheaper, reach = [], [], self.reach[j]
        for k in around:
            before = self.reach[k]
            self.reach[k] -= self._length(i, k)
            self.around[k].discard(i)
            if k != j and k not in own:
                fresh += [(k, j), (j, k)]
                own.add(k)
                self.around[k].add(j)
                length = self._length(j, k)
                self.reach[k] += length
                self.reach[j] += length
            if k != j and self.reach[k] < CHEAPER * before:
                cheaper.append(k)
        self.around[i] = set()
        if self.reach[j] < CHEAPER * reach:
            cheaper.append(j)
        self.quadric[j] = tuple(p + q for p, q in zip(self.quadric[i], self.quadric[j], strict=True))
        return fresh + [(k, m) for k in cheaper for m in self.around[k]]

    def _length(self, i: int, j: int) -> float:
        (a, b, c), (x, y, z) = self.position[i], self.position[j]
        return ((a - x) ** 2 + (b - y) ** 2 + (c - z) ** 2) ** 0.5


def recentred(
    nodes: np.ndarray,
    edges: np.ndarray,
    node_of_vertex: np.ndarray,
    contracted: np.ndarray,
    vertices: np.ndarray,
    faces: np.ndarray,
) -> np.ndarray:
    """The ``nodes`` (N, 3), moved back by the mean displacement of their regions' boundaries in the contraction.

    The region of a node is its vertices in ``node_of_vertex`` (V,). Boundary loops run half-way between its vertices
    and others, through the faces that have both. The displacement ``contracted - vertices`` (V, 3) is averaged over all
    loops by length. A node without a boundary moves like the nearest node with one. A leaf moves like the node before
    it, because its region is often a patch on one side of a limb.
    """
    label, away = node_of_vertex[faces], contracted - vertices
    num, sides = len(nodes), []
    for k in range(3):  # faces with corner k on one side of a boundary, and the two others on the other side
        (c, a, b), (own, other, same) = (np.roll(rows, -k, axis=1).T for rows in (faces, label))
        is_cut = (other == same) & (own != other)
        c, a, b = c[is_cut], a[is_cut], b[is_cut]
        length = np.linalg.norm(vertices[a] - vertices[b], axis=1) / 2
        moved = length[:, None] * (2 * away[c] + away[a] + away[b]) / 4
        sides += [(side, length, moved) for side in (own[is_cut], other[is_cut])]
    end, length, moved = map(np.concatenate, zip(*sides, strict=True))
    total = np.bincount(end, weights=length, minlength=num)
    sums = [np.bincount(end, weights=moved[:, axis], minlength=num) for axis in range(3)]
    shift = np.stack(sums, axis=1) / np.where(total > 0, total, 1.0)[:, None]
    known = np.flatnonzero(total > 0)
    if len(known):
        shift = shift[known[spatial.KDTree(nodes[known]).query(nodes)[1]]]
    degree = np.bincount(edges.ravel(), minlength=num)
    for leaf, before in (edges.T, edges.T[::-1]):
        is_leaf = (degree[leaf] == 1) & (degree[before] > 1)
        shift[leaf[is_leaf]] = shift[before[is_leaf]]
    return nodes - shift
