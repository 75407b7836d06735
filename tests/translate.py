"""Write `msf_jax/numerics/kernels.ll`, the kernels of the package in LLVM's intermediate representation.

    python -m tests.translate

Run from the project's root after a kernel, or a number that it names, has changed. Numba translates each kernel for the
types that its annotations give. Each gets an entry that takes its arguments as one row of 8-byte words, in the order of
`msf_jax.numerics.compiled._words`. The text is for no processor in particular: no vectors, no sum in another order. It
depends on the versions of Numba, which `pyproject.toml` pins, and of Python, whose byte code Numba reads.
"""

import importlib
import os
import re
import sys
import types
from typing import Any, get_type_hints

# For any processor: settings that Numba reads when it is imported, and again below.
os.environ |= {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": "", "NUMBA_LOOP_VECTORIZE": "0"}
os.environ |= {"NUMBA_SLP_VECTORIZE": "0"}

from llvmlite import binding as llvm
from numba import config, njit
from numba import types as numba_types

from msf_jax.numerics import compiled
from msf_jax.numerics.compiled import Kernel

config.reload_config()
# Division by zero is no exception, and nothing is allocated: a kernel then needs nothing of Numba when it runs.
OPTIONS: dict[str, Any] = {
    "error_model": "numpy",
    "_nrt": False,
    "no_cfunc_wrapper": True,
    "no_cpython_wrapper": True,
}
MODULES = (
    "msf_jax.curve.branches",
    "msf_jax.inside.balls",
    "msf_jax.solid.handles",
    "msf_jax.solid.kernels",
    "msf_jax.solid.sections",
    "msf_jax.limbs.levels",
    "msf_jax.limbs.tree",
    "msf_jax.meso.kernels",
)  # that have kernels
PYTHON = (3, 11)  # whose byte code is read
HEAD = "; Made of the kernels by `python -m tests.translate`: edit those.\n"
# Hints that only help passes, which have been run, and that older LLVMs lack; and comments.
HINTS = re.compile(r" (captures\(none\)|range\([^)]*\)|initializes\(\(.*?\)\)|#\d+)|, ![a-z.]+ !\d+| *;.*")
# LLVM 20 aborts the process on the `lifetime` of LLVM 22, and adds declarations of its own functions itself.
LEFT_OUT = re.compile(r"target |source_|attributes|!|$|.*@llvm\.lifetime\.|declare double @llvm\.sqrt\.")
SCALARS = {float: "float64", int: "int64", bool: "boolean", type(None): "void"}


def numba_type(kind: Any) -> Any:
    """What Numba calls the type that ``kind`` annotates."""
    if kind in SCALARS:
        return getattr(numba_types, SCALARS[kind])
    if hasattr(kind, "_fields"):
        fields = get_type_hints(kind, include_extras=True).values()
        return numba_types.NamedTuple(list(map(numba_type, fields)), kind)
    dtype, axes = kind.__metadata__
    return numba_types.Array(getattr(numba_types, dtype.name), axes, "C")


def function_of(kernel: Kernel, parts: dict[Kernel, Any]) -> types.FunctionType:
    """The kernel's function, with the parts that it names translated."""
    names = {name: kernel.function.__globals__.get(name) for name in kernel.function.__code__.co_names}
    for each in (value for value in names.values() if isinstance(value, Kernel)):
        if each not in parts:
            parts[each] = njit(**OPTIONS)(function_of(each, parts))
    known = {name: parts[value] for name, value in names.items() if isinstance(value, Kernel)}
    return types.FunctionType(kernel.function.__code__, {**kernel.function.__globals__, **known})


def entry(kernel: Kernel, text: str) -> str:
    """The function of one argument, a row of words, that calls the kernel whose module is ``text``."""
    found = next(line for line in text.splitlines() if line.startswith("define") and "linkonce" not in line)
    name, given = re.findall(r"define [^@]*(@[^(]+)\((.*)\)", found)[0]
    kinds = [each.split()[0] for each in re.split(r", (?=(?:ptr|i64|i8|i1|double)\b)", given)][2:]
    lines, values, word = [], [], 0

    def load(kind: str) -> str:
        nonlocal word
        lines.append(f"%p{word} = getelementptr i64, ptr %words, i64 {word}\n%w{word} = load {kind}, ptr %p{word}")
        word += 1
        return f"%w{word - 1}"

    def flatten(kind: Any) -> None:
        if hasattr(kind, "_fields"):
            for each in get_type_hints(kind, include_extras=True).values():
                flatten(each)
        elif hasattr(kind, "__metadata__"):
            dtype, axes = kind.__metadata__
            size = dtype.itemsize
            data, shape = load("ptr"), [load("i64") for _ in range(axes)]
            strides = [str(size)]
            for length in shape[:0:-1]:
                strides.append(f"%s{len(lines)}")
                lines.append(f"{strides[-1]} = mul i64 {strides[-2]}, {length}")
            count = f"%s{len(lines)}"
            lines.append(f"{count} = mul i64 {strides[-1]}, {shape[0]}")
            values.extend(["null", "null", count, str(size), data, *shape, *strides[::-1]])
        else:
            values.append(load(kinds[len(values)]))

    hints = list(get_type_hints(kernel.function, include_extras=True).values())
    for kind in hints[:-1]:
        flatten(kind)
    assert len(values) == len(kinds), (kernel.__name__, values, kinds)
    called = ", ".join(f"{kind} {value}" for kind, value in zip(kinds, values, strict=True))
    body = "\n".join(lines)
    return f"""
define i64 @{kernel.entry}(ptr %words) {{
%found = alloca i64
%error = alloca ptr
store i64 0, ptr %found
{body}
%status = call i32 {name}(ptr %found, ptr %error, {called})
%result = load i64, ptr %found
ret i64 %result
}}
"""


def all_kernels() -> list[Kernel]:
    """The kernels of all modules."""
    found = [(name, each) for name in MODULES for each in vars(importlib.import_module(name)).values()]
    return [each for name, each in found if isinstance(each, Kernel) and not each.is_part and each.__module__ == name]


def translated() -> str:
    """The module of all kernels, as text."""
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    machine = llvm.Target.from_default_triple().create_target_machine(cpu="generic", features="", opt=2)
    parts: dict[Kernel, Any] = {}
    whole = llvm.parse_assembly("")
    kernels = all_kernels()
    for kernel in kernels:
        kinds = [numba_type(kind) for kind in get_type_hints(kernel.function, include_extras=True).values()]
        made = njit(kinds[-1](*kinds[:-1]), **OPTIONS)(function_of(kernel, parts))
        text = next(iter(made.inspect_llvm().values()))
        whole.link_in(llvm.parse_assembly(text + entry(kernel, text)))
    entries = {kernel.entry for kernel in kernels}
    for function in whole.functions:
        if not function.is_declaration and function.name not in entries:
            function.linkage = "internal"
    for name in whole.global_variables:
        name.linkage = "internal"
    options = llvm.create_pipeline_tuning_options(speed_level=2)
    options.loop_vectorization = options.slp_vectorization = options.loop_unrolling = False
    builder = llvm.create_pass_builder(machine, options)
    passes = builder.getModulePassManager()
    passes.add_strip_symbols_pass()  # names hold a count of what Numba has translated before in this process
    passes.run(whole, builder)
    return HEAD + portable(str(whole))


def portable(text: str) -> str:
    """``text`` for every LLVM since 20, and with square roots as instructions instead of calls of C's function."""
    lines = HINTS.sub("", text).replace("@sqrt(", "@llvm.sqrt.f64(").splitlines()
    return "".join(f"{line}\n" for line in lines if not LEFT_OUT.match(line))


if __name__ == "__main__":
    if sys.version_info[:2] != PYTHON:
        raise SystemExit(f"The text of Python {sys.version} would differ: run this with {'.'.join(map(str, PYTHON))}.")
    compiled.TEXT.write_text(translated(), newline="\n")
    print(f"{compiled.TEXT}: {compiled.TEXT.stat().st_size / 1000:.0f} kB")
