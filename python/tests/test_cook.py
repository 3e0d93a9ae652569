"""Cooks: the same numbers as the command, frames, and errors with their place."""

import json
import os
import subprocess

import numpy as np
import pytest

import saute
from conftest import RECIPE

THIN = """title = "thin"
[pan]
initial_c = 180
[[food]]
id = "steak"
kind = "beef-lean"
size_mm = [60, 50, 15]
mesh = "2013"
[[step]]
put = "steak"
[[step]]
at_s = 5
end = true
"""


@pytest.fixture(scope="module")
def thin():
    return saute.cook(THIN)


def test_the_numbers_are_those_of_the_command(thin, tmp_path):
    program = os.environ.get("SAUTE_PROGRAM")
    if program is None:
        pytest.skip("SAUTE_PROGRAM names no saute")
    path = tmp_path / "thin.toml"
    path.write_text(THIN)
    said = subprocess.run([program, "cook", str(path), "--json"], check=True, capture_output=True, text=True)
    expected = json.loads(said.stdout)
    del expected["wall_s"]
    assert thin.to_dict() == expected
    assert json.dumps(thin.to_dict()) == json.dumps(expected), "the order of the keys is the same too"


def test_a_dict_cooks_as_its_text(thin):
    recipe = {
        "title": "thin",
        "pan": {"initial_c": np.int64(180)},
        "food": [{"id": "steak", "kind": "beef-lean", "size_mm": np.array([60, 50, 15]), "mesh": "2013"}],
        "step": [{"put": "steak"}, {"at_s": 5.0, "end": True}],
    }
    assert saute.cook(recipe).to_dict() == thin.to_dict()


def test_a_summary_has_its_series_its_kitchen_and_its_keys(thin):
    series = thin.series
    assert list(series)[:4] == ["time_s", "hob_drawn_w", "pan_c", "steak.core_c"]
    assert series["time_s"][-1] == 5 and len(series["steak.mass_g"]) == len(series["time_s"])
    assert thin.kitchen["steak"].core_c == pytest.approx(thin.foods[0]["core_c"]["end"])
    assert thin.is_done and thin.title == "thin"
    with pytest.raises(AttributeError, match="it has: title"):
        thin.taste


def test_the_series_is_a_frame_of_pandas(thin):
    pytest.importorskip("pandas")
    frame = thin.to_pandas()
    assert frame["time_s"].iloc[-1] == 5 and "steak.core_c" in frame.columns


def test_the_series_is_a_frame_of_polars(thin):
    pytest.importorskip("polars")
    assert thin.to_polars()["time_s"][-1] == 5


def test_an_error_tells_file_key_line_and_remedy(tmp_path):
    path = tmp_path / "hot.toml"
    path.write_text('[pan]\nkind = "carbon-steel-26"\ninitial_c = 900\n')
    with pytest.raises(saute.InputError) as caught:
        saute.cook(path)
    error = caught.value
    assert (error.file, error.key, error.line) == (str(path), "pan.initial_c", 3)
    assert "out of range" in error.message and "0 to 300" in error.remedy
    assert f"{path}:3" in str(error) and "remedy" in str(error)


def test_an_error_in_a_dict_tells_the_key():
    recipe = {**RECIPE, "food": [RECIPE["food"][0], {"id": "b", "kind": "unicorn"}]}
    with pytest.raises(saute.InputError) as caught:
        saute.cook(recipe)
    assert caught.value.key == "food[1].kind" and caught.value.line is None
    assert "shrimp" in caught.value.remedy


@pytest.mark.parametrize(
    ("recipe", "words"),
    [
        ("no-such-recipe", "no recipe with this name"),
        ({"food": None}, "no recipe"),
        ({"pan": {"initial_c": float("nan")}}, "no recipe"),
        ("pan = 3", "pan"),
        ({"wine": 1}, "wine"),
    ],
)
def test_what_is_no_recipe_is_refused(recipe, words):
    with pytest.raises(saute.InputError, match=words):
        saute.cook(recipe)


def test_what_no_recipe_can_hold_is_refused():
    with pytest.raises(TypeError, match="a recipe holds text, numbers"):
        saute.cook({"pan": {"initial_c": object()}})
    with pytest.raises(TypeError, match="must be a dict"):
        saute.cook(3)


def test_an_optional_package_that_is_missing_is_named(thin, monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "polars", None)
    with pytest.raises(ImportError, match=r"pip install 'saute\[frames\]'"):
        thin.to_polars()
