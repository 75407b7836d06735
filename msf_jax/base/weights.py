"""Weights in a JSON file, to use tuned weights on the command line and in other programs."""

import json
import os
from pathlib import Path

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.base.options import Weights
from msf_jax.base.writing import write_whole

FORMAT = "msf_jax weights"  # marks the file's format


def save_weights(weights: Weights, path: str | os.PathLike[str]) -> None:
    """Write ``weights`` to a JSON file: numbers, or lists with one for each vertex of the mesh.

    Raises:
        ConfigError: a weight is not finite.
        OSError: the file cannot be written; what was there before is untouched.
    """
    values = {name: np.asarray(value, dtype=np.float64) for name, value in vars(weights).items()}
    for name, value in values.items():
        if not np.isfinite(value).all():
            raise ConfigError(f"Weights.{name} is not finite: expected numbers")
    content = {"format": FORMAT, "version": 1, "weights": {name: value.tolist() for name, value in values.items()}}
    write_whole(path, json.dumps(content, indent=1) + "\n")


def read_weights(path: str | os.PathLike[str]) -> Weights:
    """The weights in a file that `save_weights` or `Tuned.save` wrote.

    Raises:
        ConfigError: the file is of another kind; the message says what was found.
        OSError: the file cannot be read.
    """
    name = Path(path).name
    if Path(path).exists() and not Path(path).is_file():  # reading a pipe would wait
        raise ConfigError(f"{name!r} is not a regular file: expected a file that save_weights wrote")
    try:
        content = json.loads(Path(path).read_text("utf-8"))
        if content["format"] != FORMAT or content["version"] != 1:
            raise ValueError(f"it is a {content['format']!r} of version {content['version']!r}")
        held = {key: np.array(value, dtype=np.float64) for key, value in content["weights"].items()}
        if set(held) - set(vars(Weights())):
            raise ValueError(f"there is no weight {min(set(held) - set(vars(Weights())))!r}")
        if not all(value.ndim <= 1 and np.isfinite(value).all() for value in held.values()):
            raise ValueError("a weight is neither a number nor a list of numbers")
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise ConfigError(f"{name!r} has no weights ({error}): expected a file that save_weights wrote") from error
    return Weights(**{key: float(value) if value.ndim == 0 else value for key, value in held.items()})
