"""Validation: read a mesh, check it, make the repairs that are never in doubt, refuse other faults with a message.

A valid surface is closed, consistently oriented outwards, manifold at edges and vertices, and encloses a volume. The
repairs made here are listed in the report: coincident vertices of an open mesh are welded, vertices without a face
dropped, components that are inside out flipped, vertices where several fans meet split into one per fan.
"""

from dataclasses import dataclass, replace

import numpy as np
from scipy import spatial

from msf_jax.base.errors import MeshError
from msf_jax.meshes.reading import OR_REPAIR, MeshLike, count, read
from msf_jax.meshes.repair import (
    FEWEST_TO_JOIN,
    FEWEST_VERTICES,
    NO_VOLUME,
    Repair,
    as_repair,
    cut_apart,
    has_corner_twice,
    repaired,
    with_volume,
)
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import signed_volume
from msf_jax.solid.solid import nested
from msf_jax.topology import graphs
from msf_jax.topology.graphs import by_label, edge_codes, half_edges


@dataclass(frozen=True)
class Component:
    """One closed connected surface.

    vertices: (V, 3) float64, the caller's units. faces: (F, 3). genus: handles. cavities: vertices (W, 3) and faces of
    those inside it, wound inwards. cavity_genus: their handles, around which a curve of the solid has loops, too."""

    vertices: np.ndarray
    faces: np.ndarray
    genus: int
    cavities: tuple[np.ndarray, np.ndarray] | None = None
    cavity_genus: int = 0


@dataclass(frozen=True)
class Surface:
    """A checked input.

    vertices: (V, 3) and faces: (F, 3) of the whole repaired surface, in the caller's units.
    components: its parts, whose vertices are ``vertices[members[c]]``, and their cavities' ``vertices[linings[c]]``.
    vertex_of_input: (V_in,) the vertex for each of the caller's; -1 if it is in no face, or inside joined parts.
    input_of_vertex: (V,) the caller's vertex for each; the first of several welded ones, and for one that ``is_made``
        (V,) by repair the nearest one, or that of the extruded rim.
    strays: (S, 3) the caller's vertices without a vertex here, in the caller's order.
    repairs: the changes, one sentence each. given: vertices and faces of the caller's mesh.
    rims: the caller's vertices around each filled hole. num_left_out: pieces beyond ``Repair.most_parts``.
    joined_handles: handles that the solid has and the parts that were joined had not; None if none were to be joined.
    """

    vertices: np.ndarray
    faces: np.ndarray
    components: tuple[Component, ...]
    members: tuple[np.ndarray, ...]
    linings: tuple[np.ndarray, ...]
    vertex_of_input: np.ndarray
    input_of_vertex: np.ndarray
    is_made: np.ndarray
    strays: np.ndarray
    repairs: tuple[str, ...]
    given: tuple[np.ndarray, np.ndarray]
    rims: tuple[np.ndarray, ...] = ()
    num_left_out: int = 0
    joined_handles: int | None = None

    @property
    def genus(self) -> int:
        """Handles of all solids, those of their cavities included."""
        return sum(component.genus + component.cavity_genus for component in self.components)

    def first(self, num: int) -> "Surface":
        """The surface of the first ``num`` components only."""
        rows = np.sort(np.concatenate([*self.members[:num], *self.linings[:num]]))
        number = np.full(len(self.vertices) + 1, -1)
        number[rows] = np.arange(len(rows))
        vertex_of_input = number[self.vertex_of_input]
        return replace(
            self,
            vertices=self.vertices[rows],
            faces=number[self.faces[number[self.faces[:, 0]] >= 0]],
            components=self.components[:num],
            members=tuple(number[member] for member in self.members[:num]),
            linings=tuple(number[lining] for lining in self.linings[:num]),
            vertex_of_input=vertex_of_input,
            input_of_vertex=self.input_of_vertex[rows],
            is_made=self.is_made[rows],
            strays=self.given[0][vertex_of_input < 0],
            rims=tuple(rim for rim in self.rims if (vertex_of_input[rim] >= 0).all()),
        )


def prepare(mesh: "MeshLike", repair: bool | str | Repair = False) -> Surface:
    """Read and check ``mesh``, and repair it as ``repair`` says. The caller's object is not changed.

    Raises:
        MeshError: the message says what was found, how often and where first, and what to do about it.
        ConfigError: ``repair`` is none of True, False, "join" and a `Repair`.
    """
    wanted = as_repair(repair)
    vertices, faces = read(mesh)
    if wanted is None:
        return _checked(vertices, faces)
    done = repaired(vertices, faces, wanted)
    try:
        if wanted.join is None:
            checked = _checked(done.vertices, done.faces)
        else:
            checked = _joined(done.vertices, done.faces, wanted.join)
    except MeshError as error:
        raise MeshError(f"after repair, {str(error).replace(OR_REPAIR, ', or let Repair do more')}") from error
    target = np.where(done.vertex_of_given < 0, -1, checked.vertex_of_input[done.vertex_of_given])
    source = done.source[checked.input_of_vertex]
    is_made = checked.is_made | done.is_made[checked.input_of_vertex]
    left = np.flatnonzero(~is_made & (target[source] < 0))  # kept copies of vertices that repair doubled
    target[source[left]] = left
    return replace(
        checked,
        vertex_of_input=target,
        input_of_vertex=source,
        is_made=is_made,
        strays=vertices[target < 0],
        repairs=done.repairs + checked.repairs,
        given=(vertices, faces),
        rims=done.rims,
        num_left_out=done.num_left_out,
    )


def _joined(vertices: np.ndarray, faces: np.ndarray, reach: float) -> Surface:
    """The checked surface after joining closed parts; see `joining`."""
    from msf_jax.meshes import joining  # imported here, because most runs join nothing

    parts = _checked(vertices, faces, is_joined=False)
    done = joining.joined([_with_cavities(part) for part in parts.components], reach)
    faces, crumbs, _ = with_volume(done.vertices, done.faces)
    if len(faces) == 0:
        raise MeshError(f"no part has the {FEWEST_VERTICES} vertices and the volume that a solid needs")
    used, corners = np.unique(faces, return_inverse=True)
    checked = _checked(done.vertices[used], corners.reshape(-1, 3))
    every = [each for pair in zip(parts.members, parts.linings, strict=True) for each in pair]
    member = np.concatenate(every)  # the parts' vertices, in the order in which `joining` counts them
    source = done.source[used][checked.input_of_vertex]
    is_made = source < 0
    source[is_made] = source[~is_made][spatial.KDTree(checked.vertices[~is_made]).query(checked.vertices[is_made])[1]]
    number = np.full(len(done.vertices) + 1, -1)
    number[used] = checked.vertex_of_input
    target = np.full(len(parts.vertices) + 1, -1)
    target[member] = number[done.vertex_of_part]
    return replace(
        checked,
        vertex_of_input=target[parts.vertex_of_input],
        input_of_vertex=parts.input_of_vertex[member[source]],
        is_made=is_made,
        repairs=(*parts.repairs, *done.repairs, *crumbs, *checked.repairs),
        joined_handles=max(checked.genus - parts.genus, 0),
    )


def _with_cavities(part: Component) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of a part and its cavities."""
    if part.cavities is None:
        return part.vertices, part.faces
    vertices, faces = part.cavities
    return np.concatenate([part.vertices, vertices]), np.concatenate([part.faces, faces + len(part.vertices)])


def _checked(vertices: np.ndarray, faces: np.ndarray, is_joined: bool = True) -> Surface:
    """The surface of a valid mesh, after the repairs that are never in doubt.

    If not ``is_joined``, its parts will be joined later: then they may be smaller."""
    given = vertices, faces
    repairs: list[str] = []
    vertex_of_input = np.arange(len(vertices))
    caller_number = np.arange(len(vertices))
    bad = np.flatnonzero(has_corner_twice(faces))
    if len(bad):
        raise MeshError(f"{count(bad, 'face', 'faces')} degenerate (a corner occurs twice): remove them{OR_REPAIR}")
    twin = half_edges(faces).twin
    if (twin < 0).any():
        vertices, faces, welded, vertex_of_input = _weld(vertices, faces)
        twin = half_edges(faces).twin
        if welded:
            repairs.append(f"welded {welded} duplicate {'vertex' if welded == 1 else 'vertices'}")
            caller_number = np.unique(vertex_of_input, return_index=True)[1]
    _check_edges(faces, twin, caller_number)

    strays = np.empty((0, 3))
    used = np.zeros(len(vertices), dtype=bool)
    used[faces] = True
    if not used.all():
        num = int((~used).sum())
        repairs.append(f"left out vertices that no face uses: {num} (mapped to the node nearest to them)")
        number = np.where(used, np.cumsum(used) - 1, -1)
        strays = vertices[vertex_of_input[number[vertex_of_input] < 0]]
        vertices, faces, vertex_of_input = vertices[used], number[faces], number[vertex_of_input]
        caller_number = caller_number[used]

    vertices, faces, owner = _split_pinches(vertices, faces, twin)
    input_of_vertex = np.concatenate([caller_number, caller_number[owner]])
    pinches = len(np.unique(owner))
    if pinches:
        repairs.append(f"split {pinches} pinched {'vertex' if pinches == 1 else 'vertices'} into one per fan")

    label = graphs.labels_of_faces(faces, len(vertices))
    members, faces_of = by_label(label), by_label(label[faces[:, 0]])
    fewest = FEWEST_VERTICES if is_joined else FEWEST_TO_JOIN
    local = np.empty(len(vertices), dtype=np.int64)
    parts, names = [], []
    for number, (member, mine) in enumerate(zip(members, faces_of, strict=True)):
        local[member] = np.arange(len(member))
        first = caller_number[min(member[0], len(caller_number) - 1)]
        names.append("the mesh" if len(members) == 1 else f"component {number} (the one with vertex {first})")
        parts.append(_component(vertices[member], local[faces[mine]], names[-1], fewest))
    volume = np.array([size for _, size in parts])
    owner, _ = nested([Enclosure(part.vertices, part.faces) for part, _ in parts], volume)
    is_cavity = owner != np.arange(len(parts))
    is_flipped = (volume < 0) != is_cavity
    for number in np.flatnonzero(is_flipped).tolist():
        faces[faces_of[number]] = faces[faces_of[number]][:, ::-1]
    if is_joined:
        repairs += [f"flipped {names[k]}, which was inside out" for k in np.flatnonzero(is_flipped).tolist()]
        hollow = "is a cavity in another component: it has no curve of its own"
        repairs += [f"{names[k]} {hollow}" for k in np.flatnonzero(is_cavity).tolist()]
    elif is_flipped.any():
        flipped = "part that was" if is_flipped.sum() == 1 else "parts that were"
        repairs.append(f"flipped {is_flipped.sum()} {flipped} inside out")
    components, linings = [], []
    for number in np.flatnonzero(~is_cavity).tolist():
        within = np.flatnonzero(is_cavity & (owner == number)).tolist()
        linings.append(np.concatenate([members[0][:0], *(members[k] for k in within)]))
        part = parts[number][0]
        if within:
            local[linings[-1]] = np.arange(len(linings[-1]))
            hollow = vertices[linings[-1]], local[np.concatenate([faces[faces_of[k]] for k in within])]
            part = replace(part, cavities=hollow, cavity_genus=sum(parts[k][0].genus for k in within))
        components.append(part)
    return Surface(
        vertices=vertices,
        faces=faces,
        components=tuple(components),
        members=tuple(members[number] for number in np.flatnonzero(~is_cavity)),
        linings=tuple(linings),
        vertex_of_input=vertex_of_input,
        input_of_vertex=input_of_vertex,
        is_made=np.zeros(len(vertices), dtype=bool),
        strays=strays,
        repairs=tuple(repairs),
        given=given,
    )


def _weld(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray, int, np.ndarray]:
    """Merge exactly coincident vertices, and drop the faces that become degenerate."""
    _, first, inverse = np.unique(vertices, axis=0, return_index=True, return_inverse=True)
    inverse = inverse.ravel()
    order = np.argsort(first, kind="stable")  # keep the caller's order
    number = np.argsort(order)
    welded = number[inverse][faces]
    return vertices[first[order]], welded[~has_corner_twice(welded)], len(vertices) - len(first), number[inverse]


def _check_edges(faces: np.ndarray, twin: np.ndarray, caller_number: np.ndarray) -> None:
    """Raise a `MeshError` unless every edge has two faces of consistent orientation, whose half-edges are each other's
    ``twin`` (3F,). ``caller_number`` are the caller's ids of vertices, for messages."""
    if len(faces) == 0:
        raise MeshError("no face is left once coincident vertices are welded: the mesh is degenerate")
    # Half-edges that occur several times have one twin, whose twin is at most one of them, and may be no number at all.
    if ((twin >= 0) & (twin[twin % len(twin)] == np.arange(len(twin)))).all():
        return
    edge, _, count = edge_codes(faces)
    origin, target = faces.ravel(), faces[:, [1, 2, 0]].ravel()

    def say(bad: np.ndarray) -> str:
        half = [np.flatnonzero(edge == each)[0] for each in bad[:5]]
        shown = ", ".join("{}-{}".format(*caller_number[sorted((origin[k], target[k]))]) for k in half)
        return f"{len(bad)} {'edge' if len(bad) == 1 else 'edges'} ({shown}{', ...' if len(bad) > 5 else ''})"

    crowded, single = np.flatnonzero(count > 2), np.flatnonzero(count == 1)
    if len(crowded):
        also = f", and open: {say(single)} with only one face" if len(single) else ""
        close = " and close the holes" if len(single) else ""
        raise MeshError(
            f"not manifold: {say(crowded)} with more than two faces{also}: "
            f"separate the sheets that meet there{close}{OR_REPAIR}"
        )
    if len(single):
        raise MeshError(
            f"the mesh is open: {say(single)} with only one face: close its holes first, "
            f"for example with trimesh.repair.fill_holes{OR_REPAIR}"
        )
    odd = np.flatnonzero(np.bincount(edge, weights=origin < target) != 1)
    if len(odd):
        raise MeshError(
            f"not consistently oriented: {say(odd)} run the same way in both faces: "
            f"orient the faces first, for example with trimesh.repair.fix_winding{OR_REPAIR}"
        )


def _split_pinches(
    vertices: np.ndarray, faces: np.ndarray, twin: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """One vertex per fan: the first fan keeps the vertex's id, the others get new vertices at the end. Returns
    vertices, faces, and the old vertex for each new one."""
    parted, source = cut_apart(faces, twin)
    if len(source) == len(vertices):
        return vertices.copy(), faces.copy(), source[:0]
    extra = np.flatnonzero(np.append(False, source[1:] == source[:-1]))
    extra = extra[np.argsort(np.unique(parted, return_index=True)[1][extra])]  # in the order of their first corners
    number = source.copy()
    number[extra] = len(vertices) + np.arange(len(extra))
    return np.concatenate([vertices, vertices[source[extra]]]), number[parted], source[extra]


def _component(vertices: np.ndarray, faces: np.ndarray, name: str, fewest: int) -> tuple[Component, float]:
    """The part as a solid, wound outwards, and its signed volume as given."""
    if len(vertices) < fewest:
        what = "is a tetrahedron" if len(vertices) == 4 else f"has {len(vertices)} vertices"
        raise MeshError(
            f"{name} {what}: expected at least {fewest} vertices; subdivide it if it should have a skeleton"
        )
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    size = float((high - low).max())
    volume = signed_volume((vertices - (low + high) / 2) / size, faces) if size > 0 else 0.0
    if not abs(volume) > NO_VOLUME:
        raise MeshError(
            f"{name} encloses no volume ({volume:.3g} of the cube of its extent, {size:.3g}): expected a solid"
        )
    if volume < 0:
        faces = faces[:, ::-1]
    euler = len(vertices) - len(faces) // 2
    return Component(vertices, faces, (2 - euler) // 2), volume * size**3
