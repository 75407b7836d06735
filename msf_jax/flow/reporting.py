"""The report of a run: what was found, and how far to trust it."""

import numpy as np

from msf_jax.flow.curves import MOST_VOLUME, is_tangle
from msf_jax.flow.state import Iteration, State, Stopwatch
from msf_jax.host.mesh.checking import Surface
from msf_jax.skeleton.report import Report


def report_of(
    checked: Surface,
    states: list[State],
    reasons: list[tuple[bool, str]],
    history: tuple[Iteration, ...],
    notes: list[str],
    figures: dict[str, float],
    watch: Stopwatch,
) -> Report:
    """The report without what is the curve's own: components, cycles and inside are filled in for each."""
    return Report(
        components=0,
        mesh_components=len(checked.components),
        genus=sum(component.genus for component in checked.components),
        cycles=0,
        inside=np.nan,
        converged=all(is_converged for is_converged, _ in reasons),
        reason="; ".join(dict.fromkeys(reason for _, reason in reasons)),
        iterations=len(history),
        fixed=sum(int(state.meso.is_fixed.sum()) for state in states),
        live=sum(state.meso.num_live for state in states),
        volume=max(abs(state.history[-1].volume) if state.history else 1.0 for state in states),
        unsolved=sum(not line.is_solved for line in history),
        solve_steps=sum(line.steps + line.smoothing_steps for line in history),
        coarsened=sum(state.num_coarsened for state in states),
        repairs=checked.repairs,
        notes=(*notes, *_notes(states, history)),
        figures=figures,
        seconds=watch.seconds,
    )


def _notes(states: list[State], history: tuple[Iteration, ...]) -> list[str]:
    notes = []
    if tangles := sum(map(is_tangle, states)):
        notes.append(f"{tangles} of {len(states)} curves not finished: over {MOST_VOLUME:.0%} of the volume is left")
    if redone := sum(line.redone > 0 for line in history):
        notes.append(f"{redone} {'step was' if redone == 1 else 'steps were'} redone shorter: numbers ran away")
    return notes
