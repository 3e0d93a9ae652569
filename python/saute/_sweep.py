"""Sweeps: a recipe cooked many times with values that vary."""

from __future__ import annotations

import os
import sys
import time
import warnings

from . import _core

ENGINES = ("local", "ray")


def sweep(spec, out, engine="local", address=None, jobs=None, data=None):
    """Cooks all rows of a sweep that are not in a folder yet; returns how many there are.

    Args:
        spec: the specification, as `saute sweep` reads it: the path of a file, its text, or a dict,
            whose values under `vary` go by their names.
        out: the folder of the results, `rows/part-*.parquet` in it. A sweep that was broken off goes on where it was.
        engine: "local" for the cores of this machine, "ray" for those of a Ray cluster. The files are the same.
        address: of the Ray cluster, as "10.0.0.1:6379"; by default the one that this program is connected to, that of the
            variable RAY_ADDRESS, or a new one on this machine.
        jobs: cooks at the same time; by default as many as there are cores.
        data: a folder of your own foods, pans and recipes, as the command's `--data`. Only this machine needs it.

    Returns:
        A dict: `path` of the Parquet files, numbers of `rows`, those that are `done`, `failed` and were `cooked` in this call, and
        `wall_s` [s].

    Raises:
        InputError: the specification, its recipe, the data or the folder cannot be used.
        ImportError: the engine is "ray", and Ray is not installed.
        ConnectionError: no Ray cluster answers, or none of its machines can cook.
    """
    if engine not in ENGINES:
        raise ValueError(f"engine must be one of {', '.join(ENGINES)}, not {engine!r}")
    if address is not None and engine != "ray":
        raise ValueError('address is for engine="ray"')
    if jobs is not None and (not isinstance(jobs, int) or jobs < 1):
        raise ValueError(f"jobs must be a whole number of 1 or more, not {jobs!r}")
    begun = time.monotonic()
    planned = _core.Sweep(spec, data)
    for doubt in planned.doubts:
        warnings.warn(f"some rows will fail: {doubt}", stacklevel=2)
    progress = Progress()
    try:
        if engine == "ray":
            from ._sweep_ray import cook_on_ray

            counts = cook_on_ray(planned, os.fspath(out), address, jobs, progress)
        else:
            counts = _core.SweepFolder(os.fspath(out), planned).cook_all(jobs, progress)
    finally:
        progress.end()
    rows, done, failed, cooked = counts
    path = os.path.join(os.fspath(out), "rows")
    wall_s = time.monotonic() - begun
    return {"path": path, "rows": rows, "done": done, "failed": failed, "cooked": cooked, "wall_s": wall_s}


class Progress:
    """A line on a terminal: rows, rate and time left."""

    def __init__(self):
        self._begun = time.monotonic()
        self._shown = False

    def __call__(self, rows, done, failed, fresh):
        if not sys.stderr.isatty():
            return
        text = f"{done} of {rows} rows" + (f", {failed} failed" if failed else "")
        if fresh:
            rate = fresh / (time.monotonic() - self._begun)
            text += f", {rate:.1f} a second, {(rows - done) / rate:.0f} s left"
        # The end of a longer line before it is cleared.
        print(f"\r{text}\x1b[K", end="", file=sys.stderr, flush=True)
        self._shown = True

    def end(self):
        if self._shown:
            print(file=sys.stderr)
