"""The state of a run in a file. A run that was killed continues from it, with the same result to the last bit.

The file holds what iterations change: each component's surface, history and recorded steps. The preparation before the
iterations is computed again, with the same result. Hashes of the mesh and of every setting identify the run.
"""

import hashlib
import os
from pathlib import Path
from typing import Any

import jax
import numpy as np

from msf_jax.base import archive, version
from msf_jax.base.errors import ConfigError
from msf_jax.base.options import Config, Weights
from msf_jax.device.buffers import real_dtype
from msf_jax.flow import resuming
from msf_jax.flow.state import Iteration, State
from msf_jax.meso.collapse import CollapseRound
from msf_jax.meso.meso import Compaction, Fixing, Meso
from msf_jax.meso.split import SplitRound
from msf_jax.recording.records import Step

KIND = "checkpoint"  # of the file, see `archive`
FORMAT_VERSION = 3  # of the format: files of other versions are refused
RECORDS = {kind.__name__: kind for kind in (Meso, Step, Iteration, CollapseRound, SplitRound, Fixing, Compaction)}
CHANGING = ("meso", "t_c", "w_L_factor", "capacity", "history", "steps", "failure")  # attributes of a `State`
ADVICE = "choose another path"


class Checkpoint:
    """The checkpoint of the run that ``run`` identifies, in the file ``path``. Without a path nothing is saved.

    Attributes:
        saved: for each component that was begun, the attributes that its iterations have changed.
        failure: why the last write failed; empty if it did not.

    Raises:
        ConfigError: the path cannot be written to, or the file there is of another run, or no checkpoint.
    """

    def __init__(self, path: str | os.PathLike[str] | None, run: dict[str, str]) -> None:
        self.path, self.run, self.failure = None if path is None else Path(path), run, ""
        self.saved: list[dict[str, Any]] = []
        if self.path is None:
            return
        folder = self.path.absolute().parent
        if self.path.is_dir() or not folder.is_dir() or not os.access(folder, os.W_OK):
            raise ConfigError(
                f"cannot write a checkpoint to {str(path)!r}: expected a file name in a folder that can be written to"
            )
        if self.path.exists():
            with archive.reading(self.path, KIND, FORMAT_VERSION, ADVICE) as (header, arrays):
                of = dict(header["run"])
                if other := [what for what in {**of, **run} if of.get(what) != run.get(what)]:
                    raise ConfigError(
                        f"the checkpoint {str(path)!r} is of another run, with another {', another '.join(other)}: "
                        "choose another path, or delete it"
                    )
                self.saved = archive.decoded(header["states"], arrays, RECORDS)
                resuming.check_states(self.saved, CHANGING)

    def restore(self, state: State, config: Config) -> None:
        """Replace ``state``, the first state of a component, by the saved state of that component, if there is one.

        Raises:
            ConfigError: the saved state cannot follow from ``state``.
        """
        if state.number < len(self.saved):
            saved = self.saved[state.number]
            try:
                resuming.check_goes_on(state, saved, config)
            except ValueError as error:
                raise ConfigError(f"the checkpoint {str(self.path)!r} is damaged, {error}: {ADVICE}") from error
            for name, value in saved.items():
                setattr(state, name, value)

    def save(self, states: list[State]) -> None:
        """Write the states of the components so far. A failed write sets ``failure``, and the run continues."""
        if self.path is None:
            return
        arrays: dict[str, np.ndarray] = {}
        changing = [{name: getattr(state, name) for name in CHANGING} for state in states]
        changing += self.saved[len(states) :]
        header = {"run": self.run, "states": archive.encoded(changing, arrays, RECORDS)}
        try:
            archive.write(self.path, KIND, FORMAT_VERSION, header, arrays, compress=False)
            self.failure = ""
        except OSError as error:
            self.failure = f"the checkpoint {str(self.path)!r} could not be written: {error.strerror or error}"


def run_of(
    given: tuple[np.ndarray, np.ndarray], weights: Weights, config: Config, pins: np.ndarray, repair: Any
) -> dict[str, str]:
    """What identifies a run: the hash or text of each input, by name."""
    device = jax.devices()[0]
    return {
        "mesh": _hash(*given),
        "weights": _hash(*(np.asarray(weight, dtype=np.float64) for weight in vars(weights).values())),
        "config": repr(config.replace(max_seconds=None)),  # the same run, if it has more time
        "pins": _hash(pins),
        "repair": repr(repair),
        "precision": str(np.dtype(real_dtype())),
        "version of msf_jax": version.VERSION,
        "version of jax": jax.__version__,
        "device": f"{device.platform} {device.device_kind}",
    }


def _hash(*arrays: np.ndarray) -> str:
    digest = hashlib.sha256()
    for array in arrays:
        digest.update(f"{array.dtype.str}{array.shape}".encode())
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()
