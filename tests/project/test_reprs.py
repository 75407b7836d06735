"""What a notebook or a prompt shows of a result: one line, with what matters of it."""

from pathlib import Path

import jax
import numpy as np
import pytest
from run_cases import flow_of

import msf_jax
from msf_jax import Weights
from msf_jax.app.batch import BatchResult
from msf_jax.tuning.tuner import Tuned, TuningStep
from tests.benchmarks import ground_truth

LONGEST = 160


@pytest.fixture(scope="module")
def results():
    """Of one short run, each with what its line says."""
    shape = ground_truth.make("straight_coarse")
    flow = flow_of("straight_coarse")
    skeleton, nodes = flow.skeleton, f"{len(flow.skeleton.vertices)} nodes"
    track = msf_jax.track(skeleton, [shape.mesh.vertices])
    step = TuningStep(Weights(w_L=np.ones(5)), 0.2, 0.1, True, True)
    tuned = Tuned(step.weights, 0.1, (flow,), (step,), "no more")
    return [
        (skeleton, f"Skeleton({nodes}, "),
        (skeleton.report, "Report(converged, 0 cycles for genus 0, 100.00 % inside)"),
        (skeleton.branches[0], f"Branch({nodes} from "),
        (flow, f"Flow({len(flow.history)} iterations, Skeleton("),
        (flow.tape, "Tape("),
        (msf_jax.follow(skeleton, shape.mesh.vertices), f"Followed(nodes float64[{len(skeleton.vertices)}, 3], radii "),
        (track, "Track(1 frames, 0 of them need a fresh run, Skeleton("),
        (track.frames[0], "TrackedFrame(frame 0: 100.00 % inside)"),
        (tuned, "Tuned(0.1 at w_L 1 to 1, w_H 0.1, "),
        (shape, "KnownShape('straight_coarse', "),
        (BatchResult(({"error": "x"},), Path("m.csv"), 1), "BatchResult(1 meshes, 1 failed, 'm.csv')"),
    ]


def test_a_result_is_one_line(results):
    for result, start in results:
        assert repr(result).startswith(start)
        assert "\n" not in repr(result) and len(repr(result)) <= LONGEST


def test_what_is_traced_has_a_line_too(results):
    """Shapes are known then, values are not."""
    seen = []
    skeleton = results[0][0]
    vertices = np.zeros((len(skeleton.mesh_map), 3))
    jax.eval_shape(lambda moved: seen.append(repr(msf_jax.follow(skeleton, moved))), vertices)
    assert seen[0].startswith("Followed(nodes float64[")


def test_a_run_that_failed_says_so(results):
    report = results[1][0]
    values = report.to_dict() | {"converged": False, "reason": "stalled", "cycles": 2}
    assert repr(msf_jax.Report.from_dict(values)) == (
        "Report(NOT converged, stalled, 2 cycles, EXPECTED 0 for genus 0, around ONLY 0 handles, 100.00 % inside)"
    )


def test_a_report_comes_back_from_plain_values(results):
    report = results[1][0]
    assert msf_jax.Report.from_dict(report.to_dict()) == report
