"""Options that change a curve before it is written: units, pieces, loops, a root, nodes, radii."""

import argparse
import math
from typing import TYPE_CHECKING, NamedTuple

from msf_jax.base.errors import ConfigError

if TYPE_CHECKING:
    import numpy as np

    from msf_jax.skeleton.skeleton import Skeleton


class Shaping(NamedTuple):
    """The values of these options, which can be sent to another process. root: a point, "soma" or "thickest", or None
    for no tree."""

    scale: float = 1.0
    units: str = ""
    resample: float | None = None
    simplify: float | None = None
    heal: float | None = None
    root: tuple[float, ...] | str | None = None
    radius: str | None = None


UNCHANGED = Shaping()


def add_options(parser: argparse.ArgumentParser) -> None:
    """The options that `asked_for` reads."""
    after = parser.add_argument_group(
        "what is written", "Lengths are in the units of the written file: the mesh is scaled first."
    )
    after.add_argument("--scale", type=float, metavar="X", help="multiply the mesh's coordinates, to change the unit")
    after.add_argument("--units", metavar="NAME", help="name of the unit of length, for .swc, .npz and .json files")
    after.add_argument("--resample", type=float, metavar="X", help="distance between nodes along the branches")
    after.add_argument(
        "--simplify", type=float, metavar="X", help="fewer nodes, such that the curve moves by at most this length"
    )
    after.add_argument("--heal", type=float, metavar="X", help="join pieces of the curve over gaps up to this length")
    after.add_argument("--tree", action="store_true", help="cut loops where they are thinnest")
    after.add_argument(
        "--root",
        metavar="R",
        help="of the tree: the node nearest to x,y,z, soma, or thickest, as --root=1,2,3; implies --tree",
    )
    after.add_argument(
        "--radius",
        choices=["ball", "section"],
        help="ball: of the largest ball inside (default); section: of a disc with the cross-section's area",
    )


def asked_for(arguments: argparse.Namespace) -> Shaping:
    """The values of the options of `add_options`; a `ConfigError` for an invalid length or root."""
    for name in ("scale", "resample", "simplify", "heal"):
        value = getattr(arguments, name)
        if value is not None and not 0 < value < math.inf:
            raise ConfigError(f"--{name} is {value}: expected a finite number above 0")
    root: tuple[float, ...] | str | None = "thickest" if arguments.tree else None
    if arguments.root is not None:
        root = arguments.root if arguments.root in ("soma", "thickest") else _place(arguments.root)
    scale = 1.0 if arguments.scale is None else arguments.scale
    lengths = arguments.resample, arguments.simplify, arguments.heal
    return Shaping(scale, arguments.units or "", *lengths, root, arguments.radius)


def _place(text: str) -> tuple[float, ...]:
    try:
        place = tuple(float(value) for value in text.split(","))
    except ValueError:
        place = ()
    if len(place) != 3 or not all(map(math.isfinite, place)):
        raise ConfigError(f"--root is {text!r}: expected x,y,z, soma or thickest")
    return place


def scaled(mesh: "tuple[np.ndarray, np.ndarray]", asked: Shaping) -> "tuple[np.ndarray, np.ndarray]":
    """Vertices and faces of a mesh in the units that are asked for."""
    return (mesh[0] * asked.scale, mesh[1]) if asked.scale != 1 else mesh


def shaped(skeleton: "Skeleton", asked: Shaping) -> "Skeleton":
    """The curve after the changes ``asked``: gaps, loops and root, nodes, radii, then the name of the unit."""
    from dataclasses import replace

    if asked.heal is not None:
        skeleton = skeleton.heal(asked.heal)
    if asked.root is not None:
        skeleton = skeleton.to_tree(None if asked.root == "thickest" else asked.root)
    if asked.resample is not None:
        skeleton = skeleton.resample(asked.resample)
    if asked.simplify is not None:
        skeleton = skeleton.simplify(asked.simplify)
    if asked.radius is not None:
        skeleton = skeleton.with_radii(asked.radius)
    return replace(skeleton, units=asked.units)
