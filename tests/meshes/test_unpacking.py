"""Archives: what unpacks to too much is refused."""

from pathlib import Path

import pytest
import trimesh

from msf_jax.base.errors import MeshError
from msf_jax.meshes import reading
from msf_jax.meshes.files import unpacking


def test_an_archive_that_unpacks_to_too_much_is_refused(tmp_path: Path, monkeypatch):
    (tmp_path / "box.3mf").write_bytes(trimesh.creation.box().export(file_type="3mf"))
    assert len(reading.read(tmp_path / "box.3mf")[0]) == 8
    monkeypatch.setattr(unpacking, "LARGEST_UNPACKED", 100)
    with pytest.raises(MeshError, match=r"unpacks to \d+ bytes: expected at most 100"):
        reading.read(tmp_path / "box.3mf")
