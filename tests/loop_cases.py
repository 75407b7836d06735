"""Closed polylines, and solids with handles that they go around."""

from functools import cache

import numpy as np
from conftest import torus

from msf_jax.solid.enclosure import Enclosure
from tests.benchmarks import ground_truth

NO_EDGES = np.empty((0, 2), dtype=np.int64)


def shape_of(mesh):
    return Enclosure(np.array(mesh.vertices, dtype=float), np.array(mesh.faces, dtype=np.int64))


def cycle(num, first=0):
    """The edges of a closed polyline of ``num`` nodes."""
    step = np.arange(num)
    return first + np.stack([step, (step + 1) % num], axis=1)


def circle(radius, centre=(0.0, 0.0, 0.0), num=120):
    angle = np.linspace(0, 2 * np.pi, num, endpoint=False)
    return np.array(centre) + radius * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)


def torus_knot(along, across):
    """Goes ``along`` times round the axis of a ring of radius 1, and ``across`` times round its middle."""
    angle = np.linspace(0, 2 * np.pi, 120 * along, endpoint=False)
    out = 1 + 0.15 * np.cos(across * angle)
    return np.stack([out * np.cos(along * angle), out * np.sin(along * angle), 0.15 * np.sin(across * angle)], axis=1)


def windings(shape, line):
    """The linking numbers of a closed polyline with the loops of a solid's surface."""
    return shape.handles.linking(line, np.roll(line, -1, axis=0), np.zeros(len(line), dtype=np.int64))[0]


RING = shape_of(torus(minor=0.3))


@cache
def theta():
    """A solid of genus 2, and a curve in it: its own, a loop around both handles, one in a limb, and a lone node."""
    shape = ground_truth.make("theta")
    size = np.ptp(shape.mesh.vertices)
    small = circle(0.05, shape.points[5], 12)
    points = np.concatenate([shape.points, shape.points + [0.01, 0.0, 0.0], small, shape.points[:1]])
    num = len(shape.points)
    edges = np.concatenate([shape.edges, shape.edges + num, cycle(12, 2 * num)])
    assert shape_of(shape.mesh).holds(*(points[edges[:, k]] for k in (0, 1))).all() and size > 0
    return np.array(shape.mesh.vertices), np.array(shape.mesh.faces), points, edges
