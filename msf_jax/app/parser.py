"""The options of every command, with their help, and their conversion to weights, a `Config` and a repair mode."""

import argparse
import difflib
from collections.abc import Callable, Mapping
from typing import Any

import shtab

from msf_jax.app import shaping
from msf_jax.app.help import teaching
from msf_jax.base.options import SYSTEMS, Config, Weights
from msf_jax.base.version import VERSION
from msf_jax.base.weights import read_weights
from msf_jax.skeleton.formats import export

WEIGHTS = {
    "w_L": "contraction (w_L)",
    "w_H": "attraction to a vertex's current position (w_H)",
    "w_M": "attraction to the Voronoi pole (w_M)",
    "smoothing": "lambda of the implicit smoothing",
}
REPAIRS = {"mend": True, "join": "join"}  # the argument of `skeletonize` for each value of --repair
MESH = "a closed triangle mesh: .off, .obj, .ply, .stl, .glb, .3mf and others, or VTK's where pyvista is installed"


def parser_of(run: Mapping[str, Callable[[argparse.Namespace], int]]) -> argparse.ArgumentParser:
    """The parser of all commands with their options. ``run`` has the function of each command, by name."""
    parser = argparse.ArgumentParser(prog="msf-jax", **teaching("PARSER"))
    parser.add_argument("--version", action="version", version=f"msf-jax {VERSION}")
    parser.set_defaults(run=lambda _: parser.print_help() or 0, parser=parser)
    commands = parser.add_subparsers(title="commands", metavar="COMMAND")

    one = commands.add_parser("skeletonize", help="the curve skeleton of a mesh", **teaching("SKELETONIZE"))
    _completes(one.add_argument("mesh", metavar="IN", help=MESH), shtab.FILE)
    suffixes = f"one of {', '.join(export.WRITERS)}"
    place = f"where to write the curve, {suffixes} (default: IN with .swc)"
    _completes(one.add_argument("-o", "--output", metavar="OUT", help=place), shtab.FILE)
    _forcing(one)
    _completes(one.add_argument("--picture", metavar="PNG", help="draw the curve in the mesh, too"), shtab.FILE)
    _repairing(one)
    one.add_argument("--evaluate", action="store_true", help="add scores such as off-centre to the report")
    _completes(
        one.add_argument(
            "--checkpoint",
            metavar="FILE",
            help="save the state of the run there; a run that was killed continues from it",
        ),
        shtab.FILE,
    )
    _settings(one)
    shaping.add_options(one)
    one.add_argument("--pin", type=int, action="append", metavar="N", help="hold vertex N in place (can be repeated)")
    one.add_argument(
        "--bones", type=int, metavar="N", help="of a .glb file: their number (default: by bends and lengths)"
    )
    one.add_argument("--check", action="store_true", help="verify the surface after every round of edits (slower)")
    _common(one)
    one.set_defaults(run=run["skeletonize"])

    demo = commands.add_parser("demo", help="skeletonise a hand made in code", **teaching("DEMO"))
    _completes(
        demo.add_argument(
            "-o", "--output", metavar="FOLDER", default=".", help="where to put the files (default: here)"
        ),
        shtab.DIRECTORY,
    )
    _forcing(demo)
    _common(demo)
    demo.set_defaults(run=run["demo"])

    viewer = commands.add_parser("view", help="an interactive page of a mesh and its curve", **teaching("VIEW"))
    _completes(viewer.add_argument("mesh", metavar="IN", help=MESH), shtab.FILE)
    place = "where to write the page (default: IN with .html)"
    _completes(viewer.add_argument("-o", "--output", metavar="HTML", help=place), shtab.FILE)
    _forcing(viewer)
    _repairing(viewer)
    _settings(viewer)
    _common(viewer)
    viewer.set_defaults(run=run["view"])

    many = commands.add_parser("batch", help="the curves of all meshes in a folder", **teaching("BATCH"))
    _completes(many.add_argument("folder", metavar="IN_DIR", help="where the meshes are"), shtab.DIRECTORY)
    _completes(many.add_argument("output", metavar="OUT_DIR", help="where curves and manifest.csv go"), shtab.DIRECTORY)
    many.add_argument("--jobs", type=int, metavar="N", help="processes (default: one for each core)")
    many.add_argument("--format", default=".swc", metavar="SUFFIX", help=f"one of {', '.join(export.WRITERS)}")
    many.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask scheduler, such as tcp://host:8786")
    _repairing(many)
    many.add_argument("--retry", action="store_true", help="try failed meshes again")
    limit = "a mesh that takes more than this many seconds gets an error; compare --max-seconds"
    many.add_argument("--timeout", type=float, metavar="X", help=f"{limit} (default: no limit)")
    many.add_argument("--evaluate", action="store_true", help="add scores such as off-centre to the table")
    shaping.add_options(many)
    _settings(many)
    _common(many)
    many.set_defaults(run=run["batch"])

    series = commands.add_parser("track", help="one curve through meshes with the same faces", **teaching("TRACK"))
    _completes(series.add_argument("mesh", metavar="FIRST", help=f"{MESH}, or its curve as .npz"), shtab.FILE)
    _completes(series.add_argument("folder", metavar="FRAMES", help="where the meshes are"), shtab.DIRECTORY)
    place = "where curves and frames.csv go"
    _completes(series.add_argument("-o", "--output", metavar="OUT_DIR", required=True, help=place), shtab.DIRECTORY)
    series.add_argument("--format", default=".swc", metavar="SUFFIX", help=f"one of {', '.join(export.WRITERS)}")
    _repairing(series)
    _settings(series)
    _common(series)
    series.set_defaults(run=run["track"])

    again = commands.add_parser("report", help="print the report of a saved curve", **teaching("REPORT"))
    place = f"a saved curve: {export.HOLD_REPORT}"
    _completes(again.add_argument("curve", metavar="CURVE", help=place), shtab.FILE)
    again.set_defaults(run=run["report"])

    shell = commands.add_parser("completion", help="completion of commands in a shell", **teaching("COMPLETION"))
    shell.add_argument("shell", choices=shtab.SUPPORTED_SHELLS, help="the kind of shell")
    shell.set_defaults(run=lambda arguments: print(shtab.complete(parser, arguments.shell)) or 0)
    for command in commands.choices.values():
        command.set_defaults(parser=command)
    return parser


def parsed(parser: argparse.ArgumentParser, words: list[str]) -> argparse.Namespace:
    """The parsed ``words``. For an unknown option it prints the command's usage and the most similar option."""
    arguments, unknown = parser.parse_known_args(with_whole_options(words))
    if unknown:
        near = difflib.get_close_matches(unknown[0].partition("=")[0], arguments.parser._option_string_actions, 1)
        hint = f"; did you mean {near[0]}?" if near else ""
        arguments.parser.error(f"unrecognized arguments: {' '.join(unknown)}{hint}")
    return arguments


def with_whole_options(words: list[str]) -> list[str]:
    """``words``, with ``--repair`` and ``--root`` joined to their values, because argparse would misread two cases.

    It would take the word after a bare ``--repair``, such as a mesh's name, as its value. It would take negative
    coordinates after ``--root`` as another option.
    """
    whole, words = [], list(words)
    while words:
        word = words.pop(0)
        after = words[0] if words else ""
        if word == "--repair" and after not in REPAIRS:
            word = f"{word}=mend"
        elif word == "--root" and after[:1] == "-" and after[1:2] in tuple("0123456789."):
            word = f"{word}={words.pop(0)}"
        whole.append(word)
    return whole


def _completes(option: Any, kind: object) -> None:
    """Let the shell complete files or folders for an option, by an attribute that shtab reads."""
    option.complete = kind


def _forcing(parser: argparse.ArgumentParser) -> None:
    """The option of commands that write files whose names were not given."""
    parser.add_argument("--force", action="store_true", help="overwrite existing files whose name was not given")


def _repairing(parser: argparse.ArgumentParser) -> None:
    """The option that `_repair_of` reads."""
    parser.add_argument(
        "--repair",
        choices=list(REPAIRS),
        metavar="join",
        nargs="?",
        const="mend",
        help="repair a mesh that is no closed manifold, and report the changes; with join, also make one solid of "
        "parts that overlap or nearly touch",
    )


def repair_of(arguments: argparse.Namespace) -> bool | str:
    """The argument ``repair`` of `skeletonize`."""
    return REPAIRS.get(arguments.repair, False)


def _settings(parser: argparse.ArgumentParser) -> None:
    """Options that become weights and a `Config`; see `_configured`."""
    defaults = Config()
    curve = parser.add_argument_group("the curve", "Lengths are fractions of the bounding box's diagonal.")
    curve.add_argument(
        "--least-slenderness",
        "--prune",
        type=float,
        metavar="X",
        help="remove branches of lower slenderness: 1 for a limb that sticks out by its radius, 4 to 8 for a finger; "
        f"0 removes none (default: {defaults.least_slenderness})",
    )
    curve.add_argument(
        "--detail",
        type=float,
        metavar="X",
        help=f"which short limbs that stand out have a branch: 0 none, 1 any (default: {defaults.detail})",
    )
    curve.add_argument(
        "--coarsen",
        type=float,
        metavar="X",
        help=f"collapse edges shorter than this before the flow; 0 collapses none (default: {defaults.coarsen})",
    )
    flow = parser.add_argument_group("the flow", "Of the weights, only the ratios of the first three matter.")
    flow.add_argument("--system", default="msf", metavar="NAME", help=f"one of {', '.join(SYSTEMS)} (default: msf)")
    for name, meaning in WEIGHTS.items():
        default = getattr(Weights(), name)
        option = f"--{name.replace('_', '-')}"
        flow.add_argument(option, dest=name, type=float, metavar="X", help=f"{meaning} (default of msf: {default})")
    file = "a file of weights from Tuned.save or save_weights; the options above replace single weights"
    _completes(flow.add_argument("--weights", metavar="FILE", help=file), shtab.FILE)
    flow.add_argument(
        "--max-iterations",
        type=int,
        metavar="N",
        help=f"largest number of iterations (default: {defaults.max_iterations})",
    )
    flow.add_argument(
        "--max-seconds",
        type=float,
        metavar="X",
        help="end each run after this many seconds, with the curve so far (default: no limit)",
    )


def configured(arguments: argparse.Namespace, **others: Any) -> tuple[Weights, Config]:
    """Weights and `Config` from the options of `_settings`; others have the system's values."""
    names = ("max_iterations", "max_seconds", "coarsen", "least_slenderness", "detail")
    changes = {name: getattr(arguments, name) for name in names}
    changes = {name: value for name, value in changes.items() if value is not None}
    config = Config.named(arguments.system, **others, **changes)
    given = {name: getattr(arguments, name) for name in WEIGHTS if getattr(arguments, name) is not None}
    weights = config.default_weights() if arguments.weights is None else read_weights(arguments.weights)
    return Weights(**(vars(weights) | given)), config


def _common(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--float32", action="store_true", help="compute in float32 instead of float64")
    parser.add_argument("-q", "--quiet", action="store_true", help="no progress bar and no report")
