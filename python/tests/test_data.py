"""A folder of the user's own foods, pans and recipes, as the command's `--data`."""

import os
import pathlib
import pickle

import pytest

import saute
from conftest import RECIPE

PANS = pathlib.Path(__file__).parent.parent.parent / "data" / "pans"


@pytest.fixture
def data(tmp_path):
    """A folder with a recipe and a pan of one's own."""
    (tmp_path / "recipes").mkdir()
    (tmp_path / "recipes" / "mine.toml").write_text(
        'title = "mine"\n[pan]\nkind = "my-pan"\ninitial_c = 150\n[[food]]\nid = "steak"\nkind = "beef-lean"\n'
        'size_mm = [60, 50, 15]\nmesh = "2013"\n[[step]]\nput = "steak"\n[[step]]\nat_s = 2\nend = true\n'
    )
    (tmp_path / "pans").mkdir()
    shipped = (PANS / "carbon-steel-26.toml").read_text(encoding="utf-8")
    (tmp_path / "pans" / "my-pan.toml").write_text(shipped, encoding="utf-8")
    return tmp_path


def test_own_pans_and_recipes_are_found_by_name(data):
    kitchen = saute.Kitchen("mine", data=data)
    assert kitchen.pan_name and kitchen["steak"].kind == "beef-lean"
    assert saute.Kitchen(pan="my-pan", data=str(data)).pan_c == pytest.approx(20, abs=10)
    assert saute.cook("mine", data=data).title == "mine"
    with pytest.raises(saute.InputError, match="my-pan"):
        saute.Kitchen(pan="my-pan")


def test_a_kitchen_with_own_data_is_stored_and_goes_on(data):
    kitchen = saute.Kitchen("mine", data=data)
    kitchen.put("steak")
    kitchen.step(5)
    again = pickle.loads(pickle.dumps(kitchen))
    restored = saute.Kitchen.from_snapshot(kitchen.snapshot(), data=data)
    for one in (kitchen, again, restored):
        one.step(5)
    assert kitchen.state_hash == again.state_hash == restored.state_hash
    with pytest.raises(saute.SnapshotError):
        saute.Kitchen.from_snapshot(kitchen.snapshot())


def test_a_broken_file_is_named_with_its_line(data):
    (data / "pans" / "my-pan.toml").write_text('name = "x"\nweight = 3\n')
    with pytest.raises(saute.InputError) as caught:
        saute.Kitchen("mine", data=data)
    assert caught.value.file == str(data / "pans" / "my-pan.toml") and caught.value.line >= 1
    assert caught.value.remedy


def test_a_folder_that_is_none_or_holds_nothing_is_refused(tmp_path):
    with pytest.raises(saute.InputError, match="data is no folder"):
        saute.Kitchen(RECIPE, data=tmp_path / "nowhere")
    with pytest.raises(saute.InputError, match="none of the folders") as caught:
        saute.cook(RECIPE, data=tmp_path)
    assert "foods/" in caught.value.remedy


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="the system has no pipes in folders")
def test_a_pipe_a_device_and_a_link_out_of_the_folder_are_refused_before_they_are_opened(data, tmp_path_factory):
    pipe = data / "foods" / "mine.toml"
    pipe.parent.mkdir()
    os.mkfifo(pipe)
    with pytest.raises(saute.InputError, match=r"mine\.toml.* is a pipe or a device, not a file"):
        saute.Kitchen("mine", data=data)
    with pytest.raises(saute.InputError, match="is a pipe or a device, not a file"):
        saute.Kitchen(str(pipe))
    with pytest.raises(saute.InputError, match="is a pipe or a device, not a file"):
        saute.cook(pathlib.Path("/dev/zero"))
    pipe.unlink()
    secret = tmp_path_factory.mktemp("elsewhere") / "secret.toml"
    secret.write_text("secret")
    pipe.symlink_to(secret)
    with pytest.raises(saute.InputError, match=r"mine\.toml.* leads out of data, to .*secret\.toml") as caught:
        saute.Kitchen("mine", data=data)
    assert caught.value.remedy == "copy the file into the folder"
    pipe.unlink()
    os.mkfifo(data / "goals.toml")
    with pytest.raises(saute.InputError, match=r"goals\.toml.* is a pipe or a device"):
        saute.Kitchen("mine", data=data)
