"""The command line: ``msf-jax skeletonize``, ``view``, ``batch`` and the others, also as ``python -m msf_jax``.

`parser.HELP` has the exit codes. A curve whose report is not sound, or says that these are no limbs, is written with a
warning. An existing file whose name was not given is not overwritten. Help and errors appear without delay: commands
import modules on demand, and JAX only after the mesh was accepted.
"""

import argparse
import gc
import io
import os
import signal
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from msf_jax.app.parser import REPAIRS, configured, shaping_of, whole_parser
from msf_jax.base.clock import begin, held_interrupts
from msf_jax.base.errors import ConfigError, FlowError, Interrupted, MeshError
from msf_jax.base.writing import made_folder, plain, write_whole
from msf_jax.skeleton.formats import writers

if TYPE_CHECKING:
    import numpy as np

    from msf_jax.skeleton.skeleton import Skeleton

INTERRUPTED = 128 + signal.SIGINT  # the exit code after Ctrl-C, as of other programs
LISTED = 10  # failed meshes of a batch, or doubtful frames, that are printed; the table has all


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line with ``argv`` (the process's own if not given); returns the exit code."""
    parser = whole_parser()
    arguments = parser.parse_args(argv)
    arguments.is_process = argv is None
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # a name may have characters that the terminal's encoding has not
            stream.reconfigure(errors="backslashreplace")
    try:
        if arguments.command is None:
            parser.print_help()
            return 0
        with held_interrupts():
            import trimesh  # noqa: F401
        return COMMANDS[arguments.command](arguments)
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


def _fail(message: str, code: int) -> int:
    if sys.stderr is not None:
        print(f"msf-jax: {plain(' '.join(message.splitlines()))}", file=sys.stderr)
    return code


def _start_jax(arguments: argparse.Namespace) -> None:
    """Import JAX, which is slow, and set the precision and the cache."""
    with held_interrupts():
        import jax

        import msf_jax
        import msf_jax.flow.loop
    if arguments.is_process:  # at its end, Python would look through all modules for cycles, for 0.3 s
        gc.freeze()
    jax.config.update("jax_enable_x64", not arguments.float32)
    msf_jax.cache_compilations()


def _curve_of(arguments: argparse.Namespace) -> "tuple[tuple[np.ndarray, np.ndarray], Skeleton, str]":
    """The mesh as it was read, in the requested units, and its curve; after Ctrl-C, the curve so far and a message."""
    from msf_jax.meshes import checking, reading
    from msf_jax.numerics import compiled

    begin(compiled.load)  # LLVM needs neither Python's lock nor the mesh
    weights, config = configured(arguments)
    mesh = shaping_of(arguments).scaled(reading.read(arguments.mesh))
    accepted = checking.prepare(mesh, REPAIRS[arguments.repair])
    _start_jax(arguments)
    from msf_jax.flow.loop import skeletonize

    try:
        return mesh, skeletonize(accepted, weights, config, progress=not arguments.quiet), ""
    except Interrupted as interruption:
        return mesh, interruption.flow.skeleton, "interrupted: the files have the curve so far"


def _skeletonize(arguments: argparse.Namespace) -> int:
    """``skeletonize``, and ``view``, which differs in what it writes by default."""
    target = _target(arguments, ".html" if arguments.command == "view" else ".swc")
    suffix = target.suffix.lower()
    shaping = shaping_of(arguments)
    is_curve = suffix not in (".html", ".png")
    render = writers.writer_for(target, shaping.label) if is_curve else None  # refuses a suffix before the flow
    mesh, skeleton, stopped = _curve_of(arguments)
    skeleton, notes = shaping.shaped(skeleton), ()
    source = arguments.mesh if shaping.scale == 1 else mesh  # a format that contains the mesh has its file's materials
    if suffix == ".glb":
        from msf_jax.skeleton.rigging.rig import glb_of

        rig = skeleton.rig(source)
        content, notes = glb_of(rig, source), rig.notes
    elif suffix == ".png":
        from msf_jax import view

        content = view.picture(skeleton, mesh)
    else:
        content = render(skeleton, source) if render else skeleton.view(mesh).to_html(include_plotlyjs=True)
    _finish(arguments, skeleton, {target: content})
    for note in notes:
        _fail(f"rig: {note}", 0)
    return _fail(stopped, INTERRUPTED) if stopped else 0


def _track(arguments: argparse.Namespace) -> int:
    from msf_jax.app import track

    paths = track.frames_in(arguments.folder, arguments.output)
    writers.writer_for(f"curve{arguments.format}")  # refuses a wrong suffix before the run, not after it
    if arguments.mesh.lower().endswith(".npz"):
        _start_jax(arguments)
        from msf_jax.skeleton.formats.importing import read_curve

        skeleton = read_curve(arguments.mesh)
    else:
        _, skeleton, stopped = _curve_of(arguments)
        if stopped:
            raise KeyboardInterrupt("interrupted: nothing is written")
    table, num_lacking, doubts = track.run(
        skeleton, paths, arguments.output, suffix=arguments.format, progress=not arguments.quiet
    )
    if not arguments.quiet:
        print(f"{len(paths)} frames, {len(paths) - num_lacking} curves; see {table}")
    for doubt in doubts[:LISTED]:
        _fail(f"warning: {doubt}", 1)
    return min(num_lacking, 1)


def _batch(arguments: argparse.Namespace) -> int:
    from msf_jax.meshes import reading

    weights, config = configured(arguments)
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
        shaping=shaping_of(arguments),
        progress=not arguments.quiet,
        **{name: getattr(arguments, name) for name in ("jobs", "scheduler", "retry")},
    )
    if not arguments.quiet:
        print(f"{len(done.rows)} meshes, {done.num_done} of them now, {done.num_failed} failed; see {done.manifest}")
    for row in [row for row in done.rows if row["error"]][:LISTED]:
        _fail(f"{row['path']}: {row['error']}", 1)
    return min(done.num_failed, 1)


def _demo(arguments: argparse.Namespace) -> int:
    folder = made_folder(arguments.output)
    _start_jax(arguments)
    from msf_jax import shapes, view
    from msf_jax.flow.loop import skeletonize

    mesh = shapes.hand()
    content, own = str(mesh.export(file_type="off")), folder / "hand.off"
    if own.exists() and own.read_bytes() != content.encode():
        raise ConfigError(f"{str(own)!r} exists with another content: name another folder with -o")
    skeleton = skeletonize(mesh, progress=not arguments.quiet)
    curve, picture = writers.writer_for("hand.swc")(skeleton, mesh), view.picture(skeleton, mesh)
    _finish(arguments, skeleton, {own: content, folder / "hand.swc": curve, folder / "hand.png": picture})
    return 0


def _report(arguments: argparse.Namespace) -> int:
    from msf_jax.skeleton.formats import importing

    print("\n".join(importing.report_lines(arguments.curve)))
    return 0


COMMANDS = {"skeletonize": _skeletonize, "view": _skeletonize, "demo": _demo, "batch": _batch, "track": _track}
COMMANDS["report"] = _report


def _target(arguments: argparse.Namespace, suffix: str) -> Path:
    """The file of the result: the given one, or one beside the mesh, which must not exist yet.

    Raises:
        ConfigError: it cannot be written; before the run, not after it.
    """
    mesh = Path(arguments.mesh)
    target = mesh.parent / (mesh.stem + suffix) if arguments.output is None else Path(arguments.output)
    folder = Path(os.path.realpath(target)).parent  # of its target, if it is a link
    if arguments.output is None and target.exists():
        raise ConfigError(f"{str(target)!r} exists already: name a file with -o, this one to overwrite it")
    if target.is_dir() or not folder.is_dir() or not os.access(folder, os.W_OK):
        raise ConfigError(f"cannot write {str(target)!r}: expected a file's name, in a folder that is there and yours")
    if os.path.realpath(target) == os.path.realpath(arguments.mesh):
        raise ConfigError(f"{str(target)!r} is the mesh, which would be overwritten: choose another name")
    return target


def _finish(arguments: argparse.Namespace, skeleton: "Skeleton", files: dict[Path, str | bytes]) -> None:
    """Write ``files``, all of them rendered before, and print the report."""
    for path, content in files.items():
        write_whole(path, content)
    if not arguments.quiet:
        print(f"nodes: {len(skeleton.vertices)}, edges: {len(skeleton.edges)}, tips: {skeleton.num_leaves}")
        print(skeleton.report)
        print("wrote " + ", ".join(map(str, files)))
    if not skeleton.report.is_sound:
        _fail("warning: look at this curve before you use it: its report is not sound", 0)
    elif not skeleton.report.are_limbs:
        _fail(f"warning: the topology is right, but these are no limbs: {'; '.join(skeleton.report.not_limbs)}", 0)
