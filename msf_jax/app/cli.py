"""The command line: ``msf-jax skeletonize``, ``demo``, ``view``, ``batch``, also as ``python -m msf_jax``.

Exit codes: 0 when all is written, 1 when some mesh of a batch failed or some frame has no curve, 2 for bad input or
options, 130 for Ctrl-C, after which the curve as far as it went is written. A curve whose report is not clean is
written all the same, with a warning.
"""

import argparse
import contextlib
import os
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import jax
import numpy as np
import shtab

import msf_jax
from msf_jax import shapes
from msf_jax.app import batch, track
from msf_jax.app.help import teaching
from msf_jax.base.errors import ConfigError, FlowError, Interrupted, MeshError
from msf_jax.base.options import SYSTEMS, Config, Weights
from msf_jax.base.version import VERSION
from msf_jax.base.writing import write_whole
from msf_jax.host.mesh import reading
from msf_jax.skeleton.formats import export
from msf_jax.skeleton.pictures import panels
from msf_jax.skeleton.skeleton import Skeleton

LISTED = 10  # of the meshes of a batch that failed, so many are named
WEIGHTS = {
    "w_L": "contraction (w_L)",
    "w_H": "attraction to where a vertex is (w_H)",
    "w_M": "attraction to the Voronoi pole (w_M)",
    "smoothing": "lambda of the implicit smoothing",
}


MESH = "a closed triangle mesh in any format that trimesh reads"


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line with ``argv`` (the process's own if not given); returns the exit code."""
    arguments = _parser().parse_args(argv)
    jax.config.update("jax_enable_x64", not arguments.float32)
    _cache_compilations()
    try:
        with _without_loader_noise():
            return arguments.run(arguments)
    except (MeshError, ConfigError, FlowError) as error:
        return _fail(str(error), 2)
    except OSError as error:
        return _fail(f"{error.strerror or error}: {error.filename}" if error.filename else str(error), 2)
    except KeyboardInterrupt:
        return _fail("interrupted", 130)


def _fail(message: str, code: int) -> int:
    if sys.stderr is not None:
        print(f"msf-jax: {' '.join(message.splitlines())}", file=sys.stderr)
    return code


def _cache_compilations() -> None:
    """Keep compiled steps in the user's cache folder, so that only the first run on a machine compiles."""
    if getattr(jax.config, "jax_compilation_cache_dir", None) is None:
        base = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
        jax.config.update("jax_compilation_cache_dir", str(base / "msf_jax"))
        jax.config.update("jax_persistent_cache_min_compile_time_secs", 0.2)


@contextlib.contextmanager
def _without_loader_noise() -> Iterator[None]:
    """Hold back what native code writes to standard error, and pass it on at the end but for one known false alarm.

    For every step that it takes from the cache on a CPU, XLA prints five kilobytes about tuning flags that are "not
    supported on the host machine" (jax issue 38445, xla issue 44565). It listens to no option that can still be set.
    """
    python_stderr = sys.stderr
    if python_stderr is None:  # closed by whoever started us: there is nothing to hold back
        yield
        return
    with tempfile.TemporaryFile() as held:
        python_stderr.flush()
        original = os.dup(2)
        os.dup2(held.fileno(), 2)
        if python_stderr is sys.__stderr__:  # Python's own messages and the progress bar still go out at once
            sys.stderr = os.fdopen(original, "w", buffering=1, closefd=False)
        try:
            yield
        finally:
            sys.stderr.flush()
            sys.stderr = python_stderr
            os.dup2(original, 2)
            os.close(original)
            held.seek(0)
            for line in held.read().splitlines():
                if b"cpu_aot_loader" not in line:
                    print(line.decode(errors="replace"), file=sys.stderr)


def _completes(option: Any, kind: object) -> None:
    """The shell offers files or folders for an option: shtab reads an attribute of it that argparse does not know."""
    option.complete = kind


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="msf-jax", **teaching("PARSER"))
    parser.add_argument("--version", action="version", version=f"msf-jax {VERSION}")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")

    one = commands.add_parser("skeletonize", help="a mesh in, its curve skeleton out", **teaching("SKELETONIZE"))
    _completes(one.add_argument("mesh", metavar="IN", help=MESH), shtab.FILE)
    suffixes = f"one of {', '.join(export.WRITERS)}"
    _completes(one.add_argument("-o", "--output", metavar="OUT", required=True, help=suffixes), shtab.FILE)
    _completes(one.add_argument("--picture", metavar="PNG", help="draw the curve in the mesh, too"), shtab.FILE)
    one.add_argument("--repair", action="store_true", help="mend a mesh that is no closed manifold, and say how")
    one.add_argument("--evaluate", action="store_true", help="report off-centre, missed surface and the like, too")
    _completes(
        one.add_argument(
            "--checkpoint",
            metavar="FILE",
            help="keep the state there while it runs; a run that was killed goes on from it",
        ),
        shtab.FILE,
    )
    _settings(one)
    one.add_argument("--pin", type=int, action="append", metavar="N", help="hold vertex N in place (can be repeated)")
    one.add_argument("--check", action="store_true", help="verify the surface after every round of edits (slower)")
    _common(one)
    one.set_defaults(run=_skeletonize)

    demo = commands.add_parser("demo", help="skeletonise a hand made in code", **teaching("DEMO"))
    _completes(
        demo.add_argument(
            "-o", "--output", metavar="FOLDER", default=".", help="where to put the files (default: here)"
        ),
        shtab.DIRECTORY,
    )
    _common(demo)
    demo.set_defaults(run=_demo)

    look = commands.add_parser("view", help="a page to look around in", **teaching("VIEW"))
    _completes(look.add_argument("mesh", metavar="IN", help=MESH), shtab.FILE)
    place = "where to write it (default: IN with .html)"
    _completes(look.add_argument("-o", "--output", metavar="HTML", help=place), shtab.FILE)
    look.add_argument("--repair", action="store_true", help="mend a mesh that is no closed manifold, and say how")
    _settings(look)
    _common(look)
    look.set_defaults(run=_view)

    many = commands.add_parser("batch", help="a folder of meshes in, a folder of curves out", **teaching("BATCH"))
    _completes(many.add_argument("folder", metavar="IN_DIR", help="where the meshes are"), shtab.DIRECTORY)
    _completes(many.add_argument("output", metavar="OUT_DIR", help="where curves and manifest.csv go"), shtab.DIRECTORY)
    many.add_argument("--jobs", type=int, metavar="N", help="processes (default: one for each core)")
    many.add_argument("--format", default=".swc", metavar="SUFFIX", help=f"one of {', '.join(export.WRITERS)}")
    many.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask scheduler, such as tcp://host:8786")
    many.add_argument("--repair", action="store_true", help="mend meshes that are no closed manifolds")
    many.add_argument("--retry", action="store_true", help="take those again that failed")
    many.add_argument("--evaluate", action="store_true", help="figures such as off-centre in the table, too")
    _settings(many)
    _common(many)
    many.set_defaults(run=_batch)

    series = commands.add_parser("track", help="one curve through meshes of the same faces", **teaching("TRACK"))
    _completes(series.add_argument("mesh", metavar="FIRST", help=f"{MESH}, or its curve as .npz"), shtab.FILE)
    _completes(series.add_argument("folder", metavar="FRAMES", help="where the meshes are"), shtab.DIRECTORY)
    place = "where curves and frames.csv go"
    _completes(series.add_argument("-o", "--output", metavar="OUT_DIR", required=True, help=place), shtab.DIRECTORY)
    series.add_argument("--format", default=".swc", metavar="SUFFIX", help=f"one of {', '.join(export.WRITERS)}")
    series.add_argument("--repair", action="store_true", help="mend the first mesh if it is no closed manifold")
    _settings(series)
    _common(series)
    series.set_defaults(run=_track)

    shell = commands.add_parser("completion", help="let a shell complete commands", **teaching("COMPLETION"))
    shell.add_argument("shell", choices=shtab.SUPPORTED_SHELLS, help="which")
    shell.set_defaults(float32=False, run=lambda arguments: print(shtab.complete(parser, arguments.shell)) or 0)
    return parser


def _view(arguments: argparse.Namespace) -> int:
    target = _checked_target(arguments.output or str(Path(arguments.mesh).with_suffix(".html")), arguments.mesh)
    if target.suffix.lower() != ".html":
        raise ConfigError(f"the page is an HTML file: expected a name that ends in .html, not {target.name!r}")
    weights, config = _configured(arguments)
    mesh = reading.read(arguments.mesh, finite=not arguments.repair)
    skeleton = msf_jax.skeletonize(mesh, weights, config, repair=arguments.repair, progress=not arguments.quiet)
    skeleton.view(mesh, target)
    _tell(skeleton, [target], arguments.quiet)
    return 0


def _track(arguments: argparse.Namespace) -> int:
    paths = track.frames_in(arguments.folder, arguments.output)
    export.writer_for(f"curve{arguments.format}")  # a wrong suffix is found before the run, not after it
    if arguments.mesh.lower().endswith(".npz"):
        skeleton = msf_jax.read_curve(arguments.mesh)
    else:
        weights, config = _configured(arguments)
        mesh = reading.read(arguments.mesh, finite=not arguments.repair)
        skeleton = msf_jax.skeletonize(mesh, weights, config, repair=arguments.repair, progress=not arguments.quiet)
    table, lacking, doubtful = track.run(
        skeleton, paths, arguments.output, suffix=arguments.format, progress=not arguments.quiet
    )
    if not arguments.quiet:
        print(f"{len(paths)} frames, {len(paths) - len(lacking)} curves; see {table}")
    for line in (lacking + doubtful)[:LISTED]:
        _fail(f"warning: {line}", 1)
    if len(lacking + doubtful) > LISTED:
        _fail(f"and {len(lacking + doubtful) - LISTED} more, in {table}", 1)
    return min(len(lacking), 1)


def _batch(arguments: argparse.Namespace) -> int:
    weights, config = _configured(arguments, evaluate=arguments.evaluate)
    folder = Path(arguments.folder)
    if not folder.is_dir():
        raise ConfigError(f"no folder {str(folder)!r}: expected one with meshes")
    known = reading.readable_suffixes()
    out = Path(arguments.output).resolve()
    if out == folder.resolve():
        raise ConfigError(f"OUT_DIR is IN_DIR, {arguments.output!r}: expected another folder for the curves")
    paths = [path for path in sorted(folder.rglob("*")) if path.suffix.lower().lstrip(".") in known and path.is_file()]
    paths = [path for path in paths if out not in path.resolve().parents]
    if not paths:
        raise ConfigError(f"no mesh in {str(folder)!r}: expected files that end in one of {', '.join(known)}")
    done = batch.run(
        paths,
        arguments.output,
        weights=weights,
        config=config,
        repair=arguments.repair,
        suffix=arguments.format,
        jobs=arguments.jobs,
        scheduler=arguments.scheduler,
        retry=arguments.retry,
        progress=not arguments.quiet,
    )
    if not arguments.quiet:
        print(f"{len(done.rows)} meshes, {done.num_done} of them now, {done.num_failed} failed; see {done.manifest}")
    failed = [row for row in done.rows if row["error"]]
    for row in failed[:LISTED]:
        _fail(f"{row['path']}: {row['error']}", 1)
    if len(failed) > LISTED:
        _fail(f"and {len(failed) - LISTED} more that failed, in {done.manifest}", 1)
    return min(done.num_failed, 1)


def _settings(parser: argparse.ArgumentParser) -> None:
    """Options that become weights and a `Config`; see `_configured`."""
    defaults = Config()
    curve = parser.add_argument_group("the curve", "Lengths are fractions of the bounding box's diagonal.")
    curve.add_argument(
        "--prune",
        type=float,
        metavar="X",
        help="take away branches of less persistence: 1 for a twig inside a limb, 2 for a limb that sticks out by its "
        f"radius; 0: none (default: {defaults.prune})",
    )
    curve.add_argument(
        "--coarsen",
        type=float,
        metavar="X",
        help=f"collapse edges shorter than that before the flow; 0: none (default: {defaults.coarsen})",
    )
    flow = parser.add_argument_group("the flow", "Of the weights, only the ratios of the first three matter.")
    flow.add_argument("--system", default="msf", metavar="NAME", help=f"one of {', '.join(SYSTEMS)} (default: msf)")
    for name, meaning in WEIGHTS.items():
        default = getattr(Weights(), name)
        option = f"--{name.replace('_', '-')}"
        flow.add_argument(option, dest=name, type=float, metavar="X", help=f"{meaning} (default of msf: {default})")
    flow.add_argument(
        "--max-iterations", type=int, metavar="N", help=f"give up after so many (default: {defaults.max_iterations})"
    )


def _configured(arguments: argparse.Namespace, **others: Any) -> tuple[Weights, Config]:
    """What the options of `_settings` say, the rest as the system has it."""
    changes = {name: getattr(arguments, name) for name in ("max_iterations", "coarsen", "prune")}
    changes = {name: value for name, value in changes.items() if value is not None}
    config = Config.named(arguments.system, **others, **changes)
    given = {name: getattr(arguments, name) for name in WEIGHTS if getattr(arguments, name) is not None}
    return Weights(**(vars(config.default_weights()) | given)), config


def _common(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--float32", action="store_true", help="compute in float32 instead of float64")
    parser.add_argument("-q", "--quiet", action="store_true", help="no progress bar and no report")


def _skeletonize(arguments: argparse.Namespace) -> int:
    target = _checked_target(arguments.output, arguments.mesh)
    render = export.writer_for(target)  # a wrong suffix is found before the flow, not after it
    picture = None
    if arguments.picture is not None:
        picture = _checked_target(arguments.picture, arguments.mesh, arguments.output)
        if picture.suffix.lower() != ".png":
            raise ConfigError(f"the picture is a PNG file: expected a name that ends in .png, not {picture.name!r}")
    if arguments.checkpoint is not None:
        others = [arguments.mesh, arguments.output, *([arguments.picture] if arguments.picture else [])]
        _checked_target(arguments.checkpoint, *others)
    weights, config = _configured(arguments, check=arguments.check, evaluate=arguments.evaluate)
    mesh = reading.read(arguments.mesh, finite=not arguments.repair)
    stopped = ""
    try:
        skeleton = msf_jax.skeletonize(
            mesh,
            weights,
            config,
            pins=arguments.pin,
            repair=arguments.repair,
            checkpoint=arguments.checkpoint,
            progress=not arguments.quiet,
        )
    except Interrupted as interruption:
        skeleton = interruption.flow.skeleton
        stopped = f"interrupted: {target} holds the curve as far as it went"
        stopped += f"; the same command goes on from {arguments.checkpoint}" if arguments.checkpoint else ""
    files: dict[Path, str | bytes] = {target: render(skeleton, mesh)}
    if picture:
        files[picture] = panels.picture(skeleton, mesh)
    code = _finish(skeleton, files, arguments.quiet)
    if stopped:
        return _fail(stopped, 130)
    if arguments.checkpoint:  # the curve is written: nothing is left to go on with
        Path(arguments.checkpoint).unlink(missing_ok=True)
    return code


def _checked_target(path: str, *others: str) -> Path:
    """A file that can be written to, and is none of ``others``."""
    target = Path(path)
    folder = target.absolute().parent
    if not path or target.is_dir():
        raise ConfigError(f"{path!r} is no file name: expected the name of a file to write")
    if not folder.is_dir():
        raise ConfigError(f"no folder {str(folder)!r} to write {target.name!r} to: make it first")
    if not os.access(folder, os.W_OK):
        raise ConfigError(f"cannot write to {str(folder)!r}: choose another folder for {target.name!r}")
    if any(os.path.realpath(path) == os.path.realpath(other) for other in others):
        raise ConfigError(f"{path!r} is named twice: writing it would overwrite the other; choose another name")
    return target


def _demo(arguments: argparse.Namespace) -> int:
    folder = Path(arguments.output)
    folder.mkdir(parents=True, exist_ok=True)
    mesh = shapes.hand()
    skeleton = msf_jax.skeletonize(mesh, progress=not arguments.quiet)
    files: dict[Path, str | bytes] = {
        folder / "hand.off": str(mesh.export(file_type="off")),
        folder / "hand.swc": export.writer_for("hand.swc")(skeleton, mesh),
        folder / "hand.png": panels.picture(skeleton, mesh),
    }
    return _finish(skeleton, files, arguments.quiet)


def _finish(skeleton: Skeleton, files: dict[Path, str | bytes], quiet: bool) -> int:
    """Write ``files``, all of them rendered by now, and tell about it."""
    for path, content in files.items():
        write_whole(path, content)
    _tell(skeleton, list(files), quiet)
    return 0


def _tell(skeleton: Skeleton, written: list[Path], quiet: bool) -> None:
    if not quiet:
        num_tips = int((np.bincount(skeleton.edges.ravel(), minlength=len(skeleton.vertices)) == 1).sum())
        print(f"nodes: {len(skeleton.vertices)}, edges: {len(skeleton.edges)}, tips: {num_tips}")
        print(skeleton.report)
        print("wrote " + ", ".join(map(str, written)))
    if not skeleton.report.is_sound and sys.stderr is not None:
        print("msf-jax: warning: look at this curve before you use it, its report is not clean", file=sys.stderr)
