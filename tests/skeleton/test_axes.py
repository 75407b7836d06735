"""Axes of virtual plants, whose orders, parents, angles and lengths are known; cylinders of models of trees."""

import csv
from itertools import pairwise

import numpy as np
import pandas
import pytest
from scipy import spatial

import msf_jax
from msf_jax import shapes
from msf_jax.skeleton.skeleton import Skeleton, curve_of


class Plant:
    """A plant that is grown axis by axis. parent, angle, position, tip: of each axis, as it was asked for."""

    def __init__(self, height: float, lean: float, num: int = 40) -> None:
        t = lean * np.linspace(0, 1, num)
        step = height / (num - 1) * np.stack([np.sin(t), 0 * t, np.cos(t)], axis=1)
        line = np.vstack([np.zeros(3), np.cumsum((step[1:] + step[:-1]) / 2, axis=0)])
        self.points, self.radii, self.edges = (
            [*line],
            [*np.linspace(0.2, 0.12, num)],
            [*pairwise(range(num))],
        )
        self.nodes, self.parent, self.angle = [list(range(num))], [-1], [np.nan]
        self.position, self.length = [np.nan], [height]

    def grow(self, parent: int, place: int, angle: float, turn: float, length: float, radius: float) -> int:
        """A straight axis from node ``place`` of its parent, at an angle to it, turned about it; both in degrees."""
        nodes = self.nodes[parent]
        line = np.array([self.points[node] for node in nodes])
        up = line[place + 1] - line[place - 1]
        up /= np.linalg.norm(up)
        u = np.cross(up, [0.3, 1.0, 0.2])
        u /= np.linalg.norm(u)
        a, b = np.radians([angle, turn])
        along = np.cos(a) * up + np.sin(a) * (np.cos(b) * u + np.sin(b) * np.cross(up, u))
        num = 30
        own = [nodes[place], *range(len(self.points), len(self.points) + num)]
        self.points += [line[place] + length * k / num * along for k in range(1, num + 1)]
        self.radii += [radius] * num
        self.edges += list(pairwise(own))
        self.nodes.append(own)
        self.parent.append(parent)
        self.angle.append(angle)
        self.length.append(length)
        self.position.append(float(np.linalg.norm(np.diff(line[: place + 1], axis=0), axis=1).sum()))
        return len(self.nodes) - 1

    @property
    def curve(self) -> Skeleton:
        return curve_of(np.array(self.points), np.sort(np.array(self.edges), axis=1), np.array(self.radii))

    def mesh(self, spacing: float):
        return shapes.solid_around(np.array(self.points), np.array(self.edges), np.array(self.radii), spacing)


def virtual(seed: int, num: int = 4) -> Plant:
    """A leaning stem with axes at random angles; the first two have one of their own."""
    random, plant = np.random.default_rng(seed), Plant(6.0, 0.3)
    for k in range(num):
        side = plant.grow(0, 8 + 7 * k, random.uniform(42, 75), 137.5 * k, random.uniform(1.6, 2.4), 0.1)
        if k < 2:
            plant.grow(side, 17, random.uniform(45, 70), 40.0, 1.2, 0.09)
    return plant


def check(plant: Plant, skeleton: Skeleton, degrees: float, share: float, away: float, ends: float) -> None:
    """All orders and parents are right. ``ends``: what the curve lacks of a length, in radii of the plant's ends."""
    table = pandas.DataFrame(skeleton.columns("axes"))
    tips = np.array([plant.points[nodes[-1]] for nodes in plant.nodes])
    which = spatial.KDTree(tips).query(skeleton.vertices[table["end"]])[1]
    assert sorted(which) == list(range(len(tips)))
    order = [0]
    for parent in plant.parent[1:]:
        order.append(order[parent] + 1)
    np.testing.assert_array_equal(table["order"], np.array(order)[which])
    found = np.where(table["parent"] >= 0, which[table["parent"]], -1)
    np.testing.assert_array_equal(found, np.array(plant.parent)[which])
    is_side = table["parent"] >= 0
    np.testing.assert_allclose(table["angle"][is_side], np.array(plant.angle)[which][is_side], atol=degrees)
    radius = np.array([plant.radii[nodes[-1]] for nodes in plant.nodes])
    expected = np.array(plant.length) + ends * radius + np.where(np.arange(len(tips)) == 0, ends * plant.radii[0], 0.0)
    np.testing.assert_allclose(table["length"], expected[which], rtol=share)
    base = np.where(np.array(plant.parent)[which] == 0, ends * plant.radii[0], 0.0)
    position = np.array(plant.position)[which] + base
    np.testing.assert_allclose(table["position"][is_side], position[is_side], atol=away)
    for parent in set(table["parent"][is_side]):  # internodes add up
        mine = table["parent"] == parent
        assert table["internode"][mine].sum() == pytest.approx(table["position"][mine].max())
        assert (table["internode"][mine] > -1e-9).all()


@pytest.mark.parametrize("seed", range(3))
def test_the_axes_of_a_curve_are_those_it_was_grown_with(seed):
    plant = virtual(seed)
    check(plant, plant.curve, degrees=3.0, share=1e-3, away=0.02, ends=0.0)


def test_strahlers_order_is_one_more_where_equals_meet():
    """A stem with two axes, of which one has an axis: 2 where that begins, and 2 along the stem below the tip: 1, 2."""
    plant = Plant(6.0, 0.0)
    one = plant.grow(0, 10, 60, 0, 2.0, 0.1)
    plant.grow(0, 20, 60, 120, 2.0, 0.1)
    plant.grow(one, 15, 60, 0, 1.0, 0.08)
    table = pandas.DataFrame(plant.curve.columns("axes"))
    order = dict(zip(table["end"], table["strahler"], strict=True))
    tips = [nodes[-1] for nodes in plant.nodes]
    assert [order[tip] for tip in tips] == [3, 2, 1, 1]


@pytest.mark.parametrize(("radius", "goes_on"), [(0.1, False), (0.45, True)])
def test_an_axis_goes_on_with_the_thickest_and_straightest(radius, goes_on):
    """At 60 degrees a branch counts 3/4: one of 0.45 takes the place of the stem, of up to 0.2, one of 0.1 does not."""
    plant = Plant(6.0, 0.0)
    side = plant.grow(0, 20, 60, 0, 2.0, radius)
    skeleton = plant.curve.to_tree(0)
    table = pandas.DataFrame(skeleton.columns("axes"))
    (main,) = np.flatnonzero(table["order"] == 0)
    assert table["start"][main] == 0 and (table["end"][main] == plant.nodes[side][-1]) == goes_on
    assert len(table["axis"]) == 2


def test_a_stub_does_not_end_an_axis():
    """Where a stem bends by 50 degrees: one as thick as the stem below, straight on, and 0.3 long."""
    plant = Plant(3.0, 0.0)
    upper = plant.grow(0, 38, 50, 0, 4.0, 0.1)
    plant.radii[38:40] = 0.2, 0.2  # the last edge of the first stem is the stub
    plant.points[39] = plant.points[38] + np.array([0, 0, 0.3])
    table = plant.curve.to_tree(0).columns("axes")
    assert table["order"].tolist() == [0, 1] and table["end"][0] == plant.nodes[upper][-1]


@pytest.mark.parametrize("degrees", [15.0, 27.0, 60.0])
def test_an_angle_is_to_the_direction_below_the_fork(degrees):
    """A symmetric Y: each branch is as many degrees from the trunk, whichever continues it."""
    plant = Plant(3.0, 0.0)
    for turn in (0, 180):
        plant.grow(0, 38, degrees, turn, 2.5, 0.12)
    kept = np.delete(np.arange(len(plant.points)), 39)  # without the trunk's last edge
    edges = np.searchsorted(kept, [edge for edge in plant.edges if 39 not in edge])
    curve = curve_of(np.array(plant.points)[kept], np.sort(edges, axis=1), np.array(plant.radii)[kept])
    assert curve.to_tree(0).columns("axes")["angle"][1] == pytest.approx(degrees, abs=0.5)


def stored_anew(curve: Skeleton, seed: int) -> Skeleton:
    """The same curve with other numbers of its nodes."""
    order = np.random.default_rng(seed).permutation(len(curve.vertices))
    edges = np.unique(np.sort(np.argsort(order)[curve.edges], axis=1), axis=0)
    return curve_of(curve.vertices[order], edges, curve.radii[order])


@pytest.mark.parametrize("seed", range(3))
def test_directions_come_from_the_root(seed):
    """A point or a node near a tip roots at that tip, one within a branch splits it, however the nodes are numbered."""
    plant = virtual(seed)
    curve = stored_anew(plant.curve, seed)
    foot, middle = plant.points[2], plant.points[11]  # 0.3 from the tip, of radius 0.2; and between two forks
    near = int(np.linalg.norm(curve.vertices - foot, axis=1).argmin())
    for root in (tuple(foot), near):
        check(plant, curve.to_tree(root), degrees=3.0, share=1e-3, away=0.02, ends=0.0)
    tree = curve.to_tree(tuple(middle))
    np.testing.assert_array_equal(tree.vertices[tree.roots[0]], middle)
    table, rows = (pandas.DataFrame(tree.columns(of)) for of in ("axes", "branches"))
    ahead = table[table["parent"] < 0]
    assert (ahead["order"] == 0).all() and (ahead["start"] == tree.roots[0]).all() and len(ahead) == 2
    down = float(np.linalg.norm(np.diff(plant.points[:12], axis=0), axis=1).sum())
    assert sorted(ahead["length"]) == pytest.approx([down, plant.length[0] - down], rel=1e-4)
    assert len(rows) == len(curve.branches) + 1 and rows["length"].sum() == pytest.approx(curve.length)
    assert (rows["start"][rows["parent"] < 0] == tree.roots[0]).all()
    after = rows[rows["parent"] >= 0]
    assert (after["start"].to_numpy() == rows["end"].to_numpy()[after["parent"]]).all()


def test_cylinders_lead_from_parent_to_child(tmp_path):
    """As readers of TreeQSM's cylinders walk them: numbers from 1, and 0 for none. An axis begins at the surface of its
    parent, at 0.15 to 0.2 from the axis of a stem of 0.2 to 0.12."""
    plant = virtual(0)
    plant.curve.save(tmp_path / "plant.cylinders.csv")
    with open(tmp_path / "plant.cylinders.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    names = "radius length start.x start.y start.z axis.x axis.y axis.z parent extension added UnmodRadius branch"
    assert list(rows[0]) == [*names.split(), "BranchOrder", "PositionInBranch"]
    value = {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}
    parent, extension = value["parent"].astype(int), value["extension"].astype(int)
    start, axis = (np.stack([value[f"{of}.{x}"] for x in "xyz"], axis=1) for of in ("start", "axis"))
    end = start + value["length"][:, None] * axis
    np.testing.assert_allclose(np.linalg.norm(axis, axis=1), 1)
    assert (parent < np.arange(1, len(rows) + 1)).all() and (parent == 0).sum() == 1
    first, has = value["PositionInBranch"] == 1, parent > 0
    np.testing.assert_allclose(end[parent[~first] - 1], start[~first], atol=1e-9)
    gap = np.linalg.norm(end[parent - 1] - start, axis=1)[first & has]
    assert (gap > 0.1).all() and (gap < 0.3).all()
    np.testing.assert_array_equal(parent[extension[extension > 0] - 1], np.flatnonzero(extension > 0) + 1)
    assert first.sum() == len(plant.nodes) and (value["branch"][~first] == value["branch"][parent[~first] - 1]).all()
    order = value["BranchOrder"]
    assert (order[first & has] == order[parent[first & has] - 1] + 1).all()
    assert value["length"].sum() + gap.sum() == pytest.approx(plant.curve.length)


def test_the_tables_of_axes_and_cylinders_are_written_and_others_refused(tmp_path):
    curve = virtual(1).curve
    curve.save(tmp_path / "plant.axes.csv")
    assert (tmp_path / "plant.axes.csv").read_text().startswith("axis,parent,order,strahler,")
    with pytest.raises(msf_jax.ConfigError, match="'axes', 'cylinders'"):
        curve.columns("axis")
    alone = curve_of(np.zeros((1, 3)), np.empty((0, 2), dtype=int), np.ones(1))
    assert len(alone.columns("axes")["axis"]) == 1 and len(alone.columns("cylinders")["radius"]) == 0


@pytest.mark.slow  # virtual ones are quick
def test_a_small_plant_in_a_mesh():
    """Whole ends are round, so a length is that of the plant and 0.7 of the radius at its ends. Cylinders have the
    volume of the mesh."""
    plant = Plant(4.0, 0.1)
    plant.grow(0, 14, 60, 0, 1.5, 0.11)
    plant.grow(0, 26, 50, 137, 1.5, 0.11)
    mesh = plant.mesh(0.085)
    skeleton = msf_jax.skeletonize(mesh)
    assert skeleton.report.are_limbs
    tree = skeleton.to_tree((0.0, 0.0, 0.0))
    check(plant, tree, degrees=5.0, share=0.03, away=0.1, ends=0.7)
    for each in (tree, tree.with_radii("section")):
        cylinders = each.columns("cylinders")
        volume = np.pi * (cylinders["radius"] ** 2 * cylinders["length"]).sum()
        assert volume == pytest.approx(mesh.volume, rel=0.03)
