"""`Report`: the results of a run, and how far to trust them.

For a branch of length l outside the balls of its junctions, in a part of the solid of volume V (see
`centrelines.volumes_of`) with cross-sections of area A,

    unexplained = max(l - V / A, 0),

because a limb of that cross-section and volume is V / A long. A curve that winds, runs to and fro, or has two strands
in one limb is longer. A is the median of the areas, or their mean along the branch if that is less: planes near a
junction cut the trunk, too, and in an ellipsoid most areas are above the mean.
"""

from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np
from scipy import spatial

from msf_jax.base.clock import begin
from msf_jax.base.writing import counted
from msf_jax.curve import branches, handle_loops
from msf_jax.limbs.one_branch import leaves_of
from msf_jax.meshes.repair import specks
from msf_jax.skeleton.centrelines import volumes_of
from msf_jax.skeleton.pruning import Branch
from msf_jax.solid import crossings, sections
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import RESOLUTION, ROUNDING, arc_length, at, triangle_areas, unit
from msf_jax.solid.solid import Solid, bodies, is_end, lids_of
from msf_jax.topology import graphs

MOST_NAMED = 5  # loops of one kind, or folds, that a report names; it counts the rest
STUB = 1.5  # slenderness below which a limb is a stub, hardly longer than wide
# With this many stubs, and if they are a third of all limbs, the limbs are probably roughness of the surface. Armadillo
# has 10 stubs of 18 limbs, its fingers and toes; a statue in a robe with noise of 0.005 diagonals has 439 of 448.
MANY = 25
# Of 24 solids of limbs none has more in sheets than 0.39 of its curve's length (a rabbit with flat ears), or more
# unexplained than 0.07. A plate with four holes has 0.45 in sheets, other plates, brackets and pipes more. A plant
# whose curve has two strands in its stem, which is 10 % too long by them, has 0.084 unexplained.
MOST_IN_SHEETS = 0.42  # share of the curve's length, above which these are no limbs
MOST_UNEXPLAINED = 0.08  # likewise
# Of the curve's length between two places a radius before and after a node: their distance is less where it turns back.
# So it turns by 166 degrees or more. In the corner of bars that meet at 25 degrees it rightly turns by 155: it is 0.22.
FOLDED = 0.125
SHEET = 2.0  # balls' radii: mean radius of a sheet's cross-section; that of a rectangle 2.6 times as wide as thick
FLAT_SECTION = 1.35  # its mean radius over twice its area over its edge: of a disc 1, a square 1.1, that rectangle 1.4
IN_SHEETS = "{:.0%} of the curve's length is in sheets, where its path is arbitrary"
NOT_SURE = "NOT SURE"  # in a note that is printed first: a root that may be in no soma


@dataclass(frozen=True)
class Report:
    """The results of a run, and how far to trust them.

    Attributes:
        components, mesh_components: connected components of the curve, and of the mesh; should be equal.
        genus, cycles: sum of the genera of the mesh's components; independent cycles of the curve. Should be equal.
        loops: handles of the solid that these cycles go around, from linking numbers with loops of its surface; should
            equal ``genus`` and ``cycles``. None without the mesh, or if there are too many to prove, which is a doubt.
        in_sheets: share of the curve's length in limbs over 2.6 times as wide as thick, or in the wall around a void,
            where the path is arbitrary; over half is a doubt. None if not known, as the next two.
        unexplained: share of its length beyond limbs of its cross-sections with the solid's volume.
        elongation: the largest length of a branch in its median diameters.
        left_out: parts without a curve, because there were more than ``Repair.most_parts``.
        joined_handles: of `repair="join"`, where parts touch or overlap in several places; None without it.
        cut: cycles that `Skeleton.to_tree` cut.
        inside: fraction of the curve's length that is inside the mesh.
        converged, reason: whether the flow converged; why it stopped, one clause for each reason of a component.
        iterations: of the flow, the sum over components.
        fixed, live: vertices of the meso-skeleton at the end: those that were fixed, and all.
        coarsened: vertices that coarsening removed before the flow, see ``Config.coarsen``.
        pruned, grown: branches that were removed because they are no limbs, also by `Skeleton.prune`; and that were
            added in thin limbs that the flow had lost.
        wavefronts: components whose curves geodesic wavefronts made, as edges are longer than limbs are thick.
        volume: fraction of the coarsened surface's volume that is left, the largest over components.
        solve_steps, out_of_steps: CG steps of all solves; iterations in which one ended unsolved.
        doubts: reasons not to trust the curve, such as a loop that goes around no handle, a sentence each.
        repairs, notes: changes of the input mesh, and other unusual events, a sentence each.
        figures: `metrics.evaluate` of the finished curve, with ``Config(evaluate=True)``.
        seconds: by stage.
    """

    components: int
    mesh_components: int
    genus: int
    cycles: int
    inside: float
    converged: bool
    reason: str
    iterations: int = 0
    fixed: int = 0
    live: int = 0
    volume: float = 0.0
    solve_steps: int = 0
    coarsened: int = 0
    pruned: int = 0
    grown: int = 0
    wavefronts: int = 0
    cut: int = 0
    out_of_steps: int = 0
    loops: int | None = None
    in_sheets: float | None = None
    unexplained: float | None = None
    elongation: float | None = None
    left_out: int = 0
    joined_handles: int | None = None
    doubts: tuple[str, ...] = ()
    repairs: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    figures: dict[str, float] = field(default_factory=dict)
    seconds: dict[str, float] = field(default_factory=dict, compare=False)

    @property
    def is_sound(self) -> bool:
        """Whether the run converged, the numbers of components and cycles are right, each cycle goes around a handle of
        its own, at least 99 % of the curve is inside, and there are no ``doubts``."""
        is_right = self.components == self.mesh_components and self.cycles + self.cut == self.genus
        is_right &= self.loops == self.cycles or not self.cycles  # without cycles, loops need no proof
        return self.converged and is_right and self.inside >= 0.99 and not self.doubts

    @property
    def are_limbs(self) -> bool:
        """Whether the solid consists of limbs, and the curve is their axes, so that its lengths, radii and angles mean
        something; see ``not_limbs``. `is_sound` says whether the topology is right."""
        return not self.not_limbs

    @property
    def not_limbs(self) -> tuple[str, ...]:
        """Why `are_limbs` is False, a sentence each. A curve without its mesh, and the flow's own, are not measured."""
        if self.in_sheets is None or self.unexplained is None or self.elongation is None:
            return ("not measured, as the mesh or the finished curve is not known",)
        excess = f"{self.unexplained:.0%} of the curve's length is more than the solid explains"
        parts, handles = self.left_out, self.joined_handles or 0
        reasons = (
            (self.elongation < 1, "no part is longer than it is wide"),
            (self.in_sheets > MOST_IN_SHEETS, IN_SHEETS.format(self.in_sheets)),
            (self.unexplained > MOST_UNEXPLAINED, f"{excess}: it winds, or two strands are in one limb"),
            (parts > 0, f"repair left out {counted(parts, 'part')}, which {'has' if parts == 1 else 'have'} no curve"),
            (handles > 0, f"joining made {counted(handles, 'handle')}, where parts touch in several places"),
        )
        return tuple(reason for is_so, reason in reasons if is_so)

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for a table."""
        return asdict(self)

    def __repr__(self) -> str:
        seconds = ", ".join(f"{stage} {seconds:.2f} s" for stage, seconds in self.seconds.items())
        return "\n".join([*self.lines(), *([seconds] if seconds else [])])

    def lines(self) -> list[str]:
        """The printed lines without the seconds, which differ from run to run."""
        unsure = [note for note in self.notes if NOT_SURE in note]
        around = "as many handles" if self.loops == self.cycles else f"ONLY {counted(self.loops or 0, 'handle')}"
        lines = [
            *unsure,
            f"{'converged' if self.converged else 'NOT converged'}: {self.reason}, "
            f"after {self.iterations} iterations ({self.volume:.1e} of the volume left)",
            _compare(self.components, "component", self.mesh_components, "as in the mesh")
            + ", "
            + _compare(self.cycles, "cycle", self.genus - self.cut, f"for genus {self.genus}")
            + (f", {self.cut} more cut" if self.cut else "")
            + ("" if self.loops is None or not self.cycles else f", around {around}"),
            f"{100 * self.inside:.2f} % of the curve's length is inside the mesh",
            f"{self.fixed} of {self.live} meso-skeleton vertices fixed, {self.solve_steps} CG steps"
            + (f", {self.coarsened} vertices coarsened away before" if self.coarsened else ""),
        ]
        if self.elongation is not None:
            lines.append(f"limbs: {'yes' if self.are_limbs else 'NO, ' + '; '.join(self.not_limbs)}")
        if self.pruned or self.grown:
            lines.append(f"branches: {self.pruned} pruned as no limbs, {self.grown} grown where the flow had lost them")
        if self.out_of_steps:
            lines.append(f"in {self.out_of_steps} iterations a linear solve ran out of steps")
        if self.figures:
            lines.append(", ".join(f"{name} {value:.4g}" for name, value in self.figures.items()))
        lines += [f"in doubt: {doubt}" for doubt in self.doubts if doubt not in self.not_limbs]
        lines += [f"repaired: {repair}" for repair in self.repairs]
        return lines + [note for note in self.notes if note not in unsure]


def _compare(found: int, what: str, expected: int, why: str) -> str:
    count = counted(found, what)
    return f"{count} {why}" if found == expected else f"{count}, EXPECTED {expected} {why}"


def loops_of(
    shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, node_of_vertex: np.ndarray | None = None
) -> dict[str, Any]:
    """The report's ``loops`` and ``doubts`` for a curve ``(vertices (N, 3), edges (E, 2))``, in its solid's units.
    ``node_of_vertex`` (V,) is the node of each vertex of the solid, if known."""
    found = handle_loops.proof(shape, vertices, edges, node_of_vertex)
    doubts = []
    for closing, what in (
        (found.none, "goes around no handle"),
        (found.again, "goes only around handles of others"),
        (found.several, "goes around a handle more than once"),
        (found.outside, "leaves the solid"),
    ):
        for a, b in edges[closing[:MOST_NAMED]].tolist():
            doubts.append(f"the loop through nodes {a} and {b} {what}")
        if len(closing) > MOST_NAMED:
            doubts.append(f"so do {len(closing) - MOST_NAMED} more")
    if found.unproved:
        many = f"{found.unproved} handles are too many for a curve of {len(edges)} edges"
        doubts.append(f"the loops were not proved: {many}")
    return {"loops": None if found.unproved else found.rank, "doubts": tuple(doubts)}


def assessed(
    shape: Enclosure,
    vertices: np.ndarray,
    edges: np.ndarray,
    node_of_vertex: np.ndarray | None = None,
    branches_of: Callable[[], list[Branch]] = list,
    is_joined: bool = False,
    lids: np.ndarray | tuple[int, ...] = (),
) -> dict[str, Any]:
    """The report's ``loops``, ``doubts`` and shares for a finished curve, see `loops_of` and `shares_of`. Its branches
    are only asked for if it has many ends. Where the solid's parts were joined, ``is_joined``, that is no advice.
    ``lids`` (L,): the faces that close openings, default none."""
    about, doubts = loops_of(shape, vertices, edges, node_of_vertex), list[str]()
    shape.prepare()  # before two threads ask for it
    overlaps = begin(_overlaps, shape, vertices, edges, node_of_vertex, is_joined, lids)
    shares = shares_of(shape, vertices, edges, node_of_vertex)
    if len(leaves_of(edges)) >= MANY:
        slender = [branch.slenderness for branch in branches_of() if np.isfinite(branch.slenderness)]
        stubs = sum(each < STUB for each in slender)
        if stubs >= MANY and 3 * stubs > len(slender):
            doubts.append(f"{stubs} of {len(slender)} limbs are hardly longer than wide: the surface may be rough")
    if shares["in_sheets"] > 1 / 2:  # the curve could as well be elsewhere
        doubts.append(IN_SHEETS.format(shares["in_sheets"]))
    doubts += _folds(shape, vertices, edges)
    doubts += overlaps.result()
    return about | shares | {"doubts": (*about["doubts"], *doubts)}


def _folds(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> list[str]:
    """The doubts about places where a branch runs out and back: the sharpest node of each. A stretch that is shorter
    than a radius shows no turn."""
    radius, is_held = shape.clearance(vertices), np.zeros(len(vertices), dtype=bool)
    found: set[int] = set()
    for nodes, is_loop, *_ in branches.paths_of(vertices, edges, is_held):
        path = np.concatenate([nodes[:-1], nodes]) if is_loop else nodes
        x, along = vertices[path], arc_length(vertices[path])
        before, after = (np.clip(along + sign * radius[path], 0.0, along[-1]) for sign in (-1, 1))
        length = after - before
        share = np.linalg.norm(at(x, along, after) - at(x, along, before), axis=1) / np.maximum(length, 1e-300)
        share[[0, -1]] = np.inf
        fold = np.flatnonzero((share < FOLDED) & (length >= radius[path]))
        for run in np.split(fold, np.flatnonzero(np.diff(fold) > 1) + 1) if len(fold) else ():
            found.add(int(path[run[share[run].argmin()]]))
    doubts = [f"the curve turns back at node {node}" for node in sorted(found)[:MOST_NAMED]]
    return doubts + [f"and at {len(found) - MOST_NAMED} more"] * (len(found) > MOST_NAMED)


def _overlaps(
    shape: Enclosure,
    vertices: np.ndarray,
    edges: np.ndarray,
    node_of_vertex: np.ndarray | None,
    is_joined: bool,
    lids: np.ndarray | tuple[int, ...],
) -> list[str]:
    """The doubts about a surface whose solid it does not bound everywhere, as parts of it are inside, and about specks
    beside or inside the solid, whose limbs are none."""
    node = np.asarray(spatial.KDTree(vertices).query(shape.vertices)[1]) if node_of_vertex is None else node_of_vertex
    length = np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1)
    doubts = []
    if num := len(crossings.apart_pairs(shape, lids, node, shape.clearance(vertices), edges, length)):
        least = "at least " if shape.crossed.is_cut else ""
        doubts.append(
            f"the surface crosses itself, in {least}{counted(num, 'pair')} of triangles: radii count "
            "walls inside the solid, and loops may be missing" + '; repair="join" makes one solid' * (not is_joined)
        )
    elif num := len(crossings.passed(shape, vertices, edges)):
        doubts.append(
            f"the curve passes through the surface in {counted(num, 'edge')}, where parts of the surface touch: "
            "what is between them may be left out"
        )
    solids = bodies(shape)
    if len(solids) > 1:
        outside = (np.unique(shape.faces[body.outside], return_inverse=True) for body in solids)
        parts = [Enclosure(shape.vertices[used], corners.reshape(-1, 3)) for used, corners in outside]
        if num := int(specks(parts).sum()):
            what = "part is a speck, which has" if num == 1 else "parts are specks, which have"
            doubts.append(f"{num} {what} no limbs: repair=True leaves specks out")
    if num := sum(body.is_within for body in solids):
        which = "a solid is inside another" if num == 1 else f"{num} solids are inside others"
        doubts.append(f"{which} and wound outwards, too: it is taken as full; a cavity is wound inwards")
    return doubts


def bare_ends(solid: Solid, vertices: np.ndarray, edges: np.ndarray) -> tuple[str, ...]:
    """The notes about flat round ends of limbs, with walls across them all around, that have no end of the curve within
    their radius: they are short for it, as caps of vessels can be."""
    shape, x = solid.shape, solid.enter(vertices)
    face, other = np.arange(3 * len(shape.faces)) // 3, shape.mesh.twins // 3
    is_flat = (shape.normals[face] * shape.normals[other]).sum(axis=1) > 1 - RESOLUTION
    group = graphs.labels(len(shape.faces), face[is_flat], other[is_flat])
    some = np.flatnonzero(np.bincount(group)[group] >= 4)  # a hexagon has four triangles, 0.83 of the disc around it
    group, corners = group[some], shape.triangles[some]
    area, reach = triangle_areas(corners), np.zeros(group.max(initial=-1) + 1)
    whole = np.bincount(group, area)
    middle = np.stack([np.bincount(group, area * axis) for axis in shape.centroids[some].T], axis=1)
    away = corners - (middle / np.maximum(whole, 1e-300)[:, None])[group][:, None]
    np.maximum.at(reach, group, np.linalg.norm(away, axis=2).max(axis=1))
    tree, ends, found = spatial.KDTree(x), x[leaves_of(edges)], []
    for number in np.flatnonzero(whole > 0.8 * np.pi * reach**2):
        (lid,) = lids_of(shape.vertices, shape.faces, some[group == number])
        away = lid.rim - lid.middle  # the walls of a limb are inside of its rim, those of a pocket outside
        away = away[np.linalg.norm(away, axis=1) > 0.9 * lid.reach]
        beside = lid.middle + 1.1 * away - 0.1 * lid.reach * lid.normal
        near = int(tree.query(lid.middle)[1])
        is_bare = (np.linalg.norm(ends - lid.middle, axis=1) > lid.radius()).all()
        is_thick = shape.clearance(x[[near]])[0] > 0.4 * lid.radius()  # beside the middle of a stool's plate it is not
        if is_bare and is_thick and not shape.contains(beside).any() and is_end(shape, lid):
            place = "({:.4g}, {:.4g}, {:.4g})".format(*solid.leave(lid.middle))
            found.append(f"the flat end at {place} has no branch, as it is short for its radius")
    return tuple(found)


def shares_of(
    shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, node_of_vertex: np.ndarray | None = None
) -> dict[str, float]:
    """The report's ``in_sheets``, ``unexplained`` and ``elongation`` of a curve ``(vertices (N, 3), edges (E, 2))`` in
    the solid ``shape``. ``node_of_vertex`` (V,) is the node of each of its vertices; the nearest one if not given."""
    radius = shape.clearance(vertices)
    paths = branches.paths_of(vertices, edges, np.zeros(len(vertices), dtype=bool))
    length, degree = graphs.lengths(vertices, edges), graphs.degrees(len(vertices), edges)
    own = np.bincount(edges.ravel(), np.repeat(length, 2), len(vertices))
    own[degree != 2] = 0.0  # a junction has no cross-section, and the ball of an end is small
    asked = np.flatnonzero(own * radius > 0)
    normal = unit(branches.chords(vertices, paths, radius) @ vertices)[asked] if paths else vertices[asked]
    found = sections.cut(shape, vertices[asked], normal, radius[asked])
    # Where a limb begins, a plane across it cuts off the trunk's side, and a ball beside an axis is small: a section is
    # wider than the ball there, and not flat. In the middle of a round section of a shell is a void. Next to its inner
    # wall, the void is beside the curve, and the section is a wall around it.
    is_flat = (found.radius > FLAT_SECTION * found.size) | ~shape.contains(found.centroid)
    is_wide = (found.radius > SHEET * radius[asked]) & is_flat | ~found.is_found
    known = own[asked] * np.isin(np.arange(len(asked)), found.corners.loop)
    in_sheets = float(known[is_wide].sum() / max(known.sum(), 1e-300))
    area, traced = np.full(len(vertices), np.nan), graphs.trace(len(vertices), edges)
    area[asked] = np.where(found.is_found, found.area, np.nan)
    volume = volumes_of(shape, vertices, traced, radius, node_of_vertex)
    unexplained = elongation = 0.0
    for nodes, within in zip(map(np.array, traced), volume.tolist(), strict=True):
        along = arc_length(vertices[nodes])
        begin, end = np.where(degree[nodes[[0, -1]]] > 2, radius[nodes[[0, -1]]], 0.0)  # the balls of junctions
        is_known = (along >= begin) & (along <= along[-1] - end) & (area[nodes] > 0)
        if is_known.any():
            areas = area[nodes[is_known]]
            mean = np.average(areas, weights=np.gradient(along)[is_known])
            # Where parts overlap, the volume beside a branch may be negative: nothing of it is explained.
            explained = max(within, 0.0) / min(np.median(areas), mean)
            unexplained += max(float(along[-1] - begin - end - explained), 0.0)
        thickness = 2 * float(np.median(radius[nodes]))
        elongation = max(elongation, float(along[-1]) / thickness if thickness > ROUNDING else 0.0)
    unexplained /= max(float(length.sum()), 1e-300)
    return {"in_sheets": in_sheets, "unexplained": unexplained, "elongation": elongation}
