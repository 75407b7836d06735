"""The result of `tune`."""

import os
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from msf_jax.base.options import Weights, save_weights
from msf_jax.flow.state import Flow
from msf_jax.gradients.tape import Comparison


class TuningStep(NamedTuple):
    """One proposal. The first is the start.

    weights: proposed. expected: the objective predicted by the tapes or by the model of past runs; NaN if there was no
    prediction. found: the objective of fresh runs; inf if one failed, NaN if none was made. is_taken: whether the
    weights were accepted. box: half the width of the trust region, or the standard deviation of candidates, in natural
    logarithms. converges: whether all of the fresh runs did. changed: decisions of the fresh runs that are not those of
    the runs with the weights before; None if no tapes were compared.
    """

    weights: Weights
    expected: float
    found: float
    is_taken: bool
    box: float
    converges: bool
    changed: Comparison | None


@dataclass(frozen=True)
class Tuned:
    """The result of `tune`.

    Attributes:
        weights: the best weights.
        value: the objective there, by fresh runs, the mean over the meshes.
        flows: those runs, one for each mesh.
        trajectory: every proposal, in order.
        reason: why it stopped.
        of_defaults: the objective at the system's default weights, within the bounds; NaN if they were not tried.
    """

    weights: Weights
    value: float
    flows: tuple[Flow, ...]
    trajectory: tuple[TuningStep, ...]
    reason: str
    of_defaults: float = np.nan

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the best weights to a JSON file, for ``msf-jax skeletonize --weights`` and `msf_jax.read_weights`."""
        save_weights(self.weights, path)

    def __repr__(self) -> str:
        weights = ", ".join(f"{name} {shown(weight)}" for name, weight in vars(self.weights).items())
        return f"Tuned({self.value:.6g} at {weights}, after {len(self.trajectory) - 1} steps, {self.reason})"

    def __str__(self) -> str:
        beats = f"{self.of_defaults:.6g}" + ("" if self.value < self.of_defaults else ": nothing beats them")
        lines = [f"{len(self.trajectory) - 1} steps, {self.reason}"]
        lines += [] if np.isnan(self.of_defaults) else [f"default weights: {beats}"]
        lines += ["objective   expected   box    decisions changed"]
        for step in self.trajectory:
            weights = ", ".join(f"{name} {shown(weight)}" for name, weight in vars(step.weights).items())
            changed = f"{step.changed.different} of {step.changed.total}" if step.changed else "-"
            mark = "taken" if step.is_taken else "     "
            expected = "-" if np.isnan(step.expected) else f"{step.expected:.6g}"  # NaN: there was no prediction
            found = "-" if np.isnan(step.found) else f"{step.found:.6g}"  # NaN: there was no fresh run
            lines.append(f"{found:<11} {expected:<10} {step.box:.3f}  {changed:<16} {mark}  {weights}")
        return "\n".join(lines)


def shown(weight: Any) -> str:
    """A weight in a few digits, or the range of an array of them."""
    return f"{float(weight):.4g}" if np.ndim(weight) == 0 else f"{np.min(weight):.3g} to {np.max(weight):.3g}"
