"""The options of every command, with their help, and their conversion to weights, a `Config` and a `Shaping`."""

import argparse
import math
from typing import Any

from msf_jax.app.shaping import Shaping
from msf_jax.base.options import SYSTEMS, Config, Weights
from msf_jax.base.version import VERSION
from msf_jax.skeleton.formats import writers

REPAIRS = {None: False, "mend": True, "join": "join"}  # the argument of `skeletonize` for each value of --repair
MESH = "a closed triangle mesh: .off, .obj, .ply, .stl, .glb, .3mf, or VTK's where pyvista is installed"
CURVES = f"one of {', '.join(writers.WRITERS)}"

# The help of each command. Its first line is in the list of commands, and a test parses its examples.
HELP = {
    "": """\
Curve skeletons of closed triangle meshes by Medial Skeletonization Flow.

first steps:
  msf-jax demo                      a hand made in code, its curve and a picture
  msf-jax skeletonize hand.off      hand.swc, and a report that says how far to trust it
  msf-jax COMMAND --help            options and more examples

exit codes: 0 all files are written (warnings name doubtful curves), 1 a mesh of a batch failed, or
a frame has no curve, 2 bad input or options, 130 Ctrl-C (the curve so far is written, if there is one)""",
    "skeletonize": """\
the curve skeleton of a closed mesh

examples:
  msf-jax skeletonize hand.off -o hand.png                  a picture of the curve in the mesh
  msf-jax skeletonize scan.stl -o scan.vtp --repair         a mesh that is not closed, or not oriented
  msf-jax skeletonize teapot.obj -o teapot.npz --repair join   join parts that overlap or touch
  msf-jax skeletonize hand.off -o hand.swc --prune 3        fewer branches; --prune 0 keeps all
  msf-jax skeletonize neuron.ply -o neuron.swc --repair join --root soma --radius section --units nm
  msf-jax skeletonize vessel.vtp -o vessel.csv --repair     a table of branches; of nodes: -o vessel.nodes.csv
  msf-jax skeletonize person.obj -o person.glb              a rig, for Blender""",
    "view": """\
the same as an interactive page

The page needs no network: the surface, the curve, and a slider for the flow's iterations.

example:
  msf-jax view hand.off -o hand.html --w-M 0.8""",
    "demo": """\
hand.off, a hand with five fingers and a handle, with hand.swc and hand.png

then: msf-jax view hand.off""",
    "batch": """\
the curves of all meshes in a folder and its subfolders

manifest.csv has a row for each mesh, with its report or its error; other meshes are not affected.
Started again, the batch skeletonises what is missing.

examples:
  msf-jax batch meshes curves --jobs 4 --format .vtp --prune 2
  msf-jax batch meshes curves --scheduler tcp://host:8786   on a Dask cluster that sees the folders""",
    "track": """\
one curve through all meshes of a folder, in the order of their names

They must have the faces of the first mesh, with moved vertices. Nodes have the same ids in all.
frames.csv says how much of each curve is inside, and whether its frame needs a run of its own.

examples:
  msf-jax track first.obj frames -o curves
  msf-jax track first.npz frames -o curves              a saved curve: no run""",
    "report": """\
print the report of a saved curve

example:
  msf-jax report hand.swc""",
}


def whole_parser() -> argparse.ArgumentParser:
    """The parser of all commands with their options."""
    layout: dict[str, Any] = {"formatter_class": argparse.RawDescriptionHelpFormatter, "allow_abbrev": False}
    parser = argparse.ArgumentParser("msf-jax", description=HELP[""], **layout)
    parser.add_argument("--version", action="version", version=f"msf-jax {VERSION}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", dest="command")
    added = {
        name: commands.add_parser(name, help=text.splitlines()[0], description=text, **layout)
        for name, text in HELP.items()
        if name
    }
    one, page, demo, many, series = (added[name] for name in ("skeletonize", "view", "demo", "batch", "track"))
    for each, suffix in ((one, ".swc"), (page, ".html")):
        each.add_argument("mesh", metavar="IN", help=MESH)
        each.add_argument("-o", "--output", metavar="OUT", help=f"{CURVES}, .png or .html (default: IN with {suffix})")
    demo.add_argument("-o", "--output", metavar="FOLDER", default=".", help="where to put the files (default: here)")
    many.add_argument("folder", metavar="IN_DIR", help="where the meshes are")
    many.add_argument("output", metavar="OUT_DIR", help="where curves and manifest.csv go")
    many.add_argument("--jobs", type=int, metavar="N", help="processes (default: one for each core)")
    many.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask scheduler, such as tcp://host:8786")
    many.add_argument("--retry", action="store_true", help="try failed meshes again")
    series.add_argument("mesh", metavar="FIRST", help=f"{MESH}, or its curve as .npz")
    series.add_argument("folder", metavar="FRAMES", help="where the meshes are")
    series.add_argument("-o", "--output", metavar="OUT_DIR", required=True, help="where curves and frames.csv go")
    for each in (many, series):
        each.add_argument("--format", default=".swc", metavar="SUFFIX", help=CURVES)
    for each in (one, page, many):
        _add_shaping(each)
    for each in (one, page, many, series):
        _add_settings(each)
    for each in (one, page, demo, many, series):
        each.add_argument("--float32", action="store_true", help="compute in float32 instead of float64")
        each.add_argument("-q", "--quiet", action="store_true", help="no progress bar and no report")
    added["report"].add_argument("curve", metavar="CURVE", help="a saved curve, .npz or .swc")
    return parser


def _add_settings(parser: argparse.ArgumentParser) -> None:
    """Options of the mesh's repair, and those that `configured` reads."""
    defaults, weights = Config(), Weights()
    repair = "repair a mesh that is no closed manifold, and report the changes; with join, also make one solid of "
    repair += "parts that overlap or nearly touch; after the mesh's name"
    parser.add_argument("--repair", choices=["mend", "join"], metavar="join", nargs="?", const="mend", help=repair)
    parser.add_argument("--evaluate", action="store_true", help="add scores such as off-centre to the report")
    flow = parser.add_argument_group(
        "the run", "Lengths are fractions of the bounding box's diagonal. Of w_L, w_H and w_M, only the ratios matter."
    )
    flow.add_argument("--system", default="msf", metavar="NAME", help=f"one of {', '.join(SYSTEMS)} (default: msf)")
    flow.add_argument(
        "--max-iterations", type=int, metavar="N", help=f"the largest number (default: {defaults.max_iterations})"
    )
    least = "remove branches of lower slenderness: 1 for a limb that sticks out by its radius, 4 to 8 for a finger; "
    for names, what in {
        ("--least-slenderness", "--prune"): f"{least}0 removes none (default: {defaults.least_slenderness})",
        ("--detail",): f"which short limbs that stand out have a branch: 0 none, 1 any (default: {defaults.detail})",
        ("--coarsen",): f"collapse edges shorter than this before the flow (default: {defaults.coarsen})",
        ("--max-seconds",): "end each run after this many seconds, with the curve so far (default: no limit)",
        ("--w-L",): f"weight of contraction (default of msf: {weights.w_L})",
        ("--w-H",): f"weight of a vertex's current position (default of msf: {weights.w_H})",
        ("--w-M",): f"weight of the pole (default of msf: {weights.w_M})",
        ("--smoothing",): f"lambda of the implicit smoothing (default of msf: {weights.smoothing})",
    }.items():
        flow.add_argument(*names, type=float, metavar="X", help=what)


def configured(arguments: argparse.Namespace) -> tuple[Weights, Config]:
    """Weights and `Config` from the options of `_add_settings`; others have the system's values."""
    names = ("max_iterations", "max_seconds", "coarsen", "least_slenderness", "detail", "evaluate")
    given = {name: value for name, value in vars(arguments).items() if value is not None}
    config = Config.named(arguments.system, **{name: given[name] for name in names if name in given})
    usual = vars(config.default_weights())
    return Weights(**{name: given.get(name, value) for name, value in usual.items()}), config


def _add_shaping(parser: argparse.ArgumentParser) -> None:
    """The members of a `Shaping`, by their names."""
    lengths = "Lengths are in the units of the written file: the mesh is scaled first."
    group = parser.add_argument_group("what is written", lengths)
    for name, what in {
        "scale": "multiply the mesh's coordinates, to change the unit",
        "resample": "distance between nodes along the branches",
        "simplify": "fewer nodes, such that the curve moves by at most this length",
        "heal": "join pieces of the curve over gaps up to this length",
    }.items():
        group.add_argument(f"--{name}", type=positive_number, metavar="X", help=what)
    group.add_argument("--units", metavar="NAME", help="name of the unit of length, for .swc, .json and .npz files")
    tree = "make a tree, by cutting loops where they are thinnest; its root is the node nearest to x,y,z, soma, or "
    group.add_argument("--root", type=root, metavar="R", help=f"{tree}thickest, as --root=-1,2,3")
    radius = "ball: of the largest ball inside (default); section: of a disc with the cross-section's area"
    group.add_argument("--radius", choices=["ball", "section"], help=radius)
    group.add_argument("--label", type=int, metavar="N", help="label of all but a soma in an .swc file, as 3, dendrite")


def shaping_of(arguments: argparse.Namespace) -> Shaping:
    """The `Shaping` from the options of `_add_shaping`; without them, one that changes nothing."""
    given = {name: getattr(arguments, name, None) for name in Shaping._fields}
    return Shaping(**{name: value for name, value in given.items() if value is not None})


def positive_number(text: str) -> float:
    """A type of argparse, whose messages have the function's name."""
    value = float(text)
    if not 0 < value < math.inf:
        raise argparse.ArgumentTypeError(f"{text}: expected a finite number above 0")
    return value


def root(text: str) -> tuple[float, ...] | str:
    """Likewise; see `Shaping`."""
    if text in ("soma", "thickest"):
        return text
    place = tuple(map(float, text.split(",")))
    if len(place) != 3 or not all(map(math.isfinite, place)):
        raise argparse.ArgumentTypeError(f"{text}: expected x,y,z, soma or thickest")
    return place
