"""Sweeps on a Ray cluster of three raylets on 127.0.0.1, with one core each, one of which is killed."""

import os
import pathlib
import shutil
import subprocess
import sys

os.environ["RAY_USAGE_STATS_ENABLED"] = "0"
# Ray takes 127.0.0.1 in an address for the machine's own address in its network, where a cluster on 127.0.0.1 does not listen. It
# does not where clusters are off, as on macOS; that turns off nothing else that is used here.
os.environ["RAY_ENABLE_WINDOWS_OR_OSX_CLUSTER"] = "0"
# The folder of own data, next to the tests of sweeps on one machine.
sys.path.append(str(pathlib.Path(__file__).parent.parent / "tests"))

import pyarrow.parquet
import pytest
import ray
from own_kitchen import SPEC as OWN_SPEC
from own_kitchen import own_kitchen
from ray.cluster_utils import Cluster

import saute

HERE = "127.0.0.1"
#: What a raylet is made with. The object store [bytes] is small, as results are.
RAYLET = {"num_cpus": 1, "object_store_memory": 80 * 2**20, "node_ip_address": HERE}
ROWS = 72
SPEC = {
    "recipe": "medium",
    "for_s": 4.0,
    "coarseness": 4.0,
    "rows_per_part": 20,
    "vary": {
        "food.steak.size_mm[2]": {"from": 15.0, "to": 30.0},
        "pan.initial_c": {"from": 20.0, "to": 60.0},
    },
    "design": {"kind": "latin-hypercube", "n": ROWS, "seed": 7},
}


@pytest.fixture(scope="module")
def local(tmp_path_factory):
    """The files of the sweep as this machine alone makes them."""
    out = tmp_path_factory.mktemp("local")
    told = saute.sweep(SPEC, out, jobs=2)
    assert (told["rows"], told["done"], told["cooked"]) == (ROWS, ROWS, ROWS)
    return files(told["path"])


@pytest.fixture(scope="module")
def cluster():
    """Three raylets; the program is connected to them."""
    made = Cluster(initialize_head=True, head_node_args={**RAYLET, "include_dashboard": False})
    made.workers = [made.add_node(**RAYLET) for _ in range(2)]
    made.wait_for_nodes()
    yield made
    ray.shutdown()
    made.shutdown()


def files(folder):
    return {path.name: path.read_bytes() for path in sorted(pathlib.Path(folder).iterdir())}


@pytest.mark.filterwarnings("ignore:some rows will fail")
def test_own_data_travel_to_machines_that_do_not_have_them(cluster, tmp_path, monkeypatch):
    from saute import _sweep

    data, spec = own_kitchen(tmp_path / "data"), tmp_path / "spec.toml"
    spec.write_text(OWN_SPEC)
    program = os.environ["SAUTE_PROGRAM"]
    subprocess.run([program, "sweep", spec, "--out", tmp_path / "command", "--data", data], check=False)

    class WithoutTheFolder(_sweep.Progress):
        """It is made when the sweep was read, and before anything is handed out."""

        def __init__(self):
            super().__init__()
            shutil.rmtree(data)

    monkeypatch.setattr(_sweep, "Progress", WithoutTheFolder)
    told = saute.sweep(spec, tmp_path / "out", engine="ray", address=cluster.address, data=data)
    assert not data.exists()
    assert (told["rows"], told["done"], told["cooked"], told["failed"]) == (12, 12, 12, 4)
    assert files(told["path"]) == files(tmp_path / "command" / "rows")


def test_a_cluster_that_loses_a_machine_gives_the_rows_of_one_machine_bit_for_bit(cluster, local, tmp_path, monkeypatch):
    from saute import _sweep

    killed = []

    def watch(self, rows, done, failed, fresh):
        if done >= ROWS // 4 and not killed:
            killed.append(done)
            cluster.remove_node(cluster.workers.pop(), allow_graceful=False)

    monkeypatch.setattr(_sweep.Progress, "__call__", watch)
    assert cluster.address.startswith(f"{HERE}:")
    told = saute.sweep(SPEC, tmp_path / "out", engine="ray", address=cluster.address)
    assert killed and ROWS // 4 <= killed[0] < ROWS
    assert (told["rows"], told["done"], told["cooked"], told["failed"]) == (ROWS, ROWS, ROWS, 0)
    assert files(told["path"]) == local
    table = pyarrow.parquet.read_table(told["path"]).sort_by("row")
    assert table["row"].to_pylist() == list(range(ROWS))
    assert table.schema.field("vary.pan.initial_c").type == pyarrow.float64()
    assert set(table["status"].to_pylist()) == {"for_s"}


def test_a_sweep_that_one_machine_began_goes_on_on_the_cluster(cluster, local, tmp_path):
    planned = saute._core.Sweep(SPEC)
    folder = saute._core.SweepFolder(str(tmp_path), planned)
    folder.take(planned.run([0, 1, 2, 40]))
    folder.close()
    told = saute.sweep(SPEC, tmp_path, engine="ray", address=cluster.address)
    assert (told["done"], told["cooked"]) == (ROWS, ROWS - 4)
    assert files(told["path"]) == local


def test_a_wrong_address_is_named_before_work_begins(tmp_path):
    ray.shutdown()
    with pytest.raises(ConnectionError, match="no Ray cluster answers at 127.0.0.1:9"):
        saute.sweep(SPEC, tmp_path / "out", engine="ray", address="127.0.0.1:9")
    assert not (tmp_path / "out").exists()


def test_a_cluster_without_workers_is_named_before_work_begins(tmp_path):
    ray.shutdown()
    empty = Cluster(initialize_head=True, head_node_args={**RAYLET, "num_cpus": 0, "include_dashboard": False})
    try:
        with pytest.raises(ConnectionError, match="has no worker with a core"):
            saute.sweep(SPEC, tmp_path / "out", engine="ray", address=empty.address)
        assert not (tmp_path / "out").exists()
    finally:
        ray.shutdown()
        empty.shutdown()
