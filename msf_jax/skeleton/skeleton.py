"""`Skeleton`, the result of a run: a curve with radii, a map from the input's vertices, and a `Report`.

What can be made of one are functions in other modules, which its methods import when they are called.
"""

import os
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from msf_jax.limbs import one_branch
from msf_jax.limbs.caps import Caps
from msf_jax.limbs.one_branch import Branch
from msf_jax.skeleton import changes, pytree, slopes
from msf_jax.skeleton.report import Report
from msf_jax.skeleton.source import Source
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from networkx import Graph
    from pandas import DataFrame
    from plotly.graph_objects import Figure as PlotlyFigure
    from scipy import sparse
    from trimesh import Trimesh
    from trimesh.path import Path3D

    from msf_jax.base.binding import Binding
    from msf_jax.meshes.reading import MeshLike
    from msf_jax.skeleton.framing import Frame
    from msf_jax.skeleton.rigging.rig import Rig


@dataclass(frozen=True, eq=False)
class Skeleton:
    """A curve skeleton.

    Attributes:
        vertices: (N, 3) float64, nodes in the caller's units.
        edges: (E, 2) int, each with its smaller node first, in ascending order.
        radii: (N,) radius of the largest ball around the node that lies inside the surface; 0 for a node outside.
        mesh_map: (V,) int, the node of every input vertex.
        report: the figures of the run, and how far to trust it.
        source: the surface that the curve was made from; without it, radii of a changed curve are lower bounds.
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
        cycles = f"{self.report.cycles} {'cycle' if self.report.cycles == 1 else 'cycles'}"
        inside = "" if np.isnan(self.report.inside) else f", {100 * self.report.inside:.2f} % inside"
        return f"Skeleton({len(self.vertices)} nodes, {len(self.edges)} edges, {cycles}{inside})"

    @property
    def length(self) -> float:
        """Length of all edges, in the caller's units."""
        return float(np.linalg.norm(self.vertices[self.edges[:, 0]] - self.vertices[self.edges[:, 1]], axis=1).sum())

    @property
    def num_leaves(self) -> int:
        """The number of nodes with one edge."""
        return int((np.bincount(self.edges.ravel()) == 1).sum())

    @property
    def branches(self) -> list[Branch]:
        """The paths between nodes whose degree is not 2, with their length, slenderness and surface."""
        share = None
        if self.source is not None:
            share = np.bincount(self.mesh_map, weights=self.source.areas, minlength=len(self.vertices))
        known = self._slenderness
        slenderness = one_branch.by_balls(self.vertices, self.radii) if known is None else known
        return one_branch.measure(self.vertices, self.edges, slenderness, share)

    @cached_property
    def _slenderness(self) -> np.ndarray | None:
        """The slenderness of each leaf on the solid's surface; None if branches are measured by their balls."""
        if self.source is None or self.report.wavefronts:
            return None
        solid = self.source.solid
        return one_branch.slenderness(Caps(solid.outside), solid.enter(self.vertices), self.edges)

    def prune(self, slenderness: float = 1.0, detail: float | None = None) -> "Skeleton":
        """A new skeleton with one branch for each limb of at least that ``slenderness`` that has any; see `Branch`.

        Nothing less slender than half a ball, 0.5, is a limb, unless it stands out; 0 keeps all branches. ``detail``,
        from 0 to 1, says which limbs that only stand out count, as in `Config`. If it is given, limbs without a branch
        get one, through the middles of their rings: a coarser detail removes branches, a finer one adds some. Without
        it, limbs count that stand out at the detail 0.5, and nothing is added.

        A run with ``Config(least_slenderness=slenderness, detail=detail)`` chooses limbs in the same way. Components,
        cycles and branches with a pin are kept. The mesh's vertices of a pruned branch go to its junction.

        Without its mesh, or if wavefronts made the curve, branches are pruned by their balls, the least slender first.

        Raises:
            ConfigError: ``slenderness`` is negative or not a number, ``detail`` is not from 0 to 1, or is given where
                limbs are not known.
        """
        return changes.pruned(self, slenderness, detail)

    def resample(self, spacing: float) -> "Skeleton":
        """A new skeleton with nodes about every ``spacing`` along branches, in the caller's units. Ends and pins stay.

        An edge that would leave the solid is bisected. A larger spacing never gives more nodes.

        Raises:
            ConfigError: ``spacing`` is not above 0, or would give more than ten million nodes.
        """
        return changes.resampled(self, spacing)

    def smooth(self, rounds: int = 10) -> "Skeleton":
        """A new skeleton, smoothed: in each round nodes move half of the way to the midpoint of their two neighbours.

        Ends of branches and pins stay, and so does a node that would leave the solid or lose half of its clearance.

        Raises:
            ConfigError: ``rounds`` is negative.
        """
        return changes.smoothed(self, rounds)

    def simplify(self, tolerance: float) -> "Skeleton":
        """A new skeleton with the fewest nodes within ``tolerance`` of this one, a length. Ends and pins stay.

        Unlike `resample`, it keeps nodes where a branch bends. Edges may leave the solid by up to ``tolerance``.

        Raises:
            ConfigError: ``tolerance`` is not above 0.
        """
        return changes.simplified(self, tolerance)

    def to_tree(self, root: Any = None) -> "Skeleton":
        """A new skeleton without loops: each loop is cut at its thinnest edge. An SWC file of it has the root first.

        Args:
            root: id of the node that is the root of its component, a point (x, y, z) for the node nearest to it, or
                "soma" (see `soma`). The default is the thickest node, as in the other components. See ``roots``.

        Returns:
            The same nodes and map, with fewer edges. ``report.cut`` counts the loops; ``report.notes`` says where they
            were cut, and whether the soma is sure.

        Raises:
            ConfigError: the curve has no such node.
        """
        return changes.tree_of(self, root)

    def soma(self) -> changes.Soma:
        """The thickest place, where the soma of a neuron may be, and whether it stands out enough to be sure."""
        return changes.soma_of(self)

    def heal(self, reach: float = np.inf) -> "Skeleton":
        """A new skeleton with fewer pieces: edges between nearest nodes join pieces over gaps of up to ``reach``.

        It makes no loop. ``reach`` is in the caller's units. ``report.notes`` gives the largest gap.

        Raises:
            ConfigError: ``reach`` is not above 0.
        """
        return changes.healed(self, reach)

    def with_radii(self, of: str) -> "Skeleton":
        """The same curve with another kind of radii, which saved files then have, too.

        Args:
            of: "ball", the radius of the largest inscribed ball around each node; or "section", that of a disc with the
                area of the cross-section there. In a flat limb the second is larger. A node without a cross-section,
                such as beyond a limb's end, has the ball's.

        Raises:
            ConfigError: ``of`` is neither, or the surface that the curve was made from is not known.
        """
        return changes.with_radii(self, of)

    @cached_property
    def binding(self) -> "Binding":
        """The curve as a function of the mesh's vertices, for `msf_jax.follow`; made on first access.

        A pytree of NumPy arrays, padded to one of few capacities. A jitted function with a binding as its argument is
        compiled once for all skeletons of one capacity.

        Raises:
            ConfigError: the surface that the curve was made from is not known.
        """
        return slopes.binding_of(self)

    def jacobian(self) -> "sparse.csr_matrix":
        """The derivative of `msf_jax.follow` at the recorded vertices.

        Returns:
            (3 N, 3 V), sparse. Entry (3 i + a, 3 v + b) is the derivative of coordinate a of node i with respect to
            coordinate b of vertex v of the input mesh. Of coincident vertices only the first has entries.

        Raises:
            ConfigError: the surface that the curve was made from is not known.
        """
        return slopes.jacobian(self)

    def covariance(self, sigma: Any) -> np.ndarray:
        """The covariance of each node for independent noise of the mesh's vertices, to first order; see `jacobian`.

        Args:
            sigma: standard deviation of the noise of every vertex along each axis, in the mesh's units: a number, or
                (V,) one for each vertex of the input mesh.

        Returns:
            (N, 3, 3) covariances, in the mesh's units squared. They do not cover other decisions of a run.

        Raises:
            ConfigError: ``sigma`` is negative, not finite or of another shape, or the surface is not known.
        """
        return slopes.covariance(self, sigma)

    def columns(self, of: str = "branches") -> dict[str, np.ndarray]:
        """Measurements with a row for each of ``branches``, in their order, or for each node, axis or cylinder.

        A dictionary of arrays; `to_pandas` makes a data frame. ``save("x.csv")`` and ``save("x.nodes.csv")``,
        ``.axes.csv`` and ``.cylinders.csv`` write the same tables. Lengths are in the caller's
        units, angles in degrees; unknown values are NaN. Branches are directed away from the root of `to_tree`, or from
        the tip of the thickest limb.

        - "branches": start and end nodes; parent, the branch before it, or -1; is_tip; length, chord, tortuosity
          (length over chord); mean_radius, least_radius and largest_radius, without the ends, where balls touch the end
          of the limb or belong to a junction; volume of its part of the solid; angle to its parent, 0 if straight;
          slenderness and surface, as in `Branch`.
        - "nodes": x, y, z, radius, branch, along (the length from the branch's start), tangent, curvature;
          area, perimeter, largest_diameter and least_diameter of the cross-section.
        - "axes": of a plant: an axis goes on through forks with the thickest and straightest branch. parent axis, or
          -1; order, 0 of the main axis; strahler order; start and end nodes; position on the parent; internode, the
          length of the parent since the axis before; angle to the parent; length, chord, radii and volume.
        - "cylinders": along each edge, by the names of TreeQSM and rTwig, numbered from 1.

        Raises:
            ConfigError: ``of`` is neither.
        """
        from msf_jax.skeleton import converting

        return converting.columns_of(self, of)

    def save(self, path: str | os.PathLike[str], mesh: "MeshLike | None" = None) -> None:
        """Write the curve, atomically, in the format of the suffix.

        - ``.swc``: a tree, parents first. Its ids are row numbers from 1, not node ids. Loops are cut; comments list
          the cut edges and the report.
        - ``.obj`` (line elements), ``.polylines.txt`` (CGAL's), ``.ply`` (vertices with radius, edges), ``.graphml``
          (NetworkX's).
        - ``.vtp``: VTK PolyData, with the `columns` of branches and nodes. ``.csv``, ``.nodes.csv``,
          ``.axes.csv``, ``.cylinders.csv``: its tables.
        - ``.npz``: everything, with the surface. ``.json``: everything, without the surface.
        - ``.glb``: glTF of ``mesh``, as `skeletonize` took it, with its materials, texture seams and normals (smooth
          where it has none), on the bones of ``rig()``. For another rig use ``rig(...).save(path, mesh)``.

        `msf_jax.read_curve` reads all of these but ``.vtp``, ``.csv`` and ``.glb``.

        Raises:
            ConfigError: the suffix is none of these, or a ``.glb`` was requested without a mesh.
            MeshError: ``mesh`` is not the one that the curve was made from.
            OSError: the file cannot be written; what was there before is untouched.
        """
        from msf_jax.base.writing import write_whole
        from msf_jax.skeleton.formats import export

        write_whole(path, export.writer_for(path)(self, mesh))

    def save_precomputed(self, folder: str | os.PathLike[str], segment: int = 1) -> None:
        """Write the curve as ``segment`` of Neuroglancer's precomputed skeletons: ``info``, radii, and SWC's labels
        as ``vertex_types``. ``units`` must be nm, um, mm or m; "" are nanometres.

        Raises:
            ConfigError: the id or the units are none, or the folder has skeletons of other units.
        """
        from msf_jax.skeleton import converting

        converting.save_precomputed(self, folder, segment)

    def rig(
        self, bones: int | None = None, influences: int = 4, mesh: "MeshLike | None" = None, names: str | None = None
    ) -> "Rig":
        """Bones for the mesh, with smooth skinning weights; ``save("x.glb", mesh)`` writes one.

        Joints are where limbs begin, where the curve bends most, and at regular distances along a long limb; both sides
        of a symmetric shape have the same. The root is the pelvis of a body, on two legs or four, or the thickest
        junction. Loops are cut where they are thinnest. Weights are computed by heat diffusion over the surface.

        Args:
            bones: their number; `Rig.notes` says if it is not met. None: as the shape bends, at most 50.
            influences: the largest number of bones for a vertex.
            mesh: the mesh that the curve was made from, as `skeletonize` took it; only needed if repair made vertices.
            names: "mixamo", "vrm" or "unreal": those of a biped's joints. Axes are the mesh's; others keep theirs.

        Raises:
            ConfigError: a number is out of range, the surface that the curve was made from is not known, or names were
                asked for and the shape is no biped, with the reason.
            MeshError: ``mesh`` is not the one that the curve was made from.
        """
        from msf_jax.skeleton.rigging import rig

        return rig.rigged(self, bones, influences, mesh, names)

    def frame(self, tolerance: float | None = None) -> "Frame":
        """Beams of a solid of bars: straight members between joints, with areas and second moments of their sections.

        Joints whose balls are nearer than ``tolerance`` become one. Branches are cut where they bend by more than it.
        Ends without a joint are carried to the end face.

        Args:
            tolerance: a length in the mesh's units; the median radius of the curve if not given.

        Raises:
            ConfigError: ``tolerance`` is not above 0, no branch is longer, a member has no cross-section, or the
                surface that the curve was made from is not known.
        """
        from msf_jax.skeleton import framing

        return framing.frame_of(self, tolerance)

    def view(self, mesh: "MeshLike | None" = None, path: str | os.PathLike[str] | None = None) -> "PlotlyFigure":
        """An interactive page: the curve in its surface, with sliders for the flow's iterations and for pruning.

        Args:
            mesh: the mesh that the curve was made from, as `skeletonize` took it; by default the repaired surface.
            path: an ``.html`` file to write, which needs no network.

        Returns:
            A plotly figure; a notebook shows it inline.

        Raises:
            ConfigError: ``path`` has another suffix.
            MeshError: ``mesh`` is not the one that the curve was made from.
        """
        from msf_jax.skeleton.pictures import page

        return page.view(self, mesh, path)

    def plot(
        self, mesh: "MeshLike | None" = None, *, elevation: float | None = None, azimuth: float | None = None
    ) -> "Figure":
        """A matplotlib figure, for papers: the mesh translucent, the curve coloured by radius; see `panels.figure`."""
        from msf_jax.skeleton.pictures import panels

        return panels.figure(self, mesh, elevation=elevation, azimuth=azimuth)

    def segments(self, mesh: "MeshLike") -> list["Trimesh"]:
        """The surface split by branch: one `trimesh.Trimesh` for each of ``branches``, in their order.

        A face belongs to the branch of most of its corners' nodes, or else of its first corner's; a node at a junction
        counts for the first of its branches. A small piece within another branch belongs to that branch. A branch may
        have no faces. Each mesh has its own colour, and ``vertex_attributes`` "radius", "node" and "branch".

        Raises:
            MeshError: ``mesh`` is not the one that the curve was made from.
        """
        from msf_jax.skeleton.pictures import segmentation

        return segmentation.segments(self, mesh)

    def to_networkx(self) -> "Graph":
        """A graph with ``position`` (3,) and ``radius`` at its nodes, and ``length`` at its edges."""
        from msf_jax.skeleton import converting

        return converting.networkx_of(self)

    def to_pandas(self, of: str = "branches") -> "DataFrame":
        """The `columns` as a `pandas.DataFrame`; a ConfigError if there is no pandas."""
        from msf_jax.skeleton import converting

        return converting.pandas_of(self, of)

    def to_navis(self) -> Any:
        """A `navis.TreeNeuron` with radii, labels and units, without loops; a ConfigError if there is no navis."""
        from msf_jax.skeleton import converting

        return converting.navis_of(self)

    def to_path3d(self) -> "Path3D":
        """The edges as a `trimesh.path.Path3D`, one line entity for each branch."""
        from msf_jax.skeleton import converting

        return converting.path3d_of(self)


def curve_of(vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray) -> Skeleton:
    """A skeleton of a curve without its mesh, as files of other programs have it: without a map, and with a report that
    has only the counts."""
    components, cycles = graphs.cycle_count(len(vertices), edges)
    report = Report(components, components, cycles, cycles, float("nan"), True, "read from a file")
    return Skeleton(vertices, edges, radii, np.empty(0, dtype=np.int64), report)


pytree.register(Skeleton)
