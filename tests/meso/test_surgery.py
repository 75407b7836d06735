"""The costs of the surgery of Au et al. 2008, edge by edge."""

import numpy as np
import pytest
from conftest import blob

from msf_jax.meso import surgery


def test_the_costs_are_those_of_the_paper():
    """F_a from the lines of all edges that were gathered, F_b from the lengths that are left, edge by edge."""
    mesh = blob(1, 2)
    x = np.array(mesh.vertices)
    a, b = mesh.edges_unique.T
    work = surgery._Costs(x, a, b)
    around = [set(neighbours) for neighbours in mesh.vertex_neighbors]
    lines = [[(i, j) for j in around[i]] for i in range(len(x))]

    def expected(i, j):
        shape = 0.0
        for start, end in lines[i] + lines[j]:
            along = (x[end] - x[start]) / np.linalg.norm(x[end] - x[start])
            shape += (np.cross(along, x[j] - x[start]) ** 2).sum()
        return shape + 0.1 * np.linalg.norm(x[i] - x[j]) * sum(np.linalg.norm(x[i] - x[k]) for k in around[i])

    random = np.random.default_rng(4)
    for _ in range(60):
        i = int(random.choice([v for v in range(len(x)) if around[v]]))
        j = int(random.choice(sorted(around[i])))
        assert work.cost(i, j) == pytest.approx(expected(i, j), rel=1e-9)
        work.merge(i, j)
        lines[j] += lines[i]
        for k in around[i]:
            around[k] = (around[k] - {i}) | ({j} if k != j else set())
        around[j] |= around[i] - {j}
        around[i] = set()
