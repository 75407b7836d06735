"""Mutated mesh files at validation: each is its mesh or a `MeshError`, in little time and memory, and nothing else.

    python -m tests.benchmarks.fuzz [--files N] [--seed N] [--seconds S] [--memory GB]

Prints, for each format, how many files were tried, read, refused, and the longest time that one took. A file of OBJ,
OFF or PLY that is read must be the mesh that a strict parser finds in it, which shares no code with the project:
plyfile's, and those below, which know triangles only. "lenient" are files that those do not allow.
"""

import argparse
import io
import re
import resource
import sys
import tempfile
import time
import traceback
from collections import Counter
from pathlib import Path

import numpy as np
import plyfile
import trimesh

from msf_jax import MeshError
from msf_jax.meshes import checking, reading
from tests.benchmarks.frame import TooLong, limited

HOSTILE = [
    *("nan", "inf", "-inf", "1e999", "-1", "0", "", "1000000000", "99999999999999999999", "0x10", "1/2/3", "é"),
    *("1e308", "1180591620717411303424", "\x85", "\u2028", "\nl 1 1180591620717411303424\n"),
    *("2147483647", "4294967296", "-9223372036854775808", "\x00", "#", "1e-320", "3 0 1 2", "OFF", "end_header"),
]


def originals() -> dict[str, bytes]:
    """One sound mesh in every format, by the format's name."""
    mesh = trimesh.creation.icosphere(1)
    mesh.apply_scale([1.0, 0.8, 0.7])

    def exported(kind: str, **options: object) -> bytes:
        content = mesh.export(file_type=kind, **options)
        return content if isinstance(content, bytes) else content.encode()

    return {
        "off": exported("off"),
        "obj": exported("obj"),
        "ply": exported("ply"),
        "ascii ply": exported("ply", encoding="ascii"),
        "stl": exported("stl"),
        "ascii stl": exported("stl_ascii"),
        "glb": exported("glb"),
        "3mf": exported("3mf"),
        "marked obj": exported("obj").decode().encode("utf-8-sig"),
        "backward obj": backward(mesh),
    }


def backward(mesh: trimesh.Trimesh) -> bytes:
    """An OBJ file whose faces count back from their line, with vertices after them."""
    lines = ["v {} {} {}".format(*vertex) for vertex in mesh.vertices.tolist()]
    lines += ["f {} {} {}".format(*face) for face in (mesh.faces - len(mesh.vertices)).tolist()]
    return "\n".join([*lines, "v 9 9 9", "v 8 8 8\n"]).encode()


def mutated(content: bytes, others: list[bytes], random: np.random.Generator) -> bytes:
    """``content`` with one to three things wrong."""
    for _ in range(random.integers(1, 4)):
        num = max(len(content), 1)
        start = int(random.integers(num))
        end = min(num, start + int(random.choice([1, 4, 30, 300])))
        match random.integers(8):
            case 0:
                content = content[:start]
            case 1:
                content = content[:start] + content[end:]
            case 2:
                content = content[:end] + content[start:]
            case 3:
                content = content[:start] + random.bytes(end - start) + content[end:]
            case 4:
                content = content[:start] + random.bytes(end - start) + content[start:]
            case 5 | 6:
                words = content.split(b" ")
                words[int(random.integers(len(words)))] = str(random.choice(HOSTILE)).encode()
                content = b" ".join(words)
            case _:
                other = others[int(random.integers(len(others)))]
                content = content[:start] + other[int(random.integers(len(other))) :]
    return content


def text_of(content: bytes) -> str:
    """By its mark, or UTF-8, or Latin-1."""
    for mark, encoding in ((b"\xef\xbb\xbf", "utf-8"), (b"\xff\xfe", "utf-16-le"), (b"\xfe\xff", "utf-16-be")):
        if content.startswith(mark):
            return content[len(mark) :].decode(encoding)
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError:
        return content.decode("latin-1")


def whole(word: str) -> int:
    if not re.fullmatch(r"[-+]?[0-9]+", word):
        raise ValueError
    return int(word)


def obj(content: bytes) -> tuple[list, list]:
    """Indices count from 1, or back from the line that they are in."""
    vertices: list[list[float]] = []
    faces: list[list[int]] = []
    for line in re.split(r"\r\n|\n|\r", re.sub(r"\\(\r\n|\n)", " ", text_of(content))):
        words = line.split("#")[0].split()
        if words[:1] == ["v"]:
            vertices.append([float(word) for word in words[1:4]])
        elif words[:1] == ["f"]:
            face = [whole(word.split("/")[0]) for word in words[1:]]
            faces.append([corner - 1 if corner > 0 else len(vertices) + corner if corner else -1 for corner in face])
    return vertices, faces


def off(content: bytes) -> tuple[list, list]:
    """Word by word, without comments and colours, with or without a count of edges."""
    words = " ".join(line.split("#")[0] for line in re.split(r"\r\n|\n|\r", text_of(content))).split()
    num, num_faces = whole(words[1]), whole(words[2])
    data = words[4:] if len(words) == 4 + 3 * num + 4 * num_faces else words[3:]
    rows = [[whole(word) for word in data[k : k + 4]] for k in range(3 * num, len(data), 4)]
    if words[0].upper() != "OFF" or min(num, num_faces) < 0 or len(data) != 3 * num + 4 * num_faces:
        raise ValueError
    vertices = [[float(word) for word in data[k : k + 3]] for k in range(0, 3 * num, 3)]
    return vertices, [row[1:] if row[0] == 3 else [] for row in rows]


def ply(content: bytes) -> tuple[list, list]:
    document = plyfile.PlyData.read(io.BytesIO(content))
    name = next(name for name in ("vertex_indices", "vertex_index") if name in document["face"])
    return np.stack([document["vertex"][axis] for axis in "xyz"], axis=1).tolist(), document["face"][name].tolist()


PARSERS = {".obj": obj, ".off": off, ".ply": ply}


def corners_of(suffix: str, content: bytes) -> np.ndarray | None:
    """The corners (F, 3, 3) of the triangles of a file; None if it is not of its format."""
    try:
        vertices, faces = PARSERS[suffix](content)
        points, index = np.array(vertices, dtype=float).reshape(-1, 3), np.array(faces, dtype=object)
        if index.shape != (len(faces), 3) or not all(corner in range(len(points)) for corner in index.ravel()):
            return None
        return points[index.astype(np.int64)]
    except (plyfile.PlyParseError, ValueError, KeyError, IndexError, TypeError, StopIteration, OverflowError):
        return None


def are_same(ours: np.ndarray, theirs: np.ndarray) -> bool:
    """Whether two lists of triangles are the same, in any order and from any first corner."""

    def canonical(triangles: np.ndarray) -> np.ndarray:
        triangles = np.nan_to_num(triangles, nan=7e77, posinf=8e88, neginf=-8e88).astype(np.float64)
        turned = np.stack([np.roll(triangles, turn, axis=1).reshape(-1, 9) for turn in range(3)], axis=1)
        first = np.array([np.lexsort(rows.T[::-1])[0] for rows in turned], dtype=int)
        rows = turned[np.arange(len(turned)), first]
        return rows[np.lexsort(rows.T[::-1])]

    return ours.shape == theirs.shape and np.allclose(canonical(ours), canonical(theirs), rtol=1e-6, atol=1e-9)


def judged(path: Path, content: bytes) -> str:
    """Whether what is read is what a strict parser finds; a `MeshError` if it is not read."""
    vertices, faces = reading.read(path)
    if path.suffix not in PARSERS:
        return "read"
    found = corners_of(path.suffix, content)
    return "lenient" if found is None else "read" if are_same(vertices[faces], found) else "ANOTHER MESH"


def fuzz(num: int, seed: int, seconds: float) -> tuple[list[str], list[str]]:
    """Try ``num`` files; returns lines of a table, and what went wrong, one text each."""
    random, files = np.random.default_rng(seed), originals()
    outcomes: Counter[tuple[str, str]] = Counter()
    longest, wrong, stdout = dict.fromkeys(files, 0.0), [], sys.stdout
    with tempfile.TemporaryDirectory() as folder:
        for number in range(num):
            name = list(files)[number % len(files)]
            content = mutated(files[name], list(files.values()), random)
            path = Path(folder) / f"mesh.{name.split()[-1]}"
            path.write_bytes(content)
            start, outcome = time.perf_counter(), ""
            sys.stdout = io.StringIO()
            try:
                with limited(seconds):
                    outcome = judged(path, content)
                    if outcome == "ANOTHER MESH":
                        wrong.append(f"file {number}, {name}: it is another mesh than {content[:300]!r} says")
                    checking.prepare(path, repair=number % 3 == 0)
            except MeshError:
                outcome = outcome or "refused"  # else it was read, and is no solid
            except (Exception, TooLong):
                outcome = "FAILED"
                wrong.append(f"file {number}, {name}, {content[:300]!r}\n{traceback.format_exc()}")
            finally:
                sys.stdout = stdout
            longest[name] = max(longest[name], time.perf_counter() - start)
            outcomes[name, outcome] += 1
    kinds = ("read", "lenient", "refused", "ANOTHER MESH", "FAILED")
    lines = [f"| format | files | {' | '.join(kinds)} | longest, s |", "| --- " * 8 + "|"]
    for name in files:
        counts = [outcomes[name, outcome] for outcome in kinds]
        lines.append(f"| {name} | {sum(counts)} | {' | '.join(map(str, counts))} | {longest[name]:.2f} |")
    return lines, wrong


def main() -> int:
    """Print the table, and every failure."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--files", type=int, default=20_000, help="to try")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--seconds", type=float, default=20, help="that one file may take")
    parser.add_argument("--memory", type=float, default=4.0, help="address space in GB that all of it may take")
    arguments = parser.parse_args()
    limit = int(arguments.memory * 1e9)
    resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    lines, wrong = fuzz(arguments.files, arguments.seed, arguments.seconds)
    print("\n".join(lines))
    print(f"peak memory {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6:.2f} GB, {len(wrong)} failures")
    print("\n\n".join(wrong[:10]))
    return min(len(wrong), 1)


if __name__ == "__main__":
    sys.exit(main())
