"""A kitchen: built from what a recipe can be, moved by commands, stored and restored."""

import pickle
import threading
import time

import numpy as np
import pytest

import saute
from conftest import RECIPE


def test_a_kitchen_is_built_from_a_dict_a_text_a_path_a_name_and_from_food_and_pan(tmp_path):
    text = '[pan]\ninitial_c = 180\n[[food]]\nid = "steak"\nkind = "beef-lean"\nsize_mm = [80, 60, 15]\n'
    path = tmp_path / "mine.toml"
    path.write_text(text)
    built = [
        saute.Kitchen(RECIPE, coarseness=3),
        saute.Kitchen(text, coarseness=3),
        saute.Kitchen(path, coarseness=3),
        saute.Kitchen(str(path), coarseness=3),
        saute.Kitchen(food="beef-lean", id="steak", size_mm=(80, 60, 15), pan_c=180, coarseness=3),
        saute.Kitchen(food="beef-lean", id="steak", size_mm=np.array([80, 60, 15]), pan_c=180, coarseness=3),
    ]
    assert len({kitchen.state_hash for kitchen in built}) == 1
    assert saute.Kitchen("medium", coarseness=4).names == ["steak"]
    assert saute.Kitchen(pan="cast-iron-26").names == []


def test_a_step_is_a_tenth_of_a_second_and_a_frame_a_sixth_of_it(kitchen):
    kitchen.step(7)
    kitchen.step_frames(3)
    assert kitchen.time_s == pytest.approx(0.75)
    assert kitchen.tick == 7


def test_every_command_does_what_its_name_says(kitchen):
    kitchen.hob(w=1500)
    assert kitchen.hob_w == 1500
    kitchen.oil(g=8)
    kitchen.water(g=5)
    kitchen.butter(g=5)
    assert kitchen.oil_g > 7.9 and kitchen.water_g > 4.9
    kitchen.put("steak", at_mm=(10, 0))
    assert kitchen["steak"].place == "pan" and kitchen["steak"].at_mm == pytest.approx((10, 0))
    kitchen.step(10)
    kitchen.press("steak", n=20, for_s=0.5)
    kitchen.move("steak", to_mm=[-10, 0])
    kitchen.shake(amplitude_mm=10, hz=2, for_s=0.5)
    kitchen.step(80)
    assert kitchen["steak"].at_mm[0] < 5
    kitchen.tilt(10, towards_deg=90)
    kitchen.step(5)
    assert kitchen.pan_pose_m[3] != 0
    kitchen.tilt(0)
    kitchen.lid()
    assert kitchen.lid_is_on
    kitchen.lid(on=False)
    kitchen.flip("steak")
    kitchen.step(60)
    assert kitchen["steak"].upside_down
    kitchen.toss(height_mm=60)
    kitchen.move_pan(lift_mm=50)
    kitchen.cool(for_s=1)
    kitchen.hob_hold(c=120)
    kitchen.lead("tongs", [0.05, 0, 0.1, 0, 0, 0, 1])
    kitchen.step(5)
    kitchen.let_go()
    kitchen.step(30)
    kitchen.rest("steak", on="rack")
    kitchen.step(80)
    assert kitchen["steak"].place in ("rack", "held")


def test_a_command_that_cannot_be_carried_out_is_refused_and_changes_nothing(kitchen):
    before = kitchen.state_hash
    with pytest.raises(saute.RefusedError, match="is not in the pan: put it in first"):
        kitchen.flip("steak")
    with pytest.raises(saute.RefusedError, match="there is no food \"fish\""):
        kitchen.put("fish")
    with pytest.raises(saute.RefusedError, match="the hob gives 0 to"):
        kitchen.hob(w=float("nan"))
    assert kitchen.state_hash == before


@pytest.mark.parametrize(
    ("call", "error", "expected"),
    [
        (lambda k: k.hob(w="much"), TypeError, "w"),
        (lambda k: k.put("steak", at_mm=[1, 2, 3]), ValueError, r"\[x, y\] in mm, 2 finite numbers, not 3"),
        (lambda k: k.put("steak", at_mm="left"), TypeError, "not str"),
        (lambda k: k.put("steak", at_mm=[float("inf"), 0]), ValueError, "finite"),
        (lambda k: k.hold_pan([0, 0, 0]), ValueError, "qx, qy, qz, qw"),
        (lambda k: k.hold_pan([0, 0, 0, 0, 0, 0, 0]), ValueError, "unit quaternion"),
        (lambda k: k.rest("steak", on="floor"), ValueError, "board"),
        (lambda k: k.tilt(float("nan")), ValueError, "0 to 80"),
        (lambda k: k.toss(height_mm=1e9), ValueError, "50 to 500"),
        (lambda k: k.oil(g=-1), ValueError, "0 to 300"),
        (lambda k: k.step(-1), OverflowError, "negative"),
        (lambda k: k["fish"], KeyError, "there are: steak"),
        (lambda k: k[0], TypeError, "by its name"),
        (lambda k: k["steak"].field("taste"), ValueError, "temperature_k"),
        (lambda k: k.lead("spoon", [0, 0, 0, 0, 0, 0, 1]), ValueError, "tongs"),
        (lambda k: saute.Kitchen([1, 2]), TypeError, "must be a dict, the text"),
        (lambda k: saute.Kitchen(RECIPE, food="shrimp"), TypeError, "not both"),
        (lambda k: saute.Kitchen(RECIPE, coarseness=0.1), ValueError, "coarseness"),
        (lambda k: k.restore(b"soup"), saute.SnapshotError, "no kitchen"),
        (lambda k: k.render(size=(1, 2, 3)), ValueError, "width, height"),
        (lambda k: k.render(view="smell"), ValueError, "temperature"),
        (lambda k: k.render(camera=(0, 0)), ValueError, "pitch_deg"),
    ],
)
def test_shapes_and_types_are_refused_with_what_was_expected(kitchen, call, error, expected):
    with pytest.raises(error, match=expected):
        call(kitchen)


def test_a_kitchen_pickles_and_goes_on_bit_by_bit(frying):
    other = pickle.loads(pickle.dumps(frying))
    third = saute.Kitchen(pan="cast-iron-26")
    third.restore(frying.snapshot())
    copy = frying.copy()
    for kitchen in (frying, other, third, copy):
        kitchen.flip("steak")
        kitchen.step(30)
    assert len({k.state_hash for k in (frying, other, third, copy)}) == 1
    assert len({k.snapshot() for k in (frying, other, third, copy)}) == 1


def test_a_damaged_snapshot_is_refused(frying):
    snapshot = bytearray(frying.snapshot())
    snapshot[-1] ^= 1
    with pytest.raises(saute.SnapshotError, match="damaged"):
        frying.restore(bytes(snapshot))


def test_other_threads_of_python_run_while_a_kitchen_steps(frying):
    laps = 0
    stepping = threading.Thread(target=frying.step, args=(300,))
    stepping.start()
    while stepping.is_alive():
        laps += 1
        time.sleep(0)
    assert laps > 10
    assert frying.tick == 320


def test_the_pan_follows_a_pose_and_feels_the_weight_of_what_lies_in_it(frying):
    frying.step(30)
    frying.water(g=100)
    weight = 9.80665e-3 * (frying["steak"].mass_g + frying.water_g + frying.oil_g)
    frying.step(1)
    force = frying.pan_wrench[:3]
    assert force[2] == pytest.approx(-weight, rel=0.02)
    pose = frying.pan_pose_m.copy()
    pose[2] += 0.1
    frying.hold_pan(pose)
    lifting = []
    for _ in range(6):
        frying.step_frames(1)
        lifting.append(frying.pan_wrench[2])
    assert min(lifting) < 1.2 * force[2], "what is lifted weighs more"
    frying.step(20)
    assert frying.pan_pose_m == pytest.approx(pose, abs=1e-3)
    assert frying["steak"].pose_m[2] > 0.1


def test_a_piece_reads_the_present_state(frying):
    steak = frying["steak"]
    before = steak.core_c
    frying.step(100)
    assert steak.core_c > before
    assert steak.bottom["browned_pct"] >= 0 and set(steak.top) == set(steak.bottom)
    assert sum(steak.doneness_pct().values()) == pytest.approx(100)
    assert steak.lost_pct > 0 and steak.mass_g < steak.raw_mass_g
    assert frying.score("medium")["score"] < 100


def test_a_kitchen_has_the_stove_that_is_named():
    assert saute.hobs() == ["gas", "induction", "iron-plate", "radiant"]
    water_c = {}
    for hob in saute.hobs():
        kitchen = saute.Kitchen(hob=hob, pan="carbon-steel-26", pan_c=20)
        kitchen.water(500)
        kitchen.hob(w=1150)
        kitchen.step(600)
        water_c[hob] = kitchen.pan_c
        again = saute.Kitchen.from_snapshot(kitchen.snapshot())
        again.step(50)
        kitchen.step(50)
        assert again.pan_c == kitchen.pan_c
    assert water_c["induction"] > water_c["gas"] > water_c["iron-plate"]
    with pytest.raises(saute.RefusedError, match="no sensor"):
        saute.Kitchen(hob="gas").hob_hold(180)
    with pytest.raises(saute.InputError, match="gas, induction, iron-plate, radiant"):
        saute.Kitchen(hob="campfire")


NOT_A_NUMBER = [float("nan"), float("inf"), float("-inf"), 1e308, -1e308]

# A call with a number, and the range that its refusal names: the column of Python in docs/doors.md.
DOORS = [
    (lambda k, v: k.hob(w=v), "the hob gives 0 to"),
    (lambda k, v: k.hob_hold(c=v), "the hob holds"),
    (lambda k, v: k.hob_hold(c=180, w=v), "the hob gives 0 to"),
    (lambda k, v: k.put("steak", at_mm=(v, 0)), "finite|-200 to 200"),
    (lambda k, v: k.put("steak", at_mm=(0, v), heap=True), "finite|-200 to 200"),
    (lambda k, v: k.halve("steak", at_mm=v), "-150 to 150"),
    (lambda k, v: k.press("steak", n=v), "0 to 100"),
    (lambda k, v: k.press("steak", for_s=v), "0.1 to 600"),
    (lambda k, v: k.baste("steak", for_s=v), "0.1 to 600"),
    (lambda k, v: k.move("steak", to_mm=(v, 0)), "finite|-200 to 200"),
    (lambda k, v: k.move_pan(at_mm=(v, 0)), "finite|moved and lifted by up to"),
    (lambda k, v: k.move_pan(lift_mm=v), "0 to 500"),
    (lambda k, v: k.cool(for_s=v), "0.1 to 600"),
    (lambda k, v: k.toss(height_mm=v), "50 to 500"),
    (lambda k, v: k.shake(amplitude_mm=v), "0 to 100"),
    (lambda k, v: k.shake(hz=v), "0 to 8"),
    (lambda k, v: k.shake(for_s=v), "0.1 to 600"),
    (lambda k, v: k.tilt(v), "0 to 80"),
    (lambda k, v: k.tilt(10, towards_deg=v), "-360 to 360"),
    (lambda k, v: k.oil(g=v), "0 to 300"),
    (lambda k, v: k.butter(g=v), "0 to 300"),
    (lambda k, v: k.water(g=v), "0 to 1000"),
]


@pytest.mark.parametrize(("call", "expected"), DOORS)
@pytest.mark.parametrize("value", NOT_A_NUMBER)
def test_a_number_that_is_none_or_huge_is_refused_with_its_range_and_changes_nothing(kitchen, call, expected, value):
    before = kitchen.state_hash
    with pytest.raises((ValueError, saute.RefusedError), match=expected):
        call(kitchen, value)
    assert kitchen.state_hash == before
    kitchen.step(10)
    assert np.isfinite(kitchen.pan_c)


@pytest.mark.parametrize("value", [float("nan"), float("inf"), float("-inf")])
@pytest.mark.parametrize("at", range(7))
def test_a_pose_with_a_number_that_is_none_is_refused_and_the_pan_stays(kitchen, at, value):
    pose = [0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 1.0]
    pose[at] = value
    before = kitchen.state_hash
    with pytest.raises(ValueError, match="finite"):
        kitchen.hold_pan(pose)
    with pytest.raises(ValueError, match="finite"):
        kitchen.lead("turner", pose)
    assert kitchen.state_hash == before


@pytest.mark.parametrize("value", [1e308, -1e308, 3.0, -1.0])
def test_a_place_out_of_reach_is_held_at_its_edge(frying, value):
    frying.hold_pan([value, 0.0, 0.1, 0.0, 0.0, 0.0, 1.0])
    frying.step(10)
    assert np.isfinite(frying.pan_pose_m).all() and np.abs(frying.pan_pose_m[:3]).max() < 1
    assert np.isfinite(frying["steak"].core_c) and frying["steak"].place == "pan"
