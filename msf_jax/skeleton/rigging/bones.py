"""Bones from a curve: the joints, the parent of each bone, and its part of the curve.

A bone begins at its joint, about which it turns. The root's joint is at the thickest junction; its part of the curve is
inside the ball there. Each branch at a junction begins with its own joint, where it leaves the junction's ball, as an
arm leaves a shoulder. So each limb turns on its own. A branch has more bones where it bends most, or where it is long.

In a shape with a mirror plane both sides have the same joints and cuts: those of the mean of a branch and its mirror
image. The root is then where limbs come in pairs, see `rooting`.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.curve import branches
from msf_jax.skeleton.rigging import biped, cutting, girdles, mirror, rooting
from msf_jax.solid.geometry import arc_length, at
from msf_jax.topology import graphs

LEAST_LIMB = 0.6  # radii of the junction's ball: a limb that sticks out of the ball by less has no bone
FOR_LIMBS = 0.6  # share of all bones for the first bones of branches, at most; the rest is for bends


class Bones(NamedTuple):
    """B bones, parents before children.

    joints: (B, 3) the start of each, about which it turns. tails: (B, 3) the end. parents: (B,) -1 for a root. branch:
    (B,) the branch of the curve, -1 for a root. place: (B,) the position along the branch, from 0. is_limb: (B,)
    whether the branch ends in a tip.
    twin: (B,) the bone that is the mirror image, -1 without one. side: (B,) 1 on the left, -1 on the right, and 0
    without a twin. is_spine: (B,) whether it is of a spine. role: (B,) of a biped's bone, see
    `biped`, or "". of_node: (N,) the bone of every node of the curve.
    """

    joints: np.ndarray
    tails: np.ndarray
    parents: np.ndarray
    branch: np.ndarray
    place: np.ndarray
    is_limb: np.ndarray
    twin: np.ndarray
    side: np.ndarray
    is_spine: np.ndarray
    role: np.ndarray
    of_node: np.ndarray


def bones_of(
    vertices: np.ndarray,
    edges: np.ndarray,
    radii: np.ndarray,
    most: int,
    size: np.ndarray | None = None,
    held: np.ndarray | None = None,
    for_limbs: float = FOR_LIMBS,
    fill: bool = False,
    is_biped: bool = False,
) -> Bones:
    """At most ``most`` bones for a curve ``(vertices (N, 3), edges (E, 2))`` with balls of ``radii`` (N,). If there are
    too many components, the longest have bones.

    Args:
        size: (N,) of the limbs; the radii unless given.
        held: (N,) the number of the mesh's vertices at each node; any number unless given.
        for_limbs: the share of ``most`` for the first bones of branches, at most.
        fill: as many bones as there is length for, up to ``most``, also where nothing is bent or long.
        is_biped: whether the joints are those of a biped.

    Raises:
        ConfigError: a biped was asked for, and this is none.
    """
    size = radii if size is None else size
    held = np.full(len(vertices), cutting.FEWEST_HELD) if held is None else held
    tips = np.flatnonzero(graphs.degrees(len(vertices), edges) == 1)  # without those that cuts make
    edges = edges[branches.cut_loops(len(vertices), edges, size)]
    plane = mirror.mirror_of(vertices, edges, tips)
    body = girdles.body_of(vertices, edges, radii, tips, plane)
    stays, target = _limbs(vertices, edges, radii, max(1, int(for_limbs * most)), plane)
    vertices, edges, size, met = _met(vertices, edges[stays[edges].all(axis=1)], size, radii, plane, body)
    stays, target = stays & (met == np.arange(len(met))), met[target]
    body = body._replace(girdles=[int(met[node]) for node in body.girdles if stays[met[node]]])
    roots, paths = rooting.paths_of(vertices, edges, size, stays, most, plane, body)
    plan = biped.plan(paths, body, plane, len(roots)) if is_biped else biped.Plan({}, {}, False)
    cuts = cutting.cuts_of(paths, most - len(roots), held, fill, plan.stops)
    role: list[str] = []
    joints, tails, parents, branch, place, is_limb, side, is_spine = [], [], [], [], [], [], [], []
    of_node, last, first_of = np.full(len(vertices), -1), {}, {}
    for number, root in enumerate(roots):
        joints.append(root.joint)
        tails.append(root.tail)
        parents.append(-1)
        branch.append(-1)
        place.append(0)
        is_limb.append(False)
        side.append(0)
        is_spine.append(False)
        role.append("hips" if is_biped and number == 0 else "")
        of_node[root.node] = number
        last[root.node] = number  # maps the last node of a branch to its last bone
    for number, (path, stops) in enumerate(zip(paths, cuts, strict=True)):
        above = last[int(path.nodes[0])]
        first_of[number] = first = len(joints)
        ends = at(path.line, path.stops, stops)
        for k in range(len(stops) - 1):
            joints.append(ends[k])
            tails.append(ends[k + 1])
            parents.append(above if k == 0 else len(joints) - 2)
            branch.append(number)
            place.append(k)
            is_limb.append(path.is_limb)
            side.append(-path.side if plan.is_swapped else path.side)
            role.append(plan.roles[number][k] if number in plan.roles else "")
            is_spine.append(path.is_spine)
        piece = np.minimum(np.searchsorted(stops, path.part, side="right") - 1, len(stops) - 2)
        own = np.where(piece < 0, above, first + piece)
        of_node[path.nodes[1:]] = own[1:]
        last[int(path.nodes[-1])] = int(own[-1])
    twin = np.full(len(joints), -1)
    for bone in range(len(roots), len(joints)):
        if side[bone]:
            twin[bone] = first_of[paths[branch[bone]].image] + place[bone]
    known = np.flatnonzero(of_node >= 0)
    lost = np.flatnonzero((of_node < 0) & stays)  # nodes of components without a bone
    if len(lost):
        away = np.linalg.norm(vertices[lost][:, None] - vertices[known], axis=2)
        of_node[lost] = of_node[known[away.argmin(axis=1)]]
    columns = [
        np.array(column) for column in (joints, tails, parents, branch, place, is_limb, twin, side, is_spine, role)
    ]
    found = Bones._make([*columns, of_node[target]])
    while len(found.joints) > most:  # a junction of more limbs than that
        length = np.linalg.norm(found.tails - found.joints, axis=1)
        found = without(found, int(np.where((found.parents < 0) | (found.role != ""), np.inf, length).argmin()))[0]
    return found


def without(bones: Bones, bone: int) -> tuple[Bones, np.ndarray]:
    """The bones without ``bone``, which is no root, and the new number (B,) of every old bone; that of ``bone`` is the
    number of its heir.

    The first bone of a branch is joined to the next one of the branch, so that the branch still begins at its root.
    Another one is joined to its parent.
    """
    columns = bones._replace(**{name: value.copy() for name, value in bones._asdict().items()})
    joints, tails, parents, branch, place = columns[:5]
    is_next = (branch == branch[bone]) & (place == place[bone] + 1)
    if place[bone] == 0 and is_next.any():
        heir = int(is_next.argmax())
        joints[heir], parents[heir] = joints[bone], parents[bone]
    else:
        heir = int(parents[bone])
        if branch[heir] == branch[bone]:
            tails[heir] = tails[bone]
    place[(branch == branch[bone]) & (place > place[bone])] -= 1
    if columns.twin[bone] >= 0:  # the other side has its twin taken away
        columns.twin[columns.twin[bone]] = -1
    stays = np.arange(len(parents)) != bone
    rank = np.cumsum(stays) - 1
    rank[bone] = rank[heir]
    moved = [np.where(values < 0, -1, rank[values]) for values in (parents, columns.twin)]
    columns = columns._replace(parents=moved[0], twin=moved[1])
    kept = [values[stays] for values in columns[:-1]]
    return Bones._make([*kept, rank[columns.of_node]]), rank


def _met(
    vertices: np.ndarray,
    edges: np.ndarray,
    size: np.ndarray,
    radii: np.ndarray,
    plane: mirror.Mirror | None,
    body: girdles.BodyGirdles,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Join junctions with no length for a bone between them: how many of them a hand or a head has is chance.

    The pelvis and the shoulders stay where they are; others are joined in their middle, with their largest ``size``
    (N,). Mirror images stay or go together. Returns vertices, edges, sizes, and the node that replaces each (N,).
    """
    vertices, size, target = vertices.copy(), size.copy(), np.arange(len(vertices))
    of_place, body_ends = vertices.copy(), {end for end in (body.pelvis, body.shoulders) if end is not None}
    junctions = graphs.degrees(len(vertices), edges) > 2
    while True:
        degree = graphs.degrees(len(vertices), edges)
        trunks = [np.array(nodes) for nodes in graphs.trace(len(vertices), edges)]
        trunks = [
            nodes
            for nodes in trunks
            if (degree[nodes[[0, -1]]] > 2).all() and not body_ends.issuperset(nodes[[0, -1]].tolist())
        ]
        length = np.array([_between(vertices, size, radii, nodes) for nodes in trunks])
        if not (length < 1).any():
            return vertices, edges, size, target
        one = int(length.argmin())
        middle = np.stack([vertices[nodes[[0, -1]]].mean(axis=0) for nodes in trunks])
        other = one if plane is None else int(mirror.images(plane, middle)[one])
        for number in {one, other} - {-1}:
            ends = target[trunks[number][[0, -1]]]
            joined = np.isin(target, np.r_[ends, trunks[number]])
            held = body_ends.intersection(ends.tolist())
            own = held.pop() if held else int(ends[size[ends].argmax()])
            target[joined] = own
            size[own] = size[ends].max()
            if own not in body_ends:
                vertices[own] = of_place[joined & junctions].mean(axis=0)
        edges = np.unique(np.sort(target[edges], axis=1), axis=0)
        edges = edges[edges[:, 0] != edges[:, 1]]


def _between(vertices: np.ndarray, size: np.ndarray, radii: np.ndarray, nodes: np.ndarray) -> float:
    """The length of a branch outside the larger ball at its ends, over the least length of a bone."""
    length = float(arc_length(vertices[nodes])[-1])
    start = min(float(size[nodes[[0, -1]]].max()), rooting.LEAVES * length)
    return (length - start) / max(rooting.SHORTEST * float(np.percentile(radii[nodes], rooting.USUAL)), 1e-300)


def _limbs(
    vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, most: int, plane: mirror.Mirror | None
) -> tuple[np.ndarray, np.ndarray]:
    """Remove limbs that are too short for a bone, then the shortest limbs until there are ``most`` branches. A limb's
    length counts from the ball at its junction; mirror images stay or go together. Returns which nodes stay (N,), and
    the node that replaces each (N,)."""
    target = np.arange(len(vertices))
    paths = dict(enumerate(graphs.trace(len(vertices), edges)))
    at_end: dict[int, set[int]] = {}
    for number, nodes in paths.items():
        for end in {nodes[0], nodes[-1]}:
            at_end.setdefault(end, set()).add(number)
    length = {number: arc_length(vertices[nodes])[-1] for number, nodes in paths.items()}

    def reach(tip: int) -> tuple[float, float]:
        """How far the limb of a tip sticks out of the ball at its junction, and the radius of that ball; infinite for a
        branch without a junction."""
        number = next(iter(at_end[tip]))
        junction = paths[number][0] if paths[number][-1] == tip else paths[number][-1]
        if len(at_end[junction]) < 3:
            return np.inf, 0.0
        return length[number] - radii[junction], radii[junction]

    def remove(tip: int) -> None:
        number = at_end.pop(tip).pop()
        nodes = paths.pop(number)
        junction = nodes[0] if nodes[-1] == tip else nodes[-1]
        target[[node for node in nodes if node != junction]] = junction
        at_end[junction].discard(number)
        if len(at_end[junction]) == 2:  # it is no longer a junction: its two branches become one
            a, b = sorted(at_end.pop(junction))
            one = paths[a] if paths[a][-1] == junction else paths[a][::-1]
            other = paths[b] if paths[b][0] == junction else paths[b][::-1]
            paths[a] = one + other[1:]
            length[a] += length[b]
            del paths[b]
            for end in {paths[a][0], paths[a][-1]}:
                at_end[end] = (at_end[end] - {b}) | {a}

    tips = np.flatnonzero(graphs.degrees(len(vertices), edges) == 1)
    image = np.arange(len(tips)) if plane is None else mirror.images(plane, vertices[tips])
    pair = {int(tip): {int(tip), int(tips[k])} if k >= 0 else {int(tip)} for tip, k in zip(tips, image, strict=True)}
    while True:
        far = {tip: reach(tip) for tip in pair if tip in at_end}
        mean = {tip: np.mean([far[each] for each in pair[tip] if each in far], axis=0) for tip in far}
        short = {tip: each for tip, each in mean.items() if each[0] < LEAST_LIMB * each[1]}
        if not short and len(paths) <= most:
            break
        least, tip = min(((float(each[0]), tip) for tip, each in (short or mean).items()), default=(np.inf, 0))
        if least == np.inf:
            break
        for each in pair[tip]:
            if each in at_end and reach(each)[0] < np.inf:
                remove(each)
    while (target[target] != target).any():
        target = target[target]
    return target == np.arange(len(vertices)), target
