"""Names of bones: the branch, the place along it, and the side of a symmetric shape.

``root``; ``trunk2_1`` for the first bone of a branch between two junctions; ``limb5_3.L`` for the third bone of a
branch that ends in a tip. Two branches that are mirror images have the same number, with ``.L`` and ``.R``, by which
Blender finds the other side. Left is the side with the larger coordinate across the mirror: the left of a figure that
looks along z with y up, as in glTF, or along -y with z up, as in Blender.
"""

import numpy as np
from scipy import spatial

from msf_jax.skeleton.rigging.bones import Bones

ALIKE = 0.1  # diagonals of the rig: distance between a branch's ends and those of its mirror image, at most
ENOUGH = 0.6  # share of the branches' length that has a mirror image in a symmetric shape, at least


def names_of(bones: Bones) -> tuple[str, ...]:
    """A unique name for each bone."""
    number, side = _sides(bones)
    names, roots = [], int((bones.parents < 0).sum())
    for bone, branch in enumerate(bones.branch):
        if branch < 0:
            names.append("root" if roots == 1 else f"root{bone + 1}")
            continue
        kind = "limb" if bones.is_limb[bone] else "trunk"
        names.append(f"{kind}{number[branch]}_{bones.place[bone] + 1}{side[branch]}")
    return tuple(names)


def _sides(bones: Bones) -> tuple[dict[int, int], dict[int, str]]:
    """The number and the side (".L", ".R" or "") of each branch."""
    known = np.unique(bones.branch[bones.branch >= 0])
    image = _mirrored(bones, known)
    number: dict[int, int] = {}
    for branch in known.tolist():
        other = image.get(branch, (branch, ""))[0]
        number[branch] = number[other] if other in number else len(set(number.values())) + 1
    return number, {branch: image.get(branch, (branch, ""))[1] for branch in known.tolist()}


def _mirrored(bones: Bones, known: np.ndarray) -> dict[int, tuple[int, str]]:
    """The mirror image of each branch, and the branch's side; empty unless the shape is symmetric."""
    if len(known) < 2:
        return {}
    rows = [np.flatnonzero(bones.branch == branch) for branch in known]
    begin = np.array([bones.joints[row[0]] for row in rows])
    end = np.array([bones.tails[row[-1]] for row in rows])
    length = np.linalg.norm(end - begin, axis=1)
    points = np.concatenate([bones.joints, bones.tails])
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    axes = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2]
    best = ENOUGH
    found: dict[int, tuple[int, str]] = {}
    for normal in np.concatenate([np.eye(3), axes]):
        normal = normal * np.sign(normal[np.abs(normal).argmax()])
        height = points @ normal
        for middle in ((height.max() + height.min()) / 2, float(bones.joints[0] @ normal)):
            flipped = [at - 2 * ((at @ normal) - middle)[:, None] * normal for at in (begin, end)]
            away, image = map(np.asarray, spatial.KDTree(np.hstack([begin, end])).query(np.hstack(flipped)))
            is_pair = (away < ALIKE * size) & (image[image] == np.arange(len(known)))
            is_other = is_pair & (image != np.arange(len(known)))
            share = length[is_pair].sum() / max(length.sum(), 1e-300)
            if is_other.any() and share > best:
                best = share
                side = [".L" if at else ".R" for at in (begin + end) @ normal / 2 > middle]
                found = {int(known[k]): (int(known[image[k]]), side[k]) for k in np.flatnonzero(is_other)}
    return found
