"""`jax.export` with fixed sizes: `follow`, and an iteration, for the CPU and for machines that are not at hand."""

from functools import partial

import jax
import numpy as np
import pytest
from device_cases import build, one_level, pebble
from jax import export
from run_cases import flow_of

import msf_jax
from msf_jax import Config, Weights
from msf_jax.device import iteration
from tests.benchmarks import ground_truth

PLATFORMS = ("cpu", "cuda", "tpu")  # XLA compiles for the last two where such a device is; all operations are lowered


@pytest.fixture(scope="module")
def tube():
    mesh = ground_truth.make("straight_coarse").mesh
    return np.array(mesh.vertices), flow_of("straight_coarse").skeleton


@pytest.mark.slow  # so is an iteration, below
def test_follow_is_exported_with_fixed_sizes(tube):
    vertices, skeleton = tube
    moved = vertices + 0.05 * np.sin(2 * vertices[:, [1, 2, 0]])
    program = jax.jit(lambda vertices: tuple(msf_jax.follow(skeleton, vertices)))
    exported = export.export(program, platforms=PLATFORMS)(jax.ShapeDtypeStruct(vertices.shape, vertices.dtype))
    assert exported.platforms == PLATFORMS
    for one, other in zip(exported.call(moved), msf_jax.follow(skeleton, moved), strict=True):
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-13)
    with pytest.raises(ValueError, match="shape"):
        exported.call(moved[1:])


@pytest.mark.slow
def test_an_exported_program_is_read_back_with_its_gradient(tube):
    pytest.importorskip("flatbuffers")  # what JAX writes it with
    vertices, skeleton = tube
    program = jax.jit(lambda vertices: tuple(msf_jax.follow(skeleton, vertices)))
    read = export.deserialize(export.export(program)(vertices).serialize(vjp_order=1))

    def slope(follow):
        return jax.grad(lambda vertices: (follow(vertices)[0] ** 2).sum())(vertices)

    np.testing.assert_allclose(slope(read.call), slope(program), rtol=0, atol=1e-12)


@pytest.mark.slow
def test_an_iteration_is_lowered_for_every_platform():
    """Both solves, and their derivative."""
    case = build(*pebble(3, 60), layout=one_level(128, 16))
    move = partial(iteration.move, settings=Config().tight().on_device, layout=case.layout)

    def value(positions):
        return (move(case.buffers._replace(positions=positions), Weights()).positions ** 2).sum()

    exported = export.export(jax.jit(jax.grad(value)), platforms=PLATFORMS)(case.buffers.positions)
    assert exported.platforms == PLATFORMS and exported.out_avals[0].shape == (128, 3)
