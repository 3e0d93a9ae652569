"""Promise: meshio reads the fields of a cook, and finds the cook's own numbers."""

import meshio
import pytest


@pytest.mark.parametrize("name, kind", [("steak", "wedge"), ("steak, surface", "triangle"), ("pan", "triangle")])
def test_every_instant_is_read(series, name, kind):
    for time in series.times():
        grid = meshio.read(series.files[time, name])
        assert {block.type for block in grid.cells} == {kind}
        assert float(grid.field_data["TimeValue"].ravel()[0]) == pytest.approx(time)
        # A list, not a column.
        assert grid.point_data["temperature_c"].shape == (len(grid.points),)


def test_the_mass_is_the_summary_s(series):
    fields = meshio.read(series.files[12.0, "steak"]).point_data
    numbers = next(f for f in series.summary["foods"] if f["id"] == "steak")
    mass = sum(fields[name].sum() for name in ("water_kg", "lean_solids_kg", "fat_kg"))
    assert 1e3 * mass == pytest.approx(numbers["mass_g"]["end"], rel=1e-9)
