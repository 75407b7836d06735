"""The factor that is the preconditioner of ill-conditioned systems, against the dense inverse."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from conftest import blob

from msf_jax import Config
from msf_jax.base.layout import layout_for
from msf_jax.base.options import Weights
from msf_jax.device.buffers import Buffers, Rings
from msf_jax.device.iteration import _equations, _jitted_energies
from msf_jax.meso import packing
from msf_jax.meso.meso import Meso
from msf_jax.numerics.factors import factored


def system(mesh, w_L, w_H, area=1.0, fixed=()):
    """The dense normal operator, the sparse factor's inverse, which rows are free, and the layout's capacity."""
    vertices = mesh.vertices / mesh.scale
    meso = Meso.from_mesh(vertices, np.array(mesh.faces))
    meso.is_fixed[list(fixed)] = True
    layout = layout_for(meso.num_rows, packing.rows_beyond(meso.degree))
    order, _, fields = packing.pack(meso, layout, np.full(meso.num_rows, area), np.dtype(np.float64))
    buffers = Buffers(**{**fields, "rings": Rings(*fields["rings"])})
    settings = Config.au2008().on_device
    energy = _jitted_energies(buffers, Weights(w_L, w_H, 0.0, 0.0), settings, layout)[0]
    operator, b = _equations(buffers, energy, settings, layout)
    num = len(order)
    eye = jnp.eye(layout.capacity)[:, :num]
    dense = np.asarray(jax.jit(lambda A: A(eye))(operator))[:num]
    arrays = jax.device_get((operator.neighbour, operator.weights[0], operator.own, operator.shift, operator.free))
    inverse = factored(*arrays, layout)
    return dense, inverse(np.asarray(eye))[:num], np.asarray(b)[:num], inverse


@pytest.mark.slow  # steps of conjugate gradients with it are counted in quick tests
def test_the_factor_is_within_a_half_of_the_inverse_however_large_w_L_is():
    mesh = blob(3, 2)
    area = float(mesh.area / mesh.scale**2)  # of no ring: w_H varies over the surface
    for w_L in (1.0, 1e6):
        dense, inverse, _, _ = system(mesh, w_L, 1.0, area, fixed=(0, 5))
        value = np.linalg.eigvals(inverse @ dense)
        assert np.abs(value.imag).max() < 1e-4
        assert value.real.min() > 0.49
        assert value.real.max() < 1.3
    diagonal = np.diag(dense)  # what the diagonal makes of it; a similar matrix is symmetric
    by_diagonal = np.linalg.eigvalsh(dense / np.sqrt(np.outer(diagonal, diagonal)))
    assert by_diagonal[-1] > 1e4 * by_diagonal[0]


def test_what_is_fixed_is_left_alone_and_nothing_is_made_of_what_is_no_number():
    mesh = blob(3, 2)
    _, inverse, _, apply = system(mesh, 10.0, 1.0, fixed=(7,))
    row = np.argmax(np.isclose(np.abs(inverse - np.eye(len(inverse))).sum(axis=1), 0))
    assert (inverse[row] == np.eye(len(inverse))[row]).all()
    r = np.random.default_rng(0).normal(size=(2048, 3))
    assert not np.array_equal(apply(r), r)
    bad = np.full(4, np.nan)
    layout = layout_for(4, [4, 4, 4])
    slots = np.zeros(layout.num_slots)
    assert factored(slots.astype(int), slots, bad, bad, bad, layout)(bad) is bad
