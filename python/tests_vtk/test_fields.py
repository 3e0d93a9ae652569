"""Promise: VTK reads the fields of a cook, and finds the cook's own numbers on sound cells."""

import numpy as np
import pytest
from conftest import arrays
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkFiltersCore import vtkCutter
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter

WEDGE, TRIANGLE, POLYHEDRON = 13, 5, 42


def sizes(grid, name):
    """Returns the volumes or areas of the cells as VTK measures them."""
    measured = vtkCellSizeFilter()
    measured.SetInputData(grid)
    measured.Update()
    return arrays(measured.GetOutput().GetCellData())[name]


def test_every_instant_has_every_body(series):
    assert series.times() == [0.0, 5.0, 10.0, 12.0]
    for time in series.times():
        for name in ("steak", "steak, surface", "block", "block, surface", "pan"):
            grid = series.grid(time, name)
            assert grid.GetNumberOfCells() > 100
            told = grid.GetFieldData().GetAbstractArray("TimeValue").GetTuple1(0)
            assert told == pytest.approx(time)


@pytest.mark.parametrize("food, kind", [("steak", WEDGE), ("block", POLYHEDRON)])
def test_the_inside_is_the_summary_s(series, food, kind):
    grid = series.grid(12.0, food)
    assert {grid.GetCellType(i) for i in range(grid.GetNumberOfCells())} == {kind}
    fields = arrays(grid.GetPointData() if kind == WEDGE else grid.GetCellData())
    numbers = next(f for f in series.summary["foods"] if f["id"] == food)
    mass = sum(fields[name].sum() for name in ("water_kg", "lean_solids_kg", "fat_kg"))
    assert 1e3 * mass == pytest.approx(numbers["mass_g"]["end"], rel=1e-9)
    assert len(fields["temperature_k"]) == numbers["nodes"]
    assert np.allclose(fields["temperature_c"] + 273.15, fields["temperature_k"], atol=1e-9)
    assert fields["temperature_c"].max() > 60 > fields["temperature_c"].min()
    volumes = sizes(grid, "Volume")
    assert (volumes > 0).all()
    # It has lost a little volume already; the cells of a body from a surface fill it up to 5 %.
    assert volumes.sum() == pytest.approx(fields["volume_m3"].sum(), rel=0.06)


def test_units_are_told_of_each_field(series):
    points = series.grid(5.0, "steak").GetPointData()
    unit = lambda name: points.GetArray(name).GetInformation().Get(vtkDataArray.UNITS_LABEL())
    assert [unit(name) for name in ("temperature_c", "water_kg", "modulus_kpa")] == ["°C", "kg", "kPa"]


def test_a_comment_says_what_food_it_is(series):
    assert b"<!-- food: steak; kind: beef-lean; place: pan; program: saute " in series.files[5.0, "steak"].read_bytes()[:400]


def test_the_surface_touches_the_pan_below(series):
    grid = series.grid(5.0, "steak, surface")
    fields, points = arrays(grid.GetPointData()), vtk_to_numpy(grid.GetPoints().GetData())
    touched = fields["contact_w_m2k"] > 100
    assert touched.any() and (fields["contact_temperature_c"][touched] > 100).all()
    assert points[touched, 2].max() < points[:, 2].min() + 0.004
    assert fields["colour_srgb"].shape == (len(points), 3) and fields["colour_srgb"].dtype == np.uint8
    below = fields["normal"][touched, 2]
    assert (below < -0.5).all()


def test_the_flip_turns_the_body_and_not_its_rest_shape(series):
    before, after = (series.grid(time, "steak") for time in (5.0, 12.0))
    rest = [arrays(grid.GetPointData())["rest_m"] for grid in (before, after)]
    assert (rest[0] == rest[1]).all()
    height = [vtk_to_numpy(grid.GetPoints().GetData())[:, 2] for grid in (before, after)]
    assert np.corrcoef(height[0], rest[0][:, 2])[0, 1] > 0.9
    assert np.corrcoef(height[1], rest[0][:, 2])[0, 1] < -0.9


@pytest.mark.parametrize("food", ["steak", "block"])
def test_a_plane_cuts_the_inside(series, food):
    grid = series.grid(12.0, food)
    plane = vtkPlane()
    plane.SetOrigin(grid.GetCenter())
    plane.SetNormal(1, 0, 0)
    cutter = vtkCutter()
    cutter.SetInputData(grid)
    cutter.SetCutFunction(plane)
    cutter.Update()
    low, high = grid.GetBounds()[2:4], grid.GetBounds()[4:6]
    box = (low[1] - low[0]) * (high[1] - high[0])
    assert 0.5 * box < sizes(cutter.GetOutput(), "Area").sum() < 1.01 * box


def test_the_pan_has_the_oil_of_the_summary(series):
    grid = series.grid(12.0, "pan")
    fields = arrays(grid.GetPointData())
    assert {grid.GetCellType(i) for i in range(grid.GetNumberOfCells())} == {TRIANGLE}
    assert 1e3 * fields["oil_kg"].sum() == pytest.approx(series.summary["liquids_g"]["oil"], rel=1e-9)
