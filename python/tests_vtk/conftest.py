"""A cook with its fields: a steak, and a block of cells from a surface file."""

import json
import os
import pathlib
import subprocess
import xml.etree.ElementTree as xml

import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

ROOT = pathlib.Path(__file__).parents[2]

RECIPE = """title = "two foods"
[pan]
kind = "carbon-steel-26"
initial_c = 200
[[food]]
id = "steak"
kind = "beef-lean"
size_mm = [80, 60, 15]
initial_c = 5
[[food]]
id = "block"
kind = "block"
size_mm = [40]
initial_c = 5
[[step]]
hob_w = 1200
[[step]]
put = "steak"
at_mm = [-35, 0]
[[step]]
put = "block"
at_mm = [70, 0]
[[step]]
at_s = 6
flip = "steak"
[[step]]
at_s = 12
end = true
"""

# A block of 40 x 30 x 14 mm.
CORNERS = [(x, y, z) for z in (0, 14) for y in (0, 30) for x in (0, 40)]
FACES = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]

SHAPE = """form = "mesh"

[mesh]
file = "block.obj"
source = "chosen"
confidence = "low"

"""


def block():
    """Returns lean beef in the shape of the block, as a file of a food."""
    text = (ROOT / "data" / "foods" / "beef-lean.toml").read_text(encoding="utf-8")
    before, rest = text.split('form = "steak"', 1)
    text = before + SHAPE + rest[rest.index("[lean]") :]
    for table in ("natural", "fat_cap"):
        first = text.index(f"[{table}]")
        text = text[:first] + text[text.index("\n[", first) + 1 :]
    return text


def read(path):
    """Returns the grid in a VTU file."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    assert reader.GetErrorCode() == 0, path
    return reader.GetOutput()


def arrays(data):
    """Returns the arrays of points or cells by their names."""
    found = [data.GetAbstractArray(i) for i in range(data.GetNumberOfArrays())]
    return {array.GetName(): vtk_to_numpy(array) for array in found}


class Series:
    """The files of a cook: grids by time and name, and its summary."""

    def __init__(self, folder):
        self.folder = folder
        self.summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        entries = xml.parse(folder / "fields.pvd").getroot().iter("DataSet")
        self.files = {}
        for entry in entries:
            self.files[float(entry.get("timestep")), entry.get("name")] = folder / entry.get("file")

    def times(self):
        return sorted({time for time, _ in self.files})

    def grid(self, time, name):
        return read(self.files[time, name])


@pytest.fixture(scope="session")
def series(tmp_path_factory):
    program = os.environ.get("SAUTE_PROGRAM")
    if program is None:
        pytest.skip("SAUTE_PROGRAM names no saute")
    folder = tmp_path_factory.mktemp("fields")
    foods = folder / "data" / "foods"
    foods.mkdir(parents=True)
    (foods / "block.toml").write_text(block(), encoding="utf-8")
    lines = [f"v {x} {y} {z}" for x, y, z in CORNERS] + ["f " + " ".join(map(str, face)) for face in FACES]
    (foods / "block.obj").write_text("\n".join(lines) + "\n", encoding="utf-8")
    recipe = folder / "two.toml"
    recipe.write_text(RECIPE, encoding="utf-8")
    out = folder / "out"
    command = [program, "cook", recipe, "--data", folder / "data", "--out", out, "--fields", "5"]
    ran = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    return Series(out)
