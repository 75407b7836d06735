"""A process that was forked after a run: it has no threads of JAX, and what waits for them never ends.

So it is refused. On Linux, `multiprocessing` and `concurrent.futures` fork before Python 3.14, unless told otherwise.
"""

import os

from msf_jax.base.errors import FlowError

_user: int | None = None  # the process that runs are made in


def check() -> None:
    """Note that runs are made in this process.

    Raises:
        FlowError: they were made in the one that this was forked from.
    """
    global _user
    if _user not in (None, os.getpid()):
        raise FlowError(
            "this process was forked from one in which msf_jax had run, where JAX would wait for ever: start processes "
            'by multiprocessing.get_context("spawn"), or take msf_jax.batch'
        )
    _user = os.getpid()
