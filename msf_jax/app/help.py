"""The text of ``msf-jax --help`` around the options: what each command does, and examples, which a test parses."""

import argparse
from typing import Any

HELP = {  # for each command: the text above the options, and the text below them
    "PARSER": (
        "Curve skeletons of closed triangle meshes by Medial Skeletonization Flow.",
        """\
first steps:
  msf-jax demo                                      a hand made in code, its curve and a picture
  msf-jax skeletonize hand.off                      hand.swc, and a report that says how far to trust it
  msf-jax view hand.off                             an interactive page
  msf-jax COMMAND --help                            options and more examples

exit codes: 0 all files are written (warnings name doubtful curves), 1 a mesh of a batch failed, or
a frame has no curve, 2 bad input or options, 130 Ctrl-C (the curve so far is written, if there is one)""",
    ),
    "SKELETONIZE": (
        """\
Skeletonise one closed mesh. The report at the end says whether the flow converged, whether the curve
has one cycle for each handle of the mesh, and how much of the curve is inside.""",
        """\
examples:
  msf-jax skeletonize hand.off                              writes hand.swc, if it does not exist
  msf-jax skeletonize hand.off -o hand.swc --picture hand.png
  msf-jax skeletonize scan.stl -o scan.vtp --repair         a mesh that is not closed, or not oriented
  msf-jax skeletonize teapot.obj -o teapot.npz --repair join   join parts that overlap or touch
  msf-jax skeletonize hand.off -o hand.swc --prune 3        fewer branches; --prune 0 keeps all
  msf-jax skeletonize hand.off -o hand.swc --w-M 0.8        better centred, more side branches
  msf-jax skeletonize neuron.ply -o neuron.swc --repair join --root soma --radius section --units nm
  msf-jax skeletonize vessel.vtp -o vessel.csv --repair     a table of branches; of nodes: -o vessel.nodes.csv
  msf-jax skeletonize plant.ply -o plant.axes.csv --repair join --root 0,0,0   a table of a plant's axes
  msf-jax skeletonize person.obj -o person.glb              a rig, for Blender
  msf-jax skeletonize big.ply -o big.npz --checkpoint big.run.npz
  msf-jax skeletonize big.ply -o big.npz --max-seconds 600  the curve so far after ten minutes""",
    ),
    "DEMO": (
        "Skeletonise a hand with five fingers and a handle. Writes hand.off, hand.swc and hand.png.",
        "then: msf-jax view hand.off",
    ),
    "VIEW": (
        """\
Skeletonise one mesh and write a page for a browser, which needs no network: the surface, the curve,
and sliders for the iterations of the flow and for pruning.""",
        """\
examples:
  msf-jax view hand.off -o hand.html
  msf-jax view hand.off --w-M 0.8        other weights, as for skeletonize""",
    ),
    "BATCH": (
        """\
Skeletonise every mesh in a folder and its subfolders. manifest.csv has a row for each mesh, with its
report or its error; other meshes are not affected. Started again, it skeletonises what is missing.""",
        """\
examples:
  msf-jax batch meshes curves --jobs 4
  msf-jax batch meshes curves --format .vtp
  msf-jax batch meshes curves --w-M 0.8 --prune 2           weights and the like, as for skeletonize
  msf-jax batch meshes curves --retry                       try failed meshes again
  msf-jax batch meshes curves --timeout 600                 an error for a mesh that takes over ten minutes
  msf-jax batch meshes curves --scheduler tcp://host:8786   on a Dask cluster that sees the folders""",
    ),
    "TRACK": (
        """\
Skeletonise the first mesh and follow its curve through all meshes of a folder, in the order of their
names. They must have the same faces, with moved vertices. Nodes have the same ids in all. frames.csv
says for each frame how much of its curve is inside, and whether it needs a run of its own.""",
        """\
examples:
  msf-jax track first.obj frames -o curves
  msf-jax track first.obj frames -o curves --format .vtp
  msf-jax track first.npz frames -o curves              a saved curve: no run""",
    ),
    "REPORT": (
        "Print the report of a saved curve: its figures, and how far to trust it.",
        """\
examples:
  msf-jax report hand.swc
  msf-jax report hand.npz                with the seconds of every stage""",
    ),
    "COMPLETION": (
        "Print a script with which the shell completes commands and options.",
        """\
example, for bash:
  msf-jax completion bash > ~/.local/share/bash-completion/completions/msf-jax""",
    ),
}


def teaching(name: str) -> dict[str, Any]:
    """Arguments of a parser for its help: the text above its options, and the examples below them."""
    description, epilog = HELP[name]
    layout = argparse.RawDescriptionHelpFormatter
    return {"description": description, "epilog": epilog, "formatter_class": layout, "allow_abbrev": False}
