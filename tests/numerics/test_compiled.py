"""What all compiled loops share: the arrays that they take, what they need, and threads."""

import subprocess
import sys

import numpy as np
import pytest
from conftest import blob

from msf_jax.solid.enclosure import Enclosure


def test_arrays_of_another_kind_are_taken_as_copies():
    """Other types, strides and byte orders, and arrays that may not be written to."""
    shape = Enclosure(np.array(blob(73, 1).vertices), np.array(blob(73, 1).faces))
    points = np.random.default_rng(5).integers(-1, 2, (20, 3)) / 2
    frozen = points.copy()
    frozen.flags.writeable = False
    plain = shape.nearest(points), shape.winding_numbers(points)
    others = points.astype(np.float32), np.asfortranarray(points), frozen, points.astype(">f8"), points[::-1][::-1]
    for other in others:
        np.testing.assert_array_equal(shape.nearest(other), plain[0])
        np.testing.assert_array_equal(shape.winding_numbers(other), plain[1])


PROGRAM = """
import sys
import msf_jax
from msf_jax.solid import kernels
assert "llvmlite" not in sys.modules
import numpy as np
found, which, none = np.empty(1), np.empty(1, dtype=np.int64), np.zeros(2, dtype=np.int64)
triangles, (boxes, order) = np.eye(3)[None], kernels.tree_of(np.zeros((1, 3)), np.ones((1, 3)))
mesh = kernels.Mesh(np.eye(3), np.arange(3), triangles, np.arange(3), boxes, order)
kernels.nearest(np.ones((1, 3)), mesh, none[:1], found, which)
print(found[0])
assert "numba" not in sys.modules
"""


@pytest.mark.system
def test_neither_numba_nor_a_folder_is_needed():
    found = subprocess.run([sys.executable, "-c", PROGRAM], capture_output=True, text=True, timeout=300)
    assert float(found.stdout) == pytest.approx(4 / 3), found.stderr
