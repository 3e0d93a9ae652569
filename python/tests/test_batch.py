"""A batch: every kitchen in it is what it would be alone, for any number of threads."""

import numpy as np
import pytest

import saute
from conftest import RECIPE


def kitchens(count):
    made = []
    for i in range(count):
        recipe = {**RECIPE, "food": [{**RECIPE["food"][0], "size_mm": [80, 60, 12 + i], "seed": i + 1}]}
        kitchen = saute.Kitchen(recipe, coarseness=4)
        kitchen.put("steak")
        kitchen.hob(w=500 + 100 * i)
        made.append(kitchen)
    return made


def test_results_are_the_same_on_any_number_of_threads_and_alone():
    alone = kitchens(5)
    batches = [saute.KitchenBatch(kitchens(5), threads=threads) for threads in (1, 2, 3)]
    readings = [batch.step(40) for batch in batches]
    for kitchen in alone:
        kitchen.step(40)
    hashes = [kitchen.state_hash for kitchen in alone]
    assert all(batch.state_hashes() == hashes for batch in batches)
    assert all(np.array_equal(readings[0], other) for other in readings[1:])


def test_readings_are_one_structured_array():
    batch = saute.KitchenBatch(kitchens(3))
    readings = batch.step(20)
    assert readings.shape == (3,)
    assert readings["time_s"] == pytest.approx(2)
    assert readings["core_c"].shape == (3, 1)
    for i in range(3):
        kitchen = batch[i]
        steak = kitchen["steak"]
        assert readings["pan_c"][i] == kitchen.pan_c
        assert readings["core_c"][i, 0] == steak.core_c and readings["bottom_c"][i, 0] == steak.bottom_c
        assert readings["mass_g"][i, 0] == steak.mass_g
        assert readings["top_lab_l"][i, 0] == steak.top["l"]


def test_commands_go_to_all_or_to_those_that_a_mask_names():
    batch = saute.KitchenBatch(kitchens(3))
    batch.step(20)
    batch.hob(np.array([100.0, 200.0, 300.0]))
    batch.flip("steak", where=[True, False, True])
    readings = batch.step(60)
    assert list(readings["hob_w"]) == [100, 200, 300]
    assert list(readings["upside_down"][:, 0]) == [1, 0, 1]
    with pytest.raises(saute.RefusedError, match="in kitchen 0, 1, 2: .* is in the pan already"):
        batch.put("steak")
    with pytest.raises(ValueError, match="3 truth values"):
        batch.flip("steak", where=[True])
    with pytest.raises(TypeError, match="a number or 3 numbers"):
        batch.hob([1.0, 2.0])


def test_each_kitchen_may_go_its_own_way():
    batch = saute.KitchenBatch(kitchens(3))
    readings = batch.step([5, 0, 40])
    assert list(readings["time_s"].round(6)) == [0.5, 0.0, 4.0]
    readings = batch.step_frames([6, 0, 0])
    assert readings["time_s"][0] == pytest.approx(0.6) and readings["time_s"][1] == 0
    assert len(batch.scores(where=[True, False, True])) == 2
    with pytest.raises(TypeError, match="a number of ticks, or 3 of them"):
        batch.step([1, 2])


def test_pans_are_held_led_tools_push_and_oil_is_poured():
    batch = saute.KitchenBatch(kitchens(2))
    before = batch.readings()
    poses = before["pan_pose_m"].copy()
    poses[:, 0] += [0.02, -0.03]
    batch.hold_pan(poses)
    batch.oil([5.0, 7.0])
    batch.lead("turner", poses + np.array([0, -0.08, 0.01, 0, 0, 0, 0]), where=[True, False])
    readings = batch.step(10)
    batch.let_go()
    assert readings["pan_pose_m"] == pytest.approx(poses, abs=1e-3)
    assert readings["oil_g"] - before["oil_g"] == pytest.approx([5, 7], abs=0.1)
    with pytest.raises(TypeError, match="2 × 7"):
        batch.hold_pan(poses[:1])
    with pytest.raises(ValueError, match="turner"):
        batch.lead("fork", poses)


def test_the_reduced_mesh_is_near_the_full_one_and_can_only_be_read():
    fine = [saute.Kitchen(food="beef-lean", id="steak", size_mm=(80, 60, 12), pan_c=200)]
    fine[0].put("steak")
    fine[0].hob(w=600)
    fine[0].step(10)
    reduced = saute.KitchenBatch(fine, reduced=True)
    assert reduced.reduced
    whole = saute.KitchenBatch(fine)
    for batch in (reduced, whole):
        batch.step(300)
        batch.flip("steak")
        batch.step(300)
    one, other = reduced.readings(), whole.readings()
    assert one["time_s"] == pytest.approx(other["time_s"])
    assert one["core_c"] == pytest.approx(other["core_c"], abs=0.5)
    assert one["mass_g"] == pytest.approx(other["mass_g"], rel=0.01)
    with pytest.raises(saute.RefusedError, match="only be read"):
        reduced[0].step(1)
    with pytest.raises(saute.RefusedError, match="only be read"):
        reduced[0].snapshot()
    with pytest.raises(ValueError, match="multiple of 5"):
        reduced.step(3)
    with pytest.raises(ValueError, match="nothing moves"):
        reduced.step_frames(1)
    with pytest.raises(ValueError, match="put all foods in"):
        saute.KitchenBatch([saute.Kitchen(RECIPE)], reduced=True)


def test_a_kitchen_taken_out_of_a_batch_goes_its_own_way():
    batch = saute.KitchenBatch(kitchens(2))
    before = batch.state_hashes()
    one = batch[0]
    one.step(10)
    assert batch.state_hashes() == before
    batch[0] = one
    assert batch.state_hashes()[0] == one.state_hash
    with pytest.raises(IndexError, match="there are 2"):
        batch[2]
    with pytest.raises(ValueError, match="as many pieces"):
        batch[1] = saute.Kitchen(pan="cast-iron-26")
    with pytest.raises(TypeError, match="a list of Kitchen"):
        saute.KitchenBatch([1])
    with pytest.raises(ValueError, match="at least one"):
        saute.KitchenBatch([])
