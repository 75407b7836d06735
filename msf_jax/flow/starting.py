"""The start of a component's flow: its frame, the filter, coarsening or resampling, handles and poles."""

import numpy as np

from msf_jax.base.clock import Clock, begin
from msf_jax.base.errors import MeshError
from msf_jax.base.options import Config, PreprocessingOptions
from msf_jax.flow.state import LIMITS, Limits, State
from msf_jax.flow.stepping import compile_ahead
from msf_jax.inside import balls
from msf_jax.limbs.caps import Caps
from msf_jax.meshes.checking import Component
from msf_jax.meso import collapse, homology, ring_tables, split
from msf_jax.meso.meso import Meso
from msf_jax.numerics import reconstruction
from msf_jax.numerics.reconstruction import LowPass
from msf_jax.recording.records import FoundPoles, Start
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.frame import RESOLUTION, UnitFrame, frame_of, sort_mesh
from msf_jax.solid.geometry import signed_volume, triangle_areas

FIRST = 400.0  # 1/diagonals: the first w_L over the square root of the mean area of a face, see `Config.au2008`
LEAST_VOLUME = 1e-9  # diagonals cubed: of a component whose coordinates are rounded to the frame's grid
MOST_REFINED = 8_000  # vertices: refining stops at about this many
LEAST_REFINED = 0.05  # share of the area that must be at long edges; below it, refining changes no limb or hole
MOST_COARSENED = 0.05  # share of the volume that coarsening may change; above it, the surface is not coarsened
MOST_FILTERED = 0.25  # share of the volume that the filter for poles may remove; above it, the filter is left out


def init(
    component: Component,
    number: int,
    config: Config,
    clock: Clock,
    pins: np.ndarray | None = None,
    weights: np.ndarray | None = None,
    limits: Limits = LIMITS,
) -> State:
    """The first state of a component: in its own frame, resampled if the config says so, with its poles.

    ``pins`` are ids of vertices of the component that stay fixed. ``weights`` (V, 4) are weights per vertex, if given.
    """
    options = config.preprocessing
    clock.check()
    frame, order, shape, solid = _entered(component)
    faces = shape.faces
    pins = np.flatnonzero(np.isin(order, [] if pins is None else pins))
    meso, mesh_filter = _surface(shape, pins, options, clock)
    meso.weights = None if weights is None else weights[order]
    clock.check()
    with clock.stage("thickness"):
        meso.scale = balls.scales(meso.positions, faces)
    if abs(meso.volume()) < LEAST_VOLUME:
        raise MeshError(
            f"component {number} is too thin: no volume is left of it at the flow's resolution, "
            f"{RESOLUTION:.0e} of its diagonal; expected a solid"
        )
    if 0 < component.genus <= homology.LARGEST_GENUS:
        with clock.stage("homology"):
            meso.classes = homology.ring_classes(shape.vertices, faces, meso.rings)
    clock.check()
    max_rows = limits.growth * meso.num_rows + limits.growth_margin
    if options.resample:
        with clock.stage("resampling"):
            meso = _resampled(meso, options.resample, config.check)
            max_rows = max(max_rows, limits.growth * meso.num_rows)
    else:
        meso = _refined(meso, shape, config, clock)
        max_rows = max(max_rows, limits.growth * meso.num_rows)
    clock.check()
    meso, num_coarsened = _coarsened(meso, config, clock)
    clock.check()
    # A surface that was refined before has more triangles than the solid's own, and is no nearer to it.
    is_coarsened = len(shape.vertices) > 2 * meso.num_rows and not (options.reconstruct_mesh or options.resample)
    coarse = Enclosure(meso.positions, meso.faces()) if is_coarsened else shape
    with clock.stage("poles"):
        _ = coarse.mesh  # made here, before two threads ask for it
    # Split edges follow the limbs of a solid of few triangles better; filtered or resampled surfaces are others.
    is_same = len(meso.positions) > len(shape.vertices) and not (options.reconstruct_mesh or options.resample)
    of_limbs = Enclosure(meso.positions, meso.faces()) if is_same else coarse
    clock.check()
    with clock.stage("compile"):
        compile_ahead(meso, config)
    clock.check()
    caps = None
    if config.least_slenderness or config.curve.extend_tips:
        caps = begin(_with_limbs, of_limbs, config.least_slenderness, config.detail, clock)
    found = None
    if options.use_poles:
        found = _poles(meso, shape, options, clock)
        meso.poles = np.where(found.is_inside[:, None], found.poles, meso.positions)
        meso.has_pole = found.is_inside.copy()  # edits change the surface, not what was found
        meso.trust = found.trust.copy() if options.pole_confidence else None
    start = Start(mesh_filter, meso.edits, found)
    meso.edits = []
    return State(
        component=component,
        number=number,
        frame=frame,
        order=order,
        shape=shape,
        solid=solid,
        coarse=coarse,
        pins=pins,
        first_volume=meso.volume(),
        max_rows=max_rows,
        num_coarsened=num_coarsened,
        first_area=meso.area(),
        first_ring_area=_one_ring_areas(meso) if config.flow.w_H_follows_area else np.empty(0),
        poles=meso.poles[meso.node_of_input],
        has_pole=meso.has_pole[meso.node_of_input],
        start=start,
        meso=meso,
        t_c=config.flow.threshold_min,
        caps=caps,
        w_L_factor=FIRST * np.sqrt(meso.area() / len(meso.faces())) if config.flow.w_H_follows_area else 1.0,
    )


def _entered(component: Component) -> tuple[UnitFrame, np.ndarray, Enclosure, Enclosure]:
    """The frame of a component, the order of its vertices there, its outer surface, and its solid with its cavities."""
    frame = frame_of(component.vertices)
    entered = frame.enter(component.vertices)
    order, faces = sort_mesh(entered, component.faces)
    shape = Enclosure(entered[order], faces)
    if component.cavities is None:
        return frame, order, shape, shape
    lining, hollow = component.cavities
    vertices, inner = np.concatenate([shape.vertices, frame.enter(lining)]), hollow + len(order)
    return frame, order, shape, Enclosure(vertices, np.concatenate([faces, inner]))


def _with_limbs(shape: Enclosure, least: float, detail: float, clock: Clock) -> Caps:
    """The caps of a surface, whose limbs are known then, see `Caps.limbs`."""
    caps = Caps(shape, detail, clock.ask)
    caps.limbs(least)
    return caps


def _surface(
    shape: Enclosure, pins: np.ndarray, options: PreprocessingOptions, clock: Clock
) -> tuple[Meso, LowPass | None]:
    """The surface to contract, with its pins fixed, and the filter that was applied to it, if any."""
    vertices, kept = shape.vertices, None
    if options.reconstruct_mesh:
        with clock.stage("reconstruction"):
            vertices, kept = _rebuilt(vertices, shape.faces, options.reconstruct_mesh, options)
            vertices[pins] = shape.vertices[pins]
    meso = Meso.from_mesh(vertices, shape.faces)
    meso.is_fixed[pins] = True
    return meso, kept


def _coarsened(meso: Meso, config: Config, clock: Clock) -> tuple[Meso, int]:
    """The surface with its short edges collapsed, and the number of vertices removed.

    The surface is returned unchanged if coarsening would change its volume by more than ``MOST_COARSENED``.
    """
    if not config.coarsen:
        return meso, 0
    with clock.stage("coarsening"):
        coarsened = meso.copied()
        collapse.collapse_short_edges(coarsened, config.coarsen, keep_faces=True, check=config.check)
        if abs(coarsened.volume() - meso.volume()) > MOST_COARSENED * abs(meso.volume()):
            return meso, 0
        return coarsened.compacted(), coarsened.num_rows - coarsened.num_live


def _refined(meso: Meso, shape: Enclosure, config: Config, clock: Clock) -> Meso:
    """The surface with edges split that are long compared with the limb's thickness: else patches slide across holes.

    A surface whose long edges bound little area is returned unchanged.
    """
    refine = config.preprocessing.refine
    if not refine:
        return meso
    with clock.stage("refining"):
        a, b = ring_tables.edges_from_rings(meso.rings)
        length = collapse.edge_lengths(meso.positions, a, b)
        is_long = length > refine
        longest = np.zeros(meso.num_rows)
        np.maximum.at(longest, np.concatenate([a, b])[np.tile(is_long, 2)], np.tile(length[is_long], 2))
        is_end = longest > 0
        corners = meso.positions[(faces := meso.faces())[is_end[faces].sum(axis=1) > 1]]
        if triangle_areas(corners).sum() < LEAST_REFINED * meso.area():
            return meso
        # Equilateral triangles with edges of this length cover the surface with about MOST_REFINED vertices.
        least = max(refine, float(np.sqrt(meso.area() / (MOST_REFINED * 0.4))))
        asked = longest > least
        limit = np.full(meso.num_rows, 1.0)
        limit[asked] = balls.edge_lengths(shape, meso.positions[asked], longest[asked])
        split.split_long_edges(meso, np.maximum(limit, least), check=config.check)
        return meso


def _rebuilt(
    vertices: np.ndarray, faces: np.ndarray, k: int, options: PreprocessingOptions
) -> tuple[np.ndarray, LowPass | None]:
    kept = reconstruction.low_pass(faces, len(vertices), k, exact=options.exact_reconstruction)
    return reconstruction.apply(kept, vertices, faces), kept


def _resampled(meso: Meso, length: float, check: bool) -> Meso:
    """The surface with edges between 4/5 and 4/3 of ``length``, except where topology forbids a collapse."""
    for _ in range(3):
        split.split_long_edges(meso, 4 / 3 * length, check=check)
        collapse.collapse_short_edges(meso, 4 / 5 * length, check=check)
        meso = meso.compacted()
    return meso


def _poles(meso: Meso, shape: Enclosure, options: PreprocessingOptions, clock: Clock) -> FoundPoles:
    """Poles of the (reconstructed) surface, whether each pulls (only inside the input's surface), and their trust.

    The trust in a pole is (1 - cos(spoke angle)) / 2. On a thin solid the reconstruction is left out: it keeps too few
    frequencies, and would leave little more than the axis.
    """
    sites, faces, kept = meso.positions, meso.faces(), None
    is_thin = meso.scale is not None and bool(np.median(meso.scale) < 1)
    if options.reconstruct_poles and not is_thin:
        with clock.stage("reconstruction"):
            sites, kept = _rebuilt(sites, faces, options.reconstruct_poles, options)
        is_thin = signed_volume(sites, faces) < (1 - MOST_FILTERED) * meso.volume()
    if is_thin:
        sites, kept = meso.positions, None
    with clock.stage("poles"):
        seek = balls.ball_poles if options.poles == "balls" or (options.poles == "auto" and is_thin) else None
        found = (seek or balls.voronoi_poles)(sites, faces, box=shape.vertices)
        has_pole = found.is_found.copy()
        has_pole[has_pole] = shape.contains(found.position[has_pole])
        trust = (1 - np.cos(balls.spoke_angles(found, sites))) / 2
        return FoundPoles(kept, sites, found.position, found.tetrahedron, has_pole, trust)


def _one_ring_areas(meso: Meso) -> np.ndarray:
    area = triangle_areas(meso.positions[meso.faces()])
    return np.bincount(meso.faces().T.ravel(), weights=np.tile(area, 3), minlength=meso.num_rows)
