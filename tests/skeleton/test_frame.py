"""Beams from solids of bars: members, lengths, sections against closed forms; a small beam solver; files."""

from itertools import combinations, product

import manifold3d
import numpy as np
import pytest
import trimesh
from run_cases import flow_of
from scipy import spatial

import msf_jax
from msf_jax import ConfigError, shapes
from msf_jax.skeleton.centrelines import section_of
from msf_jax.skeleton.framing import Frame, trace_wires
from msf_jax.skeleton.skeleton import Skeleton

SIDES = 24


def polygon(num: int, a: float, b: float) -> np.ndarray:
    turn = 2 * np.pi * np.arange(num) / num
    return np.stack([a * np.cos(turn), b * np.sin(turn)], axis=1)


def rectangle(width: float, height: float) -> np.ndarray:
    return np.array([[0.0, 0], [width, 0], [width, height], [0, height]])


def series(a: float, b: float) -> float:
    """The torsion constant of a rectangle a >= b (Timoshenko and Goodier)."""
    odd = np.arange(1, 80, 2)
    return a * b**3 * (1 / 3 - 64 * b / (np.pi**5 * a) * (np.tanh(odd * np.pi * a / (2 * b)) / odd**5).sum())


@pytest.mark.parametrize(("a", "b"), [(1.0, 1.0), (3.0, 1.0), (0.02, 0.03)])
def test_the_section_of_an_ellipse(a, b):
    corners = polygon(240, a, b) + [5.0, -3.0]
    found = section_of(corners)
    assert found.area == pytest.approx(np.pi * a * b, rel=1e-3)
    np.testing.assert_allclose(found.centroid, [5.0, -3.0], atol=1e-9)
    moments = np.pi * a * b / 4 * np.array([[a**2, 0], [0, b**2]])
    np.testing.assert_allclose(found.moments, moments, rtol=2e-3, atol=1e-12 * a * b)


@pytest.mark.parametrize(("a", "b"), [(1.0, 1.0), (2.0, 1.0), (5.0, 1.0)])
def test_the_section_of_a_rectangle(a, b):
    found = section_of(rectangle(a, b))
    np.testing.assert_allclose(found.moments, np.diag([b * a**3, a * b**3]) / 12, rtol=1e-12, atol=1e-15)


def test_short_bars_at_an_acute_joint():
    """A bracket: a diagonal of 45 degrees between bars of eight radii, so that sections of the middle are in joints."""
    points, members = np.array([[0.0, 0, -2], [0, 0, 2], [0, 0, 4], [2, 0, 4], [6, 0, 4]]), np.array([*"01122334"], int)
    members = np.concatenate([members.reshape(-1, 2), [[1, 3]]])
    mesh = shapes.solid_around(points, members, np.full(5, 0.254), 0.12)
    frame = msf_jax.skeletonize(mesh).frame()
    rounded = points + [[0, 0, -0.25], [0, 0, 0], [0, 0, 0], [0, 0, 0], [0.25, 0, 0]]
    check(frame, rounded, members, share=0.01, away=0.05)
    np.testing.assert_allclose(frame.moments, np.pi * 0.25**4 / 4, rtol=0.05)


def bars(points: np.ndarray, members: np.ndarray, radius: float) -> trimesh.Trimesh:
    """Bars with 24 sides between ``points``, with balls where several meet, as one solid in long triangles."""
    parts = [trimesh.creation.cylinder(radius, segment=points[pair], sections=SIDES) for pair in members]
    count = np.bincount(members.ravel())
    parts += [trimesh.creation.icosphere(2, radius).apply_translation(points[k]) for k in np.flatnonzero(count > 1)]
    solids = [manifold3d.Manifold(manifold3d.Mesh64(part.vertices, part.faces.astype(np.uint64))) for part in parts]
    found = manifold3d.Manifold.batch_boolean(solids, manifold3d.OpType.Add).to_mesh64()
    return trimesh.Trimesh(found.vert_properties[:, :3], found.tri_verts.astype(np.int64), process=False)


def cube() -> tuple[np.ndarray, np.ndarray]:
    corners = np.array(list(product((0.0, 4.0), repeat=3)))
    return corners, np.array(
        [pair for pair in combinations(range(8), 2) if (corners[pair[0]] != corners[pair[1]]).sum() == 1]
    )


def portal() -> tuple[np.ndarray, np.ndarray]:
    return np.array([[0.0, 0, 0], [0, 0, 4], [5, 0, 4], [5, 0, 0]]), np.array([[0, 1], [1, 2], [2, 3]])


def octet() -> tuple[np.ndarray, np.ndarray]:
    corners = 4.5 * np.array(list(product((0.0, 1.0), repeat=3)))
    faces = 4.5 * np.array([[0.5, 0.5, 0], [0.5, 0.5, 1], [0.5, 0, 0.5], [0.5, 1, 0.5], [0, 0.5, 0.5], [1, 0.5, 0.5]])
    points = np.concatenate([corners, faces])
    return points, spatial.KDTree(points).query_pairs(4.5 / np.sqrt(2) + 1e-6, output_type="ndarray")


def check(frame: Frame, points: np.ndarray, members: np.ndarray, share: float, away: float) -> None:
    """The members are those, with lengths to within ``share`` and joints to within ``away``."""
    assert len(frame.members) == len(members) and len(frame.joints) == len(points)
    distance, number = spatial.KDTree(points).query(frame.joints)
    assert distance.max() < away and len(set(number.tolist())) == len(points)
    found = {tuple(sorted(pair)) for pair in number[frame.members].tolist()}
    assert found == {tuple(sorted(pair)) for pair in members.tolist()}
    true = points[number[frame.members]]
    np.testing.assert_allclose(frame.lengths, np.linalg.norm(true[:, 1] - true[:, 0], axis=1), rtol=share)


def of_disc(radius: float) -> tuple[float, float]:
    """The area and the second moment of a bar's polygon."""
    found = section_of(polygon(SIDES, radius, radius))
    return found.area, float(found.moments[0, 0])


@pytest.mark.slow  # short bars, and a single one, are quick
def test_a_frame_of_round_bars_in_long_triangles():
    points, members = portal()
    skeleton = msf_jax.skeletonize(bars(points, members, 0.3))
    assert skeleton.report.is_sound and skeleton.report.are_limbs
    frame = skeleton.frame()
    check(frame, points, members, share=0.01, away=0.05)
    area, moment = of_disc(0.3)
    np.testing.assert_allclose(frame.area, area, rtol=0.02)
    np.testing.assert_allclose(frame.moments, moment, rtol=0.05)
    np.testing.assert_allclose(frame.torsion, 2 * moment, rtol=0.05)
    assert frame.eccentricity.max() < 0.05 and frame.variation.max() < 0.02


@pytest.mark.slow
def test_an_octet_cell_of_thirty_six_members():
    points, members = octet()
    mesh = shapes.solid_around(points, members, np.full(14, 0.255), 0.115)  # triangles are chords
    assert 1 - mesh.euler_number // 2 == 36 - 14 + 1  # a coarse grid can leave tiny tunnels where two bars part
    frame = msf_jax.skeletonize(mesh).frame()
    check(frame, points, members, share=0.01, away=0.05)
    np.testing.assert_allclose(frame.moments, np.pi * 0.25**4 / 4, rtol=0.05)


@pytest.fixture(scope="module")
def cantilever() -> Skeleton:
    """A bar 6 long, 0.6 by 0.4."""
    mesh = trimesh.creation.box((6.0, 0.6, 0.4)).subdivide_to_size(0.3)
    return msf_jax.skeletonize(trimesh.Trimesh(mesh.vertices, mesh.faces))


def test_a_cantilever_bends_as_theory_says(cantilever):
    """F l^3 / 3 E I for a force at its end, along both principal axes; and T l / G J."""
    frame = cantilever.frame()
    assert frame.lengths == pytest.approx([6.0], rel=0.005) and frame.area == pytest.approx([0.24], rel=0.01)
    np.testing.assert_allclose(frame.moments[0], [0.4 * 0.6**3 / 12, 0.6 * 0.4**3 / 12], rtol=0.01)
    assert abs(frame.axes[0, 1] @ [0, 0, 1]) > 0.999  # the larger one about z
    fixed = int(frame.joints[:, 0].argmin())
    modulus, shear = 200.0, 80.0
    for force, moment in (([0, 0, 1, 0, 0, 0], 0.6 * 0.4**3 / 12), ([0, 1, 0, 0, 0, 0], 0.4 * 0.6**3 / 12)):
        moved = solved(frame, fixed, np.array(force, dtype=float), modulus, shear)
        assert moved[:3] @ force[:3] == pytest.approx(6.0**3 / (3 * modulus * moment), rel=0.05)
    turned = solved(frame, fixed, np.array([0, 0, 0, 1.0, 0, 0]), modulus, shear)
    assert turned[3] == pytest.approx(6.0 / (shear * series(0.6, 0.4)), rel=0.08)  # of Saint-Venant's estimate


def solved(frame: Frame, fixed: int, load: np.ndarray, modulus: float, shear: float) -> np.ndarray:
    """The displacement and rotation (6,) of the other joint of a frame of one member: Euler and Bernoulli's beam."""
    (length,), (area,), (torsion,), (moments,) = frame.lengths, frame.area, frame.torsion, frame.moments
    stiff = np.zeros((12, 12))
    for row, value in ((0, modulus * area / length), (3, shear * torsion / length)):
        stiff[np.ix_([row, row + 6], [row, row + 6])] += value * np.array([[1, -1], [-1, 1]])
    # Bending along axis 2 is about axis 1, and the reverse.
    for moment, (u, turn), sign in ((moments[0], (2, 4), -1), (moments[1], (1, 5), 1)):
        c = sign * length
        block = np.array(
            [
                [12, 6 * c, -12, 6 * c],
                [6 * c, 4 * c**2, -6 * c, 2 * c**2],
                [-12, -6 * c, 12, -6 * c],
                [6 * c, 2 * c**2, -6 * c, 4 * c**2],
            ]
        )
        place = [u, turn, u + 6, turn + 6]
        stiff[np.ix_(place, place)] += modulus * moment / length**3 * block
    turn = np.kron(np.eye(4), frame.axes[0])
    stiff = turn.T @ stiff @ turn
    first = 0 if frame.members[0, 0] == fixed else 6
    free = np.arange(6, 12) if first == 0 else np.arange(6)
    return np.linalg.solve(stiff[np.ix_(free, free)], load)


def test_a_frame_in_files(cantilever, tmp_path):
    frame = cantilever.frame()
    frame.save(tmp_path / "frame.inp")
    lines = (tmp_path / "frame.inp").read_text().splitlines()
    place = lines.index("*BEAM GENERAL SECTION, ELSET=M1, SECTION=GENERAL")
    values = [float(word) for word in lines[place + 1].split(",")]
    np.testing.assert_allclose(values, [*frame.area, frame.moments[0, 0], 0, frame.moments[0, 1], *frame.torsion])
    np.testing.assert_allclose([float(word) for word in lines[place + 2].split(",")], frame.axes[0, 1])
    frame.save(tmp_path / "ccx.inp", solver="calculix")
    text = (tmp_path / "ccx.inp").read_text()
    place = text.splitlines().index("*BEAM SECTION, ELSET=M1, MATERIAL=STEEL, SECTION=GENERAL")
    shear = float(text.splitlines()[place + 1].split(",")[-1])
    assert 5 / 6 < shear < 0.9  # Timoshenko's coefficient, of a rectangle and of a disc
    assert "*USER ELEMENT, TYPE=U1" in text and "*BEAM SECTION, ELSET=M1, MATERIAL=STEEL, SECTION=GENERAL" in text
    for name, solver in (("frame.step", "abaqus"), ("frame.inp", "ansys")):
        with pytest.raises(ConfigError, match=r"expected the suffix \.inp|'abaqus', 'calculix'"):
            frame.save(tmp_path / name, solver=solver)


def test_meshio_reads_the_elements(cantilever, tmp_path):
    meshio = pytest.importorskip("meshio")
    frame = cantilever.frame()
    frame.save(tmp_path / "frame.inp")
    read = meshio.read(tmp_path / "frame.inp")
    np.testing.assert_allclose(read.points, frame.joints)
    np.testing.assert_array_equal(np.concatenate([cells.data for cells in read.cells]), frame.members)


def test_a_bend_near_an_end_is_a_joint_and_a_rounded_one_is_one():
    """Columns of four radii; and bends that are rounded over a radius and a half."""
    for rounding in (0.0, 0.45):
        corners = [[0.0, 0, 0], [0, 0, 1.2], [5, 0, 1.2], [5, 0, 0]]
        path = [corners[0]]
        for before, here, after in zip(corners[:-2], corners[1:-1], corners[2:], strict=True):
            ends = [np.add(here, rounding * np.sign(np.subtract(other, here))) for other in (before, after)]
            t = np.linspace(0, 1, 9)[:, None]
            path += [*((1 - t) ** 2 * ends[0] + 2 * t * (1 - t) * here + t**2 * ends[1])] if rounding else [here]
        path = np.array([*path, corners[-1]])
        along = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1)))
        stops = np.linspace(0, along[-1], 75)
        points = np.stack([np.interp(stops, along, path[:, axis]) for axis in range(3)], axis=1)
        edges = np.stack([np.arange(74), np.arange(1, 75)], axis=1)
        _, members, nodes = trace_wires(points, edges, np.full(75, 0.3), 0.3)
        assert len(nodes) == 3 and (np.bincount(members.ravel()) == 1).sum() == 2


def test_joints_nearer_than_the_tolerance_are_one_and_others_are_not(cantilever):
    with pytest.raises(ConfigError, match="tolerance is -1"):
        cantilever.frame(-1)
    with pytest.raises(ConfigError, match="no branch is longer"):
        flow_of("y_coarse").skeleton.frame(10.0)
    assert repr(cantilever.frame()).startswith("Frame(1 members, 2 joints, length 6")
