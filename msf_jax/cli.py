"""The command line: ``msf-jax skeletonize IN -o OUT`` and ``msf-jax demo``, also as ``python -m msf_jax``.

Exit codes: 0 when a curve was written, 2 for bad input or options, 130 for Ctrl-C, after which the curve as far as it
went is written. A curve whose report is not clean is written all the same, with a warning.
"""

import argparse
import contextlib
import os
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path

import jax
import numpy as np

import msf_jax
from msf_jax import export, shapes, view
from msf_jax.errors import ConfigError, FlowError, Interrupted, MeshError
from msf_jax.host import surface
from msf_jax.options import SYSTEMS, Config, Weights
from msf_jax.skeleton import Skeleton

WEIGHTS = {
    "w_L": "contraction (w_L)",
    "w_H": "attraction to where a vertex is (w_H)",
    "w_M": "attraction to the Voronoi pole (w_M)",
    "smoothing": "lambda of the implicit smoothing",
}


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


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="msf-jax",
        allow_abbrev=False,
        description="Curve skeletons of closed triangle meshes by Medial Skeletonization Flow.",
    )
    parser.add_argument("--version", action="version", version=f"msf-jax {msf_jax.__version__}")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")

    one = commands.add_parser(
        "skeletonize",
        allow_abbrev=False,
        help="a mesh in, its curve skeleton out",
        description="Skeletonise one closed mesh. The report is printed at the end.",
        epilog="example: msf-jax skeletonize hand.off -o hand.swc --w-M 0.6 --picture hand.png",
    )
    one.add_argument("mesh", metavar="IN", help="a closed triangle mesh in any format that trimesh reads")
    one.add_argument("-o", "--output", metavar="OUT", required=True, help=f"one of {', '.join(export.WRITERS)}")
    one.add_argument("--picture", metavar="PNG", help="draw the curve in the mesh, too")
    one.add_argument("--system", default="msf", metavar="NAME", help=f"one of {', '.join(SYSTEMS)} (default: msf)")
    for name, meaning in WEIGHTS.items():
        one.add_argument(f"--{name.replace('_', '-')}", dest=name, type=float, metavar="X", help=meaning)
    one.add_argument("--max-iterations", type=int, metavar="N", help="give up after N iterations")
    one.add_argument("--coarsen", type=float, metavar="X", help="collapse shorter edges first, in diagonals; 0: none")
    one.add_argument("--prune", type=float, metavar="X", help="take away branches of less persistence; 0: none")
    one.add_argument("--pin", type=int, action="append", metavar="N", help="hold vertex N in place (can be repeated)")
    one.add_argument("--repair", action="store_true", help="mend a mesh that is no closed manifold, and say how")
    one.add_argument(
        "--checkpoint", metavar="FILE", help="keep the state there while it runs; a run that was killed goes on from it"
    )
    one.add_argument("--evaluate", action="store_true", help="report off-centre, missed surface and the like, too")
    one.add_argument("--check", action="store_true", help="verify the surface after every round of edits (slower)")
    _common(one)
    one.set_defaults(run=_skeletonize)

    demo = commands.add_parser(
        "demo",
        allow_abbrev=False,
        help="skeletonise a hand with five fingers and a handle, made in code",
        description="Skeletonise a hand with five fingers and a handle; leaves mesh, skeleton and picture.",
    )
    demo.add_argument("-o", "--output", metavar="FOLDER", default=".", help="where to put the files (default: here)")
    _common(demo)
    demo.set_defaults(run=_demo)
    return parser


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
    changes = {name: getattr(arguments, name) for name in ("max_iterations", "coarsen", "prune")}
    changes = {name: value for name, value in changes.items() if value is not None}
    config = Config.named(arguments.system, check=arguments.check, evaluate=arguments.evaluate, **changes)
    given = {name: getattr(arguments, name) for name in WEIGHTS if getattr(arguments, name) is not None}
    weights = Weights(**(vars(config.default_weights()) | given))
    mesh = surface.read(arguments.mesh, finite=not arguments.repair)
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
        files[picture] = view.picture(skeleton, mesh)
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
        folder / "hand.png": view.picture(skeleton, mesh),
    }
    return _finish(skeleton, files, arguments.quiet)


def _finish(skeleton: Skeleton, files: dict[Path, str | bytes], quiet: bool) -> int:
    """Write ``files``, all of them rendered by now, and tell about it."""
    for path, content in files.items():
        export.write_whole(path, content)
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
