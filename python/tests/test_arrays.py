"""Arrays: they show the state as it was when they were requested, without a copy, and never change or dangle."""

import gc

import numpy as np
import pytest

import saute
from conftest import RECIPE


def all_arrays(kitchen):
    steak = kitchen["steak"]
    arrays = dict(steak.fields())
    arrays["surface"] = steak.surface_points_m
    arrays["normals"] = steak.surface_normals
    arrays["triangles"] = steak.surface_triangles
    arrays["volumes"] = steak.volumes_m3
    arrays["pan"] = kitchen.pan_temperature_k
    arrays["pan points"] = kitchen.pan_points_m
    arrays["pan triangles"] = kitchen.pan_triangles
    return arrays


def test_fields_are_shown_without_a_copy(frying):
    steak = frying["steak"]
    once, again = steak.temperature_k, steak.temperature_k
    assert once.__array_interface__["data"][0] == again.__array_interface__["data"][0]
    assert steak.surface_points_m.strides == (48, 8), "points and normals lie side by side in the simulator's table"


def test_arrays_have_the_shapes_that_they_say(frying):
    steak = frying["steak"]
    nodes = len(steak.temperature_k)
    assert all(field.shape == (nodes,) and field.dtype == np.float64 for field in steak.fields().values())
    assert steak.points_m.shape == (nodes, 3)
    patches = len(steak.surface_points_m)
    assert steak.surface_nodes.max() < nodes and steak.surface_triangles.max() < patches
    assert len(frying.pan_temperature_k) >= len(frying.pan_points_m) > frying.pan_triangles.max()
    assert np.linalg.norm(steak.surface_normals, axis=1) == pytest.approx(1)
    size = np.ptp(steak.points_m, axis=0)
    assert size[2] == pytest.approx(0.015, rel=0.1)
    assert 273 < steak.temperature_k.min() < steak.temperature_k.max() < 500


def test_arrays_cannot_be_written(frying):
    for name, array in all_arrays(frying).items():
        with pytest.raises(ValueError, match="read-only|WRITEABLE"):
            array[0] = 1
        with pytest.raises(ValueError, match="WRITEABLE"):
            array.flags.writeable = True
        assert not array.flags.writeable, name


def test_a_view_never_changes_or_dangles():
    """Views are held over steps, a cut, a restore and the end of their kitchen; rubbish is collected at each turn."""
    kitchen = saute.Kitchen(RECIPE, coarseness=3)
    start = kitchen.snapshot()
    kitchen.hob(w=1500)
    kitchen.put("steak")
    held = []

    def hold(words):
        arrays = all_arrays(kitchen)
        held.append((words, arrays, {name: array.copy() for name, array in arrays.items()}))
        gc.collect()

    def check():
        gc.collect()
        churn = [np.random.default_rng(1).random(20_000) for _ in range(50)]
        for words, arrays, copies in held:
            for name, array in arrays.items():
                assert np.array_equal(array, copies[name]), (words, name)
        del churn

    hold("raw")
    kitchen.step(50)
    hold("after steps")
    check()
    kitchen.rest("steak")
    while kitchen.busy:
        kitchen.step(5)
    hold("on the board")
    kitchen.halve("steak")
    hold("halved")
    kitchen.step(10)
    check()
    kitchen.restore(start)
    hold("restored")
    kitchen.step(5)
    check()
    other = kitchen.copy()
    del kitchen
    check()
    other.step(3)
    del other
    check()
    held[:] = held[::2]
    check()
    one = held[0][1]["temperature_k"][3:7]
    value = one.copy()
    held.clear()
    gc.collect()
    assert np.array_equal(one, value), "a slice of a view keeps the memory"


def test_a_step_writes_where_it_always_wrote_once_no_view_lives(frying):
    def address():
        return frying["steak"].temperature_k.__array_interface__["data"][0]

    before = address()
    frying.step(3)
    assert address() == before, "no view lived: nothing was copied"
    view = frying["steak"].temperature_k
    frying.step(3)
    assert address() != before, "a view lived: the step wrote to fresh memory"
    del view


def test_a_view_that_lives_does_not_change_what_a_step_gives(frying):
    other = frying.copy()
    views = []
    for _ in range(20):
        views.append(frying["steak"].temperature_k)
        frying.step(1)
    other.step(20)
    assert frying.state_hash == other.state_hash
    assert not np.array_equal(views[0], views[-1])


def test_a_surface_is_turned_by_its_pose_as_the_picture_turns_it():
    from saute._pyvista import turned

    points = np.array([[1.0, 0.0, 0.0], [0.0, 2.0, 0.0]])
    half = np.sqrt(0.5)
    assert turned(points, np.array([0, 0, half, half])) == pytest.approx(np.array([[0, 1, 0], [-2, 0, 0]]))


def test_a_piece_is_a_mesh_of_pyvista(frying):
    pytest.importorskip("pyvista", reason="the group of VTK has it: test_vtk in scripts/python.sh")
    mesh = frying["steak"].to_pyvista()
    assert mesh.n_points == len(frying["steak"].surface_points_m) and "temperature_k" in mesh.point_data
