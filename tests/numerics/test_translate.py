"""The text of the kernels: as the translator writes it, and as LLVM compiles it for other platforms than this one."""

import platform
import re
import struct
import subprocess
import sys
from pathlib import Path

import pytest
from llvmlite import binding as llvm

from msf_jax.numerics import compiled

ROOT = Path(__file__).parents[2]
PLATFORMS = {
    "Linux": "x86_64-unknown-linux-gnu",
    "Linux on Arm": "aarch64-unknown-linux-gnu",
    "macOS on Arm": "arm64-apple-darwin",
    "Windows": "x86_64-pc-windows-msvc",
}
FUSED = re.compile(r"\bfn?m(?:add|sub|la|ls)\b")  # a product and a sum with one rounding


@pytest.mark.system
@pytest.mark.skipif(platform.machine() != "x86_64" or sys.platform != "linux", reason="the text is written on Linux")
def test_the_text_is_what_the_translator_writes():
    """To the byte: a kernel that was changed, or a text that was edited by hand, is seen."""
    pytest.importorskip("numba")  # the lowest versions are tested without: Numba pins its own llvmlite
    from tests import translate

    if sys.version_info[:2] != translate.PYTHON:
        pytest.skip("Numba reads the byte code, and that of another Python differs")
    # In a process of its own: what else is loaded here changes how far LLVM unrolls loops.
    command = [
        sys.executable,
        "-c",
        "import sys; from tests import translate; sys.stdout.write(translate.translated())",
    ]
    written = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    assert written == compiled.TEXT.read_text(), "kernels.ll is of other kernels: run `python -m tests.translate`"


def test_every_kernel_is_in_the_text():
    pytest.importorskip("numba")
    from tests import translate

    names = [each.entry for each in translate.all_kernels()]
    assert len(names) > 10 and all(compiled._engine().get_function_address(name) for name in names)


def made_for(name: str) -> tuple[llvm.TargetMachine, llvm.ModuleRef]:
    """The text for a platform, and what compiles it as `compiled` does."""
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    machine = llvm.Target.from_triple(PLATFORMS[name]).create_target_machine(opt=2, jit=True)
    module = llvm.parse_assembly(compiled.TEXT.read_text())
    module.triple, module.data_layout = machine.triple, str(machine.target_data)
    return machine, module


def undefined(code: bytes) -> set[str]:
    """The names that an object file expects from elsewhere, by its table of symbols: ELF's, Mach-O's or COFF's."""

    def text(at: int) -> str:
        return code[at : code.index(0, at)].decode()

    if code[:4] == b"\x7fELF":
        sections, count = struct.unpack_from("<Q", code, 40)[0], struct.unpack_from("<H", code, 60)[0]
        rows = [struct.unpack_from("<IIQQQQII", code, sections + 64 * k) for k in range(count)]
        _, _, _, _, start, size, link, _ = next(row for row in rows if row[1] == 2)  # SHT_SYMTAB
        symbols = [struct.unpack_from("<IBBH", code, at) for at in range(start, start + size, 24)]
        return {text(rows[link][4] + name) for name, _, _, section in symbols if name and section == 0}
    if code[:4] == b"\xcf\xfa\xed\xfe":
        at = 32
        while (command := struct.unpack_from("<IIIIII", code, at))[0] != 2:  # LC_SYMTAB
            at += command[1]
        _, _, start, count, strings, _ = command
        symbols = [struct.unpack_from("<IB", code, start + 16 * k) for k in range(count)]
        return {text(strings + name).removeprefix("_") for name, kind in symbols if kind & 0x0E == 0}  # N_UNDF
    start, count = struct.unpack_from("<II", code, 8)
    found, k = set(), 0
    while k < count:
        at = start + 18 * k
        zeros, name, _, section, _, kind, more = struct.unpack_from("<IIIhHBB", code, at)
        if section == 0 and kind == 2:  # IMAGE_SYM_CLASS_EXTERNAL
            found.add(code[at : at + 8].rstrip(b"\0").decode() if zeros else text(start + 18 * count + name))
        k += 1 + more
    return found - {"_fltused"}  # a mark for linkers: no code refers to it


@pytest.mark.parametrize(
    "name", [name if name == "Linux" else pytest.param(name, marks=pytest.mark.slow) for name in PLATFORMS]
)
def test_all_that_the_code_calls_is_registered(name):
    machine, module = made_for(name)
    code = machine.emit_object(module)
    assert undefined(code) <= set(compiled.SYMBOLS)
    assert "atan2" in undefined(code)  # and the table was read


@pytest.mark.parametrize(
    "name", ["Linux on Arm", pytest.param("macOS on Arm", marks=pytest.mark.slow)]
)  # a plain x86-64 has no such instructions
def test_products_and_sums_are_rounded_one_by_one(name):
    """Else a kernel gives other bits on Arm than elsewhere."""
    machine, module = made_for(name)
    assembly = machine.emit_assembly(module)
    assert re.search(r"\bfmul\b", assembly) and not FUSED.search(assembly)
