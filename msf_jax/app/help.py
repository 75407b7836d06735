"""What ``msf-jax --help`` says around the options: what a command does, and examples that a test parses."""

import argparse
from typing import Any

HELP = {  # what stands above the options, and below them
    "PARSER": (
        "Curve skeletons of closed triangle meshes by Medial Skeletonization Flow.",
        """\
first steps:
  msf-jax demo                                      a hand made in code, its curve and a picture
  msf-jax skeletonize hand.off                      hand.swc, and a report that says how far to trust it
  msf-jax view hand.off                             a page to look around in
  msf-jax COMMAND --help                            options and more examples

exit codes: 0 all is written (warnings say where a curve is doubtful), 1 a mesh of a batch failed,
2 bad input or options, 130 Ctrl-C (the curve as far as it went is written)""",
    ),
    "SKELETONIZE": (
        """\
Skeletonise one closed mesh. The report is printed at the end: whether the flow converged, whether
the curve has as many cycles as the mesh has handles, how much of it is inside.""",
        """\
examples:
  msf-jax skeletonize hand.off                              writes hand.swc, unless there is one
  msf-jax skeletonize hand.off -o hand.swc --picture hand.png
  msf-jax skeletonize scan.stl -o scan.vtp --repair         not closed, or not one way round
  msf-jax skeletonize teapot.obj -o teapot.npz --repair join   parts that belong together are one
  msf-jax skeletonize hand.off -o hand.swc --prune 3        fewer branches; --prune 0 keeps all
  msf-jax skeletonize hand.off -o hand.swc --w-M 0.8        nearer to the middle, more side branches
  msf-jax skeletonize neuron.ply -o neuron.swc --repair join --root soma --radius section --units nm
  msf-jax skeletonize vessel.vtp -o vessel.csv --repair     a table of branches; of nodes: -o vessel.nodes.csv
  msf-jax skeletonize person.obj -o person.glb              a rig, for Blender
  msf-jax skeletonize big.ply -o big.npz --checkpoint big.run.npz""",
    ),
    "DEMO": (
        "Skeletonise a hand with five fingers and a handle; leaves hand.off, hand.swc and hand.png.",
        "then: msf-jax view hand.off",
    ),
    "VIEW": (
        """\
Skeletonise one mesh and write a page that any browser shows, without a network: the surface, the
curve, and sliders through the iterations of the flow and through pruning.""",
        """\
examples:
  msf-jax view hand.off -o hand.html
  msf-jax view hand.off --w-M 0.8        other weights, as for skeletonize""",
    ),
    "BATCH": (
        """\
Skeletonise every mesh in a folder and in those below it. A bad mesh fails alone: manifest.csv has a
row for each, with its report or its error. Started again, it does what is missing.""",
        """\
examples:
  msf-jax batch meshes curves --jobs 4
  msf-jax batch meshes curves --format .vtp
  msf-jax batch meshes curves --w-M 0.8 --prune 2           weights and the like, as for skeletonize
  msf-jax batch meshes curves --retry                       take what failed once more
  msf-jax batch meshes curves --scheduler tcp://host:8786   on a Dask cluster that sees the folders""",
    ),
    "TRACK": (
        """\
Skeletonise the first mesh and follow its curve through all meshes of a folder, in the order of their
names: the same faces, moved vertices. Nodes have the same numbers in all. frames.csv says of each how
much of its curve is inside, and whether it is bent too far and wants a run of its own.""",
        """\
examples:
  msf-jax track first.obj frames -o curves
  msf-jax track first.obj frames -o curves --format .vtp
  msf-jax track first.npz frames -o curves              a curve that was saved before: no run""",
    ),
    "REPORT": (
        "Print the report of a curve that was written before: what was found, and how far to trust it.",
        """\
examples:
  msf-jax report hand.swc
  msf-jax report hand.npz                with the seconds of every stage""",
    ),
    "COMPLETION": (
        "Print a script that lets a shell complete commands and options.",
        """\
example, for bash:
  msf-jax completion bash > ~/.local/share/bash-completion/completions/msf-jax""",
    ),
}


def teaching(name: str) -> dict[str, Any]:
    """How a parser explains itself: what stands above its options, and the examples below them."""
    description, epilog = HELP[name]
    layout = argparse.RawDescriptionHelpFormatter
    return {"description": description, "epilog": epilog, "formatter_class": layout, "allow_abbrev": False}
