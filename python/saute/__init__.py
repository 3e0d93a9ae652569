"""saute: a frying pan, the food in it and the hands that move both, from Python.

    >>> import saute
    >>> kitchen = saute.Kitchen("medium")        # the kitchen of a shipped recipe, before its first step
    >>> kitchen.hob(w=2000)
    >>> kitchen.step(600)                        # a minute: 600 ticks of 0.1 s
    >>> kitchen.put("steak")
    >>> kitchen["steak"].core_c                  # °C

Units stand in the names: `_c` °C, `_k` kelvin, `_w` watts, `_g` grams, `_kg` kilograms, `_mm` millimetres, `_m` metres,
`_s` seconds, `_n` newtons, `_pct` per cent.
"""

from __future__ import annotations

from ._core import TICK_S, Kitchen, KitchenBatch, Piece, __version__, foods, hobs, oils, pans, recipes
from ._errors import GraphicsError, InputError, RefusedError, SnapshotError
from ._summary import Summary, cook
from ._sweep import sweep

__all__ = [
    "GraphicsError",
    "InputError",
    "Kitchen",
    "KitchenBatch",
    "Piece",
    "RefusedError",
    "SnapshotError",
    "Summary",
    "TICK_S",
    "__version__",
    "cook",
    "foods",
    "hobs",
    "oils",
    "pans",
    "recipes",
    "sweep",
]
