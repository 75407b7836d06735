"""Mutated mesh files at validation: each is a mesh or a `MeshError`, in little time and memory, and nothing else.

    python -m tests.benchmarks.fuzz [--files N] [--seed N] [--seconds S] [--memory GB]

Prints, for each format, how many files were tried, read, refused, and the longest time that one took.
"""

import argparse
import io
import resource
import signal
import sys
import tempfile
import time
import traceback
from collections import Counter
from pathlib import Path

import numpy as np
import trimesh

from msf_jax import MeshError
from msf_jax.host.mesh import checking

HOSTILE = [
    *("nan", "inf", "-inf", "1e999", "-1", "0", "", "1000000000", "99999999999999999999", "0x10", "1/2/3", "é"),
    *("2147483647", "4294967296", "-9223372036854775808", "\x00", "#", "1e-320", "3 0 1 2", "OFF", "end_header"),
]


def originals() -> dict[str, bytes]:
    """One sound mesh in every format, by the format's name."""
    mesh = trimesh.creation.icosphere(1)
    mesh.apply_scale([1.0, 0.8, 0.7])

    def exported(kind: str, **options: object) -> bytes:
        content = mesh.export(file_type=kind, **options)
        return content if isinstance(content, bytes) else content.encode()

    return {
        "off": exported("off"),
        "obj": exported("obj"),
        "ply": exported("ply"),
        "ascii ply": exported("ply", encoding="ascii"),
        "stl": exported("stl"),
        "ascii stl": exported("stl_ascii"),
    }


def mutated(content: bytes, others: list[bytes], random: np.random.Generator) -> bytes:
    """``content`` with one to three things wrong."""
    for _ in range(random.integers(1, 4)):
        num = max(len(content), 1)
        start = int(random.integers(num))
        end = min(num, start + int(random.choice([1, 4, 30, 300])))
        match random.integers(8):
            case 0:
                content = content[:start]
            case 1:
                content = content[:start] + content[end:]
            case 2:
                content = content[:end] + content[start:]
            case 3:
                content = content[:start] + random.bytes(end - start) + content[end:]
            case 4:
                content = content[:start] + random.bytes(end - start) + content[start:]
            case 5 | 6:
                words = content.split(b" ")
                words[int(random.integers(len(words)))] = str(random.choice(HOSTILE)).encode()
                content = b" ".join(words)
            case _:
                other = others[int(random.integers(len(others)))]
                content = content[:start] + other[int(random.integers(len(other))) :]
    return content


class TooSlow(BaseException):
    """A file took longer than it may."""


def fuzz(num: int, seed: int, seconds: int, *, show: bool = False) -> tuple[list[str], list[str]]:
    """Try ``num`` files; returns lines of a table, and what went wrong, one text each."""
    random, files = np.random.default_rng(seed), originals()
    outcomes: Counter[tuple[str, str]] = Counter()
    longest, wrong = dict.fromkeys(files, 0.0), []

    def stop(*_: object) -> None:
        raise TooSlow

    previous = signal.signal(signal.SIGALRM, stop)
    stdout = sys.stdout
    try:
        with tempfile.TemporaryDirectory() as folder:
            for number in range(num):
                name = list(files)[number % len(files)]
                content = mutated(files[name], list(files.values()), random)
                path = Path(folder) / f"mesh.{name.split()[-1]}"
                path.write_bytes(content)
                start = time.perf_counter()
                signal.alarm(seconds)
                sys.stdout = io.StringIO()
                try:
                    checking.prepare(path, repair=number % 3 == 0)
                    outcome = "read"
                except MeshError:
                    outcome = "refused"
                except BaseException as error:
                    outcome = "FAILED"
                    wrong.append(f"file {number}, {name}, {content[:300]!r}\n{traceback.format_exc()}")
                    if isinstance(error, KeyboardInterrupt):
                        raise
                finally:
                    signal.alarm(0)
                    sys.stdout = stdout
                longest[name] = max(longest[name], time.perf_counter() - start)
                outcomes[name, outcome] += 1
                if show and number % 1000 == 0:
                    print(f"{number} of {num}, {len(wrong)} failed", file=sys.stderr)
    finally:
        signal.signal(signal.SIGALRM, previous)
    lines = ["| format | files | read | refused | failed | longest, s |", "| --- | --- | --- | --- | --- | --- |"]
    for name in files:
        counts = [outcomes[name, outcome] for outcome in ("read", "refused", "FAILED")]
        lines.append(f"| {name} | {sum(counts)} | {' | '.join(map(str, counts))} | {longest[name]:.2f} |")
    return lines, wrong


def main() -> int:
    """Print the table, and every failure."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--files", type=int, default=20_000, help="to try")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--seconds", type=int, default=20, help="that one file may take")
    parser.add_argument("--memory", type=float, default=4.0, help="address space in GB that all of it may take")
    arguments = parser.parse_args()
    limit = int(arguments.memory * 1e9)
    resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    lines, wrong = fuzz(arguments.files, arguments.seed, arguments.seconds, show=True)
    print("\n".join(lines))
    print(f"peak memory {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6:.2f} GB, {len(wrong)} failures")
    print("\n\n".join(wrong[:10]))
    return min(len(wrong), 1)


if __name__ == "__main__":
    sys.exit(main())
