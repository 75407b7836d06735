"""A picture of the progress of `tune`."""

from typing import TYPE_CHECKING

import numpy as np

from msf_jax.tuning.result import Tuned

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def trajectory(tuned: Tuned) -> "Figure":
    """A matplotlib figure of a tuning: the objective of every proposal, and the weights that were tried."""
    from matplotlib.figure import Figure
    from matplotlib.ticker import MaxNLocator

    drawing = Figure(figsize=(10, 3.8), layout="constrained")
    left, right = drawing.subplots(1, 2)
    number = np.arange(len(tuned.trajectory))
    found = np.array([step.found for step in tuned.trajectory])
    is_taken = np.array([step.is_taken for step in tuned.trajectory])
    left.plot(number, [step.expected for step in tuned.trajectory], "--", color="0.6", label="expected")
    left.plot(number[is_taken], found[is_taken], "o-", label="found by a fresh run, taken")
    left.plot(number[~is_taken], found[~is_taken], "x", color="tab:red", label="found, not taken")
    left.set(xlabel="proposal", ylabel="objective")
    left.legend()
    for name in ("w_L", "w_H", "w_M", "smoothing"):
        values = [
            float(np.exp(np.log(np.maximum(getattr(step.weights, name), 1e-300)).mean())) for step in tuned.trajectory
        ]
        right.semilogy(number, values, ".-", label=name)
    right.set(xlabel="proposal", ylabel="weight")
    right.legend()
    for axes in (left, right):
        axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    return drawing
