"""When the flow stops, and whether it has converged then."""

from msf_jax.base.options import Config
from msf_jax.flow.state import Iteration, State
from msf_jax.host.meso import fixing

SETTLED = 0.02  # of the volume may be left, however it is; or, in membranes,
MEMBRANES, THINNED = 0.1, 0.25  # that much, if what is left is that part as thick as the solid was
PROGRESS = 0.1  # of the area, that a tooth must take away, or the flow has settled;
FEWEST = 20  # iterations, that a tooth counts for at least
STALL_ITERATIONS = 30  # without progress, after which the flow gives up: longer than a tooth of the default threshold


def has_volume(state: State, config: Config) -> bool:
    """Whether there is more to contract: volume, or, as a flat sheet has none, area that is not yet down to a curve's.

    A thin curve still has some area; it is as small as it gets when three iterations take less than a tenth of it away.
    """
    last = state.history[-1]
    if abs(last.volume) > config.volume_tolerance:
        return True
    is_settled = len(state.history) > 3 and last.area > 0.9 * state.history[-4].area
    return last.area > config.area_tolerance and not is_settled


def is_settled(history: list[Iteration], config: Config) -> bool:
    """Whether next to nothing is left, and has not become less in a whole tooth of the threshold.

    Membranes between fixed vertices have nowhere to go: their edges are split as fast as they collapse. The curve is
    read off them as it is of anything thin.
    """
    tooth = max(fixing.num_teeth(config.t_min, config.t_step, config.t_max), FEWEST)
    volume = abs(history[-1].volume)
    is_thin = volume <= MEMBRANES and volume <= THINNED * history[-1].area
    if len(history) <= tooth or not (is_thin or volume <= SETTLED):
        return False
    return history[-1].area > (1 - PROGRESS) * history[-1 - tooth].area


def done(state: State, config: Config) -> tuple[bool, str] | None:
    """None while the surface has volume and the flow can go on; else whether it converged, and why it stops."""
    if state.failure:
        return False, state.failure
    if not state.history:
        return None
    last = state.history[-1]
    if not has_volume(state, config):
        return True, "no volume left"
    if last.live - last.fixed <= config.free_tolerance * last.live:
        return True, "all vertices fixed"
    if is_settled(state.history, config):
        return True, f"settled: {abs(last.volume):.1%} of the volume is left, between fixed vertices"
    if len(state.history) >= config.max_iterations:
        return False, f"max_iterations ({config.max_iterations}) reached"
    if len(state.history) > STALL_ITERATIONS:
        before = state.history[-1 - STALL_ITERATIONS]
        recent = state.history[-STALL_ITERATIONS:]
        best = min(abs(line.volume) for line in recent)
        if best > 0.99 * abs(before.volume) and last.live - last.fixed >= before.live - before.fixed:
            return False, f"stalled: no progress in {STALL_ITERATIONS} iterations"
    return None
