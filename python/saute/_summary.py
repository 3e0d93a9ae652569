"""A recipe cooked to its end."""

from __future__ import annotations

import json

from . import _core


class Summary:
    """What a cook gave: its numbers, its time series, and the kitchen at the end.

    The keys of the numbers are attributes too: `summary.foods[0]["core_c"]["peak"]`.
    """

    def __init__(self, cooked):
        self._cooked = cooked
        self._numbers = json.loads(cooked.json())
        del self._numbers["wall_s"]

    def to_dict(self):
        """Returns the numbers as `saute cook --json` prints them, without `wall_s`: a dict of plain values, yours to change."""
        return json.loads(json.dumps(self._numbers))

    @property
    def series(self):
        """The time series: a dict of read-only arrays, by the columns of `series.csv`: `time_s`, `pan_c`, `steak.core_c` …"""
        return self._cooked.series()

    @property
    def kitchen(self):
        """The kitchen at the end: a separate `Kitchen` each time."""
        return self._cooked.kitchen()

    @property
    def is_done(self):
        """True if the recipe came to its end; False if a step was still waiting at `max_s`."""
        return self._cooked.is_done

    def to_pandas(self):
        """Returns the time series as a pandas DataFrame (needs pandas)."""
        return _imported("pandas", "frames").DataFrame(self.series)

    def to_polars(self):
        """Returns the time series as a Polars DataFrame (needs polars)."""
        return _imported("polars", "frames").DataFrame(self.series)

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self._numbers[name]
        except KeyError:
            raise AttributeError(f"a summary has no {name}; it has: {', '.join(self._numbers)}") from None

    def __dir__(self):
        return [*super().__dir__(), *self._numbers]

    def __repr__(self):
        foods = ", ".join(f"{food['id']} core {food['core_c']['peak']:.1f} °C" for food in self._numbers["foods"])
        return f"<saute.Summary {self._numbers['title']}: {self._numbers['simulated_s']} s; {foods}>"


def cook(recipe, data=None):
    """Cooks a recipe to its end and returns its `Summary`.

    Args:
        recipe: a dict, the text of a recipe in TOML, the path of a recipe file, or the name of a shipped recipe.
        data: a folder of your own foods, pans, recipes …, as the command's --data; its files go before the shipped ones.

    Raises:
        InputError: if the recipe cannot be used, or a step cannot be carried out.
    """
    return Summary(_core.cook(recipe, data))


def _imported(name, extra):
    """Imports a package that is optional."""
    import importlib

    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(f"this needs {name}: pip install 'saute[{extra}]'") from error
