"""Measurements of centrelines against closed forms: lengths, angles, areas, curvature; open ends; tables in files."""

import csv
from itertools import pairwise

import numpy as np
import pandas
import pytest
import pyvista
import trimesh
from scipy import spatial

import msf_jax
from msf_jax import ConfigError
from msf_jax.skeleton.centrelines import tangents_of
from msf_jax.skeleton.skeleton import Skeleton, Source, curve_of
from msf_jax.solid.solid import Solid
from tests.benchmarks import ground_truth


def measured(nodes, edges, mesh: trimesh.Trimesh) -> Skeleton:
    """A curve in its mesh, as a run would leave it; each vertex with the nearest node."""
    nodes, solid = np.asarray(nodes, dtype=float), Solid(np.array(mesh.vertices), np.array(mesh.faces))
    curve = curve_of(nodes, np.sort(np.asarray(edges), axis=1), solid.radii(nodes))
    nearest = spatial.KDTree(nodes).query(mesh.vertices)[1]
    source = Source(solid, solid.vertex_areas, np.empty(0, dtype=int), (), np.arange(len(mesh.vertices)))
    return Skeleton(curve.vertices, curve.edges, curve.radii, nearest, curve.report, source)


def refined(shape: ground_truth.KnownShape, spacing: float) -> tuple[np.ndarray, list]:
    """The true curve with nodes about every ``spacing``."""
    nodes, edges = [*shape.points], []
    for a, b in shape.edges:
        num = max(1, int(np.linalg.norm(shape.points[b] - shape.points[a]) / spacing))
        chain = [a, *range(len(nodes), len(nodes) + num - 1), b]
        nodes += [(1 - t) * shape.points[a] + t * shape.points[b] for t in np.arange(1, num) / num]
        edges += list(pairwise(chain))
    return np.array(nodes), edges


def chain(num: int) -> np.ndarray:
    return np.stack([np.arange(num - 1), np.arange(1, num)], axis=1)


def test_a_helix_has_its_curvature_everywhere():
    """Of radius a and rise b per radian: a / (a^2 + b^2)."""
    angle, a, b = np.linspace(0, 13, 240), 0.5, 0.1
    points = np.stack([a * np.cos(angle), a * np.sin(angle), b * angle], axis=1)
    tangent, curvature = tangents_of(points, np.full(240, 0.1))
    true = np.stack([-a * np.sin(angle), a * np.cos(angle), np.full(240, b)], axis=1) / np.hypot(a, b)
    assert (np.abs(tangent - true).max(axis=1) < 0.005).all()
    inner = slice(12, -12)
    np.testing.assert_allclose(curvature[inner], a / (a**2 + b**2), rtol=0.02)


@pytest.mark.parametrize("num", [2, 3, 4, 5, 30])
def test_a_straight_branch_of_any_number_of_nodes_has_a_tangent_and_no_curvature(num):
    points = np.linspace(0, 1, num)[:, None] * [1.0, 2.0, -2.0]
    tangent, curvature = tangents_of(points, np.full(num, 0.05))
    np.testing.assert_allclose(tangent, np.tile([1 / 3, 2 / 3, -2 / 3], (num, 1)), atol=1e-9)
    assert np.abs(curvature).max() < 1e-6


def test_the_section_of_an_elliptic_tube_has_its_area_and_diameters():
    shape = ground_truth.make("straight")
    axis = shape.points[-1] - shape.points[0]
    turn = np.linalg.svd(axis[None])[2]  # the axis, and two across it
    squeeze = turn.T @ np.diag([1.0, 2.0, 0.5]) @ turn
    mesh = trimesh.Trimesh(shape.mesh.vertices @ squeeze.T, shape.mesh.faces, process=False)
    nodes = shape.points[0] + np.linspace(0.2, 0.8, 9)[:, None] * axis
    skeleton = measured(nodes, chain(9), mesh)
    found = skeleton.columns("nodes")
    area, perimeter, largest, least = (
        found[name] for name in ("area", "perimeter", "largest_diameter", "least_diameter")
    )
    np.testing.assert_allclose(area, np.pi * 0.12**2, rtol=0.02)  # of 24 corners: 1.1 % less than the disc
    np.testing.assert_allclose(largest, 4 * 0.12, rtol=0.01)
    np.testing.assert_allclose(least, 0.12, rtol=0.02)
    ellipse = np.pi * 0.12 * (3 * 2.5 - np.sqrt((3 * 2 + 0.5) * (2 + 3 * 0.5)))  # Ramanujan's
    np.testing.assert_allclose(perimeter, ellipse, rtol=0.01)
    round_ = skeleton.with_radii("section")
    np.testing.assert_allclose(round_.radii, 0.12, rtol=0.01)
    assert (skeleton.radii < 0.065).all() and round_.radius_of == "section"
    np.testing.assert_array_equal(round_.with_radii("ball").radii, skeleton.radii)
    np.testing.assert_allclose(round_.resample(0.3).radii, 0.12, rtol=0.01)


def test_branches_know_their_lengths_angles_parents_and_radii():
    shape = ground_truth.make("y")
    nodes, edges = refined(shape, 0.05)
    table = pandas.DataFrame(measured(nodes, edges, shape.mesh).columns())
    assert len(table) == 3 and sorted(table["parent"]) == [-1, *[table.index[table["parent"] == -1][0]] * 2]
    trunk = table[table["parent"] == -1].iloc[0]
    limbs = table[table["parent"] >= 0]
    directions = shape.tips / np.linalg.norm(shape.tips, axis=1)[:, None]
    down = shape.tips[np.abs(shape.tip_radii - 0.14).argmin()]
    turns = np.degrees(np.arccos(np.clip(-directions @ (down / np.linalg.norm(down)), -1, 1)))
    np.testing.assert_allclose(sorted(limbs["angle"]), np.sort(turns)[:2], atol=1.0)
    np.testing.assert_allclose(sorted(table["length"]), np.sort(np.linalg.norm(shape.tips, axis=1)), rtol=1e-6)
    np.testing.assert_allclose(table["tortuosity"], 1, rtol=1e-9)
    assert np.isnan(trunk["angle"]) and table["is_tip"].sum() == 2
    assert 0.125 < trunk["least_radius"] <= trunk["mean_radius"] <= trunk["largest_radius"] < 0.145
    np.testing.assert_allclose(limbs["mean_radius"], (0.14 + 0.11) / 2, rtol=0.03)  # limbs taper
    assert (limbs["least_radius"] > 0.105).all()  # at the tips it is 0
    assert table["volume"].sum() == pytest.approx(shape.mesh.volume, rel=1e-3)


def test_tables_are_written_and_are_columns_of_arrays(tmp_path):
    shape = ground_truth.make("y")
    nodes, edges = refined(shape, 0.1)
    skeleton = measured(nodes, edges, shape.mesh)
    for suffix, of in ((".csv", "branches"), (".nodes.csv", "nodes")):
        skeleton.save(tmp_path / f"y{suffix}")
        with open(tmp_path / f"y{suffix}", newline="") as file:
            rows = list(csv.DictReader(file))
        columns = skeleton.columns(of)
        table = pandas.DataFrame(columns)
        assert list(rows[0]) == list(table.columns) and len(rows) == len(table)
        for name in table.columns:
            written = [np.nan if row[name] == "" else row[name] for row in rows]
            assert [str(value) for value in table[name].tolist()] == [str(value) for value in written]
        assert type(columns) is dict and list(columns) == list(table.columns)
        assert all(isinstance(values, np.ndarray) and len(values) == len(rows) for values in columns.values())
    with pytest.raises(ConfigError, match="no table of 'edges': expected one of 'branches', 'nodes'"):
        skeleton.columns("edges")


def test_vtk_reads_all_columns(tmp_path):
    """With a lone node before the lines, as VTK has it."""
    shape = ground_truth.make("y")
    nodes, edges = refined(shape, 0.1)
    skeleton = measured(np.vstack([nodes, [[0.0, 0.0, -0.5]]]), edges, shape.mesh)
    skeleton.save(tmp_path / "y.vtp")
    read = pyvista.read(tmp_path / "y.vtp")
    branches, of_nodes = pandas.DataFrame(skeleton.columns()), pandas.DataFrame(skeleton.columns("nodes"))
    order = np.argsort(branches["length"] > 0, kind="stable")
    for name in ("branch", "length", "angle", "volume", "parent", "least_radius"):
        np.testing.assert_array_equal(read.cell_data[name], branches[name].to_numpy()[order])
    for name in ("area", "curvature", "largest_diameter", "branch"):
        np.testing.assert_array_equal(read.point_data[name], of_nodes[name])
    np.testing.assert_array_equal(read.point_data["tangent"], of_nodes[["tangent_x", "tangent_y", "tangent_z"]])
    lengths = read.compute_cell_sizes(length=True, area=False, volume=False).cell_data["Length"]
    np.testing.assert_allclose(lengths, branches["length"].to_numpy()[order])


def test_a_curve_without_its_mesh_has_lengths_and_no_areas(tmp_path):
    shape = ground_truth.make("y")
    curve = curve_of(shape.points, np.sort(shape.edges, axis=1), shape.radii)
    table = pandas.DataFrame(curve.columns())
    assert table["volume"].isna().all() and (table["length"] > 0.5).all()
    assert pandas.DataFrame(curve.columns("nodes"))["area"].isna().all()
    curve.save(tmp_path / "y.vtp")
    assert "area" not in pyvista.read(tmp_path / "y.vtp").point_data
    with pytest.raises(ConfigError, match=r"does not know the mesh .*: expected one from .*; save it as \.npz"):
        curve.with_radii("section")


def cut_open(name: str) -> tuple[ground_truth.KnownShape, trimesh.Trimesh]:
    """A tube without its flat ends."""
    shape = ground_truth.make(name)
    towards = (shape.points[1] - shape.points[0], shape.points[-1] - shape.points[-2])
    is_end = np.zeros(len(shape.mesh.faces), dtype=bool)
    for end, along in zip(shape.points[[0, -1]], towards, strict=True):
        height = (shape.mesh.triangles - end) @ along / np.linalg.norm(along)
        is_end |= (np.abs(height) < 1e-3).all(axis=1)
    return shape, trimesh.Trimesh(shape.mesh.vertices, shape.mesh.faces[~is_end], process=False)


def test_a_vessel_that_was_cut_open_keeps_its_length_and_its_radius_to_the_openings():
    shape, mesh = cut_open("straight_coarse")
    assert not mesh.is_watertight
    skeleton = msf_jax.skeletonize(mesh, repair=True)
    assert len(skeleton.openings) == 2 and "2 openings" in " ".join(skeleton.report.notes)
    ends = skeleton.vertices[list(skeleton.openings)]
    order = spatial.KDTree(ends).query(shape.points[[0, -1]])
    assert order[0].max() < 0.02 and set(order[1]) == {0, 1}
    wall = 0.12 * np.cos(np.pi / 6)  # to the sides of the hexagon
    assert skeleton.radii.min() > 0.8 * wall
    (row,) = pandas.DataFrame(skeleton.columns()).to_dict("records")
    assert row["length"] == pytest.approx(2.2, rel=0.02) and row["least_radius"] > 0.8 * wall
    again = skeleton.resample(0.4)
    np.testing.assert_allclose(again.vertices[list(again.openings)], ends)
    assert again.radii.min() > 0.8 * wall


@pytest.mark.parametrize("turn", [0.0, 0.0175, 0.033, 0.5])
def test_the_diameters_of_a_flat_section_do_not_depend_on_how_it_is_turned(turn):
    """A bar of 10 x 1 x 0.1: its diagonal and its thickness."""
    mesh = trimesh.creation.box([1.0, 0.1, 10.0])
    mesh.apply_transform(trimesh.transformations.rotation_matrix(turn, [0, 0, 1]))
    nodes = np.linspace(-4, 4, 9)[:, None] * [0.0, 0, 1]
    found = measured(nodes, chain(9), mesh).columns("nodes")
    np.testing.assert_allclose(found["largest_diameter"], np.hypot(1, 0.1), rtol=1e-6)
    np.testing.assert_allclose(found["least_diameter"], 0.1, rtol=1e-6)
