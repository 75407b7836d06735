"""Curves as text with words that are others: for `tests/project/test_tampering.py`."""

import re
import tempfile
import traceback
from collections import Counter
from pathlib import Path

import numpy as np
import trimesh

import msf_jax
from msf_jax import ConfigError
from msf_jax.skeleton.formats import importing

WORDS = [
    "-5",
    "1e9",
    "1e308",
    "1e999",
    "NaN",
    "Infinity",
    "0.7",
    "true",
    "null",
    '"no"',
    "-1",
    str(2**70),
    "\x85",
    "[]",
    "",
]


def try_texts(seed: int, num: int) -> list[str]:
    """Curves as text with one word another: refused, or a curve in all its numbers. Prints a table; returns faults."""
    random, wrong, counts = np.random.default_rng(seed), [], Counter()
    skeleton = msf_jax.skeletonize(trimesh.creation.torus(1.0, 0.3, major_sections=24, minor_sections=10))
    with tempfile.TemporaryDirectory() as folder:
        whole = {suffix: Path(folder) / f"whole.{suffix}" for suffix in ("json", "swc", "ply", "graphml")}
        for path in whole.values():
            skeleton.save(path)
        for number in range(num):
            suffix = list(whole)[number % len(whole)]
            words = re.split(r"([\s,:<>\[\]{}]+)", whole[suffix].read_text())
            # Few words of a JSON file are its report's.
            first = len(words) - 400 if suffix == "json" and random.random() < 0.5 else 0
            words[2 * int(random.integers(first // 2, len(words) // 2))] = str(random.choice(WORDS))
            path = Path(folder) / f"altered.{suffix}"
            path.write_text("".join(words))
            try:
                found = msf_jax.read_curve(path)
                lines = importing.report_lines(path) if suffix in ("json", "swc") else []
            except ConfigError:
                outcome = "refused"
            except Exception:
                outcome = "FAILED"
                wrong.append(f"altered text {number}, {suffix}: {traceback.format_exc()}")
            else:
                outcome = "read"
                numbers = np.concatenate([found.vertices.ravel(), found.radii])
                cycles = len(found.edges) - len(found.vertices) + found.report.components
                if not (np.isfinite(numbers).all() and (found.radii >= 0).all() and cycles == found.report.cycles):
                    wrong.append(f"altered text {number}, {suffix}: no curve was read")
                if re.search(r"\b(inf|nan)\b", " ".join(lines[:3])):
                    wrong.append(f"altered text {number}, {suffix}: {lines}")
            counts[suffix, outcome] += 1
    outcomes = ("refused", "read", "FAILED")
    print(f"| text | {' | '.join(outcomes)} |\n{'| --- ' * 4}|")
    for suffix in whole:
        print(f"| {suffix} | {' | '.join(str(counts[suffix, outcome]) for outcome in outcomes)} |")
    return wrong
