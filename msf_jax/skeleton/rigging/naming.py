"""Names of bones: the branch, the place along it, and the side of a symmetric shape.

``root``; ``trunk2_1`` for the first bone of the second branch between two junctions; ``limb5_3.L`` for the third bone
of the fifth branch that ends in a tip. The first are those that lead to the tips farthest from all others, as the place
of a tip hardly depends on how the curve was made. Two branches that are mirror images have the same number, with ``.L``
and ``.R``, by which Blender finds the other side.
"""

from msf_jax.skeleton.rigging import biped
from msf_jax.skeleton.rigging.bones import Bones

SIDE_SUFFIXES = {1: ".L", -1: ".R", 0: ""}


def names_of(bones: Bones, standard: str | None = None) -> tuple[str, ...]:
    """A unique name for each bone; those of a biped as in ``standard``, see `biped`."""
    number: dict[int, int] = {}  # of each branch; its mirror image has the same
    names, roots, count = [], int((bones.parents < 0).sum()), {"limb": 0, "trunk": 0}
    for bone, branch in enumerate(bones.branch.tolist()):
        if standard and bones.role[bone]:
            names.append(biped.named(str(bones.role[bone]), int(bones.side[bone]), standard))
            continue
        if branch < 0:
            names.append("root" if roots == 1 else f"root{bone + 1}")
            continue
        kind = "limb" if bones.is_limb[bone] else "trunk"
        if branch not in number:
            count[kind] += 1
            number[branch] = count[kind]
            if bones.twin[bone] >= 0:
                number[int(bones.branch[bones.twin[bone]])] = count[kind]
        names.append(f"{kind}{number[branch]}_{bones.place[bone] + 1}{SIDE_SUFFIXES[int(bones.side[bone])]}")
    return tuple(names)
