"""The start of a component's flow: its frame, the filter, coarsening or resampling, handles and poles."""

from collections.abc import Callable
from typing import Any

import numpy as np

from msf_jax.base.clock import Clock, begin
from msf_jax.base.errors import MeshError
from msf_jax.base.layout import layout_for, smaller_layouts
from msf_jax.base.options import Config, PreprocessingOptions
from msf_jax.flow.programs import compile_moves
from msf_jax.flow.state import State
from msf_jax.inside import balls
from msf_jax.limbs.tree import LimbTree
from msf_jax.meshes.checking import Component
from msf_jax.meso import edits, packing, ring_tables
from msf_jax.meso.frame import UnitFrame, frame_of, sort_mesh
from msf_jax.meso.meso import Meso
from msf_jax.numerics import reconstruction
from msf_jax.numerics.reconstruction import LowPass
from msf_jax.recording.records import FoundPoles, Start
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import RESOLUTION, signed_volume, triangle_areas

FIRST = 400.0  # 1/diagonals: the first w_L over the square root of the mean area of a face, see `Config.au2008`
LEAST_VOLUME = 1e-9  # diagonals cubed: of a component whose coordinates are rounded to the frame's grid
MOST_REFINED = 8_000  # vertices: refining stops at about this many
LEAST_REFINED = 0.05  # share of the area that must be at long edges; below it, refining changes no limb or hole
MOST_COARSENED = 0.05  # share of the volume that coarsening may change; above it, the surface is not coarsened
GROWTH, GROWTH_MARGIN = 3, 1000  # splits may grow the surface to this multiple of its vertices, plus these
MOST_FILTERED = 0.25  # share of the volume that the filter for poles may remove; above it, the filter is left out


def init(
    component: Component,
    number: int,
    config: Config,
    clock: Clock,
    pins: np.ndarray | None = None,
    weights: np.ndarray | None = None,
    begin_rest: Callable[[], Any] = list,
) -> State:
    """The first state of a component: in its own frame, resampled if the config says so, with its poles.

    ``pins`` are ids of vertices of the component that stay fixed. ``weights`` (V, 4) are weights per vertex, if given.
    ``begin_rest`` begins what the end of the run needs: it is called when what is needed first was begun.
    """
    options = config.preprocessing
    clock.check()
    frame, order, outside, shape = _entered(component)
    faces = outside.faces
    pins = np.flatnonzero(np.isin(order, [] if pins is None else pins))
    vertices, mesh_filter = outside.vertices, None
    if options.reconstruct_mesh:
        with clock.stage("reconstruction"):
            exact = options.exact_reconstruction
            vertices, mesh_filter = _rebuilt(vertices, faces, options.reconstruct_mesh, exact)
            vertices[pins] = outside.vertices[pins]
    thickness, prepared = begin(balls.scales, vertices, faces), begin(outside.prepare)
    begin_rest()
    meso = Meso.from_mesh(vertices, faces)
    meso.is_fixed[pins] = True
    meso.weights = None if weights is None else weights[order]
    clock.check()
    if abs(signed_volume(meso.positions, faces)) < LEAST_VOLUME:
        raise MeshError(
            f"component {number} is too thin: no volume is left of it at the flow's resolution, "
            f"{RESOLUTION:.0e} of its diagonal; expected a solid"
        )
    if component.genus:
        with clock.stage("homology"):
            classes = outside.handles.half_edge_classes()
            meso.classes = ring_tables.beside_rings(meso.rings, faces, classes)
    clock.check()
    with clock.stage("thickness"):
        meso.scale = thickness.result()
    max_rows = GROWTH * meso.num_rows + GROWTH_MARGIN
    if options.resample:
        with clock.stage("resampling"):
            meso = _resampled(meso, options.resample)
    elif options.refine:
        with clock.stage("refining"):
            _refine(meso, outside, options.refine)
    max_rows = max(max_rows, GROWTH * meso.num_rows)
    clock.check()
    meso, num_coarsened = _coarsened(meso, config, clock)
    clock.check()
    # A surface that was refined before has more triangles than the solid's own, and is no nearer to it.
    is_coarsened = len(outside.vertices) > 2 * meso.num_rows and not (options.reconstruct_mesh or options.resample)
    coarse = Enclosure(meso.positions, meso.faces()) if is_coarsened else outside
    with clock.stage("poles"):
        prepared.result()
        coarse.prepare()  # before two threads ask for it
    clock.check()
    with clock.stage("compile"):  # for the size of the surface, and for the smaller ones that it passes through
        layouts = [layout_for(meso.num_rows, packing.rows_beyond(meso.degree))]
        if config.flow.edit_connectivity and config.max_iterations > 1:
            layouts += smaller_layouts(layouts[0])
        compile_moves(config.on_device, layouts, meso.weights is not None)
    clock.check()
    limbs = None
    if config.least_slenderness or config.curve.extend_tips:
        limbs = begin(_find_limbs, coarse, config.least_slenderness, config.detail)
    found = None
    if options.use_poles:
        found = _poles(meso, outside, options, clock)
        meso.poles = np.where(found.is_inside[:, None], found.poles, meso.positions)
        meso.has_pole = found.is_inside.copy()  # edits change the surface, not what was found
    start, meso.edits = Start(mesh_filter, meso.edits, found), []
    ring_area = np.empty(0)
    if config.flow.w_H_follows_area:
        faces = meso.faces()
        area = np.tile(triangle_areas(meso.positions[faces]), 3)
        ring_area = np.bincount(faces.T.ravel(), weights=area, minlength=meso.num_rows)
    return State(
        number=number,
        frame=frame,
        order=order,
        outside=outside,
        shape=shape,
        coarse=coarse,
        pins=pins,
        first_volume=meso.volume(),
        max_rows=max_rows,
        num_coarsened=num_coarsened,
        first_area=meso.area(),
        first_ring_area=ring_area,
        start=start,
        meso=meso,
        t_c=config.flow.threshold_min,
        limbs=limbs,
        w_L_factor=FIRST * np.sqrt(meso.area() / len(meso.faces())) if config.flow.w_H_follows_area else 1.0,
    )


def _entered(component: Component) -> tuple[UnitFrame, np.ndarray, Enclosure, Enclosure]:
    """The frame of a component, the order of its vertices there, its outer surface, and its solid with its cavities."""
    frame = frame_of(component.vertices)
    entered = frame.enter(component.vertices)
    order, faces = sort_mesh(entered, component.faces)
    outside = Enclosure(entered[order], faces)
    if component.cavities is None:
        return frame, order, outside, outside
    lining, hollow = component.cavities
    vertices, inner = np.concatenate([outside.vertices, frame.enter(lining)]), hollow + len(order)
    return frame, order, outside, Enclosure(vertices, np.concatenate([faces, inner]))


def _find_limbs(shape: Enclosure, least: float, detail: float) -> LimbTree:
    """The merge trees of a surface, whose limbs are known then."""
    tree = LimbTree(shape)
    tree.limbs(least, detail)
    return tree


def _coarsened(meso: Meso, config: Config, clock: Clock) -> tuple[Meso, int]:
    """The surface with its short edges collapsed, and the number of vertices removed; unchanged if its volume would
    change by more than ``MOST_COARSENED``."""
    if not config.coarsen:
        return meso, 0
    with clock.stage("coarsening"):
        coarsened, volume = meso.copied(), meso.volume()
        edits.collapse_short_edges(coarsened, config.coarsen, keep_faces=True)
        if abs(coarsened.volume() - volume) > MOST_COARSENED * abs(volume):
            return meso, 0
        return coarsened.compacted(), coarsened.num_rows - coarsened.num_live


def _refine(meso: Meso, shape: Enclosure, refine: float) -> None:
    """Split edges that are longer than ``refine``, and long for their limb: else patches slide across holes. A surface
    whose long edges bound little area is left as it is."""
    a, b = ring_tables.edges_from_rings(meso.rings)
    length = edits.edge_lengths(meso.positions, a, b)
    is_long = length > refine
    longest = np.zeros(meso.num_rows)
    np.maximum.at(longest, np.concatenate([a, b])[np.tile(is_long, 2)], np.tile(length[is_long], 2))
    faces = meso.faces()
    if triangle_areas(meso.positions[faces[(longest > 0)[faces].sum(axis=1) > 1]]).sum() < LEAST_REFINED * meso.area():
        return
    # Equilateral triangles with edges of this length cover the surface with about MOST_REFINED vertices.
    least = max(refine, float(np.sqrt(meso.area() / (MOST_REFINED * 0.4))))
    asked = longest > least
    limit = np.full(meso.num_rows, 1.0)
    limit[asked] = balls.edge_lengths(shape, meso.positions[asked], longest[asked])
    edits.split_long_edges(meso, np.maximum(limit, least))


def _rebuilt(vertices: np.ndarray, faces: np.ndarray, k: int, exact: bool) -> tuple[np.ndarray, LowPass | None]:
    kept = reconstruction.low_pass(faces, len(vertices), k, exact=exact)
    return reconstruction.apply(kept, vertices, faces), kept


def _resampled(meso: Meso, length: float) -> Meso:
    """The surface with edges between 4/5 and 4/3 of ``length``, except where topology forbids a collapse."""
    for _ in range(3):
        edits.split_long_edges(meso, 4 / 3 * length)
        edits.collapse_short_edges(meso, 4 / 5 * length)
        meso = meso.compacted()
    return meso


def _poles(meso: Meso, shape: Enclosure, options: PreprocessingOptions, clock: Clock) -> FoundPoles:
    """Poles of the (reconstructed) surface, and whether each pulls: only inside the input's surface.

    On a thin solid the reconstruction, which would leave little more than the axis, is left out.
    """
    sites, faces, kept = meso.positions, meso.faces(), None
    if options.reconstruct_poles and (meso.scale is None or np.median(meso.scale) == 1):
        with clock.stage("reconstruction"):
            rebuilt, low_pass = _rebuilt(sites, faces, options.reconstruct_poles, options.exact_reconstruction)
        if signed_volume(rebuilt, faces) >= (1 - MOST_FILTERED) * meso.volume():
            sites, kept = rebuilt, low_pass
    with clock.stage("poles"):
        find = balls.ball_poles if options.poles == "balls" else balls.voronoi_poles
        found = find(sites, faces, box=shape.vertices)
        has_pole = found.is_found.copy()
        has_pole[has_pole] = shape.contains(found.position[has_pole])
        return FoundPoles(kept, sites, found.position, found.tetrahedron, has_pole)
