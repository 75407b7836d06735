"""`follow` in PyTorch: its values and slopes are JAX's; and what misuse of runs and of tensors is told."""

import re
import sys
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from run_cases import flow_of

import msf_jax
from msf_jax import ConfigError, MeshError
from tests.benchmarks import ground_truth


@pytest.fixture(scope="module")
def tube():
    return flow_of("straight_coarse").skeleton, np.array(ground_truth.make("straight_coarse").mesh.vertices)


@pytest.fixture(scope="module")
def torch():
    return pytest.importorskip("torch")


def test_values_and_slopes_are_those_of_jax(tube, torch):
    """And those of PyTorch's own check, which compares with differences in random directions."""
    skeleton, vertices = tube
    tensor = torch.tensor(vertices, requires_grad=True)
    found = msf_jax.torch.follow(skeleton, tensor)
    expected = msf_jax.follow(skeleton, vertices)
    np.testing.assert_allclose(found.nodes.detach().numpy(), expected.nodes, atol=1e-12)
    np.testing.assert_allclose(found.radii.detach().numpy(), expected.radii, atol=1e-12)
    (found.nodes[:, 2] ** 2).sum().add(found.radii.sum()).backward()

    def loss(moved):
        nodes, radii = msf_jax.follow(skeleton, moved)
        return (nodes[:, 2] ** 2).sum() + radii.sum()

    np.testing.assert_allclose(tensor.grad.numpy(), jax.grad(loss)(jnp.asarray(vertices)), atol=1e-12)
    moved = torch.tensor(vertices + 1e-3 * np.random.default_rng(0).normal(size=vertices.shape), requires_grad=True)
    assert torch.autograd.gradcheck(
        lambda x: tuple(msf_jax.torch.follow(skeleton, x)), moved, fast_mode=True, atol=1e-5
    )
    narrow = torch.tensor(vertices, dtype=torch.float32, requires_grad=True)
    msf_jax.torch.follow(skeleton, narrow).nodes.sum().backward()
    assert narrow.grad.dtype == torch.float32


@pytest.mark.slow
def test_a_batch_and_a_binding_have_rows_of_padding(tube, torch):
    skeleton, vertices = tube
    batch = msf_jax.stack([skeleton, skeleton])
    tensor = torch.tensor(np.array(batch.vertices), requires_grad=True)
    nodes, _ = msf_jax.torch.follow(batch, tensor)
    for each in batch.split(nodes.detach().numpy()):
        np.testing.assert_allclose(each, skeleton.vertices, atol=1e-9)
    nodes.sum().backward()
    slope = tensor.grad.numpy()
    assert not slope[~np.array(batch.vertex_mask)].any() and not nodes[~torch.tensor(np.array(batch.node_mask))].any()
    alone = torch.tensor(vertices, requires_grad=True)
    msf_jax.torch.follow(skeleton.binding, alone).nodes.sum().backward()
    for each in batch.split(slope, "vertices"):
        np.testing.assert_allclose(alone.grad.numpy(), each, atol=1e-9)
    with pytest.raises(MeshError, match="as in the mesh"):
        msf_jax.torch.follow(batch, tensor[:5])


def test_what_is_no_tensor_of_real_numbers_is_refused(tube, torch, monkeypatch):
    skeleton, vertices = tube
    with pytest.raises(MeshError, match=r"expected a torch\.Tensor"):
        msf_jax.torch.follow(skeleton, vertices)
    with pytest.raises(MeshError, match=r"torch\.int64"):
        msf_jax.torch.follow(skeleton, torch.zeros((3, 3), dtype=torch.int64))
    jax.config.update("jax_enable_x64", False)
    try:
        with pytest.raises(ConfigError, match=r"would compute in float32: expected vertices.float\(\)"):
            msf_jax.torch.follow(skeleton, torch.tensor(vertices))
    finally:
        jax.config.update("jax_enable_x64", True)


def test_without_pytorch_it_says_what_to_install(tube, monkeypatch):
    monkeypatch.setitem(sys.modules, "torch", None)
    with pytest.raises(ConfigError, match="pip install torch"):
        msf_jax.torch.follow(*tube)


def test_a_run_in_a_trace_leads_to_follow_or_replay(tube):
    mesh = ground_truth.make("straight_coarse").mesh
    with pytest.raises(MeshError, match=r"use msf_jax\.follow inside"):
        jax.jit(lambda moved: msf_jax.skeletonize((moved, mesh.faces)).vertices)(tube[1])
    with pytest.raises(MeshError, match=r"use msf_jax\.follow inside"):
        jax.grad(lambda moved: msf_jax.skeletonize((moved, mesh.faces)).radii.sum())(tube[1])
    for run in (lambda w: msf_jax.skeletonize(mesh, w).vertices.sum(), lambda w: msf_jax.contract(mesh, w).meso.sum()):
        with pytest.raises(ConfigError, match=r"traces the weights.* use msf_jax\.replay inside, with the tape of"):
            jax.grad(lambda w, run=run: run(msf_jax.Weights(w_H=w)))(0.1)
    with pytest.raises(ConfigError, match=r"as faces have: pass the mesh as one argument, \(vertices, faces\)"):
        msf_jax.skeletonize(mesh.vertices, mesh.faces)


@pytest.mark.slow
def test_the_recipe_runs(tube, torch, tmp_path, monkeypatch):
    page = (Path(msf_jax.__file__).parent / "guide" / "cookbook.md").read_text("utf-8")
    (block,) = re.findall(r"```py\n(.*?)```", page, flags=re.DOTALL)
    ground_truth.make("straight_coarse").mesh.export(tmp_path / "hand.off")
    monkeypatch.chdir(tmp_path)
    exec(compile(block, "recipe", "exec"), {})
