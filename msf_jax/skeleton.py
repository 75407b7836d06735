"""What comes out: `Skeleton`, a curve with radii and a map from the input, and `Report`, how far to trust it."""

import os
from dataclasses import asdict, dataclass, field
from typing import TYPE_CHECKING, Any

import networkx as nx
import numpy as np

from msf_jax import export

if TYPE_CHECKING:
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
        volume: fraction of the mesh's volume that was left, the largest over components.
        unsolved: linear solves that ran out of steps before they reached their tolerance.
        solve_steps: CG steps in all.
        repairs: what was changed in the input, a sentence each.
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
    repairs: tuple[str, ...] = ()
    seconds: dict[str, float] = field(default_factory=dict, compare=False)

    @property
    def is_sound(self) -> bool:
        """Converged, every component and cycle found and none too many, and the curve at least 99 % inside."""
        is_right = self.components == self.mesh_components and self.cycles == self.genus
        return self.converged and is_right and self.inside >= 0.99

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON or a table."""
        return asdict(self) | {"repairs": list(self.repairs)}

    def __str__(self) -> str:
        lines = [
            f"{'converged' if self.converged else 'NOT converged'}: {self.reason}, "
            f"after {self.iterations} iterations ({self.volume:.1e} of the volume left)",
            _compare(self.components, "component", self.mesh_components, "as in the mesh")
            + ", "
            + _compare(self.cycles, "cycle", self.genus, f"for genus {self.genus}"),
            f"{100 * self.inside:.2f} % of the curve's length is inside the mesh",
            f"{self.fixed} of {self.live} meso-skeleton vertices fixed, {self.solve_steps} CG steps",
        ]
        if self.unsolved:
            lines.append(f"{self.unsolved} linear solves stopped before they reached their tolerance")
        lines += [f"repaired: {repair}" for repair in self.repairs]
        lines.append(", ".join(f"{stage} {seconds:.2f} s" for stage, seconds in self.seconds.items()))
        return "\n".join(lines)


def _compare(found: int, what: str, expected: int, why: str) -> str:
    count = f"{found} {what}{'' if found == 1 else 's'}"
    return f"{count} {why}" if found == expected else f"{count}, EXPECTED {expected} {why}"


@dataclass(frozen=True, eq=False)
class Skeleton:
    """A curve skeleton.

    Attributes:
        vertices: (N, 3) float64, nodes in the caller's units.
        edges: (E, 2) int, each with its smaller node first, in ascending order.
        radii: (N,) radius of the largest ball around the node that lies inside the surface; 0 for a node outside.
        mesh_map: (V,) int, the node of every input vertex.
        report: what was found and how far to trust it.
    """

    vertices: np.ndarray
    edges: np.ndarray
    radii: np.ndarray
    mesh_map: np.ndarray
    report: Report

    def __repr__(self) -> str:
        return f"Skeleton({len(self.vertices)} nodes, {len(self.edges)} edges, {self.report.cycles} cycles)"

    @property
    def length(self) -> float:
        """Length of all edges, in the caller's units."""
        return float(np.linalg.norm(self.vertices[self.edges[:, 0]] - self.vertices[self.edges[:, 1]], axis=1).sum())

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the curve in the format that the suffix names, whole or not at all.

        ``.swc`` (a tree: loops are cut, and the cut edges listed in a comment), ``.obj`` (lines), ``.cg`` (vertices and
        edges), ``.polylines.txt`` (CGAL's), ``.json`` (everything, the report included).

        Raises:
            ConfigError: the suffix is none of these.
            OSError: the file cannot be written; what was there before is untouched.
        """
        export.save(self, path)

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
            entities=[Line(branch) for branch in export.polylines(self)], vertices=self.vertices.copy(), process=False
        )
