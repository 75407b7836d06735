"""Fixing degenerate vertices, and the threshold's saw-tooth (article 3.2.5 and 3.2.6)."""

import numpy as np

from msf_jax.meso import kernels
from msf_jax.meso.collapse import Waiting
from msf_jax.meso.meso import Fixing, Meso


def degenerate_length(t_c: float) -> float:
    """t_f = t_c / 10: a shorter edge counts as a point."""
    return t_c / 10


def fix_degenerate_vertices(meso: Meso, t_f: float) -> int:
    """Fix, in place, every vertex with two or more incident edges shorter than ``t_f`` that cannot collapse.

    Returns how many became fixed.
    """
    every = np.ones(meso.num_rows, dtype=bool)
    a, b, left, right, common = Waiting().find(kernels.short_edges, meso, every, t_f).T
    is_stuck = (common != 2) | (meso.degree[left] <= 3) | (meso.degree[right] <= 3)
    count = np.bincount(np.concatenate([a[is_stuck], b[is_stuck]]), minlength=meso.num_rows)
    fresh = (count >= 2) & ~meso.is_fixed
    meso.is_fixed |= fresh
    meso.edits.append(Fixing(np.flatnonzero(fresh)))
    return int(fresh.sum())


def threshold(iteration: int, t_min: float, t_step: float, t_max: float) -> float:
    """The saw-tooth: t_c in an iteration, from 0. It rises by ``t_step``, and above ``t_max`` falls to ``t_min``."""
    return t_min + (iteration % num_periods(t_min, t_step, t_max)) * t_step


def num_periods(t_min: float, t_step: float, t_max: float) -> int:
    """Iterations from one fall of the threshold to the next."""
    # A quotient that is whole, but for rounding, is whole.
    return 1 if t_step == 0 else int((t_max - t_min) / t_step * (1 + 1e-9)) + 1
