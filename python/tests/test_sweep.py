"""Sweeps from Python: the files of the command, results that travel as bytes, and refusals."""

import builtins
import os
import pathlib
import shutil
import subprocess

import pytest

import saute
from own_kitchen import SPEC as OWN_SPEC
from own_kitchen import own_kitchen
from saute import _core

# One value of the specifications cannot be cooked.
pytestmark = pytest.mark.filterwarnings("ignore:some rows will fail")

SPEC = """recipe = "thin.toml"
for_s = 0.5
coarseness = 4
rows_per_part = 4
[vary]
"pan.initial_c" = { from = 20, to = 200, n = 3 }
"food.steak.size_mm[2]" = [12, 9000]
[design]
kind = "grid"
"""
THIN = """[pan]
kind = "carbon-steel-26"
[[food]]
id = "steak"
kind = "beef-lean"
size_mm = [60, 50, 15]
[[step]]
put = "steak"
[[step]]
at_s = 5
end = true
"""


@pytest.fixture
def spec(tmp_path):
    (tmp_path / "thin.toml").write_text(THIN)
    path = tmp_path / "spec.toml"
    path.write_text(SPEC)
    return path


def files(folder):
    return {path.name: path.read_bytes() for path in sorted(pathlib.Path(folder).iterdir())}


def test_the_files_are_those_of_the_command(spec, tmp_path):
    with pytest.warns(UserWarning, match="some rows will fail.*:7: .*9000"):
        told = saute.sweep(spec, tmp_path / "here", jobs=2)
    assert (told["rows"], told["done"], told["failed"], told["cooked"]) == (6, 6, 3, 6)
    subprocess.run([os.environ["SAUTE_PROGRAM"], "sweep", spec, "--out", tmp_path / "there"], check=False)
    assert files(told["path"]) == files(tmp_path / "there" / "rows")
    assert saute.sweep(spec, tmp_path / "here")["cooked"] == 0


def test_own_data_give_the_files_of_the_command_and_travel_with_the_sweep(tmp_path):
    data = own_kitchen(tmp_path / "data")
    spec = tmp_path / "spec.toml"
    spec.write_text(OWN_SPEC)
    told = saute.sweep(spec, tmp_path / "here", data=data, jobs=2)
    assert (told["rows"], told["done"], told["failed"]) == (12, 12, 4)
    subprocess.run([os.environ["SAUTE_PROGRAM"], "sweep", spec, "--out", tmp_path / "there", "--data", data], check=False)
    assert files(told["path"]) == files(tmp_path / "there" / "rows")
    parts = _core.Sweep(spec, data).parts()
    shutil.rmtree(data)
    elsewhere = _core.Sweep.of_parts(parts)
    folder = _core.SweepFolder(str(tmp_path / "elsewhere"), elsewhere)
    folder.take(elsewhere.run(list(range(12))))
    folder.close()
    assert files(tmp_path / "elsewhere" / "rows") == files(told["path"])


def test_own_data_that_cannot_be_used_are_refused_before_work_begins(tmp_path):
    data = own_kitchen(tmp_path / "data")
    with pytest.raises(saute.InputError, match="mine"):
        saute.sweep(OWN_SPEC, tmp_path / "out")
    with pytest.raises(saute.InputError, match="data is no folder"):
        saute.sweep(OWN_SPEC, tmp_path / "out", data=tmp_path / "nowhere")
    (data / "recipes" / "mine.toml").write_text("[pan]\nkind = 3\n")
    with pytest.raises(saute.InputError) as raised:
        saute.sweep(OWN_SPEC, tmp_path / "out", data=data)
    assert (raised.value.file, raised.value.line) == (str(data / "recipes" / "mine.toml"), 2)
    (data / "pans" / "my-pan.toml").write_text('name = "x"\nweight = 3\n')
    with pytest.raises(saute.InputError) as raised:
        saute.sweep(OWN_SPEC, tmp_path / "out", data=data)
    assert raised.value.file == str(data / "pans" / "my-pan.toml") and raised.value.remedy
    assert not (tmp_path / "out").exists()


def test_results_travel_as_bytes_in_any_order_and_twice(spec, tmp_path):
    planned = _core.Sweep(spec)
    elsewhere = _core.Sweep.of_parts(planned.parts())
    assert elsewhere.hash == planned.hash
    folder = _core.SweepFolder(str(tmp_path / "bytes"), planned)
    assert folder.next_rows(9) == [0, 1, 2, 3, 4, 5]
    for rows in ([5, 0], [3, 4, 0], [1, 2]):
        folder.take(elsewhere.run(rows))
    assert folder.tally() == (6, 6, 3, 6)
    folder.close()
    assert files(tmp_path / "bytes" / "rows") == files(saute.sweep(spec, tmp_path / "here")["path"])
    with pytest.raises(ValueError, match="no result"):
        _core.SweepFolder(str(tmp_path / "more"), planned).take([b"nothing"])
    with pytest.raises(ValueError, match="no sweep"):
        _core.Sweep.of_parts(b"nothing")
    with pytest.raises(ValueError, match="no row 6"):
        planned.run([6])


def test_mistakes_are_named_with_file_line_and_remedy(spec, tmp_path):
    spec.write_text(SPEC.replace("size_mm[2]", "size_m[2]"))
    with pytest.raises(saute.InputError) as raised:
        saute.sweep(spec, tmp_path / "out")
    assert (raised.value.file, raised.value.line) == (str(spec), 7)
    assert "size_mm" in raised.value.remedy
    with pytest.raises(saute.InputError, match="varry is no key"):
        saute.sweep({"recipe": "medium", "varry": {}}, tmp_path / "out")
    for wrong in ({"engine": "slurm"}, {"jobs": 0}, {"address": "10.0.0.1:6379"}):
        with pytest.raises(ValueError):
            saute.sweep(spec, tmp_path / "out", **wrong)
    assert not (tmp_path / "out").exists()


def test_without_ray_it_says_how_to_get_it(spec, tmp_path, monkeypatch):
    really = builtins.__import__

    def without_ray(name, *args, **kwargs):
        if name == "ray":
            raise ImportError("no module named ray")
        return really(name, *args, **kwargs)

    monkeypatch.setattr(builtins, "__import__", without_ray)
    with pytest.raises(ImportError, match="pip install"):
        saute.sweep(spec, tmp_path / "out", engine="ray")
    assert not (tmp_path / "out").exists()


def test_ctrl_c_keeps_what_is_done(spec, tmp_path, monkeypatch):
    from saute import _sweep

    spec.write_text(SPEC.replace("for_s = 0.5", "for_s = 5").replace("n = 3", "n = 60").replace("[12, 9000]", "[12, 15]"))

    def interrupted(self, rows, done, failed, fresh):
        raise KeyboardInterrupt

    monkeypatch.setattr(_sweep.Progress, "__call__", interrupted)
    with pytest.raises(KeyboardInterrupt):
        saute.sweep(spec, tmp_path / "out", jobs=1)
    monkeypatch.undo()
    planned = _core.Sweep(spec)
    rows, done, _, _ = _core.SweepFolder(str(tmp_path / "out"), planned).tally()
    assert rows == 120 and done < rows
