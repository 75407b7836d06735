"""`Frame`: a solid of bars as beams, for structural analysis; and its files, for Abaqus and CalculiX, and VTK."""

import os
from dataclasses import dataclass

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.base.writing import write_whole
from msf_jax.skeleton.formats.graphs import polydata
from msf_jax.skeleton.formats.text import number

SOLVERS = ("abaqus", "calculix")
STEEL = (210000.0, 0.3)  # Young's modulus in N/mm^2, Poisson's ratio
SHEAR = 0.85  # Timoshenko's shear coefficient, between that of a rectangle, 5/6, and of a disc, 0.9


@dataclass(frozen=True, eq=False)
class Frame:
    """Straight members between joints.

    Attributes:
        joints: (J, 3) positions, in the mesh's units.
        members: (M, 2) int, the two joints of each.
        area: (M,) of the cross-section, the mean along the member.
        axes: (M, 3, 3) unit vectors: along the member, and the two principal axes of its section, 1 and 2.
        moments: (M, 2) second moments of area about the axes 1 and 2, the larger one first.
        torsion: (M,) torsion constants, of solid sections.
        eccentricity: (M,) the largest distance between the member's axis and its joints, where axes do not meet.
        variation: (M,) standard deviation of the area along the member over its mean: 0 if it is prismatic.
    """

    joints: np.ndarray
    members: np.ndarray
    area: np.ndarray
    axes: np.ndarray
    moments: np.ndarray
    torsion: np.ndarray
    eccentricity: np.ndarray
    variation: np.ndarray

    def __repr__(self) -> str:
        return f"Frame({len(self.members)} members, {len(self.joints)} joints, length {self.lengths.sum():.4g})"

    @property
    def lengths(self) -> np.ndarray:
        """(M,) from joint to joint."""
        return np.linalg.norm(self.joints[self.members[:, 1]] - self.joints[self.members[:, 0]], axis=1)

    def save(self, path: str | os.PathLike[str], solver: str = "abaqus") -> None:
        """Write the frame, atomically.

        - ``.inp``: nodes, a beam element and a section for each member, without loads. For "abaqus" elements are B31,
          with general sections. For "calculix" they are U1, whose torsion constant is the sum of the second moments.
          The elastic constants are those of steel in newtons and millimetres: change them.
        - ``.vtp``: a line for each member with its properties, for ParaView.

        Raises:
            ConfigError: the suffix is neither, or the ``solver``.
            OSError: the file cannot be written.
        """
        name = os.fspath(path).lower()
        if solver not in SOLVERS:
            raise ConfigError(f"solver is {solver!r}: expected one of {', '.join(map(repr, SOLVERS))}")
        if not name.endswith((".inp", ".vtp")):
            raise ConfigError(f"no format for a frame in {os.fspath(path)!r}: expected the suffix .inp or .vtp")
        write_whole(path, vtp(self) if name.endswith(".vtp") else inp(self, solver))


def inp(frame: Frame, solver: str) -> str:
    """The nodes, and for each member an element with a section; numbers begin with 1."""
    modulus, ratio = STEEL
    is_user = solver == "calculix"
    kind = "U1" if is_user else "B31"
    lines = [
        "*HEADING",
        "frame written by msf_jax; the elastic constants are those of steel in N and mm",
        "*NODE, NSET=ALL",
    ]
    lines += [f"{k}, {', '.join(map(number, place))}" for k, place in enumerate(frame.joints, 1)]
    lines += ["*USER ELEMENT, TYPE=U1, NODES=2, INTEGRATION POINTS=2, MAXDOF=6"] * is_user
    for k, (a, b) in enumerate(frame.members.tolist(), 1):
        lines += [f"*ELEMENT, TYPE={kind}, ELSET=M{k}", f"{k}, {a + 1}, {b + 1}"]
    if is_user:
        lines += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{number(modulus)}, {number(ratio)}"]
    for k, (area, moments, torsion, axes) in enumerate(
        zip(frame.area, frame.moments, frame.torsion, frame.axes, strict=True), 1
    ):
        values = [area, moments[0], 0.0, moments[1]]
        first = ", ".join(map(number, axes[1]))
        if is_user:
            lines += [f"*BEAM SECTION, ELSET=M{k}, MATERIAL=STEEL, SECTION=GENERAL"]
            lines += [", ".join(map(number, [*values, SHEAR])), first]
        else:
            lines += [f"*BEAM GENERAL SECTION, ELSET=M{k}, SECTION=GENERAL"]
            lines += [", ".join(map(number, [*values, torsion])), first]
            lines += [f"{number(modulus)}, {number(modulus / (2 + 2 * ratio))}"]
    return "\n".join(lines) + "\n"


def vtp(frame: Frame) -> str:
    """A line for each member, with its properties as cell data."""
    columns = {
        "area": frame.area,
        "length": frame.lengths,
        "moment_1": frame.moments[:, 0],
        "moment_2": frame.moments[:, 1],
        "torsion": frame.torsion,
        "axis_1": frame.axes[:, 1],
        "eccentricity": frame.eccentricity,
        "variation": frame.variation,
    }
    return polydata(frame.joints, [], frame.members.tolist(), {"joint": np.arange(len(frame.joints))}, columns)
