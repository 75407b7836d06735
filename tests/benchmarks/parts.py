"""More machined solids, beside those of `tests.benchmarks.solids`: of limbs that meet, of bent sheet, with deep holes.

Angles, channels and half pipes are sheets, as the I-beam is: their curve is in the middle of their material, and the
report is right to call it not sound.
"""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from tests.benchmarks.solids import (
    QUARTER,
    SIDES,
    SLACK_WITH_HOLES,
    SPACING,
    Limb,
    Manifold,
    Size,
    Solid,
    X,
    Y,
    Z,
    along_x,
    at,
    box,
    limbs,
    ring,
    rod,
    straight,
)

SWAP = np.array([[1.0, 0, 0], [0, 0, 1], [0, 1, 0]])  # y and z
THIRD = np.array([[-0.5, -np.sqrt(0.75), 0], [np.sqrt(0.75), -0.5, 0], [0, 0, 1]])  # of a turn around z


def _half_width(area: float) -> float:
    return float(np.sqrt(area / np.pi))


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


def _circle(radius: float, x: float, along: int) -> np.ndarray:
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
    loops = [_circle(around, -middle, 2), _circle(around, middle, 1)]
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


PARTS: dict[str, Callable[[Size], Solid]] = {
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
