"""Loops that are compiled, by Numba: short walks over neighbours, loops and trees, of which NumPy makes pages of masks.

A kernel is a Python function over arrays that the caller has made. It allocates nothing, knows nothing of NumPy but how
to index, and is compiled for the one signature that its annotations give, when it is first called; `announce` has that
done beforehand, beside other work. What is compiled is kept beside the module or, where that is read-only, in Numba's
folder in the user's cache, for all processes, under a name that tells what it was made of. Numba is not imported
before.

The optimiser may not reorder sums: the same source gives the same bits in every process. What takes long to compile is
the text, about a millisecond for every operation in it, not what the processor makes of it: so kernels are few, and
have loops over axes and corners.
"""

import hashlib
import threading
import types
from collections.abc import Callable, Iterable
from functools import cached_property
from typing import Annotated, Any, get_type_hints

import numpy as np

Reals = Annotated[np.ndarray, "float64", 1]  # an array of so many axes
Points = Annotated[np.ndarray, "float64", 2]
Triangles = Annotated[np.ndarray, "float64", 3]
Ints = Annotated[np.ndarray, "int64", 1]
Rows = Annotated[np.ndarray, "int64", 2]
Flags = Annotated[np.ndarray, "bool", 1]

_SCALARS = {float: "float64", int: "int64", bool: "boolean", type(None): "void"}
# A division by zero is no exception, nothing is allocated, and nothing but Python calls: less to compile.
_OPTIONS: dict[str, Any] = {"nogil": True, "error_model": "numpy", "_nrt": False, "no_cfunc_wrapper": True}
_OF_PARTS: dict[str, Any] = {"no_cpython_wrapper": True}


class Kernel:
    """``function``, compiled when it is first called; ``is_part`` for one that only kernels call.

    Arrays are handed over as they are where they are C-contiguous, of the annotated type, and to be written to; else as
    a copy. So must be those that results are written to.
    """

    def __init__(self, function: Callable, is_part: bool):
        self.function = function
        self.__name__, self.__doc__, self.__module__ = function.__name__, function.__doc__, function.__module__
        self.is_part = is_part
        self._lock = threading.Lock()
        self.made: Callable | None = None

    def __call__(self, *arguments: Any) -> Any:
        given = list(arguments)
        for place, dtype in self._arrays:
            array = given[place]
            if array.dtype != dtype or not array.flags.carray:
                given[place] = np.array(array, dtype=dtype, order="C")
        return self.compiled()(*given)

    @cached_property
    def _hints(self) -> dict[str, Any]:
        return get_type_hints(self.function, include_extras=True)

    @cached_property
    def _arrays(self) -> list[tuple[int, np.dtype]]:
        """Which arguments are arrays, and of what."""
        kinds = [getattr(kind, "__metadata__", None) for kind in self._hints.values()]
        return [(place, np.dtype(kind[0])) for place, kind in enumerate(kinds) if kind is not None]

    @cached_property
    def _globals(self) -> dict[str, Any]:
        """The parts and constants that the function names."""
        names = {name: self.function.__globals__.get(name) for name in self.function.__code__.co_names}
        return {name: value for name, value in names.items() if isinstance(value, Kernel | float | int)}

    @cached_property
    def _text(self) -> str:
        """All that the compiled code is made of."""
        code = self.function.__code__
        used = [(name, value._text if isinstance(value, Kernel) else value) for name, value in self._globals.items()]
        return repr((code.co_code, code.co_consts, code.co_names, code.co_varnames, str(self._hints), used))

    def compiled(self) -> Callable:
        """What Numba makes of it; waits if another thread is at it."""
        with self._lock:
            if self.made is None:
                self.made = self._compiled()
            return self.made

    def _compiled(self) -> Callable:
        from numba import njit

        parts = {name: value.compiled() for name, value in self._globals.items() if isinstance(value, Kernel)}
        function = types.FunctionType(self.function.__code__, {**self.function.__globals__, **parts})
        function.__module__ = self.__module__
        if self.is_part:
            return njit(**_OPTIONS, **_OF_PARTS)(function)
        function.__qualname__ = f"{self.__name__}_{hashlib.sha256(self._text.encode()).hexdigest()[:16]}"
        kinds = [_type(kind) for kind in self._hints.values()]
        signature = kinds[-1](*kinds[:-1])
        try:
            return njit(signature, cache=True, **_OPTIONS)(function)
        except Exception:  # no folder can be written to, or what is there is damaged: every process compiles it
            return njit(signature, **_OPTIONS)(function)


def _type(kind: Any) -> Any:
    """What Numba calls the type that ``kind`` annotates."""
    from numba import types as numba_types

    if kind in _SCALARS:
        return getattr(numba_types, _SCALARS[kind])
    if hasattr(kind, "_fields"):
        fields = get_type_hints(kind, include_extras=True).values()
        return numba_types.NamedTuple(list(map(_type, fields)), kind)
    dtype, axes = kind.__metadata__
    return numba_types.Array(getattr(numba_types, dtype), axes, "C")


def kernel(function: Callable) -> Kernel:
    """``function`` over arrays, numbers and named tuples of arrays, as annotated, compiled."""
    return Kernel(function, is_part=False)


def part(function: Callable) -> Any:
    """``function`` for kernels to call."""
    return Kernel(function, is_part=True)


def announce(kernels: Iterable[Kernel]) -> None:
    """Compile ``kernels``, or load them, on another thread, and do not wait; it ends after one of them if the process
    does."""

    def work() -> None:
        for each in waiting:
            if threading.main_thread().is_alive():
                each.compiled()

    waiting = [each for each in kernels if each.made is None]
    if waiting:
        threading.Thread(target=work, name="msf_jax-kernels").start()
