"""Sweeps on a Ray cluster: tasks cook batches of rows, this program writes the files.

A task is lost with its machine; Ray starts it again, and if it cannot, its rows are handed out again here. A result that comes
twice is taken once.
"""

from __future__ import annotations

import math
import os
import socket
import time

from . import _core

#: How long a batch takes [s] (chosen: a task costs a few milliseconds besides its rows, less than 5 % of this).
BATCH_S = 1.0
#: Most rows of a batch [-] (chosen: their results stay below a few megabytes).
MOST_ROWS = 1000
#: Tasks that wait or run for each core [-] (chosen: a core finds the next one at once).
TASKS_A_CORE = 2
#: How often a batch is handed out again after Ray gave up on it [-] (chosen: a machine that dies is not the fault of its rows).
MOST_LOSSES = 10
#: How long the first task may take to answer [s] (chosen: a process starts in seconds, also on a busy machine).
PATIENCE_S = 120.0
#: Object store of a cluster that is begun here [bytes] (chosen: room for hundreds of batches).
STORE = 200 * 2**20
#: How long an address may take to answer [s].
KNOCK_S = 5.0

_made = {}


def _sweep_of(parts, key):
    """Makes the sweep once in each process."""
    if key not in _made:
        _made.clear()
        _made[key] = _core.Sweep.of_parts(parts)
    return _made[key]


def _cook(parts, key, rows):
    """The task: results of rows as bytes, and the time that they took [s]."""
    sweep = _sweep_of(parts, key)
    begun = time.perf_counter()
    return sweep.run(rows), time.perf_counter() - begun


def _probe():
    """The task that reports which version of this package a machine has."""
    return _core.__version__


def cook_on_ray(sweep, out, address, jobs, watch):
    """Cooks what is missing of a sweep on a cluster; returns the counts of its folder."""
    ray = _ray()
    own = not ray.is_initialized()
    if own:
        _connect(ray, address)
    try:
        _check(ray, address)
        folder = _core.SweepFolder(out, sweep)
        try:
            _Cluster(ray, sweep, folder, jobs).cook(watch)
            return folder.tally()
        finally:
            folder.close()
    finally:
        if own:
            ray.shutdown()


def _ray():
    os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
    try:
        import ray
    except ImportError as error:
        raise ImportError('engine="ray" needs Ray: pip install "ray>=2.40", or use engine="local"') from error
    return ray


def _connect(ray, address):
    address = address or os.environ.get("RAY_ADDRESS")
    wrong = f"no Ray cluster answers at {address}: start one with ray start --head, or correct address"
    if address not in (None, "auto", "local"):
        _knock(address, wrong)
    # A separate cluster has little memory: results are small.
    alone = {} if address else {"include_dashboard": False, "object_store_memory": STORE}
    try:
        ray.init(address=address, log_to_driver=False, **alone)
    except (ConnectionError, RuntimeError, ValueError) as error:
        raise ConnectionError(f"{wrong} ({error})") from error


def _knock(address, wrong):
    """Ray itself waits for long where nobody answers."""
    host, _, port = address.rpartition("://")[2].rpartition(":")
    try:
        with socket.create_connection((host.strip("[]"), int(port)), timeout=KNOCK_S):
            return
    except (OSError, ValueError, OverflowError) as error:
        raise ConnectionError(f"{wrong} ({error})") from error


def _check(ray, address):
    """Makes sure that tasks run, with this version of the package, before work begins."""
    where = f"the Ray cluster{f' at {address}' if address else ''}"
    if ray.cluster_resources().get("CPU", 0) < 1:
        raise ConnectionError(f"{where} has no worker with a core: start one with ray start --address=…")
    probe = ray.remote(num_cpus=1)(_probe).remote()
    try:
        version = ray.get(probe, timeout=PATIENCE_S)
    except ray.exceptions.GetTimeoutError as error:
        ray.cancel(probe, force=True)
        raise ConnectionError(f"{where} took no task in {PATIENCE_S:.0f} s: see ray status") from error
    except ray.exceptions.RayError as error:
        raise ConnectionError(f"{where} cannot use the package saute {_core.__version__}: install it there ({error})") from error
    if version != _core.__version__:
        raise ConnectionError(f"{where} has saute {version}, this program {_core.__version__}: install the same one")


class _Cluster:
    """Batches of rows on their way."""

    def __init__(self, ray, sweep, folder, jobs):
        self._ray, self._folder, self._jobs = ray, folder, jobs
        self._task = ray.remote(num_cpus=1, max_retries=3)(_cook)
        self._parts, self._key = ray.put(sweep.parts()), sweep.hash
        self._pending = {}
        self._row_s = None
        self._losses = 0

    def cook(self, watch):
        try:
            while self._hand_out():
                ready, _ = self._ray.wait(list(self._pending), num_returns=1, timeout=0.5)
                for task in ready:
                    self._take(task)
                watch(*self._folder.tally())
        except BaseException:
            for task in self._pending:
                self._ray.cancel(task, force=True)
            raise

    def _hand_out(self):
        """Keeps every core busy; returns false when all is done."""
        cores = self._jobs or max(1, int(self._ray.cluster_resources().get("CPU", 1)))
        most = cores if self._jobs else TASKS_A_CORE * cores
        while len(self._pending) < most:
            rows = self._folder.next_rows(self._batch(cores))
            if not rows:
                break
            self._pending[self._task.remote(self._parts, self._key, rows)] = rows
        return bool(self._pending)

    def _batch(self, cores):
        """Returns how many rows a batch has: first one, then as many as take BATCH_S; at the end less, so that all cores end together."""
        if self._row_s is None:
            return 1
        rows, done, _, _ = self._folder.tally()
        left = rows - done - sum(map(len, self._pending.values()))
        even = math.ceil(left / (TASKS_A_CORE * cores))
        return max(1, min(round(BATCH_S / max(self._row_s, 1e-6)), even, MOST_ROWS))

    def _take(self, task):
        rows = self._pending.pop(task)
        errors = self._ray.exceptions
        try:
            results, spent = self._ray.get(task)
        except errors.RayTaskError:
            raise
        except errors.RayError as error:
            # Its machine is gone, and Ray gave up on it.
            self._losses += 1
            if self._losses > MOST_LOSSES:
                raise ConnectionError(f"the Ray cluster lost {self._losses} tasks, the last one so: {error}") from error
            self._folder.give_back(rows)
            return
        self._folder.take(results)
        row_s = spent / len(rows)
        self._row_s = row_s if self._row_s is None else 0.7 * self._row_s + 0.3 * row_s
