"""The command line: ``msf-jax skeletonize``, ``view``, ``batch`` and the others, also as ``python -m msf_jax``.

Exit codes: 0 if all files are written, 1 if a mesh of a batch failed or a frame has no curve, 2 for bad input or
options, 130 for Ctrl-C, after which the curve so far is written, if an iteration has ended. A curve whose report is not
sound, or says that these are no limbs, is written with a warning. An existing file whose name was not given is not
overwritten without ``--force``.

Help and errors appear without delay: commands import modules on demand, and JAX only after the mesh was accepted.
"""

import argparse
import io
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from msf_jax.app.interrupts import held_interrupts
from msf_jax.app.parser import REPAIRS, configured, parser_of
from msf_jax.app.shaping import UNCHANGED, Shaping, asked_for, scaled, shaped
from msf_jax.base.errors import ConfigError, FlowError, Interrupted, MeshError
from msf_jax.base.writing import made_folder, plain, write_whole
from msf_jax.skeleton.formats import export

if TYPE_CHECKING:
    import numpy as np

    from msf_jax.skeleton.skeleton import Skeleton

INTERRUPTED = 130  # the exit code after Ctrl-C, as of other programs
LISTED = 10  # failed meshes of a batch, or doubtful frames, that are printed


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line with ``argv`` (the process's own if not given); returns the exit code."""
    commands = {"skeletonize": _skeletonize, "demo": _demo, "batch": _batch, "view": _view, "track": _track}
    arguments = parser_of(commands | {"report": _report}).parse_args(argv)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # a name may have characters that the terminal's encoding has not
            stream.reconfigure(errors="backslashreplace")
    try:
        return arguments.run(arguments)
    except (MeshError, ConfigError, FlowError) as error:
        return _fail(str(error), 2)
    except UnicodeEncodeError as error:
        return _fail(f"the system has no bytes for the name {error.object!r}: choose another one", 2)
    except OSError as error:
        return _fail(f"{error.strerror or error}: {error.filename}" if error.filename else str(error), 2)
    except MemoryError:
        return _fail("this needs more memory than there is: coarsen the mesh, or use another machine", 2)
    except KeyboardInterrupt as interruption:
        return _fail(str(interruption) or "interrupted", INTERRUPTED)


def command() -> None:
    """The command as a process."""
    sys.exit(main())


def _fail(message: str, code: int) -> int:
    if sys.stderr is not None:
        print(f"msf-jax: {plain(' '.join(message.splitlines()))}", file=sys.stderr)
    return code


def _start_jax(arguments: argparse.Namespace) -> None:
    """Import JAX, which is slow, and set the precision and the cache."""
    if os.environ.get("TF_CPP_MIN_LOG_LEVEL", "1") == "1":  # JAX sets 1 on import, so a parent process may have done so
        os.environ["TF_CPP_MIN_LOG_LEVEL"] = "3"  # hides a false alarm of XLA, see `cache_compilations`
    with held_interrupts():
        import jax

        import msf_jax
        import msf_jax.flow.skeletonize
    jax.config.update("jax_enable_x64", not arguments.float32)
    msf_jax.cache_compilations()


def _accepted(arguments: argparse.Namespace, asked: Shaping = UNCHANGED) -> "tuple[tuple[np.ndarray, np.ndarray], Any]":
    """The mesh as it was read, in the requested units, and its checked surface; a `MeshError` if it is refused."""
    from msf_jax.meshes import checking, reading

    mesh = scaled(reading.read(arguments.mesh, finite=not arguments.repair), asked)
    return mesh, checking.prepare(mesh, REPAIRS[arguments.repair])


def _skeletonize(arguments: argparse.Namespace) -> int:
    _check_is_there(arguments.mesh)
    target = _target(arguments, ".swc")
    render = export.writer_for(target)  # refuses a wrong suffix before the flow, not after it
    is_rig = target.name.lower().endswith(".glb")
    if arguments.bones is not None and not is_rig:
        raise ConfigError(f"--bones is for a rig, and {target.name!r} holds none: expected -o with .glb")
    if arguments.bones is not None and arguments.bones < 1:
        raise ConfigError(f"--bones is {arguments.bones}: expected a whole number above 0")
    asked = asked_for(arguments)
    picture = None
    if arguments.picture is not None:
        picture = _checked_target(arguments.picture, arguments.mesh, str(target))
        if picture.suffix.lower() != ".png":
            raise ConfigError(f"the picture is a PNG file: expected a name that ends in .png, not {picture.name!r}")
    weights, config = configured(arguments, check=arguments.check, evaluate=arguments.evaluate)
    mesh, accepted = _accepted(arguments, asked)
    _start_jax(arguments)
    from msf_jax.flow.skeletonize import skeletonize

    stopped = ""
    try:
        skeleton = skeletonize(accepted, weights, config, pins=arguments.pin, progress=not arguments.quiet)
    except Interrupted as interruption:
        skeleton = interruption.flow.skeleton
        stopped = f"interrupted: {target} has the curve so far"
    skeleton = shaped(skeleton, asked)
    source = arguments.mesh if asked.scale == 1 else mesh  # a format that contains the mesh has its file's materials
    notes: tuple[str, ...] = ()
    files: dict[Path, str | bytes]
    if is_rig:
        from msf_jax.skeleton.formats import gltf

        rig = skeleton.rig(bones=arguments.bones, mesh=source)
        notes, files = rig.notes, {target: gltf.of_rig(rig, source)}
    else:
        files = {target: render(skeleton, source)}
    if picture:
        from msf_jax.skeleton.pictures import panels

        files[picture] = panels.picture(skeleton, mesh)
    code = _finish(skeleton, files, arguments.quiet)
    for note in notes:
        _fail(f"rig: {note}", code)
    return _fail(stopped, INTERRUPTED) if stopped else code


def _view(arguments: argparse.Namespace) -> int:
    _check_is_there(arguments.mesh)
    target = _target(arguments, ".html")
    if target.suffix.lower() != ".html":
        raise ConfigError(f"the page is an HTML file: expected a name that ends in .html, not {target.name!r}")
    weights, config = configured(arguments)
    mesh, accepted = _accepted(arguments)
    _start_jax(arguments)
    from msf_jax.flow.skeletonize import skeletonize

    skeleton = skeletonize(accepted, weights, config, progress=not arguments.quiet)
    skeleton.view(mesh, target)
    _tell(skeleton, [target], arguments.quiet)
    return 0


def _track(arguments: argparse.Namespace) -> int:
    from msf_jax.app import track

    paths = track.frames_in(arguments.folder, arguments.output)
    export.writer_for(f"curve{arguments.format}")  # refuses a wrong suffix before the run, not after it
    if arguments.mesh.lower().endswith(".npz"):
        _start_jax(arguments)
        from msf_jax.skeleton.formats.importing import read_curve

        skeleton = read_curve(arguments.mesh)
    else:
        weights, config = configured(arguments)
        _, accepted = _accepted(arguments)
        _start_jax(arguments)
        from msf_jax.flow.skeletonize import skeletonize

        skeleton = skeletonize(accepted, weights, config, progress=not arguments.quiet)
    table, lacking, doubtful = track.run(
        skeleton, paths, arguments.output, suffix=arguments.format, progress=not arguments.quiet
    )
    if not arguments.quiet:
        print(f"{len(paths)} frames, {len(paths) - len(lacking)} curves; see {table}")
    _list([f"warning: {line}" for line in lacking + doubtful], f"more, in {table}")
    return min(len(lacking), 1)


def _batch(arguments: argparse.Namespace) -> int:
    from msf_jax.meshes import reading

    weights, config = configured(arguments, evaluate=arguments.evaluate)
    paths = reading.meshes_in(arguments.folder, arguments.output, is_deep=True)
    _start_jax(arguments)
    from msf_jax.app import batch

    done = batch.run(
        paths,
        arguments.output,
        weights=weights,
        config=config,
        repair=REPAIRS[arguments.repair],
        suffix=arguments.format,
        jobs=arguments.jobs,
        shaping=asked_for(arguments),
        scheduler=arguments.scheduler,
        retry=arguments.retry,
        timeout=arguments.timeout,
        progress=not arguments.quiet,
    )
    if not arguments.quiet:
        print(f"{len(done.rows)} meshes, {done.num_done} of them now, {done.num_failed} failed; see {done.manifest}")
    failed = [f"{row['path']}: {row['error']}" for row in done.rows if row["error"]]
    _list(failed, f"more that failed, in {done.manifest}")
    return min(done.num_failed, 1)


def _list(lines: list[str], rest: str) -> None:
    """Print the first lines, and how many others there are."""
    for line in lines[:LISTED]:
        _fail(line, 1)
    if len(lines) > LISTED:
        _fail(f"and {len(lines) - LISTED} {rest}", 1)


def _demo(arguments: argparse.Namespace) -> int:
    folder = made_folder(arguments.output)
    _start_jax(arguments)
    from msf_jax import shapes
    from msf_jax.flow.skeletonize import skeletonize
    from msf_jax.skeleton.pictures import panels

    mesh = shapes.hand()
    content, own = str(mesh.export(file_type="off")), folder / "hand.off"
    if own.exists() and own.read_bytes() != content.encode() and not arguments.force:
        raise ConfigError(f"{str(own)!r} exists with another content: name another folder with -o, or add --force")
    skeleton = skeletonize(mesh, progress=not arguments.quiet)
    files: dict[Path, str | bytes] = {
        own: content,
        folder / "hand.swc": export.writer_for("hand.swc")(skeleton, mesh),
        folder / "hand.png": panels.picture(skeleton, mesh),
    }
    return _finish(skeleton, files, arguments.quiet)


def _report(arguments: argparse.Namespace) -> int:
    from msf_jax.skeleton.formats import importing

    print("\n".join(importing.report_lines(arguments.curve)))
    return 0


def _check_is_there(path: str) -> None:
    """Report a missing mesh before a bad output path."""
    if not os.path.exists(path):
        raise MeshError(f"no file {path!r}: check the path")


def _target(arguments: argparse.Namespace, suffix: str) -> Path:
    """The file of the result: the given one, or one beside the mesh, which must not exist yet."""
    if arguments.output is not None:
        return _checked_target(arguments.output, arguments.mesh)
    target = _checked_target(str(Path(arguments.mesh).with_suffix(suffix)), arguments.mesh)
    if target.exists() and not arguments.force:
        raise ConfigError(f"{str(target)!r} exists already: name another file with -o, or add --force")
    return target


def _checked_target(path: str, *others: str) -> Path:
    """``path``, if it can be written to and is not one of ``others``."""
    target = Path(path)
    folder = Path(os.path.realpath(path)).parent  # of the target, if it is a link
    if not path or target.is_dir():
        raise ConfigError(f"{path!r} is no file name: expected the name of a file to write")
    if not folder.is_dir():
        raise ConfigError(f"no folder {str(folder)!r} to write {target.name!r} to: create it first")
    if not os.access(folder, os.W_OK):
        raise ConfigError(f"cannot write to {str(folder)!r}: choose another folder for {target.name!r}")
    if any(os.path.realpath(path) == os.path.realpath(other) for other in others):
        raise ConfigError(f"{path!r} is given for two files, and one would overwrite the other: choose another name")
    return target


def _finish(skeleton: "Skeleton", files: dict[Path, str | bytes], quiet: bool) -> int:
    """Write ``files``, all of them rendered before, and print the report."""
    for path, content in files.items():
        write_whole(path, content)
    _tell(skeleton, list(files), quiet)
    return 0


def _tell(skeleton: "Skeleton", written: list[Path], quiet: bool) -> None:
    if not quiet:
        print(f"nodes: {len(skeleton.vertices)}, edges: {len(skeleton.edges)}, tips: {skeleton.num_leaves}")
        print(skeleton.report)
        print("wrote " + ", ".join(map(str, written)))
    if not skeleton.report.is_sound:
        _fail("warning: look at this curve before you use it: its report is not sound", 0)
    elif not skeleton.report.are_limbs:
        _fail(f"warning: the topology is right, but these are no limbs: {'; '.join(skeleton.report.not_limbs)}", 0)
