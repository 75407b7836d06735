"""The options of every command, with their help, and their conversion to weights and a `Config`."""

import argparse
from collections.abc import Callable, Mapping
from typing import Any

import shtab

from msf_jax.app import shaping
from msf_jax.base.options import SYSTEMS, Config, Weights, read_weights
from msf_jax.base.version import VERSION
from msf_jax.skeleton.formats import export

WEIGHTS = {
    "w_L": "contraction (w_L)",
    "w_H": "attraction to a vertex's current position (w_H)",
    "w_M": "attraction to the Voronoi pole (w_M)",
    "smoothing": "lambda of the implicit smoothing",
}
REPAIRS = {None: False, "mend": True, "join": "join"}  # the argument of `skeletonize` for each value of --repair
MESH = "a closed triangle mesh: .off, .obj, .ply, .stl, .glb, .3mf and others, or VTK's where pyvista is installed"
SUFFIXES = f"one of {', '.join(export.WRITERS)}"
Run = Mapping[str, Callable[[argparse.Namespace], int]]

# For each command: the text above the options, and the examples below them, which a test parses.
HELP = {
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


def parser_of(run: Run) -> argparse.ArgumentParser:
    """The parser of all commands with their options. ``run`` has the function of each command, by name."""
    parser = argparse.ArgumentParser(prog="msf-jax", **_texts("PARSER"))
    parser.add_argument("--version", action="version", version=f"msf-jax {VERSION}")
    parser.set_defaults(run=lambda _: parser.print_help() or 0)
    commands = parser.add_subparsers(title="commands", metavar="COMMAND")

    def command(name: str, what: str) -> argparse.ArgumentParser:
        made = commands.add_parser(name, help=what, **_texts(name.upper()))
        made.set_defaults(run=run.get(name))
        return made

    one = command("skeletonize", "the curve skeleton of a mesh")
    _names_a_file(one, "mesh", metavar="IN", help=MESH)
    place = f"where to write the curve, {SUFFIXES} (default: IN with .swc)"
    _names_a_file(one, "-o", "--output", metavar="OUT", help=place)
    _names_a_file(one, "--picture", metavar="PNG", help="draw the curve in the mesh, too")
    one.add_argument("--evaluate", action="store_true", help="add scores such as off-centre to the report")
    one.add_argument("--pin", type=int, action="append", metavar="N", help="hold vertex N in place (can be repeated)")
    bones = "of a .glb file: their number (default: by bends and lengths)"
    one.add_argument("--bones", type=int, metavar="N", help=bones)
    one.add_argument("--check", action="store_true", help="verify the surface after every round of edits (slower)")
    shaping.add_options(one)
    _add_force(one)

    demo = command("demo", "skeletonise a hand made in code")
    place = "where to put the files (default: here)"
    _names_a_folder(demo, "-o", "--output", metavar="FOLDER", default=".", help=place)
    _add_force(demo)

    viewer = command("view", "an interactive page of a mesh and its curve")
    _names_a_file(viewer, "mesh", metavar="IN", help=MESH)
    _names_a_file(viewer, "-o", "--output", metavar="HTML", help="where to write the page (default: IN with .html)")
    _add_force(viewer)

    many = command("batch", "the curves of all meshes in a folder")
    _names_a_folder(many, "folder", metavar="IN_DIR", help="where the meshes are")
    _names_a_folder(many, "output", metavar="OUT_DIR", help="where curves and manifest.csv go")
    many.add_argument("--jobs", type=int, metavar="N", help="processes (default: one for each core)")
    many.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask scheduler, such as tcp://host:8786")
    many.add_argument("--retry", action="store_true", help="try failed meshes again")
    limit = "a mesh that takes more than this many seconds gets an error; compare --max-seconds"
    many.add_argument("--timeout", type=float, metavar="X", help=f"{limit} (default: no limit)")
    many.add_argument("--evaluate", action="store_true", help="add scores such as off-centre to the table")
    shaping.add_options(many)

    series = command("track", "one curve through meshes with the same faces")
    _names_a_file(series, "mesh", metavar="FIRST", help=f"{MESH}, or its curve as .npz")
    _names_a_folder(series, "folder", metavar="FRAMES", help="where the meshes are")
    place = "where curves and frames.csv go"
    _names_a_folder(series, "-o", "--output", metavar="OUT_DIR", required=True, help=place)
    for each in (many, series):
        each.add_argument("--format", default=".swc", metavar="SUFFIX", help=SUFFIXES)
    for each in (one, viewer, many, series):
        _add_settings(each)
    for each in (one, demo, viewer, many, series):
        each.add_argument("--float32", action="store_true", help="compute in float32 instead of float64")
        each.add_argument("-q", "--quiet", action="store_true", help="no progress bar and no report")

    again = command("report", "print the report of a saved curve")
    _names_a_file(again, "curve", metavar="CURVE", help=f"a saved curve: {export.HOLD_REPORT}")

    shell = command("completion", "completion of commands in a shell")
    shell.add_argument("shell", choices=shtab.SUPPORTED_SHELLS, help="the kind of shell")
    shell.set_defaults(run=lambda arguments: print(shtab.complete(parser, arguments.shell)) or 0)
    return parser


def _texts(name: str) -> dict[str, Any]:
    """Arguments of a parser for its help."""
    description, epilog = HELP[name]
    layout = argparse.RawDescriptionHelpFormatter
    return {"description": description, "epilog": epilog, "formatter_class": layout, "allow_abbrev": False}


def _names_a_file(parser: argparse.ArgumentParser, *names: str, **options: Any) -> None:
    """An argument for which the shell completes files, by an attribute that shtab reads."""
    parser.add_argument(*names, **options).complete = shtab.FILE  # pyright: ignore[reportAttributeAccessIssue]


def _names_a_folder(parser: argparse.ArgumentParser, *names: str, **options: Any) -> None:
    parser.add_argument(*names, **options).complete = shtab.DIRECTORY  # pyright: ignore[reportAttributeAccessIssue]


def _add_force(parser: argparse.ArgumentParser) -> None:
    """The option of commands that write files whose names were not given."""
    parser.add_argument("--force", action="store_true", help="overwrite existing files whose name was not given")


def _add_settings(parser: argparse.ArgumentParser) -> None:
    """Options of the mesh's repair, and those that `configured` reads."""
    defaults = Config()

    def number(group: Any, *names: str, what: str, kind: type = float, metavar: str = "X", **options: Any) -> None:
        group.add_argument(*names, type=kind, metavar=metavar, help=what, **options)

    repair = "repair a mesh that is no closed manifold, and report the changes; with join, also make one solid of "
    repair += "parts that overlap or nearly touch; after the mesh's name"
    choices = [name for name in REPAIRS if name]
    parser.add_argument("--repair", choices=choices, metavar="join", nargs="?", const="mend", help=repair)
    curve = parser.add_argument_group("the curve", "Lengths are fractions of the bounding box's diagonal.")
    least = "remove branches of lower slenderness: 1 for a limb that sticks out by its radius, 4 to 8 for a finger; "
    least += f"0 removes none (default: {defaults.least_slenderness})"
    number(curve, "--least-slenderness", "--prune", what=least)
    detail = f"which short limbs that stand out have a branch: 0 none, 1 any (default: {defaults.detail})"
    number(curve, "--detail", what=detail)
    coarsen = f"collapse edges shorter than this before the flow; 0 collapses none (default: {defaults.coarsen})"
    number(curve, "--coarsen", what=coarsen)
    flow = parser.add_argument_group("the flow", "Of the weights, only the ratios of the first three matter.")
    flow.add_argument("--system", default="msf", metavar="NAME", help=f"one of {', '.join(SYSTEMS)} (default: msf)")
    for name, meaning in WEIGHTS.items():
        what = f"{meaning} (default of msf: {getattr(Weights(), name)})"
        number(flow, f"--{name.replace('_', '-')}", what=what, dest=name)
    file = "a file of weights from Tuned.save or save_weights; the options above replace single weights"
    flow.add_argument("--weights", metavar="FILE", help=file)
    most = f"largest number of iterations (default: {defaults.max_iterations})"
    number(flow, "--max-iterations", what=most, kind=int, metavar="N")
    seconds = "end each run after this many seconds, with the curve so far (default: no limit)"
    number(flow, "--max-seconds", what=seconds)


def configured(arguments: argparse.Namespace, **others: Any) -> tuple[Weights, Config]:
    """Weights and `Config` from the options of `_add_settings`; others have the system's values."""
    names = ("max_iterations", "max_seconds", "coarsen", "least_slenderness", "detail")
    changes = {name: getattr(arguments, name) for name in names if getattr(arguments, name) is not None}
    config = Config.named(arguments.system, **others, **changes)
    given = {name: getattr(arguments, name) for name in WEIGHTS if getattr(arguments, name) is not None}
    weights = config.default_weights() if arguments.weights is None else read_weights(arguments.weights)
    return Weights(**(vars(weights) | given)), config
