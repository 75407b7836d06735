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

SIDES = 32  # of round solids and of holes; a multiple of four keeps a cylinder's quarter turns
SPACING = 0.3  # edges of the fine form, in radii of the thinnest limb
MOST_TRIANGLES = 16_000  # of the fine form: its edges are longer where there would be more
GAP = 0.3  # radii that a curve stops before an end face, as documented
SLACK, SLACK_WITH_HOLES = 1.02, 1.06  # greatest length over the axis: a curve goes around a hole
FORMS = ("coarse", "coarse-turned", "fine", "fine-turned")

Manifold = manifold3d.Manifold
Size = Callable[[float], float]
X, Y, Z = np.diag([-1.0, 1, 1]), np.diag([1.0, -1, 1]), np.diag([1.0, 1, -1])  # mirrors
QUARTER = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])


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


def make(name: str, seed: int) -> Solid:
    """The solid of that name, of ``SOLIDS`` or ``DOUBTFUL``."""
    random = _random(name, seed)
    return (SOLIDS | DOUBTFUL)[name](lambda value: value * random.uniform(0.95, 1.05))


def _random(name: str, seed: int) -> np.random.Generator:
    return np.random.default_rng([seed, zlib.crc32(name.encode())])


def _box(x: float, y: float, z: float) -> Manifold:
    return Manifold.cube((x, y, z), center=True)


def _rod(length: float, low: float, high: float | None = None, sides: int = SIDES) -> Manifold:
    """Around z, its middle at the origin."""
    return Manifold.cylinder(length, low, low if high is None else high, sides, center=True)


def _at(body: Manifold, x: float, y: float, z: float) -> Manifold:
    return body.translate((x, y, z))


def _along_x(body: Manifold) -> Manifold:
    return body.rotate((0.0, 90.0, 0.0))


def _straight(
    body: Manifold,
    low: float,
    high: float,
    radii: tuple[float, float],
    widths: tuple[float, float],
    symmetries: Sequence[np.ndarray] = (),
    along: int = 2,
) -> Solid:
    """One limb along an axis of coordinates, from ``low`` to ``high``."""
    way = np.eye(3)[along]
    ends = np.outer([low, high], way)
    width = float(np.mean(widths))
    edge = SPACING * (min(radii) or max(radii) / 2)
    return Solid(
        body,
        ends,
        np.outer([-1.0, 1.0], way),
        np.array(radii),
        np.array([each or width for each in widths]),
        high - low,
        width,
        edge,
        axis=[ends],
        symmetries=symmetries,
    )


def _bar(x: float, y: float, z: float) -> Solid:
    """Along x, which is the longest."""
    radius, width = min(y, z) / 2, float(np.sqrt(y * z / np.pi))
    return _straight(_box(x, y, z), -x / 2, x / 2, (radius, radius), (width, width), (X, Y, Z), along=0)


def _beam(length: float, side: float) -> Solid:
    found = _bar(length, side, side)
    return replace(found, symmetries=(X, Y, Z, np.array([[1.0, 0, 0], [0, 0, 1], [0, 1, 0]])))


def _cylinder(length: float, radius: float) -> Solid:
    size = (radius, radius)
    return _straight(_rod(length, radius), -length / 2, length / 2, size, size, (X, Y, Z, QUARTER))


def _cone(length: float, low: float, high: float) -> Solid:
    """A frustum, or a cone where ``high`` is 0."""
    body = _rod(length, low, high)
    return _straight(body, -length / 2, length / 2, (low, high), (low, high), (X, Y, QUARTER))


def _tee(body: Manifold, arm: float, stem: float, radius: float, width: float) -> Solid:
    """Along x from -``arm`` to ``arm``, and along -z to -``stem``."""
    ends = np.array([[-arm, 0, 0], [arm, 0, 0], [0, 0, -stem]])
    outwards = np.array([[-1.0, 0, 0], [1, 0, 0], [0, 0, -1]])
    axis = [ends[:2], np.array([[0.0, 0, 0], [0, 0, -stem]])]
    three = np.ones(3)
    length, edge = 2 * arm + stem, SPACING * radius
    return Solid(body, ends, outwards, radius * three, width * three, length, width, edge, axis=axis, symmetries=(X, Y))


def _pipe_tee(arm: float, stem: float, radius: float) -> Solid:
    body = _along_x(_rod(2 * arm, radius)) + _at(_rod(stem, radius), 0, 0, -stem / 2)
    return _tee(body, arm, stem, radius, radius)


def _square_tee(arm: float, stem: float, side: float) -> Solid:
    body = _box(2 * arm, side, side) + _at(_box(side, side, stem), 0, 0, -stem / 2)
    return _tee(body, arm, stem, side / 2, side / np.sqrt(np.pi))


def _bolt(shank: float, radius: float, head: float, height: float) -> Solid:
    """Its shank goes down from the origin, its head of six sides up."""
    body = _at(_rod(shank, radius), 0, 0, -shank / 2) + _at(_rod(height, head, sides=6), 0, 0, height / 2)
    wide = head * float(np.sqrt(3 * np.sqrt(3) / 2 / np.pi))
    found = _straight(body, -shank, height, (radius, height / 2), (radius, wide), (X, Y))
    return replace(found, width=radius)


def _socket_bolt(shank: float, radius: float, head: float, height: float) -> Solid:
    """With six walls sunk into a round head by half of its height, where the curve then ends."""
    body = _at(_rod(shank, radius), 0, 0, -shank / 2) + _at(_rod(height, head), 0, 0, height / 2)
    body -= _at(_rod(height, 0.5 * head, sides=6), 0, 0, height)
    found = _straight(body, -shank, height / 2, (radius, height / 4), (radius, head), (X, Y))
    return replace(found, width=radius)


def _i_beam(length: float, flange: float, height: float, thick: float, web: float) -> Solid:
    """Along x, its web upright."""
    body = _box(length, web, height)
    for side in (-1, 1):
        body += _at(_box(length, flange, thick), 0, 0, side * (height - thick) / 2)
    width = float(np.sqrt((2 * flange * thick + (height - 2 * thick) * web) / np.pi))
    return _straight(body, -length / 2, length / 2, (web / 2, web / 2), (width, width), (X, Y, Z), along=0)


def _table(x: float, y: float, top: float, leg: float, height: float) -> Solid:
    """Four square legs under a thin top, which the curve may cross as it likes."""
    body, ends = _at(_box(x, y, top), 0, 0, top / 2), []
    places = [(u, v) for u in (-1, 1) for v in (-1, 1)]
    for u, v in places:
        at = u * (x - leg) / 2, v * (y - leg) / 2
        body += _at(_box(leg, leg, height), *at, -height / 2)
        ends.append((*at, -height))
    four, width = np.ones(4), float(leg / np.sqrt(np.pi))
    length = 4 * (height + top) + 2 * float(np.hypot(x - leg, y - leg))
    down = np.tile([0.0, 0, -1], (4, 1))
    return Solid(
        body,
        np.array(ends),
        down,
        four * leg / 2,
        four * width,
        length,
        width,
        SPACING * leg / 2,
        symmetries=(X, Y),
    )


def _loop(body: Manifold, radius: np.ndarray, thin: float, width: float, symmetries: Sequence[np.ndarray]) -> Solid:
    """A ring around z whose middle is ``radius`` (N,) from it, at N angles."""
    angle = np.linspace(0, 2 * np.pi, len(radius))
    axis = np.stack([radius * np.cos(angle), radius * np.sin(angle), 0 * angle], axis=1)
    length = float(np.linalg.norm(np.diff(axis, axis=0), axis=1).sum())
    none = np.zeros((0, 3))
    edge = SPACING * thin
    return Solid(
        body,
        none,
        none,
        none[:, 0],
        none[:, 0],
        length,
        width,
        edge,
        cycles=1,
        axis=[axis],
        symmetries=symmetries,
    )


def _torus(radius: float, minor: float) -> Solid:
    section = manifold3d.CrossSection.circle(minor, 16).translate((radius, 0.0))
    return _loop(section.revolve(SIDES), np.full(361, radius), minor, minor, (X, Y, Z, QUARTER))


def _washer(inner: float, outer: float, height: float, sides: int = SIDES) -> Solid:
    """A round hole in a disc; in a nut of six sides for ``sides`` 6."""
    body = _rod(height, outer, sides=sides) - _rod(2 * height, inner)
    half = np.pi / sides  # the outer wall is nearest in the middle of a side
    angle = np.linspace(0, 2 * np.pi, 361) % (2 * half) - half
    wall = outer * np.cos(half) / np.cos(angle) - inner
    width = float(np.sqrt(wall.mean() * height / np.pi))
    return _loop(body, inner + wall / 2, min(height, wall.min()) / 2, width, (X, Y, Z))


def _bored_ball(radius: float, bore: float) -> Solid:
    """The loop is where its inscribed balls are largest."""
    body = Manifold.sphere(radius, SIDES) - _rod(3 * radius, bore)
    middle, half = (radius + bore) / 2, (radius - bore) / 2
    return _loop(body, np.full(361, middle), half, half, (X, Y, Z, QUARTER))


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
        body -= _at(_rod(2 * depth, radius, sides=24), x, y, top)
    return _with_holes(solid, body, symmetries)


def _pocketed(
    solid: Solid, size: tuple[float, float], depth: float, top: float, symmetries: Sequence[np.ndarray]
) -> Solid:
    """A pocket with four walls, down from the plane z = ``top``, in the middle."""
    return _with_holes(solid, solid.body - _at(_box(*size, 2 * depth), 0, 0, top), symmetries)


def _with_holes(solid: Solid, body: Manifold, symmetries: Sequence[np.ndarray]) -> Solid:
    return replace(solid, body=body, slack=SLACK_WITH_HOLES, symmetries=symmetries)


def _no_way(body: Manifold, size: float, thin: float) -> Solid:
    """No way is better than others: at most one branch over the ``size``, from face to face with the gaps of a ball
    of radius ``thin``."""
    none = np.zeros((0, 3))
    return Solid(body, none, none, none[:, 0], none[:, 0], size - 2 * GAP * thin, size / 2, SPACING * thin)


def _four(x: float, y: float) -> list[tuple[float, float]]:
    return [(u * x, v * y) for u in (-1, 1) for v in (-1, 1)]


def _holed_bar(s: Size) -> Solid:
    bar = _bar(s(11), s(4), 3.8)
    return _drilled(bar, [(s(1.5), 0.0)], 0.7, 1.3, 1.9, (Y,))


def _four_holed_bar(s: Size) -> Solid:
    return _drilled(_bar(s(12), s(4.4), 3.8), _four(s(3), 1.0), 0.5, 1.4, 1.9, (X, Y))


def _holed_beam(s: Size) -> Solid:
    return _drilled(_beam(s(7), 1.0), [(s(1), 0.0)], 0.22, 0.4, 0.5, (Y,))


def _holed_cylinder(s: Size) -> Solid:
    found = _straight(_along_x(_rod(length := s(8), 1.0)), -length / 2, length / 2, (1.0, 1.0), (1.0, 1.0), along=0)
    return _drilled(found, [(s(1), 0.0)], 0.3, 0.7, 1.0, (Y,))


def _holed_ball(s: Size) -> Solid:
    ball = _no_way(Manifold.sphere(2.0, SIDES), 4.0, 1.0)
    return replace(ball, body=ball.body - _at(_rod(s(2), s(0.5)), 0, 0, 2.0))


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
    "i-beam": lambda s: _i_beam(s(9), s(3), s(3.6), s(0.6), s(0.5)),
    "table": lambda s: _table(s(9.4), s(5.4), s(0.6), s(0.7), s(4)),
    **{f"cylinder-{n}": lambda s, n=n: _cylinder(n * (radius := s(1)), radius) for n in (3, 4, 6, 8, 10, 12, 16)},
    "cone": lambda s: _cone(s(6), s(1.5), 0.0),
    "cone-thin": lambda s: _cone(s(9), s(1.2), 0.0),
    "frustum": lambda s: _cone(s(6), s(1.2), s(0.7)),
    "frustum-wide": lambda s: _cone(s(6), s(1.6), s(0.6)),
    "nut": lambda s: _washer(s(1), s(2), s(1.5), 6),
    "torus": lambda s: _torus(s(3), s(1)),
    "torus-thin": lambda s: _torus(s(3), s(0.45)),
    "washer": lambda s: _washer(s(2), s(3.8), s(1.8)),
    "washer-flat": lambda s: _washer(s(1.2), s(3.2), s(0.5)),
    "bar-hole": _holed_bar,
    "bar-holes-4": _four_holed_bar,
    "bar-pocket": lambda s: _pocketed(_bar(s(11), 4.0, 3.8), (s(4), s(2)), 1.2, 1.9, (X, Y)),
    "beam-hole": _holed_beam,
    "plate-holes-4": lambda s: _drilled(_bar(s(12), s(4.5), 1.0), _four(s(4), 1.2), 0.4, 0.6, 0.5, (X, Y)),
    "plate-pocket": lambda s: _pocketed(_bar(s(12), s(4.5), 1.0), (s(6), s(2.2)), 0.5, 0.5, (X, Y)),
    "slab-holes-4": lambda s: _drilled(_bar(s(9.3), s(5.4), 1.2), _four(s(3), 1.5), 0.5, 0.7, 0.6, (X, Y)),
    "cylinder-hole": _holed_cylinder,
    "tee-hole": lambda s: _drilled(_pipe_tee(s(5), s(5), 1.0), [(0.0, 0.0)], 0.35, 0.7, 1.0, (X, Y)),
    "bolt-socket": lambda s: _socket_bolt(s(6), s(0.6), s(1.2), s(1)),
    "torus-hole": lambda s: _drilled(_torus(3.0, 1.0), [(3.0, 0.0)], s(0.3), s(0.7), 1.0, (Y,)),
    "washer-holes-4": lambda s: _drilled(_washer(2.0, 3.8, 1.8), _four(2.05, 2.05), s(0.3), s(0.6), 0.9, (X, Y)),
    "ball-bore": lambda s: _bored_ball(s(2), s(0.4)),
}
DOUBTFUL: dict[str, Callable[[Size], Solid]] = {
    "ball": lambda s: _no_way(Manifold.sphere(radius := s(2), SIDES), 2 * radius, radius),
    "ball-hole": _holed_ball,
    "cube": lambda s: _no_way(_box(side := s(3), side, side), side, side / 2),
    "square-plate": lambda s: _no_way(_box(side := s(6), side, s(0.8)), side, 0.4),
}
