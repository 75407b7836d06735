"""Solids by seed with cavities, and closed tubes that cross themselves: for `faults` and the tests."""

import numpy as np
import trimesh


def inverted(mesh: trimesh.Trimesh) -> trimesh.Trimesh:
    found = mesh.copy()
    found.invert()
    return found


def together(*parts: trimesh.Trimesh) -> trimesh.Trimesh:
    return trimesh.util.concatenate(list(parts))


def hollow(seed: int) -> tuple[trimesh.Trimesh, int]:
    """A bar, turned at random, with one to three cavities in a row, balls or rings; and how many of these are rings."""
    random = np.random.default_rng(seed)
    num = int(random.integers(1, 4))
    size = random.uniform(1.6, 2.4, 2)
    parts = [trimesh.creation.box((2.0 * num, *size)).subdivide_to_size(0.5)]
    is_ring = random.random(num) < 0.4
    for place in range(num):
        cavity = (
            trimesh.creation.torus(1.0, 0.35, major_sections=24, minor_sections=12)
            if is_ring[place]
            else trimesh.creation.icosphere(2)
        )
        cavity.apply_scale(random.uniform(0.3, 0.5))
        cavity.apply_transform(trimesh.transformations.random_rotation_matrix(random.random(3)))
        parts.append(inverted(cavity.apply_translation([2.0 * place - num + 1, *random.uniform(-0.1, 0.1, 2)])))
    turn = trimesh.transformations.random_rotation_matrix(random.random(3))
    return together(*parts).apply_transform(turn), int(is_ring.sum())


def knotted(seed: int) -> tuple[trimesh.Trimesh, int, float, np.ndarray]:
    """A closed tube that crosses itself once or three times in a plane; the genus of its union; its radius; its axis.

    The radius is that of the ball in the tube, which has twelve sides.
    """
    random = np.random.default_rng(seed)
    t, radius = 2 * np.pi * np.arange(96) / 96, random.uniform(0.2, 0.3)
    if random.random() < 0.6:
        path, genus = np.stack([2 * np.sin(t), random.uniform(1.0, 1.5) * np.sin(2 * t)], axis=1), 2
    else:
        path, genus = np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t)], axis=1), 4
    ahead = np.roll(path, -1, axis=0) - np.roll(path, 1, axis=0)
    across = np.stack([-ahead[:, 1], ahead[:, 0]], axis=1) / np.linalg.norm(ahead, axis=1, keepdims=True)
    angle = 2 * np.pi * np.arange(12) / 12
    rings = path[:, None] + radius * np.cos(angle)[:, None] * across[:, None]
    height = np.broadcast_to(radius * np.sin(angle), rings.shape[:2])
    i, j = (each.ravel() for each in np.indices((96, 12)))
    a, b, c, d = (((i + k) % 96) * 12 + (j + m) % 12 for k, m in ((0, 0), (1, 0), (1, 1), (0, 1)))
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    mesh = trimesh.Trimesh(np.concatenate([rings, height[..., None]], axis=2).reshape(-1, 3), faces, process=False)
    turn = trimesh.transformations.random_rotation_matrix(random.random(3))
    axis = trimesh.transform_points(np.pad(path, ((0, 0), (0, 1))), turn)
    mesh = (mesh if mesh.volume > 0 else inverted(mesh)).apply_transform(turn)
    return mesh, genus, radius * np.cos(np.pi / 12), axis
