"""The README's pictures: six shapes of different trades, made in code, each with its curve; and a limb that was bent.

    python -m tests.benchmarks.gallery [FOLDER]

One PNG each into ``FOLDER`` (``.github`` if not given), drawn alike by `msf_jax.view`, with its camera. What the
report says of each is printed. The limb is the last picture in the notebook ``bending``, as it was run.
"""

import base64
import io
import sys
from pathlib import Path

import jax
import nbformat
import numpy as np
import trimesh
from PIL import Image, ImageChops

import msf_jax
from msf_jax import shapes, view
from tests.benchmarks import ground_truth

INCHES, DPI, COLOURS = 2.6, 100, 48
Limb = tuple[float, float, float, float]  # x, y, z, radius


def union(paths: list[list[Limb]], spacing: float, blend: float = 0.0) -> trimesh.Trimesh:
    """The solid around paths that may share nodes."""
    return shapes.solid_around(*ground_truth.graph_of(*paths), spacing, blend=blend)


def person() -> trimesh.Trimesh:
    """Arms a little off the body, one foot before the other."""
    neck, chest, hips = (0, 0, 1.42, 0.1), (0, 0, 1.3, 0.19), (0, 0, 0.86, 0.16)
    paths = [[(0, -0.02, 1.72, 0.14), (0, -0.01, 1.6, 0.13), neck, chest, (0, 0, 1.05, 0.14), hips]]
    for side in (-1.0, 1.0):
        shoulder, step = (0.22 * side, 0, 1.36, 0.09), -0.12 * side
        hand = (0.56 * side, -0.14, 0.84, 0.05)
        paths.append([chest, shoulder, (0.42 * side, 0.03, 1.12, 0.07), hand, (0.6 * side, -0.16, 0.74, 0.05)])
        foot = (0.17 * side, step, 0.08, 0.06)
        hip, knee = (0.11 * side, 0, 0.8, 0.12), (0.15 * side, step / 2 - 0.03, 0.45, 0.085)
        paths.append([hips, hip, knee, foot, (0.2 * side, step - 0.18, 0.04, 0.05)])
    return union(paths, 0.025, 0.06)


def coil() -> trimesh.Trimesh:
    """A vessel of three turns that widens in the middle."""
    t = np.linspace(0, 1, 600)
    points = np.stack([2.2 * t, 0.5 * np.cos(6 * np.pi * t), 0.5 * np.sin(6 * np.pi * t)], axis=1)
    return ground_truth.swept_tube(points, 0.07 + 0.07 * np.exp(-(((t - 0.57) / 0.06) ** 2)), 16, "round")


def wheel() -> trimesh.Trimesh:
    """A hand wheel: a rim, five spokes, a hub with its shaft; one hole between any two spokes."""
    angle = 2 * np.pi * np.arange(40) / 40
    rim = [(float(np.cos(a)), float(np.sin(a)), 0.0, 0.1) for a in angle]
    centre = (0.0, 0.0, 0.0, 0.2)
    spokes = [[centre, (*(np.array(rim[8 * k][:3]) * 0.5), 0.075), rim[8 * k]] for k in range(5)]
    return union([[*rim, rim[0]], *spokes, [centre, (0.0, 0.0, 0.5, 0.12)]], 0.045)


def plant() -> trimesh.Trimesh:
    """A stem whose leaves' stalks come out by turns, each bent and thinner to its end."""
    stem = [(0.06 * float(np.sin(3 * z)), 0.0, float(z), 0.1 - 0.03 * float(z)) for z in np.linspace(0, 2.2, 12)]
    paths: list[list[Limb]] = [stem]
    for k in range(2, 11):
        (x, y, z, radius), turn = stem[k], (0.35 if k % 2 else np.pi + 0.35) + 0.25 * np.sin(5 * k)
        long = 0.85 - 0.055 * k
        path = [(s * long, 0.75 * s * long - 0.35 * s * s * long) for s in (0.35, 0.7, 1.0)]
        turned = [(x + out * np.cos(turn), y + 0.6 * out * np.sin(turn), z + up) for out, up in path]
        paths.append(
            [stem[k], *((*place, radius * thin) for place, thin in zip(turned, (0.7, 0.75, 0.4), strict=True))]
        )
    return union(paths, 0.03, 0.04)


def neuron() -> trimesh.Trimesh:
    """A soma with dendrites that fork three times at random, and an axon below."""
    random = np.random.default_rng(0)
    soma: Limb = (0.0, 0.0, 0.0, 0.24)
    paths: list[list[Limb]] = [[soma, (0.0, 0.05, -0.6, 0.07), (0.1, 0.0, -1.2, 0.06), (0.0, -0.05, -1.9, 0.05)]]

    def grow(start: Limb, angle: float, level: int) -> None:
        long = 0.75 - 0.1 * level + random.uniform(-0.1, 0.1)
        bend = angle + random.uniform(-0.25, 0.25)
        x, y, z, _ = start
        direction = np.array([np.cos(angle) + np.cos(bend), random.uniform(-0.3, 0.3), np.sin(angle) + np.sin(bend)])
        half = (x + long / 2 * np.cos(angle), y, z + long / 2 * np.sin(angle), 0.075 - 0.012 * level)
        end = (x + long / 2 * direction[0], y + long * direction[1], z + long / 2 * direction[2], 0.065 - 0.012 * level)
        paths.append([start, half, end])
        for side in (-1, 1) if level < 2 else ():
            grow(end, bend + side * random.uniform(0.35, 0.5), level + 1)

    for angle in (0.35, 1.2, 2.0, 2.9):
        grow(soma, angle, 0)
    return union(paths, 0.028)


def drawn(mesh: trimesh.Trimesh) -> tuple[msf_jax.Skeleton, bytes]:
    """The curve, and a small PNG of it in its mesh, without the scale."""
    skeleton = msf_jax.skeletonize(mesh)
    figure = view.panels([view.Panel(mesh=mesh, curves={"": skeleton})], size=INCHES)
    figure.axes[-1].remove()
    plain = io.BytesIO()
    figure.savefig(plain, format="png", dpi=DPI)
    return skeleton, small(Image.open(plain).convert("RGB"))


def small(picture: Image.Image) -> bytes:
    """A PNG of a few colours."""
    buffer = io.BytesIO()
    picture.quantize(COLOURS).save(buffer, "png", optimize=True)
    return buffer.getvalue()


def last_of(notebook: Path) -> bytes:
    """The last picture in a notebook, without its margins."""
    cells = nbformat.read(notebook, as_version=4).cells
    found = [output.get("data", {}).get("image/png") for cell in cells for output in cell.get("outputs", [])]
    picture = Image.open(io.BytesIO(base64.b64decode([each for each in found if each][-1]))).convert("RGB")
    return small(picture.crop(ImageChops.invert(picture).getbbox()))


def main(folder: Path) -> None:
    jax.config.update("jax_enable_x64", True)
    makers = {make.__name__: make for make in (person, coil, wheel, plant, neuron)}
    for name, mesh in {"hand": shapes.hand(0.04), **{name: make() for name, make in makers.items()}}.items():
        skeleton, picture = drawn(mesh)
        (folder / f"{name}.png").write_bytes(picture)
        print(f"{name}: {len(mesh.vertices)} vertices, {len(picture)} bytes, {skeleton!r}")
    (folder / "bending.png").write_bytes(last_of(Path(__file__).parents[2] / "notebooks" / "bending.ipynb"))


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else ".github"))
