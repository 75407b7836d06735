"""Refusal of processes that were forked after a run: they lack the threads of JAX, and would wait for them for ever.

On Linux before Python 3.14, `multiprocessing` and `concurrent.futures` fork by default.
"""

import os

from msf_jax.base.errors import FlowError

_user: int | None = None  # id of the process that has made a run


def check() -> None:
    """Record that this process makes a run.

    Raises:
        FlowError: this process was forked from one that had made a run.
    """
    global _user
    if _user not in (None, os.getpid()):
        raise FlowError(
            "this process was forked from one in which msf_jax had run, so JAX would wait for ever: start processes "
            'with multiprocessing.get_context("spawn"), or use msf_jax.batch'
        )
    _user = os.getpid()
