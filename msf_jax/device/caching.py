"""JAX's persistent cache of compiled programs, in the user's cache folder."""

import os
from pathlib import Path

import jax
import platformdirs
from jax.experimental.compilation_cache import compilation_cache

from msf_jax.base.errors import ConfigError

WORTH_KEEPING = 0.2  # seconds: programs that compile faster are not stored


def cache_compilations(folder: str | os.PathLike[str] | None = None) -> Path | None:
    """Store compiled programs in ``folder``, so that only the first run on a machine compiles. Call it once, early.

    For every stored program that it loads, JAX 0.10 prints two long lines on standard error, about features that are
    "not supported on the host machine". It is a false alarm (jax issue 38445), which JAX 0.12 does not print. Set
    ``TF_CPP_MIN_LOG_LEVEL=3`` in the environment before JAX is imported to suppress it, as the command line does.

    Args:
        folder: created if missing. The default is the folder that JAX is configured to use, by
            ``JAX_COMPILATION_CACHE_DIR`` or its configuration; else the user's cache folder, such as
            ``~/.cache/msf_jax``. Nobody else should be able to write to it, because the programs in it are executed.

    Returns:
        The folder; None if none was given and the user's cache folder cannot be written to.

    Raises:
        ConfigError: ``folder`` cannot be created or written to.
    """
    configured = getattr(jax.config, "jax_compilation_cache_dir", None)
    if folder is None and configured is not None:
        return Path(configured)
    path = Path(folder) if folder is not None else platformdirs.user_cache_path("msf_jax", appauthor=False)
    try:
        path.mkdir(parents=True, exist_ok=True)
        is_writable = os.access(path, os.W_OK)
    except OSError:
        is_writable = False
    if not is_writable:
        if folder is None:
            return None
        raise ConfigError(f"cannot write to {str(path)!r}: expected a folder for compiled programs")
    if configured != str(path):
        jax.config.update("jax_compilation_cache_dir", str(path))
        compilation_cache.reset_cache()  # otherwise JAX keeps using its first folder
    jax.config.update("jax_persistent_cache_min_compile_time_secs", WORTH_KEEPING)
    return path
