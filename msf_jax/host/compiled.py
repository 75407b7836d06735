"""Loops that are compiled, by Numba: short walks over neighbours, loops and trees, of which NumPy makes pages of masks.

A kernel is a Python function over arrays that the caller has made. It allocates nothing, knows nothing of NumPy but how
to index, and is compiled for the one signature that its annotations give, when it is first called; `announce` has that
done beforehand, on another thread. What is compiled is kept beside the module or, where that is read-only, in Numba's
folder in the user's cache, for all processes. Numba is not imported before.

The optimiser may not reorder sums, so that the same source gives the same bits everywhere. An edited module is compiled
anew; as only its own text is looked at, a kernel calls no others than those of its module.
"""

import threading
from collections.abc import Callable
from typing import Annotated, Any

import numpy as np

Reals = Annotated[np.ndarray, "float64", 1]  # an array of so many axes, C-contiguous
Points = Annotated[np.ndarray, "float64", 2]
Triangles = Annotated[np.ndarray, "float64", 3]
Ints = Annotated[np.ndarray, "int64", 1]
Rows = Annotated[np.ndarray, "int64", 2]
Flags = Annotated[np.ndarray, "bool", 1]

_SCALARS = {float: "float64", int: "int64", bool: "boolean", None: "void"}


class Kernel:
    """``function``, compiled when it is first called. One whose arguments are scalars is a part of others: see `part`.

    Arrays are taken as they are where they are of the annotated type and to be written to, else as a copy: results must
    be.
    """

    def __init__(self, function: Callable, is_part: bool):
        self.function = function
        self.__name__, self.__doc__, self.__module__ = function.__name__, function.__doc__, function.__module__
        self._is_part = is_part
        self._lock = threading.Lock()
        self._compiled: Callable | None = None
        kinds = [getattr(kind, "__metadata__", None) for kind in function.__annotations__.values()]
        self._arrays = [(place, np.dtype(kind[0])) for place, kind in enumerate(kinds) if kind is not None]

    def __call__(self, *arguments: Any) -> Any:
        given = list(arguments)
        for place, dtype in self._arrays:
            array = given[place]
            if array.dtype != dtype or not array.flags.carray:
                given[place] = np.array(array, dtype=dtype, order="C")
        return self.compiled()(*given)

    def compiled(self) -> Callable:
        """What Numba makes of it, at once or as soon as another thread has."""
        if self._compiled is None:
            with self._lock:
                if self._compiled is None:
                    self._compiled = self._compile()
        return self._compiled

    def _compile(self) -> Callable:
        import numba

        options: dict[str, Any] = {"nogil": True, "error_model": "numpy", "_nrt": False, "no_cfunc_wrapper": True}
        function, globals_ = self.function, self.function.__globals__
        parts = {name: globals_.get(name) for name in function.__code__.co_names}
        parts = {name: part.compiled() for name, part in parts.items() if isinstance(part, Kernel)}
        bound = type(function)(function.__code__, {**globals_, **parts}, function.__name__)
        bound.__module__ = function.__module__
        if self._is_part:
            return numba.njit(bound, no_cpython_wrapper=True, **options)
        try:
            compiled = numba.njit(bound, cache=True, **options)
        except RuntimeError:  # there is no folder to be written to: it is compiled in every process
            compiled = numba.njit(bound, **options)
        compiled.compile(self._signature(numba))
        return compiled

    def _signature(self, numba: Any) -> Any:
        types = {name: self._type(numba, kind) for name, kind in self.function.__annotations__.items()}
        return types.pop("return")(*types.values())

    @staticmethod
    def _type(numba: Any, kind: Any) -> Any:
        if kind in _SCALARS:
            return getattr(numba.types, _SCALARS[kind])
        dtype, axes = kind.__metadata__
        return numba.types.Array(numba.from_dtype(np.dtype(dtype)), axes, "C")


def kernel(function: Callable) -> Kernel:
    """``function`` over arrays, as annotated, compiled."""
    return Kernel(function, is_part=False)


def part(function: Callable) -> Any:
    """``function`` for kernels to call."""
    return Kernel(function, is_part=True)


def announce(kernels: list[Kernel]) -> threading.Thread:
    """Compile ``kernels``, or load them, on another thread, and do not wait; it ends early where the process does."""

    def work() -> None:
        for each in kernels:
            if not threading.main_thread().is_alive():
                return
            each.compiled()

    thread = threading.Thread(target=work, name="msf_jax-kernels")
    thread.start()
    return thread
