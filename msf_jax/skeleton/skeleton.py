"""`Skeleton`, the result of a run: a curve with radii, a map from the input's vertices, and a `Report`.

Its verbs give other curves of the same mesh. What else can be made of a skeleton are functions in other modules, which
its methods import when they are called.
"""

import numbers
import os
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from scipy import sparse, spatial

from msf_jax import metrics
from msf_jax.base import binding as bindings
from msf_jax.base.errors import ConfigError
from msf_jax.base.writing import counted, write_whole
from msf_jax.curve import finishing
from msf_jax.device import following
from msf_jax.device.buffers import real_dtype
from msf_jax.limbs import one_branch
from msf_jax.limbs.tree import LimbTree
from msf_jax.meshes.reading import MeshLike
from msf_jax.recording.following import BoundSurface, record
from msf_jax.skeleton import centrelines, pruning, resampling, trees
from msf_jax.skeleton.report import Report, assessed
from msf_jax.solid.geometry import arc_length
from msf_jax.solid.solid import Solid
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from plotly.graph_objects import Figure as PlotlyFigure

    from msf_jax.skeleton.framing import Frame
    from msf_jax.skeleton.rigging.rig import Rig

SOMA_REACH = 4.0  # radii of the thickest ball: nodes within this distance may belong to the soma
STANDS_OUT = 1.5  # least ratio of a soma's radius to the largest radius farther away
TIP_REACH = 2.0  # radii of the node nearest to a point: a tip within this length of the branch is meant
THICK = 4.0  # least ratio of a soma's radius to the median radius


class Stage(NamedTuple):
    """The surface after some iterations of the flow, in the caller's units, for pictures. iteration: their number.
    vertices: (n, 3). faces: (m, 3) int32. is_fixed: (n,)."""

    iteration: int
    vertices: np.ndarray
    faces: np.ndarray
    is_fixed: np.ndarray


@dataclass(frozen=True, eq=False)
class Source:
    """The data that a curve was made from. areas: (V,) share of the surface's area that belongs to each input vertex.
    pins: (k,) input vertices held in place; the first of several welded vertices. stages: some surfaces of the flow,
    from first to last. input_of_vertex: (v,) of each vertex of the solid; None if repair has added some."""

    solid: Solid
    areas: np.ndarray
    pins: np.ndarray
    stages: tuple[Stage, ...] = ()
    input_of_vertex: np.ndarray | None = None

    @cached_property
    def limbs(self) -> LimbTree:
        """The merge trees of the surface, made once for all curves of it."""
        return LimbTree(self.solid.outside)


class Soma(NamedTuple):
    """The thickest place of a curve. node, radius: its node and radius. contrast: its radius over the largest radius
    farther away. is_sure: whether it stands out enough to be a soma; some meshes have no soma, or only its fibre."""

    node: int
    radius: float
    contrast: float
    is_sure: bool


@dataclass(frozen=True, eq=False)
class Skeleton:
    """A curve skeleton.

    Attributes:
        vertices: (N, 3) float64, nodes in the caller's units.
        edges: (E, 2) int, each with its smaller node first, in ascending order.
        radii: (N,) radius of the largest ball around the node that lies inside the surface; 0 for a node outside.
        mesh_map: (V,) int, the node of every input vertex.
        report: the figures of the run, and how far to trust it.
        source: the surface that the curve was made from; without it, a new node has the radius of the nearest old one.
        roots: of a tree that `to_tree` made, the root of each component, the chosen one first.
        openings: nodes at the centres of openings that repair has closed: ends of vessels that were cut.
        radius_of: the kind of ``radii``: "ball", or "section", see `with_radii`.
        units: the name of the unit of length, as in files; "" if it is not known.
    """

    vertices: np.ndarray
    edges: np.ndarray
    radii: np.ndarray
    mesh_map: np.ndarray
    report: Report
    source: Source | None = field(default=None, repr=False)
    roots: tuple[int, ...] = ()
    openings: tuple[int, ...] = ()
    radius_of: str = "ball"
    units: str = ""

    def __repr__(self) -> str:
        cycles = counted(self.report.cycles, "cycle")
        inside = "" if np.isnan(self.report.inside) else f", {100 * self.report.inside:.2f} % inside"
        return f"Skeleton({len(self.vertices)} nodes, {len(self.edges)} edges, {cycles}{inside})"

    @property
    def length(self) -> float:
        """Length of all edges, in the caller's units."""
        return float(graphs.lengths(self.vertices, self.edges).sum())

    @property
    def num_leaves(self) -> int:
        """The number of nodes with one edge."""
        return int((np.bincount(self.edges.ravel()) == 1).sum())

    @property
    def branches(self) -> list[pruning.Branch]:
        """The paths between nodes whose degree is not 2, with their length, slenderness and surface."""
        source = self.source
        share = None if source is None else np.bincount(self.mesh_map, source.areas, len(self.vertices))
        return pruning.measure(self.vertices, self.edges, self._slenderness, share)

    @property
    def known_source(self) -> Source:
        """The ``source``; a `ConfigError` if there is none."""
        if self.source is None:
            raise ConfigError(
                "the skeleton does not know the mesh that it was made from: expected one from skeletonize, or from an "
                ".npz file; save it as .npz"
            )
        return self.source

    @property
    def bound_surface(self) -> BoundSurface:
        """The checked mesh, with the input vertex and the node of each of its vertices; a `ConfigError` without it."""
        source = self.known_source
        if source.input_of_vertex is None:
            raise ConfigError(
                "repair has added vertices to the mesh that the skeleton was made from: expected only the mesh's own "
                'vertices; run skeletonize without repair="join" or extruded rims'
            )
        return BoundSurface(source.solid, source.input_of_vertex, self.mesh_map[source.input_of_vertex])

    @cached_property
    def _slenderness(self) -> np.ndarray | pruning.Worth:
        """(N,) the slenderness of each leaf on the solid's surface, which a run knows; else a function of the balls."""
        if self.source is None:
            return pruning.by_balls(self.vertices, self.radii)
        return one_branch.slenderness(self.source.limbs, self.source.solid.enter(self.vertices), self.edges)

    def prune(self, slenderness: float = 0.5) -> "Skeleton":
        """A new skeleton without the branches of limbs that are less slender, see `Branch`; other limbs keep one each.

        Nothing below 0.5, half a ball, is a limb, unless it stands out at the detail 0.5, as in `Config`; 0 keeps all
        branches. Components, cycles and branches with a pin or an opening are kept. The mesh's vertices of a pruned
        branch go to its junction. Without its mesh, branches go by their balls.

        Raises:
            ConfigError: ``slenderness`` is negative or not a number.
        """
        if not (isinstance(slenderness, numbers.Real) and float(slenderness) >= 0):
            raise ConfigError(f"slenderness is {slenderness!r}: expected a number of 0 or more")
        x, edges, least, is_held = self.vertices, self.edges, float(slenderness), _held(self)
        if self.source is not None and least:
            solid, tree = self.source.solid, self.source.limbs
            leaf, _ = one_branch.choose(tree, tree.limbs(least, 0.5), solid.shape, solid.enter(x), edges, is_held)
            stays, target = one_branch.kept(x, edges, np.isin(np.arange(len(x)), leaf), is_held)
        else:
            stays, target = pruning.prune(len(x), edges, pruning.by_balls(x, self.radii), least, is_held)
        rank = np.cumsum(stays) - 1
        result = changed(self, x[stays], rank[edges[stays[edges].all(axis=1)]], rank[target])
        pruned = self.report.pruned + self.num_leaves - result.num_leaves
        return replace(result, report=replace(result.report, pruned=pruned))

    def resample(self, spacing: float) -> "Skeleton":
        """A new skeleton with nodes about every ``spacing`` along branches, a length. Ends, pins and openings stay. An
        edge that would leave the solid is bisected. A larger spacing never gives more nodes.

        Raises:
            ConfigError: ``spacing`` is not above 0, or would give more than ten million nodes.
        """
        _check_length("spacing", spacing)
        if self.length > 1e7 * float(spacing):
            long = f"spacing is {spacing!r}, and the curve {self.length:.3g} long"
            raise ConfigError(f"{long}: expected at most ten million nodes; is it in the mesh's units?")
        solid = None if self.source is None else self.source.solid
        stops_of = partial(resampling.even_stops, spacing=float(spacing), solid=solid)
        return changed(self, *resampling.resample(self.vertices, self.edges, _held(self), stops_of))

    def simplify(self, tolerance: float) -> "Skeleton":
        """A new skeleton with few nodes, where branches bend (Douglas and Peucker 1973), within ``tolerance`` of this
        one, a length. Ends, pins and roots stay. Edges may leave the solid by up to ``tolerance``.

        Raises:
            ConfigError: ``tolerance`` is not above 0.
        """
        _check_length("tolerance", tolerance)
        is_held = _held(self)
        is_held[list(self.roots)] = True
        stops_of = partial(resampling.corner_stops, tolerance=float(tolerance))
        return changed(self, *resampling.resample(self.vertices, self.edges, is_held, stops_of))

    def to_tree(self, root: Any = None) -> "Skeleton":
        """A new skeleton without loops: each loop is cut at its thinnest edge. ``report.cut`` counts the loops, and
        ``report.notes`` says where they were cut, and whether the soma is sure.

        Args:
            root: id of the node that is the root of its component, or a point (x, y, z) for the node nearest to it; for
                the tip if that node is within two radii of one. Or "soma" (see `soma`). The default is the thickest
                node, as in the other components.

        Raises:
            ConfigError: the curve has no such node.
        """
        num, why = len(self.vertices), ""
        if isinstance(root, str) and root == "soma":
            root, _, contrast, is_sure = self.soma()
            what = "the soma" if is_sure else "the thickest; NOT SURE to be the soma"
            why = f" ({what}: {contrast:.3g} times as thick as the thickest elsewhere)"
        if np.shape(root) == (3,) and np.asarray(root).dtype.kind in "fiu" and np.isfinite(root).all():
            root = int(np.linalg.norm(self.vertices - np.asarray(root), axis=1).argmin())
        is_node = isinstance(root, numbers.Integral) and not isinstance(root, bool) and 0 <= int(root) < num
        if root is not None and not is_node:
            expected = f'a node from 0 to {num - 1}, "soma", or None for the thickest node, or a point (x, y, z)'
            raise ConfigError(f"root is {root!r}: expected {expected}")
        stays = trees.cut_loops(num, self.edges, self.radii)
        edges, gone = self.edges[stays], self.radii[self.edges[~stays]].min(axis=1)
        first = None if root is None else int(root) if why else self._tip_near(int(root))
        roots = trees.roots_of(num, edges, self.radii, first)
        where = f", at radii of {gone.min():.3g} to {gone.max():.3g}" if len(gone) else ""
        place = f"root at node {roots[0]}, of radius {self.radii[roots[0]]:.3g}{why}"
        note = f"a tree: {counted(len(gone), 'loop')} cut where thinnest{where}; {place}"
        loops = None if self.report.loops is None else 0
        return replace(_relinked(self, edges, note, cut=self.report.cut + len(gone), loops=loops), roots=roots)

    def _tip_near(self, node: int) -> int:
        """The nearer tip of the branch that ``node`` is within, if that is within `TIP_REACH` radii; else ``node``."""
        degree = graphs.degrees(len(self.vertices), self.edges)
        for nodes in (np.array(path) for path in graphs.trace(len(self.vertices), self.edges) if node in path[1:-1]):
            along = arc_length(self.vertices[nodes])
            away = np.where(degree[nodes[[0, -1]]] == 1, np.abs(along[[0, -1]] - along[nodes == node]), np.inf)
            if away.min() <= TIP_REACH * self.radii[node]:
                return int(nodes[[0, -1]][away.argmin()])
        return node

    def soma(self) -> Soma:
        """The thickest place, where the soma of a neuron may be, and whether it stands out enough to be sure."""
        is_known = self.radius_of == "ball" or self.source is None
        balls = (self if is_known else self.with_radii("ball")).radii
        node = int(balls.argmax())
        is_elsewhere = np.linalg.norm(self.vertices - self.vertices[node], axis=1) > SOMA_REACH * balls[node]
        radius, elsewhere = float(balls[node]), float(balls[is_elsewhere].max(initial=0.0))
        contrast = radius / elsewhere if elsewhere > 0 else np.inf
        is_sure = bool(elsewhere > 0 and contrast >= STANDS_OUT and radius >= THICK * np.median(balls))
        return Soma(node, radius, contrast, is_sure)

    def heal(self, reach: float = np.inf) -> "Skeleton":
        """A new skeleton with fewer pieces: edges between nearest nodes join pieces over gaps of up to ``reach``, a
        length, and make no loop. ``report.notes`` gives the largest gap.

        Raises:
            ConfigError: ``reach`` is not above 0.
        """
        if reach != np.inf:
            _check_length("reach", reach)
        links = _links(self.vertices, self.edges, float(reach))
        if not len(links):
            return self
        edges, gap = finishing.in_order(np.concatenate([self.edges, links])), graphs.lengths(self.vertices, links).max()
        count = f"{len(links)} {'piece was' if len(links) == 1 else 'pieces were'} joined to the rest"
        note = f"healed: {count}, over gaps of up to {gap:.3g}, outside the mesh"
        expected = max(self.report.mesh_components - len(links), 1)
        return replace(_relinked(self, edges, note, mesh_components=expected), roots=self.roots[:1])

    def with_radii(self, of: str) -> "Skeleton":
        """The same curve with another kind of radii, which saved files then have, too.

        Args:
            of: "ball", of the largest inscribed ball around each node; or "section", of a disc with the area of the
                cross-section there, if it has one. In a flat limb the second is larger.

        Raises:
            ConfigError: ``of`` is neither, or the surface that the curve was made from is not known.
        """
        if of not in ("ball", "section"):
            raise ConfigError(f'of is {of!r}: expected "ball" or "section"')
        with_balls = replace(self, radii=self.known_source.solid.radii(self.vertices), radius_of="ball")
        return with_balls if of == "ball" else _with_sections(with_balls)

    @cached_property
    def binding(self) -> bindings.Binding:
        """The curve as a function of the mesh's vertices, for `msf_jax.follow`: a pytree of NumPy arrays, padded to one
        of few capacities, for each of which a jitted function is compiled once.

        Raises:
            ConfigError: the surface that the curve was made from is not known.
        """
        surface, pins = self.bound_surface, np.asarray(self.known_source.pins, dtype=np.int64)
        pinned = self.mesh_map[pins]
        pins_of_node = {int(node): pins[pinned == node] for node in np.unique(pinned)}
        binding = record(surface, len(self.mesh_map), self.vertices, self.edges, pins_of_node)
        return bindings.padded(binding, bindings.capacity_for(binding.live))

    def jacobian(self) -> sparse.csr_matrix:
        """The derivative of `msf_jax.follow` at the recorded vertices, that of the equation of `msf_jax.base.binding`.

        Returns:
            (3 N, 3 V), sparse. Entry (3 i + a, 3 v + b) is the derivative of coordinate a of node i with respect to
            coordinate b of vertex v of the input mesh. Of coincident vertices only the first has entries.

        Raises:
            ConfigError: the surface that the curve was made from is not known.
        """
        padded = self.binding
        binding = bindings.unpadded(padded)
        num, num_sections, many = len(binding.rest), len(binding.node), len(binding.vertices)
        entered = (padded.vertices - padded.centre) / padded.unit
        slopes = np.asarray(_slopes(padded, entered.astype(real_dtype())), dtype=np.float64)  # axis, corner, axis
        corner, share = np.arange(len(binding.section)), np.r_[1 - binding.part, binding.part]
        of_ends = share, (np.tile(corner, 2), np.r_[binding.tail, binding.head])
        ends: Any = sparse.csr_matrix(of_ends, shape=(len(corner), many))
        a: Any = sparse.csr_matrix((binding.a_value, (binding.a_row, binding.a_column)), shape=(num, num_sections))
        b: Any = sparse.csr_matrix((binding.b_value, (binding.b_row, binding.b_column)), shape=(num, many))
        total: Any = sparse.kron(b, sparse.eye_array(3), format="csr")
        for i, j in np.ndindex(3, 3):
            of_corners = slopes[i, : len(corner), j], (binding.section, corner)
            centroid = sparse.csr_matrix(of_corners, shape=(num_sections, len(corner)))
            axes = sparse.csr_matrix(([1.0], ([i], [j])), shape=(3, 3))
            total = total + sparse.kron(a @ (centroid @ ends), axes, format="csr")
        return sparse.csr_matrix(total)

    def covariance(self, sigma: Any) -> np.ndarray:
        """The covariance of each node for independent noise of the mesh's vertices, to first order: the diagonal blocks
        of J diag(sigma^2) J^T, with the `jacobian` J.

        Args:
            sigma: standard deviation of the noise of every vertex along each axis, in the mesh's units: a number, or
                (V,) one for each vertex of the input mesh.

        Returns:
            (N, 3, 3), in the mesh's units squared. They do not cover other decisions of a run.

        Raises:
            ConfigError: ``sigma`` is negative, not finite or of another shape, or the surface is not known.
        """
        num, spread = len(self.mesh_map), np.asarray(sigma, dtype=np.float64)
        if spread.shape not in ((), (num,)):
            raise ConfigError(f"sigma has shape {spread.shape}: expected a number, or ({num},), one for each vertex")
        if not (np.isfinite(spread) & (spread >= 0)).all():
            raise ConfigError("sigma has values that are negative or not finite: expected lengths of 0 or more")
        slopes: Any = self.jacobian()
        by_axis = [slopes[axis::3] for axis in range(3)]
        variance = np.repeat(np.broadcast_to(spread, num) ** 2, 3)
        blocks = np.empty((len(self.vertices), 3, 3))
        for i, j in np.ndindex(3, 3):
            blocks[:, i, j] = by_axis[i].multiply(by_axis[j]) @ variance
        return blocks

    def columns(self, of: str = "branches") -> dict[str, np.ndarray]:
        """Measurements with a row for each of ``branches``, in their order, or for each node, axis or cylinder.

        The table is a dictionary of arrays, as `pandas.DataFrame` takes it. Lengths are in the caller's units, angles
        in degrees; unknown values are NaN. Branches are directed away from the root of `to_tree`, or from the tip of
        the thickest limb; one with that root within has two rows.

        - "branches": start and end nodes; parent, the branch before it, or -1; is_tip; length, chord, tortuosity
          (length over chord); mean_radius, least_radius and largest_radius, without the ends, where balls touch the end
          of the limb or belong to a junction; volume of its part of the solid; angle to its parent, 0 if straight;
          slenderness and surface, as in `Branch`.
        - "nodes": x, y, z, radius, branch, along (the length from the branch's start), tangent, curvature;
          area, perimeter, largest_diameter and least_diameter of the cross-section.
        - "axes" of a plant, which go on through forks with the branch that is thick, straight and leads far: parent
          axis, or -1; order, 0 of the main axis; strahler order; start and end nodes; position on the parent;
          internode, the length of the parent since the axis before; angle to the parent's direction below the fork;
          length, chord, radii and volume.
        - "cylinders": along each edge outside of the parent axis, by the names of TreeQSM and rTwig, numbered from 1.

        Raises:
            ConfigError: ``of`` is none of these.
        """
        tables = {
            "branches": centrelines.branch_columns,
            "nodes": centrelines.node_columns,
            "axes": centrelines.axis_columns,
            "cylinders": centrelines.cylinder_columns,
        }
        if of not in tables:
            raise ConfigError(f"there is no table of {of!r}: expected one of {', '.join(map(repr, tables))}")
        return tables[of](self)

    def save(self, path: str | os.PathLike[str], mesh: "MeshLike | None" = None, label: int | None = None) -> None:
        """Write the curve, atomically, in the format of the suffix.

        - ``.npz``: everything, with the surface. `msf_jax.read_curve` reads this, SWC, JSON and polylines.
        - ``.json``: the curve, without report and surface. ``.ply``: vertices with radius, edges.
        - ``.swc``: a tree, parents first. Its ids are row numbers from 1, not node ids. Loops are cut; comments list
          the cut edges and the report. A soma is one node, and its neurites begin at its surface. ``label`` is the
          number of all other nodes, as 3 for dendrites; by default forks have 5, ends 6, and others 0.
        - ``.polylines.txt`` (CGAL's), ``.obj`` (line elements). ``.vtp``: VTK PolyData, with the `columns` of branches
          and nodes. ``.csv``, ``.nodes.csv``, ``.axes.csv``, ``.cylinders.csv``: tables, see `columns`.
        - ``.glb``: glTF of ``mesh``, as `skeletonize` took it, with its materials, texture seams and normals (smooth
          where it has none), on the bones of ``rig()``. For another rig use ``rig(...).save(path, mesh)``.

        Raises:
            ConfigError: the suffix is none of these, there is no mesh for a ``.glb``, or a label for another format.
            MeshError: ``mesh`` is not the one that the curve was made from.
            OSError: the file cannot be written; what was there before is untouched.
        """
        from msf_jax.skeleton.formats import writers

        write_whole(path, writers.writer_for(path, label)(self, mesh))

    def rig(self, mesh: "MeshLike | None" = None, names: str | None = None) -> "Rig":
        """Bones for the mesh, with smooth skinning weights; ``save("x.glb", mesh)`` writes one.

        Joints are where limbs begin, where they bend most, and along a long limb; both sides of a symmetric shape have
        the same. The root is the pelvis of a body, on two legs or four, or the thickest junction. Loops are cut where
        they are thinnest. A vertex has at most four bones. For fewer bones, `prune` before.

        Args:
            mesh: the mesh that the curve was made from, as `skeletonize` took it; only needed if repair made vertices.
            names: "mixamo", "vrm" or "unreal": those of a biped's joints. Axes are the mesh's.

        Raises:
            ConfigError: no mesh is known, or names were asked for and the shape is no biped, with the reason.
            MeshError: ``mesh`` is not the one that the curve was made from.
        """
        from msf_jax.skeleton.rigging import rig

        return rig.rigged(self, mesh, names)

    def frame(self, tolerance: float | None = None) -> "Frame":
        """Beams of a solid of bars: straight members between joints, with areas and second moments of their sections.
        Ends without a joint are carried to the end face.

        Args:
            tolerance: a length in the mesh's units, the curve's median radius if not given. Joints whose balls are
                nearer become one, and branches are cut where they bend by more.

        Raises:
            ConfigError: ``tolerance`` is not above 0, no branch is longer, a member has no section, or no mesh known.
        """
        from msf_jax.skeleton import framing

        if tolerance is not None:
            _check_length("tolerance", tolerance)
        return framing.frame_of(self, float(np.median(self.radii)) if tolerance is None else float(tolerance))

    def view(self, mesh: "MeshLike | None" = None, path: str | os.PathLike[str] | None = None) -> "PlotlyFigure":
        """A plotly figure, which a notebook shows inline: the curve in its surface, with a slider for the iterations.

        Args:
            mesh: the mesh that the curve was made from, as `skeletonize` took it; by default the repaired surface.
            path: an ``.html`` file to write, which needs no network.

        Raises:
            ConfigError: ``path`` has another suffix.
            MeshError: ``mesh`` is not the one that the curve was made from.
        """
        from msf_jax.skeleton import page

        return page.view(self, mesh, path)

    def plot(self, mesh: "MeshLike | None" = None) -> "Figure":
        """A matplotlib figure: the mesh, if given, translucent, and the curve coloured by radius; see `view.panels`."""
        from msf_jax import view

        return view.panels([view.Panel(mesh=mesh, curves={"": self})], size=8)


@jax.jit
def _slopes(binding: bindings.Binding, entered: jax.Array) -> jax.Array:
    """(3, C, 3): derivative of a centroid along axis i with respect to each corner of its section along axis j. No two
    sections share a corner, so three products with the transpose give the derivatives of all centroids."""
    place = following.corners(binding, entered)
    pull_back = jax.vjp(lambda corners: following.centroids(binding, corners)[0], place)[1]
    axes = jnp.eye(3, dtype=place.dtype)[:, None, :] * jnp.ones((len(binding.node), 1), place.dtype)
    return jax.vmap(lambda axis: pull_back(axis)[0])(axes)


def curve_of(vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray) -> Skeleton:
    """A skeleton of a curve without its mesh, as files of other programs have it, with counts only in its report."""
    components, cycles = graphs.cycle_count(len(vertices), edges)
    report = Report(components, components, cycles, cycles, float("nan"), True, "read from a file")
    return Skeleton(vertices, edges, radii, np.empty(0, dtype=np.int64), report)


def changed(skeleton: Skeleton, vertices: np.ndarray, edges: np.ndarray, node_of_old: np.ndarray) -> Skeleton:
    """A skeleton of the same mesh with another curve, and an updated report. ``node_of_old`` (N,) is the new node for
    each node of ``skeleton``."""
    edges, mesh_map, source = finishing.in_order(edges), node_of_old[skeleton.mesh_map], skeleton.source
    if source is None:
        radii = skeleton.radii[spatial.KDTree(skeleton.vertices).query(vertices)[1]]
    else:
        radii = source.solid.radii(vertices)
    components, cycles = graphs.cycle_count(len(vertices), edges)
    report = replace(skeleton.report, components=components, cycles=cycles, loops=None, figures={})
    roots, openings = (tuple(node_of_old[list(nodes)].tolist()) for nodes in (skeleton.roots, skeleton.openings))
    curve = {"vertices": vertices, "edges": edges, "radii": radii, "mesh_map": mesh_map, "report": report}
    result = replace(skeleton, **curve, roots=roots, openings=openings, radius_of="ball")
    if source is None:
        return result
    vertex, is_joined = source.input_of_vertex, report.joined_handles is not None
    placed = source.solid.shape, source.solid.enter(vertices), edges, None if vertex is None else mesh_map[vertex]
    found = assessed(*placed, lambda: result.branches, is_joined, source.solid.lids)
    found |= {"inside": _share_inside(result, edges)}
    result = replace(result, report=replace(report, **found))
    return result if skeleton.radius_of == "ball" else _with_sections(result)


def _with_sections(skeleton: Skeleton) -> Skeleton:
    """The same curve with radii of discs in place of those of balls; see `Skeleton.with_radii`."""
    area = centrelines.node_columns(skeleton)["area"]
    radii = np.where(np.isfinite(area), np.sqrt(np.maximum(area, 0.0) / np.pi), skeleton.radii)
    return replace(skeleton, radii=radii, radius_of="section")


def _share_inside(skeleton: Skeleton, edges: np.ndarray) -> float:
    """The fraction inside the skeleton's mesh of the length of ``edges`` of its nodes; the report's without a mesh."""
    if skeleton.source is None:
        return skeleton.report.inside
    solid = skeleton.source.solid
    balls = skeleton.radii if skeleton.radius_of == "ball" else solid.radii(skeleton.vertices)
    return metrics.inside_fraction(solid.shape, solid.enter(skeleton.vertices), edges, balls / solid.diagonal)


def _relinked(skeleton: Skeleton, edges: np.ndarray, note: str, **counts: Any) -> Skeleton:
    """The nodes of a skeleton with other ``edges``, and what its report says then."""
    components, cycles = graphs.cycle_count(len(skeleton.vertices), edges)
    counts |= {"components": components, "cycles": cycles, "inside": _share_inside(skeleton, edges), "figures": {}}
    report = replace(skeleton.report, notes=(*skeleton.report.notes, note), **counts)
    return replace(skeleton, edges=edges, report=report)


def _held(skeleton: Skeleton) -> np.ndarray:
    """(N,) whether a node stays in every curve made from this one: of a pinned vertex, or an opening."""
    is_held = np.zeros(len(skeleton.vertices), dtype=bool)
    is_held[list(skeleton.openings)] = True
    if skeleton.source is not None:
        is_held[skeleton.mesh_map[skeleton.source.pins]] = True
    return is_held


def _check_length(name: str, value: Any) -> None:
    if isinstance(value, bool) or not (isinstance(value, numbers.Real) and 0 < float(value) < np.inf):
        raise ConfigError(f"{name} is {value!r}: expected a length above 0")


def _links(vertices: np.ndarray, edges: np.ndarray, reach: float) -> np.ndarray:
    """(K, 2) shortest edges that join pieces within ``reach`` of each other: a spanning tree of least length, which
    grows from one piece to the nearest of the others (Prim 1957), without edges that are longer."""
    piece, links = graphs.labels(len(vertices), *edges.T), [np.empty((0, 2), dtype=np.int64)]
    is_in = piece == piece[0]
    while not is_in.all():
        own, other = np.flatnonzero(is_in), np.flatnonzero(~is_in)
        away, nearest = map(np.asarray, spatial.KDTree(vertices[own]).query(vertices[other]))
        next_one = away.argmin()
        if away[next_one] <= reach:
            links.append(np.sort([[own[nearest[next_one]], other[next_one]]]))
        is_in |= piece == piece[other[next_one]]
    return np.concatenate(links)
