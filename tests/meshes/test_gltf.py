"""glTF files: what is not supported is refused by its name."""

from pathlib import Path

import pytest
from file_cases import glb

from msf_jax.base.errors import MeshError
from msf_jax.meshes import reading


def primitive(document):
    return document["meshes"][0]["primitives"][0]


def accessor(document, name="POSITION"):
    found = primitive(document)
    return document["accessors"][found["attributes"].get(name, found["indices"])]


def instanced(document):
    node = next(node for node in document["nodes"] if "mesh" in node)
    node["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 0}}}


NOT_READ = {
    "a sparse accessor": lambda d: accessor(d).update(sparse={"count": 1}),
    "its indices is a sparse accessor": lambda d: accessor(d, "indices").update(sparse={"count": 1}),
    "needs EXT_mesh_gpu_instancing, .*export its instances as nodes": instanced,
    "needs KHR_draco_mesh_compression, .*without Draco": lambda d: d.update(
        extensionsRequired=["KHR_draco_mesh_compression"]
    ),
    "needs EXT_meshopt_compression, .*without meshopt": lambda d: d.update(
        extensionsRequired=["EXT_meshopt_compression"]
    ),
    "needs ACME_bend, which is not supported": lambda d: d.update(extensionsRequired=["ACME_bend"]),
    "morph targets": lambda d: (primitive(d).update(targets=[{"POSITION": 0}]), d["meshes"][0].update(weights=[0.5])),
    "triangle fan": lambda d: primitive(d).update(mode=6),
    "its POSITION has components of type 5123": lambda d: accessor(d).update(componentType=5123),
    "its indices has components of type 5126": lambda d: accessor(d, "indices").update(componentType=5126),
    "normalized integers": lambda d: accessor(d).update(normalized=True),
}


@pytest.mark.parametrize("says", NOT_READ)
def test_what_is_not_supported_in_gltf_is_refused_by_its_name(tmp_path: Path, says):
    assert len(reading.read(glb(tmp_path / "a.glb"))[1]) == 80
    with pytest.raises(MeshError, match=says):
        reading.read(glb(tmp_path / "a.glb", NOT_READ[says]))


def test_morph_targets_without_weights_do_not_move_the_mesh(tmp_path: Path):
    path = glb(tmp_path / "a.glb", lambda d: primitive(d).update(targets=[{"POSITION": 0}]))
    assert len(reading.read(path)[1]) == 80
