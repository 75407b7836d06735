"""Machined solids whose right curve is a closed form: where it ends, how long it may be, how many loops it has.

Each is made by seed, which changes its sizes by up to 5 %, around the origin, so that its symmetries are matrices. The
coarse form has the few triangles that CAD writes; the fine one has edges of about 0.3 radii of its limb.
"""

import zlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import manifold3d
import numpy as np
import trimesh
from scipy.spatial.transform import Rotation

from msf_jax.meso import edits
from msf_jax.meso.meso import Meso

SIDES = 32  # of round solids and of holes; a multiple of four keeps a cylinder's quarter turns
SPACING = 0.3  # edges of the fine form, in radii of the thinnest limb
MOST_TRIANGLES = 16_000  # of the fine form: its edges are longer where there would be more
GAP = 0.3  # radii that a curve stops before an end face, as documented
SLACK, SLACK_WITH_HOLES = 1.02, 1.06  # greatest length over the axis: a curve goes around a hole
FORMS = ("coarse", "coarse-turned", "fine", "fine-turned")

Manifold = manifold3d.Manifold
Size = Callable[[float], float]
Limb = tuple[Sequence[Sequence[float]], float, float]  # its line to its end face, its ball's radius there, half width
X, Y, Z = np.diag([-1.0, 1, 1]), np.diag([1.0, -1, 1]), np.diag([1.0, 1, -1])  # mirrors
QUARTER = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
SWAP = np.array([[1.0, 0, 0], [0, 0, 1], [0, 1, 0]])  # y and z
THIRD = np.array([[-0.5, -np.sqrt(0.75), 0], [np.sqrt(0.75), -0.5, 0], [0, 0, 1]])  # of a turn around z


@dataclass(frozen=True, eq=False)
class Solid:
    """A solid and what is right for its curve, in lengths of the solid.

    Attributes:
        body: the solid.
        ends: (K, 3) where axes of limbs meet their end faces.
        outwards: (K, 3) the axes' directions there.
        radii: (K,) the limb's inscribed ball near its end; the curve's leaf is 0.3 of it before ``ends``.
        widths: (K,) half widths: radii of the discs that have the area of the limbs' sections.
        length: of the axis, from end face to end face; the greatest right one where there is no one way.
        width: the half width that counts for the whole.
        edge: of the fine form.
        cycles: handles.
        axis: lines (N, 3) that the curve follows; none where it has no one way, as in a table's top.
        symmetries: matrices that map the solid to itself.
        slack: greatest length of the curve over ``length``.
    """

    body: Manifold
    ends: np.ndarray
    outwards: np.ndarray
    radii: np.ndarray
    widths: np.ndarray
    length: float
    width: float
    edge: float
    cycles: int = 0
    axis: list[np.ndarray] = field(default_factory=list)
    symmetries: Sequence[np.ndarray] = ()
    slack: float = SLACK

    @property
    def places(self) -> np.ndarray:
        """(K, 3) where leaves belong."""
        return self.ends - GAP * self.radii[:, None] * self.outwards

    def mesh(self, form: str) -> trimesh.Trimesh:
        """Its surface in one of ``FORMS``, without the turn."""
        body = self.body
        if form.startswith("fine"):
            least = np.sqrt(body.surface_area() / MOST_TRIANGLES * 4 / np.sqrt(3))
            body = body.refine_to_length(max(self.edge, float(least)))
        found = body.to_mesh64()
        return trimesh.Trimesh(found.vert_properties[:, :3], found.tri_verts.astype(np.int64), process=False)


def turn_of(name: str, form: str, seed: int) -> np.ndarray:
    """(3, 3) how the form is turned."""
    if not form.endswith("turned"):
        return np.eye(3)
    return Rotation.random(rng=_random(f"{name}/{form}", seed)).as_matrix()


def size_of(name: str, seed: int) -> Size:
    """By how much the sizes of the solid of that name change."""
    random = _random(name, seed)
    return lambda value: value * random.uniform(0.95, 1.05)


def _random(name: str, seed: int) -> np.random.Generator:
    return np.random.default_rng([seed, zlib.crc32(name.encode())])


def box(x: float, y: float, z: float) -> Manifold:
    return Manifold.cube((x, y, z), center=True)


def rod(length: float, low: float, high: float | None = None, sides: int = SIDES) -> Manifold:
    """Around z, its middle at the origin."""
    return Manifold.cylinder(length, low, low if high is None else high, sides, center=True)


def at(body: Manifold, x: float, y: float, z: float) -> Manifold:
    return body.translate((x, y, z))


def along_x(body: Manifold) -> Manifold:
    return body.rotate((0.0, 90.0, 0.0))


def straight(
    body: Manifold,
    low: float,
    high: float,
    radii: tuple[float, float],
    widths: tuple[float, float],
    symmetries: Sequence[np.ndarray] = (),
    along: int = 2,
) -> Solid:
    """One limb along an axis of coordinates, from ``low`` to ``high``."""
    way, width = np.eye(3)[along], float(np.mean(widths))
    ends, edge = np.outer([low, high], way), SPACING * (min(radii) or max(radii) / 2)
    half = np.array([each or width for each in widths])
    limb = (ends, np.outer([-1.0, 1.0], way), np.array(radii), half)
    return Solid(body, *limb, high - low, width, edge, axis=[ends], symmetries=symmetries)


def _half_width(area: float) -> float:
    return float(np.sqrt(area / np.pi))


def _bar(x: float, y: float, z: float) -> Solid:
    """Along x, which is the longest."""
    radius, width = min(y, z) / 2, _half_width(y * z)
    return straight(box(x, y, z), -x / 2, x / 2, (radius, radius), (width, width), (X, Y, Z), along=0)


def _beam(length: float, side: float) -> Solid:
    return replace(_bar(length, side, side), symmetries=(X, Y, Z, SWAP))


def _cylinder(length: float, radius: float) -> Solid:
    size = (radius, radius)
    return straight(rod(length, radius), -length / 2, length / 2, size, size, (X, Y, Z, QUARTER))


def _cone(length: float, low: float, high: float) -> Solid:
    """A frustum, or a cone where ``high`` is 0."""
    body = rod(length, low, high)
    return straight(body, -length / 2, length / 2, (low, high), (low, high), (X, Y, QUARTER))


def _pencil(length: float, radius: float, height: float) -> Solid:
    """A cone on a cylinder."""
    body = rod(length, radius) + at(rod(height, radius, 0.0), 0, 0, (length + height) / 2)
    return straight(body, -length / 2, length / 2 + height, (radius, 0.0), (radius, 0.0), (X, QUARTER))


def limbs(
    body: Manifold,
    lines: Sequence[Limb],
    symmetries: Sequence[np.ndarray],
    loops: Sequence[np.ndarray] = (),
) -> Solid:
    """Limbs that meet. Loops have no end. The thinnest limb's half width counts for the whole, as a bolt's does."""
    axis = [np.array(line, dtype=float) for line, _, _ in lines]
    last = np.array([line[-1] - line[-2] for line in axis])
    radii, widths = np.array([sizes for _, *sizes in lines]).T
    lengths = [float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum()) for line in [*axis, *loops]]
    return Solid(
        body,
        *(np.array([line[-1] for line in axis]), last / np.linalg.norm(last, axis=1, keepdims=True), radii, widths),
        *(sum(lengths), float(widths.min()), SPACING * float(radii.min())),
        cycles=len(loops),
        axis=[*axis, *loops],
        symmetries=symmetries,
    )


def _tee(body: Manifold, arm: float, stem: float, radius: float, width: float) -> Solid:
    """Along x from -``arm`` to ``arm``, and along -z to -``stem``."""
    tips = (-arm, 0.0, 0.0), (arm, 0.0, 0.0), (0.0, 0.0, -stem)
    return limbs(body, [(((0.0, 0.0, 0.0), tip), radius, width) for tip in tips], (X, Y))


def _pipe_tee(arm: float, stem: float, radius: float) -> Solid:
    body = along_x(rod(2 * arm, radius)) + at(rod(stem, radius), 0, 0, -stem / 2)
    return _tee(body, arm, stem, radius, radius)


def _square_tee(arm: float, stem: float, side: float) -> Solid:
    body = box(2 * arm, side, side) + at(box(side, side, stem), 0, 0, -stem / 2)
    return _tee(body, arm, stem, side / 2, _half_width(side**2))


def _bolt(shank: float, radius: float, head: float, height: float, sides: int = 6) -> Solid:
    """Its shank goes down from the origin, its head of six sides up; a nail has a round head."""
    body = at(rod(shank, radius), 0, 0, -shank / 2) + at(rod(height, head, sides=sides), 0, 0, height / 2)
    wide = head * float(np.sqrt(sides * np.sin(2 * np.pi / sides) / 2 / np.pi))
    found = straight(body, -shank, height, (radius, height / 2), (radius, wide), (X, Y))
    return replace(found, width=radius)


def _socket_bolt(shank: float, radius: float, head: float, height: float) -> Solid:
    """With six walls sunk into a round head by half of its height, where the curve then ends."""
    body = at(rod(shank, radius), 0, 0, -shank / 2) + at(rod(height, head), 0, 0, height / 2)
    body -= at(rod(height, 0.5 * head, sides=6), 0, 0, height)
    found = straight(body, -shank, height / 2, (radius, height / 4), (radius, head), (X, Y))
    return replace(found, width=radius)


def _i_beam(length: float, flange: float, height: float, thick: float, web: float) -> Solid:
    """Along x, its web upright."""
    body = box(length, web, height)
    for side in (-1, 1):
        body += at(box(length, flange, thick), 0, 0, side * (height - thick) / 2)
    width = _half_width(2 * flange * thick + (height - 2 * thick) * web)
    return straight(body, -length / 2, length / 2, (web / 2, web / 2), (width, width), (X, Y, Z), along=0)


def _table(x: float, y: float, top: float, leg: float, height: float) -> Solid:
    """Four square legs under a thin top, which the curve may cross as it likes."""
    body, width = at(box(x, y, top), 0, 0, top / 2), _half_width(leg**2)
    lines: list[Limb] = []
    for u, v in _four((x - leg) / 2, (y - leg) / 2):
        body += at(box(leg, leg, height), u, v, -height / 2)
        lines.append((((0, 0, top), (u, v, top), (u, v, -height)), leg / 2, width))
    return replace(limbs(body, lines, (X, Y)), axis=[])


def ring(body: Manifold, radius: np.ndarray, thin: float, width: float, symmetries: Sequence[np.ndarray]) -> Solid:
    """A ring around z whose middle is ``radius`` (N,) from it, at N angles."""
    angle = np.linspace(0, 2 * np.pi, len(radius))
    axis = np.stack([radius * np.cos(angle), radius * np.sin(angle), 0 * angle], axis=1)
    length, none = float(np.linalg.norm(np.diff(axis, axis=0), axis=1).sum()), np.zeros((0, 3))
    no_limb = (none, none, none[:, 0], none[:, 0])
    return Solid(body, *no_limb, length, width, SPACING * thin, cycles=1, axis=[axis], symmetries=symmetries)


def _torus(radius: float, minor: float) -> Solid:
    section = manifold3d.CrossSection.circle(minor, 16).translate((radius, 0.0))
    return ring(section.revolve(SIDES), np.full(361, radius), minor, minor, (X, Y, Z, QUARTER))


def _washer(inner: float, outer: float, height: float, sides: int = SIDES) -> Solid:
    """A round hole in a disc; in a nut of six sides for ``sides`` 6."""
    body = rod(height, outer, sides=sides) - rod(2 * height, inner)
    half = np.pi / sides  # the outer wall is nearest in the middle of a side
    angle = np.linspace(0, 2 * np.pi, 361) % (2 * half) - half
    wall = outer * np.cos(half) / np.cos(angle) - inner
    width = _half_width(float(wall.mean()) * height)
    return ring(body, inner + wall / 2, min(height, wall.min()) / 2, width, (X, Y, Z))


def _bored_ball(radius: float, bore: float) -> Solid:
    """The loop is where its inscribed balls are largest."""
    body = Manifold.sphere(radius, SIDES) - rod(3 * radius, bore)
    middle, half = (radius + bore) / 2, (radius - bore) / 2
    return ring(body, np.full(361, middle), half, half, (X, Y, Z, QUARTER))


def _drilled(
    solid: Solid,
    holes: Sequence[tuple[float, float]],
    radius: float,
    depth: float,
    top: float,
    symmetries: Sequence[np.ndarray],
) -> Solid:
    """Blind holes down from the plane z = ``top``."""
    body = solid.body
    for x, y in holes:
        body -= at(rod(2 * depth, radius, sides=24), x, y, top)
    return replace(solid, body=body, slack=SLACK_WITH_HOLES, symmetries=symmetries)


def _pocketed(
    solid: Solid, size: tuple[float, float], depth: float, top: float, symmetries: Sequence[np.ndarray]
) -> Solid:
    """A pocket with four walls, down from the plane z = ``top``, in the middle."""
    body = solid.body - at(box(*size, 2 * depth), 0, 0, top)
    return replace(solid, body=body, slack=SLACK_WITH_HOLES, symmetries=symmetries)


def _no_way(body: Manifold, size: float, thin: float) -> Solid:
    """No way is better than others: at most one branch over the ``size``, from face to face with the gaps of a ball
    of radius ``thin``."""
    none = np.zeros((0, 3))
    return Solid(body, none, none, none[:, 0], none[:, 0], size - 2 * GAP * thin, size / 2, SPACING * thin)


def _four(x: float, y: float) -> list[tuple[float, float]]:
    return [(u * x, v * y) for u in (-1, 1) for v in (-1, 1)]


def _holed_cylinder(s: Size) -> Solid:
    found = straight(along_x(rod(length := s(8), 1.0)), -length / 2, length / 2, (1.0, 1.0), (1.0, 1.0), along=0)
    return _drilled(found, [(s(1), 0.0)], 0.3, 0.7, 1.0, (Y,))


def _holed_ball(s: Size) -> Solid:
    ball = _no_way(Manifold.sphere(2.0, SIDES), 4.0, 1.0)
    return replace(ball, body=ball.body - at(rod(s(2), s(0.5)), 0, 0, 2.0))


def _profile(body: Manifold, length: float, thick: float, area: float, *symmetries: np.ndarray) -> Solid:
    """Along x, of bent sheet; the middle of its material is at y = z = 0."""
    radius, width = thick / 2, _half_width(area)
    found = straight(body, -length / 2, length / 2, (radius, radius), (width, width), along=0)
    return replace(found, symmetries=(X, *symmetries))


def _angle(length: float, side: float, thick: float) -> Solid:
    """Two equal legs, along y and z; the curve is in the corner."""
    middle = (side - thick) / 2
    body = at(box(length, side, thick), 0, middle, 0) + at(box(length, thick, side), 0, 0, middle)
    return _profile(body, length, thick, (2 * side - thick) * thick, SWAP)


def _channel(length: float, web: float, height: float, thick: float) -> Solid:
    """Two flanges up from the ends of a web, which has the curve."""
    body = box(length, web, thick)
    for side in (-1, 1):
        body += at(box(length, thick, height), 0, side * (web - thick) / 2, (height - thick) / 2)
    return _profile(body, length, thick, (web + 2 * height - 2 * thick) * thick, Y)


def _half_pipe(length: float, radius: float, thick: float) -> Solid:
    """The curve is along the back."""
    middle = radius - thick / 2
    pipe = along_x(rod(length, radius) - rod(2 * length, radius - thick))
    body = at(pipe ^ at(box(2 * length, 4 * radius, 4 * radius), 0, 0, 2 * radius), 0, 0, -middle)
    return _profile(body, length, thick, np.pi * middle * thick, Y)


def _bored(body: Manifold, low: float, floor: float, radius: float, width: float, bore: float) -> Solid:
    """A blind hole along the axis from its far end; the curve ends before the hole's floor, as in a bolt's socket."""
    found = straight(body, low, floor, (radius, radius), (width, width))
    return replace(found, slack=SLACK_WITH_HOLES, edge=SPACING * (radius - bore), symmetries=(X, Y, QUARTER))


def _bored_bar(length: float, depth: float) -> Solid:
    body = box(3, 3, length) - at(rod(2 * depth, 0.8, sides=24), 0, 0, length / 2)
    return _bored(body, -length / 2, length / 2 - depth, 1.5, _half_width(9.0), 0.8)


def _cup(length: float, depth: float) -> Solid:
    body = rod(length, 1.5) - at(rod(2 * depth, 0.8), 0, 0, length / 2)
    return _bored(body, -length / 2, length / 2 - depth, 1.5, 1.5, 0.8)


def _around_hole(radius: float, x: float, along: int) -> np.ndarray:
    """(N, 3) around a hole that goes along y or z through the axis x."""
    angle = np.linspace(0, 2 * np.pi, 361)
    line = np.zeros((361, 3))
    line[:, 0], line[:, 3 - along] = x + radius * np.cos(angle), radius * np.sin(angle)
    return line


def _two_bores(length: float, bore: float, middle: float) -> Solid:
    """A square bar with two holes through it, one across the other; the curve goes around each."""
    side, hole = 2.6, rod(9.0, bore)
    body = box(length, side, side) - at(hole, -middle, 0, 0) - at(hole.rotate((90.0, 0, 0)), middle, 0, 0)
    around = (side / 2 + bore) / 2
    loops = [_around_hole(around, -middle, 2), _around_hole(around, middle, 1)]
    between = np.array([[around - middle, 0, 0], [middle - around, 0, 0]])
    tips = [((u * (middle + around), 0, 0), (u * length / 2, 0, 0)) for u in (-1, 1)]
    found = limbs(body, [(line, side / 2, _half_width(side**2)) for line in tips], (Y, Z), [*loops, between])
    return replace(found, cycles=2, slack=SLACK_WITH_HOLES, edge=SPACING * (side / 2 - bore) / 2)


def _hammer(handle: float, head: float, side: float) -> Solid:
    """A square head along x, in the middle of which a round handle begins that goes down."""
    body, radius, half = at(rod(handle, 0.5), 0, 0, -handle / 2) + box(head, side, side), 0.5, side / 2
    lines = [(((0, 0, 0), (u * head / 2, 0, 0)), half, _half_width(side**2)) for u in (-1, 1)]
    return limbs(body, [*lines, (((0, 0, 0), (0, 0, -handle)), radius, radius)], (X, Y))


def _crossed_rods(length: float, degrees: float) -> Solid:
    """Two rods that cross at an oblique angle."""
    body, radius, turn = Manifold.sphere(0.75, SIDES), 0.7, np.radians(degrees)
    for side in (-1, 1):
        body += along_x(rod(2 * length, radius)).rotate((0, 0, side * degrees))
    tips = [(u * length * np.cos(turn), v * length * np.sin(turn), 0) for u in (-1, 1) for v in (-1, 1)]
    return limbs(body, [(((0, 0, 0), tip), radius, radius) for tip in tips], (X, Y, Z))


def _triangle(radius: float, thick: float) -> Solid:
    """Three round rods, and a ball at each corner."""
    side, body = at(along_x(rod(np.sqrt(3) * radius, thick)), 0, -radius / 2, 0), Manifold()
    for turn in (90, 210, 330):
        x, y = radius * np.cos(np.radians(turn)), radius * np.sin(np.radians(turn))
        body += side.rotate((0, 0, turn - 90)) + at(Manifold.sphere(1.05 * thick, SIDES), x, y, 0)
    angle = (np.linspace(0, 2 * np.pi, 361) + np.pi / 6) % (2 * np.pi / 3) - np.pi / 3  # from a side's middle
    return ring(body, radius / 2 / np.cos(angle), thick, thick, (X, Z, THIRD))


def _stool(height: float, radius: float, thick: float, seat: float) -> Solid:
    """Three round legs under a round seat, which the curve may cross as it likes."""
    body = at(rod(thick, seat), 0, 0, thick / 2)
    lines: list[Limb] = []
    for turn in np.arange(3) * 2 * np.pi / 3:
        u, v = 0.7 * seat * np.cos(turn), 0.7 * seat * np.sin(turn)
        body += at(rod(height, radius), u, v, -height / 2)
        lines.append((((0, 0, thick), (u, v, thick), (u, v, -height)), radius, radius))
    return replace(limbs(body, lines, (Y, THIRD)), axis=[], edge=SPACING * min(radius, thick / 2))


def _chair(side: float, leg: float, seat: float, height: float, back: float) -> Solid:
    """Four square legs under a square seat, which the curve may cross as it likes, and a back of its width."""
    out, top = (side - leg) / 2, seat + back
    body = at(box(side, side, seat), 0, 0, seat / 2) + at(box(leg, side, top), -out, 0, top / 2)
    lines: list[Limb] = [(((0, 0, seat), (-out, 0, seat), (-out, 0, top)), leg / 2, _half_width(side * leg))]
    for u, v in ((u * out, v * out) for u in (-1, 1) for v in (-1, 1)):
        body += at(box(leg, leg, height), u, v, -height / 2)
        lines.append((((0, 0, seat), (u, v, seat), (u, v, -height)), leg / 2, _half_width(leg**2)))
    return replace(limbs(body, lines, (Y,)), axis=[])


SOLIDS: dict[str, Callable[[Size], Solid]] = {
    "bar": lambda s: _bar(s(10.9), s(3.9), s(3.8)),
    "bar-flat": lambda s: _bar(s(10), s(4), s(2.5)),
    "beam-6": lambda s: _beam(s(6), 1.0),
    "beam-12": lambda s: _beam(s(12), 1.0),
    "slab": lambda s: _bar(s(9.3), s(5.4), s(1)),
    "plate": lambda s: _bar(s(12), s(4), s(0.7)),
    "tee": lambda s: _pipe_tee(s(5), s(5), 1.0),
    "tee-short": lambda s: _pipe_tee(s(3.5), s(3.5), 1.0),
    "tee-square": lambda s: _square_tee(s(5), s(6), 1.6),
    "bolt": lambda s: _bolt(s(6), s(0.6), s(1.2), s(0.8)),
    "bolt-long": lambda s: _bolt(s(10), s(0.5), s(0.95), s(0.65)),
    "nail": lambda s: _bolt(shank=s(6), radius=s(0.7), height=s(0.5), head=s(2.4), sides=SIDES),
    "i-beam": lambda s: _i_beam(s(9), s(3), s(3.6), s(0.6), s(0.5)),
    "table": lambda s: _table(s(9.4), s(5.4), s(0.6), s(0.7), s(4)),
    **{f"cylinder-{n}": lambda s, n=n: _cylinder(n * (radius := s(1)), radius) for n in (3, 4, 6, 8, 10, 12, 16)},
    "cone": lambda s: _cone(s(6), s(1.5), 0.0),
    "cone-thin": lambda s: _cone(s(9), s(1.2), 0.0),
    "pencil": lambda s: _pencil(s(2), s(1), s(5)),
    "pencil-blunt": lambda s: _pencil(s(6), s(1), s(1.5)),
    "frustum": lambda s: _cone(s(6), s(1.2), s(0.7)),
    "frustum-wide": lambda s: _cone(s(6), s(1.6), s(0.6)),
    "nut": lambda s: _washer(s(1), s(2), s(1.5), 6),
    "torus": lambda s: _torus(s(3), s(1)),
    "torus-thin": lambda s: _torus(s(3), s(0.45)),
    "washer": lambda s: _washer(s(2), s(3.8), s(1.8)),
    "washer-flat": lambda s: _washer(s(1.2), s(3.2), s(0.5)),
    "bar-hole": lambda s: _drilled(_bar(s(11), s(4), 3.8), [(s(1.5), 0.0)], 0.7, 1.3, 1.9, (Y,)),
    "bar-holes-4": lambda s: _drilled(_bar(s(12), s(4.4), 3.8), _four(s(3), 1.0), 0.5, 1.4, 1.9, (X, Y)),
    "bar-pocket": lambda s: _pocketed(_bar(s(11), 4.0, 3.8), (s(4), s(2)), 1.2, 1.9, (X, Y)),
    "beam-hole": lambda s: _drilled(_beam(s(7), 1.0), [(s(1), 0.0)], 0.22, 0.4, 0.5, (Y,)),
    "plate-holes-4": lambda s: _drilled(_bar(s(12), s(4.5), 1.0), _four(s(4), 1.2), 0.4, 0.6, 0.5, (X, Y)),
    "plate-pocket": lambda s: _pocketed(_bar(s(12), s(4.5), 1.0), (s(6), s(2.2)), 0.5, 0.5, (X, Y)),
    "slab-holes-4": lambda s: _drilled(_bar(s(9.3), s(5.4), 1.2), _four(s(3), 1.5), 0.5, 0.7, 0.6, (X, Y)),
    "cylinder-hole": _holed_cylinder,
    "tee-hole": lambda s: _drilled(_pipe_tee(s(5), s(5), 1.0), [(0.0, 0.0)], 0.35, 0.7, 1.0, (X, Y)),
    "bolt-socket": lambda s: _socket_bolt(s(6), s(0.6), s(1.2), s(1)),
    "torus-hole": lambda s: _drilled(_torus(3.0, 1.0), [(3.0, 0.0)], s(0.3), s(0.7), 1.0, (Y,)),
    "washer-holes-4": lambda s: _drilled(_washer(2.0, 3.8, 1.8), _four(2.05, 2.05), s(0.3), s(0.6), 0.9, (X, Y)),
    "ball-bore": lambda s: _bored_ball(s(2), s(0.4)),
    "hammer": lambda s: _hammer(s(8), s(4), 1.4),
    "hammer-wide": lambda s: _hammer(8.0, s(5), s(2)),
    "x-rods": lambda s: _crossed_rods(s(6), s(30)),
    "stool-3": lambda s: _stool(s(5), s(0.4), s(0.6), s(2.4)),
    "chair": lambda s: _chair(s(4), s(0.6), s(0.6), s(4), s(4)),
    "l-profile": lambda s: _angle(s(9), s(3), s(0.8)),
    "u-channel": lambda s: _channel(s(9), s(3), s(2.2), s(0.6)),
    "half-pipe": lambda s: _half_pipe(s(9), s(2), 0.5),
    "end-hole-bar": lambda s: _bored_bar(s(9), s(2.5)),
    "cup": lambda s: _cup(s(7), s(4)),
    "bar-2-bores": lambda s: _two_bores(s(12), s(0.6), s(3)),
    "triangle-frame": lambda s: _triangle(s(4), s(0.5)),
}
DOUBTFUL: dict[str, Callable[[Size], Solid]] = {
    "ball": lambda s: _no_way(Manifold.sphere(radius := s(2), SIDES), 2 * radius, radius),
    "ball-hole": _holed_ball,
    "cube": lambda s: _no_way(box(side := s(3), side, side), side, side / 2),
    "square-plate": lambda s: _no_way(box(side := s(6), side, s(0.8)), side, 0.4),
}


def plate(num_holes: int, longest: float | None = None) -> trimesh.Trimesh:
    """A plate of 10 x 6 x 1 with round holes in rows, of genus ``num_holes``: 2 x (4 + 32 ``num_holes``) vertices.

    If ``longest`` is given, edges are halved until none is longer.
    """
    columns = min(int(np.ceil(np.sqrt(num_holes * 10 / 6))), num_holes)
    rows = -(-num_holes // max(columns, 1))
    cell = np.array([10 / max(columns, 1), 6 / max(rows, 1)])
    place = np.array([[k % columns + 0.5, k // columns + 0.5] for k in range(num_holes)]).reshape(-1, 2) * cell
    radius = 0.2 * cell.min()
    outline = np.array([[0.0, 0], [10, 0], [10, 6], [0, 6]])
    return _as_mesh(_extruded([outline, *(_circle(radius)[::-1] + centre for centre in place)], 1.0), longest)


def pipe(wall: float, length: float = 4.0, sides: int = 48, longest: float | None = None) -> trimesh.Trimesh:
    """A straight pipe of outer radius 1 and a ``wall`` thickness below 1: genus 1, with one loop around its bore."""
    return _as_mesh(_extruded([_circle(1.0, sides), _circle(1.0 - wall, sides)[::-1]], length), longest)


def bracket(num_holes: int = 4, longest: float | None = None) -> trimesh.Trimesh:
    """An angle of two plates of 6 x 4 x 0.5 with ``num_holes`` screw holes, at most 8, alternating between the plates.
    Its genus is ``num_holes``."""
    leg = np.array([[0.0, 0], [6, 0], [6, 4], [0, 4]])
    holes: list[list[np.ndarray]] = [[], []]
    for k in range(num_holes):
        centre = np.array([1.7 + 3.0 * (k // 2) / max((num_holes - 1) // 2, 1), 2.0])
        holes[k % 2].append(_circle(0.4)[::-1] + centre)
    one, other = (_extruded([leg, *own], 0.5) for own in holes)
    return _as_mesh(one + other.rotate((0.0, -90.0, 0.0)).translate((0.5, 0.0, 0.0)), longest)


def rings(are_linked: bool, minor: float = 0.2, around: int = 48, across: int = 12) -> trimesh.Trimesh:
    """Two separate rings of radius 1, each of genus 1: linked as in a chain, or side by side."""
    shift = np.linspace(0, 2 * np.pi, across, endpoint=False)
    vertices, faces = [], []
    i, j = np.divmod(np.arange(around * across), across)
    there, up = (i + 1) % around * across, (j + 1) % across
    quads = np.stack([i * across + j, there + j, there + up, i * across + up], axis=1)
    for points, out, axis in zip(*_rings(are_linked, around), strict=True):
        tube = minor * (np.cos(shift)[:, None] * out[:, None] + np.sin(shift)[:, None] * axis)
        faces.append(quads[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3) + around * across * len(vertices))
        vertices.append((points[:, None] + tube).reshape(-1, 3))
    return trimesh.Trimesh(np.concatenate(vertices), np.concatenate(faces), process=False)


def ring_curves(are_linked: bool, num: int = 48) -> tuple[np.ndarray, np.ndarray]:
    """The circles in the middle of `rings`: points (2 num, 3) and edges (2 num, 2)."""
    step = np.arange(num)
    circle = np.stack([step, (step + 1) % num], axis=1)
    return np.concatenate(_rings(are_linked, num)[0]), np.concatenate([circle, circle + num])


def _rings(are_linked: bool, num: int) -> tuple[list[np.ndarray], list[np.ndarray], list[np.ndarray]]:
    """Two circles: their points (num, 3), the outward direction at each point, and the axis."""
    angle = np.linspace(0, 2 * np.pi, num, endpoint=False)
    flat = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    upright = flat[:, [0, 2, 1]] * [1, 1, -1]  # turned about x, so that both have the same sense about their axis
    away = np.array([1.0 if are_linked else 3.0, 0.0, 0.0])
    return [flat, upright + away], [flat, upright], [np.array([0.0, 0, 1]), np.array([0.0, 1, 0])]


def _circle(radius: float, sides: int = SIDES) -> np.ndarray:
    angle = np.linspace(0, 2 * np.pi, sides, endpoint=False)
    return radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def _extruded(outlines: list[np.ndarray], height: float) -> Manifold:
    """The extrusion of a polygon; outlines of holes have the opposite orientation."""
    return manifold3d.CrossSection(outlines).extrude(height)


def _as_mesh(solid: Manifold, longest: float | None) -> trimesh.Trimesh:
    found = solid.to_mesh64()
    vertices, faces = found.vert_properties[:, :3], found.tri_verts.astype(np.int64)
    if longest is not None:
        meso = Meso.from_mesh(vertices, faces)
        edits.split_long_edges(meso, longest)
        vertices, faces = meso.positions, meso.faces()
    return trimesh.Trimesh(vertices, faces, process=False)
