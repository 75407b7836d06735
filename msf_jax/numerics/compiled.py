"""Compiled loops, for short walks over neighbours, loops and trees, which would need many masks in NumPy.

A kernel is a Python function over arrays that its caller has allocated. It allocates nothing, and of NumPy it uses only
indexing. Numba translates all kernels to LLVM's intermediate representation, `kernels.ll` (`python -m
tests.translate`), which LLVM compiles in a tenth of a second when the first kernel is called. Sums are not reordered:
the same source gives the same bits in every process.
"""

import ctypes
import struct
import sys
import threading
from collections.abc import Callable
from functools import cache, cached_property, partial
from pathlib import Path
from typing import Annotated, Any, get_type_hints

import numpy as np

_REAL, _INT, _FLAG = np.dtype(np.float64), np.dtype(np.int64), np.dtype(bool)
Reals = Annotated[np.ndarray, _REAL, 1]  # an array's type, and its number of axes
Points = Annotated[np.ndarray, _REAL, 2]
Triangles = Annotated[np.ndarray, _REAL, 3]
Ints = Annotated[np.ndarray, _INT, 1]
Rows = Annotated[np.ndarray, _INT, 2]
Flags = Annotated[np.ndarray, _FLAG, 1]

TEXT = Path(__file__).with_name("kernels.ll")
# C's functions that the text needs, or that some LLVM makes of its loops: another release, or for another processor.
SYMBOLS = ("atan2", "memset")


class Kernel:
    """``function``, compiled on its first call; ``is_part`` if only kernels call it. Arrays that are C-contiguous,
    writeable and of the annotated type, as those for results must be, are passed without a copy."""

    def __init__(self, function: Callable, is_part: bool):
        self.function = function
        self.__name__, self.__doc__, self.__module__ = function.__name__, function.__doc__, function.__module__
        self.is_part = is_part
        self.entry = f"{function.__module__}.{function.__name__}"  # the name of the compiled code

    def __call__(self, *arguments: Any) -> int:
        row: list[int] = []
        alive = [_words(kind, value, row) for kind, value in zip(self._kinds, arguments, strict=True)]
        found = self._entry((ctypes.c_int64 * len(row))(*row))
        del alive  # the copies had to exist until now
        return found

    @cached_property
    def _kinds(self) -> list[Any]:
        return _hints(self.function)[:-1]

    @cached_property
    def _entry(self) -> Callable[[Any], int]:
        address = load().get_function_address(self.entry)
        if not address:
            raise RuntimeError(f"{TEXT.name} has no {self.entry}: it was made before this kernel")
        return ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_void_p)(address)  # releases Python's lock


@cache
def _hints(of: Any) -> list[Any]:
    """The annotations of a function's arguments, or of a named tuple's fields."""
    return list(get_type_hints(of, include_extras=True).values())


def _words(kind: Any, value: Any, row: list[int]) -> Any:
    """Append ``value`` of the annotated ``kind`` to ``row``, in 8-byte words; for an array, its address and lengths.

    Returns the objects that must exist until the call has ended.
    """
    if hasattr(kind, "__metadata__"):
        dtype = kind.__metadata__[0]
        if value.dtype != dtype or not value.flags.carray:
            value = np.array(value, dtype=dtype, order="C")
        # The address comes by the buffer protocol: NumPy's own attributes take 20 times as long.
        row += (ctypes.addressof(ctypes.c_char.from_buffer(value)) if value.size else 0, *value.shape)
        return value
    if hasattr(kind, "_fields"):
        return [_words(each, field, row) for each, field in zip(_hints(kind), value, strict=True)]
    row.append(struct.unpack("q", struct.pack("d", value))[0] if kind is float else int(value))
    return None


# Decorators of functions over arrays, numbers and named tuples of arrays as annotated, which return a number or None.
kernel = partial(Kernel, is_part=False)
part: Any = partial(Kernel, is_part=True)  # of kernels, which only kernels call

_LOADING = threading.Lock()


def load() -> Any:
    """The engine with the compiled code; made once."""
    with _LOADING:
        return _engine()


@cache
def _engine() -> Any:
    from llvmlite import binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    machine = llvm.Target.from_default_triple().create_target_machine(opt=2, jit=True)
    module = llvm.parse_assembly(TEXT.read_text())
    module.triple, module.data_layout = machine.triple, str(machine.target_data)
    library = ctypes.cdll.msvcrt if sys.platform == "win32" else ctypes.CDLL(None)
    for name in SYMBOLS:  # not every process has them where LLVM looks: those of Windows do not
        llvm.add_symbol(name, ctypes.cast(library[name], ctypes.c_void_p).value)
    engine = llvm.create_mcjit_compiler(module, machine)
    engine.finalize_object()
    return engine
