"""Names of bones: the branch, the place along it, and the side of a symmetric shape.

``root``; ``trunk2_1`` for the first bone of a branch between two junctions; ``limb5_3.L`` for the third bone of a
branch that ends in a tip. Two branches that are mirror images have the same number, with ``.L`` and ``.R``, by which
Blender finds the other side.
"""

from msf_jax.skeleton.rigging import biped
from msf_jax.skeleton.rigging.bones import Bones

SIDE_SUFFIXES = {1: ".L", -1: ".R", 0: ""}


def names_of(bones: Bones, standard: str | None = None) -> tuple[str, ...]:
    """A unique name for each bone; those of a biped as in ``standard``, see `biped`."""
    number: dict[int, int] = {}  # of each branch; its mirror image has the same
    names, roots, kinds = [], int((bones.parents < 0).sum()), 0
    for bone, branch in enumerate(bones.branch.tolist()):
        if standard and bones.role[bone]:
            names.append(biped.named(str(bones.role[bone]), int(bones.side[bone]), standard))
            continue
        if branch < 0:
            names.append("root" if roots == 1 else f"root{bone + 1}")
            continue
        if branch not in number:
            kinds += 1
            number[branch] = kinds
            if bones.twin[bone] >= 0:
                number[int(bones.branch[bones.twin[bone]])] = kinds
        kind = "limb" if bones.is_limb[bone] else "trunk"
        names.append(f"{kind}{number[branch]}_{bones.place[bone] + 1}{SIDE_SUFFIXES[int(bones.side[bone])]}")
    return tuple(names)
