"""What comes out: `Skeleton`, a curve with radii and a map from the input, and `Report`, how far to trust it."""

import itertools
import numbers
import os
from dataclasses import asdict, dataclass, field, replace
from typing import TYPE_CHECKING, Any, NamedTuple

import networkx as nx
import numpy as np

from msf_jax import export, metrics, page, segmentation, view
from msf_jax.errors import ConfigError
from msf_jax.host import branches, containment, curve, finishing
from msf_jax.host.branches import Branch
from msf_jax.host.centring import arc_length, at
from msf_jax.host.records import Stage
from msf_jax.host.solid import Solid

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from plotly.graph_objects import Figure as PlotlyFigure
    from trimesh import Trimesh
    from trimesh.path import Path3D


@dataclass(frozen=True)
class Report:
    """What was found, and how far to trust it.

    Attributes:
        components: connected components of the curve; as many as ``mesh_components`` when all is well.
        mesh_components: connected components of the mesh.
        genus: sum of the genera of the mesh's components.
        cycles: independent cycles of the curve; equal to ``genus`` when all is well.
        inside: fraction of the curve's length that is inside the mesh.
        converged: whether the flow reached its end.
        reason: why the flow stopped, one clause, for each component that differs.
        iterations: of the flow, the sum over components.
        fixed: vertices of the meso-skeleton that were fixed at the end.
        live: vertices of the meso-skeleton at the end.
        coarsened: vertices of the mesh that went before the flow, in edges shorter than ``Config.coarsen``.
        volume: fraction of the volume, after coarsening, that was left, the largest over components.
        unsolved: iterations in which a linear solve ran out of steps before it reached its tolerance.
        solve_steps: CG steps in all.
        repairs: what was changed in the input, a sentence each.
        notes: what else went otherwise than planned, a sentence each: steps that were redone, a checkpoint not written.
        figures: `metrics.evaluate` of the curve as the run ended, where ``Config(evaluate=True)`` asks for it.
        seconds: by stage.
    """

    components: int
    mesh_components: int
    genus: int
    cycles: int
    inside: float
    converged: bool
    reason: str
    iterations: int
    fixed: int
    live: int
    volume: float
    unsolved: int
    solve_steps: int
    coarsened: int = 0
    repairs: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    figures: dict[str, float] = field(default_factory=dict)
    seconds: dict[str, float] = field(default_factory=dict, compare=False)

    @property
    def is_sound(self) -> bool:
        """Converged, every component and cycle found and none too many, and the curve at least 99 % inside."""
        is_right = self.components == self.mesh_components and self.cycles == self.genus
        return self.converged and is_right and self.inside >= 0.99

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON or a table."""
        figures = {name: None if np.isnan(value) else value for name, value in self.figures.items()}
        inside = None if np.isnan(self.inside) else self.inside  # of a curve without its mesh
        lists = {"repairs": list(self.repairs), "notes": list(self.notes)}
        return asdict(self) | lists | {"figures": figures, "inside": inside}

    def __str__(self) -> str:
        lines = [
            f"{'converged' if self.converged else 'NOT converged'}: {self.reason}, "
            f"after {self.iterations} iterations ({self.volume:.1e} of the volume left)",
            _compare(self.components, "component", self.mesh_components, "as in the mesh")
            + ", "
            + _compare(self.cycles, "cycle", self.genus, f"for genus {self.genus}"),
            f"{100 * self.inside:.2f} % of the curve's length is inside the mesh",
            f"{self.fixed} of {self.live} meso-skeleton vertices fixed, {self.solve_steps} CG steps"
            + (f", {self.coarsened} vertices coarsened away before" if self.coarsened else ""),
        ]
        if self.unsolved:
            lines.append(f"in {self.unsolved} iterations a linear solve stopped before it reached its tolerance")
        if self.figures:
            lines.append(", ".join(f"{name} {value:.4g}" for name, value in self.figures.items()))
        lines += [f"repaired: {repair}" for repair in self.repairs]
        lines += self.notes
        lines.append(", ".join(f"{stage} {seconds:.2f} s" for stage, seconds in self.seconds.items()))
        return "\n".join(lines)


def _compare(found: int, what: str, expected: int, why: str) -> str:
    count = f"{found} {what}{'' if found == 1 else 's'}"
    return f"{count} {why}" if found == expected else f"{count}, EXPECTED {expected} {why}"


class Source(NamedTuple):
    """What a curve was made from.

    areas: (V,) share of the surface's area that belongs to each input vertex. pins: (k,) input vertices held in place.
    stages: the surface as it contracted, in a few steps from first to last.
    """

    solid: Solid
    areas: np.ndarray
    pins: np.ndarray
    stages: tuple[Stage, ...] = ()


@dataclass(frozen=True, eq=False)
class Skeleton:
    """A curve skeleton.

    Attributes:
        vertices: (N, 3) float64, nodes in the caller's units.
        edges: (E, 2) int, each with its smaller node first, in ascending order.
        radii: (N,) radius of the largest ball around the node that lies inside the surface; 0 for a node outside.
        mesh_map: (V,) int, the node of every input vertex.
        report: what was found and how far to trust it.
        source: the surface that the curve was made from; without it, radii of a changed curve are lower bounds.
    """

    vertices: np.ndarray
    edges: np.ndarray
    radii: np.ndarray
    mesh_map: np.ndarray
    report: Report
    source: Source | None = field(default=None, repr=False)

    def __repr__(self) -> str:
        return f"Skeleton({len(self.vertices)} nodes, {len(self.edges)} edges, {self.report.cycles} cycles)"

    @property
    def length(self) -> float:
        """Length of all edges, in the caller's units."""
        return float(np.linalg.norm(self.vertices[self.edges[:, 0]] - self.vertices[self.edges[:, 1]], axis=1).sum())

    @property
    def branches(self) -> list[Branch]:
        """The ways between nodes that have other than two edges, with their length, persistence and surface."""
        share = None
        if self.source is not None:
            share = np.bincount(self.mesh_map, weights=self.source.areas, minlength=len(self.vertices))
        return branches.measure(self.vertices, self.edges, self.radii, share)

    def prune(self, persistence: float = 1.6) -> "Skeleton":
        """A new skeleton without the branches of less than ``persistence``, the least first; see `Branch`.

        Components and cycles stay, and so does a branch with a pin. The vertices of the mesh that went to a pruned
        branch go to its junction. A run has pruned at ``Config.prune`` already: to slide the threshold below that, run
        once with ``Config(prune=0)``.

        Raises:
            ConfigError: ``persistence`` is negative or not a number.
        """
        if not (isinstance(persistence, numbers.Real) and persistence >= 0):
            raise ConfigError(f"persistence is {persistence!r}: expected a number of 0 or more")
        stays, target = branches.prune(self.vertices, self.edges, self.radii, persistence, self._is_held())
        rank = np.cumsum(stays) - 1
        edges = rank[self.edges[stays[self.edges].all(axis=1)]]
        return self._changed(self.vertices[stays], edges, rank[target[self.mesh_map]])

    def resample(self, spacing: float) -> "Skeleton":
        """A new skeleton whose branches have nodes about every ``spacing``, in the caller's units; ends and pins stay.

        Where an edge would leave the solid, the nodes that it would skip stay.

        Raises:
            ConfigError: ``spacing`` is not above 0.
        """
        if not (isinstance(spacing, numbers.Real) and 0 < spacing < np.inf):
            raise ConfigError(f"spacing is {spacing!r}: expected a length above 0")
        degree = np.bincount(self.edges.ravel(), minlength=len(self.vertices))
        is_end = (degree != 2) | self._is_held()
        courses, stops = [], []
        joined_ends: set[tuple[int, int]] = set()
        for branch in self.branches:
            cuts = [0, *(np.flatnonzero(is_end[branch.nodes[1:-1]]) + 1).tolist(), len(branch.nodes) - 1]
            for first, last in itertools.pairwise(cuts) if len(branch.nodes) > 1 else ():
                nodes = np.array(branch.nodes[first : last + 1])
                is_end[nodes[[0, -1]]] = True
                ends = (int(nodes[[0, -1]].min()), int(nodes[[0, -1]].max()))
                along = arc_length(self.vertices[nodes])
                num = max(1, round(along[-1] / spacing))
                if ends[0] == ends[1]:
                    num = max(3, num)  # a loop needs three edges,
                elif num == 1 and ends in joined_ends:
                    num = 2  # and of two branches with the same ends one needs a node of its own
                joined_ends.add(ends)
                courses.append((nodes, along))
                stops.append(self._stops_inside(nodes, along, np.linspace(0, along[-1], num + 1)))
        rank = np.cumsum(is_end) - 1
        node_of_old = np.where(is_end, rank, -1)
        vertices, edges, count = [self.vertices[is_end]], [np.empty((0, 2), dtype=np.int64)], int(is_end.sum())
        for (nodes, along), stop in zip(courses, stops, strict=True):
            chain = np.r_[rank[nodes[0]], np.arange(count, count + len(stop) - 2), rank[nodes[-1]]]
            vertices.append(at(self.vertices[nodes], along, stop[1:-1]))
            edges.append(np.stack([chain[:-1], chain[1:]], axis=1))
            count += len(stop) - 2
            node_of_old[nodes[1:-1]] = chain[np.abs(along[1:-1, None] - stop).argmin(axis=1)]
        return self._changed(np.concatenate(vertices), np.concatenate(edges), node_of_old[self.mesh_map])

    def _stops_inside(self, nodes: np.ndarray, along: np.ndarray, stops: np.ndarray) -> np.ndarray:
        """Arc lengths ``stops`` and those of the old nodes between two of them that the solid parts."""
        if self.source is None:
            return stops
        solid = self.source.solid
        points = solid.enter(at(self.vertices[nodes], along, stops))
        is_bad = ~containment.is_inside(solid.shape, points[:-1], points[1:])
        span = np.clip(np.searchsorted(stops, along, side="right") - 1, 0, len(is_bad) - 1)
        return np.sort(np.concatenate([stops, np.setdiff1d(along[is_bad[span]], stops)]))

    def smooth(self, rounds: int = 10) -> "Skeleton":
        """A new skeleton: in each of ``rounds`` nodes go half of the way to the middle of their two neighbours.

        Ends of branches and pins stay, and so does a node that would leave the solid or lose half of its clearance.

        Raises:
            ConfigError: ``rounds`` is negative.
        """
        if isinstance(rounds, bool) or not isinstance(rounds, numbers.Integral) or rounds < 0:
            raise ConfigError(f"rounds is {rounds!r}: expected a whole number of 0 or more")
        x, is_held = self.vertices.copy(), self._is_held()
        degree = np.bincount(self.edges.ravel(), minlength=len(x))
        ways = branches.trace(len(x), self.edges)
        for _ in range(int(rounds)):
            goal = x.copy()
            for way in ways:
                nodes = way[:-1] + way[:2] if degree[way[0]] == 2 else way  # a loop has no ends that stay
                goal[nodes[1:-1]] = x[nodes[1:-1]] / 2 + (x[nodes[:-2]] + x[nodes[2:]]) / 4
            is_safe = ~is_held
            if self.source is not None:
                is_safe &= self.source.solid.radii(goal) >= self.radii / 2
            x[is_safe] = goal[is_safe]
        edges = self.edges
        if self.source is not None:
            solid = self.source.solid
            entered, edges = containment.contain(solid.shape, solid.enter(x), edges, np.ones(len(x), dtype=bool))
            x = np.concatenate([x, solid.leave(entered[len(x) :])])
        return self._changed(x, edges, self.mesh_map)

    def _is_held(self) -> np.ndarray:
        """(N,) True for a node that a pinned vertex of the mesh goes to."""
        is_held = np.zeros(len(self.vertices), dtype=bool)
        if self.source is not None:
            is_held[self.mesh_map[self.source.pins]] = True
        return is_held

    def _changed(self, vertices: np.ndarray, edges: np.ndarray, mesh_map: np.ndarray) -> "Skeleton":
        """A skeleton of the same mesh with another curve, and the report's counts made again."""
        edges = finishing.in_order(edges)
        components, cycles = curve.cycle_count(len(vertices), edges)
        report = replace(self.report, components=components, cycles=cycles, figures={})
        if self.source is not None:
            solid = self.source.solid
            radii = solid.radii(vertices)
            inside = metrics.inside_fraction(solid.shape, solid.enter(vertices), edges, radii / solid.diagonal)
            report = replace(report, inside=inside)
        else:  # the largest ball inside one that is known
            away = np.linalg.norm(vertices[:, None] - self.vertices, axis=2)
            radii = np.maximum((self.radii - away).max(axis=1), 0.0)
        return Skeleton(vertices, edges, radii, mesh_map, report, self.source)

    def save(self, path: str | os.PathLike[str], mesh: Any = None) -> None:
        """Write the curve in the format that the suffix names, whole or not at all.

        ``.swc`` (a tree, parents first: ids count its rows from 1, and are not the nodes' numbers; loops are cut, and
        the cut edges listed in a comment), ``.obj`` (lines), ``.cg`` (vertices and edges), ``.polylines.txt`` (CGAL's),
        ``.ply`` (vertices with radius, edges), ``.vtp`` (VTK PolyData with point data "radius"), ``.graphml``
        (NetworkX's), ``.npz`` (arrays), ``.json`` (everything, the report included), ``.glb`` (glTF:
        ``mesh``, as `skeletonize` took it, skinned to the curve, whose nodes are the joints).

        Raises:
            ConfigError: the suffix is none of these, or a ``.glb`` is asked for without a mesh.
            MeshError: ``mesh`` is not the one that the curve was made from.
            OSError: the file cannot be written; what was there before is untouched.
        """
        export.save(self, path, mesh)

    def view(self, mesh: Any = None, path: str | os.PathLike[str] | None = None) -> "PlotlyFigure":
        """A page to look around in: the curve in its surface, with sliders for the flow's iterations and for pruning.

        Args:
            mesh: what the curve was made from, as `skeletonize` took it; the repaired surface if not given.
            path: an ``.html`` file to write it to, which needs no network.

        Returns:
            A plotly figure; a notebook shows it inline.

        Raises:
            ConfigError: ``path`` has another suffix.
            MeshError: ``mesh`` is not the one that the curve was made from.
        """
        return page.view(self, mesh, path)

    def plot(self, mesh: Any = None, *, elevation: float = 15.0, azimuth: float = -70.0) -> "Figure":
        """A matplotlib figure, for papers: the mesh translucent, the curve coloured by radius; see `view.figure`."""
        return view.figure(self, mesh, elevation=elevation, azimuth=azimuth)

    def segments(self, mesh: Any) -> list["Trimesh"]:
        """The surface split by branch: one `trimesh.Trimesh` for each of ``branches``, in their order.

        A face goes with the branch of its first corner's node; one at a junction to the branch that is named first. A
        branch may get none. Each has a colour of its own, and ``vertex_attributes`` "radius", "node" and "branch".

        Raises:
            MeshError: ``mesh`` is not the one that the curve was made from.
        """
        return segmentation.segments(self, mesh)

    def to_networkx(self) -> nx.Graph:
        """A graph whose nodes carry ``position`` (3,) and ``radius``, and whose edges carry ``length``."""
        graph = nx.Graph()
        for number, (position, radius) in enumerate(zip(self.vertices, self.radii, strict=True)):
            graph.add_node(number, position=tuple(position.tolist()), radius=float(radius))
        length = np.linalg.norm(self.vertices[self.edges[:, 0]] - self.vertices[self.edges[:, 1]], axis=1)
        for (a, b), size in zip(self.edges.tolist(), length.tolist(), strict=True):
            graph.add_edge(a, b, length=size)
        return graph

    def to_path3d(self) -> "Path3D":
        """The edges as a `trimesh.path.Path3D`, one line entity for each branch."""
        from trimesh.path import Path3D
        from trimesh.path.entities import Line

        return Path3D(
            entities=[Line(branch) for branch in branches.trace(len(self.vertices), self.edges)],
            vertices=self.vertices.copy(),
            process=False,
        )


def curve_of(vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray) -> Skeleton:
    """A skeleton of any curve: no map, and a report of its counts."""
    components, cycles = curve.cycle_count(len(vertices), edges)
    report = Report(
        components=components,
        mesh_components=components,
        genus=cycles,
        cycles=cycles,
        inside=float("nan"),
        converged=True,
        reason="read from a file",
        iterations=0,
        fixed=0,
        live=0,
        volume=0.0,
        unsolved=0,
        solve_steps=0,
    )
    return Skeleton(vertices, edges, radii, np.empty(0, dtype=np.int64), report)
