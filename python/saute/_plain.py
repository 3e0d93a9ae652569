"""Values of NumPy and paths as plain values."""

from __future__ import annotations

import os


def plain(value):
    """Returns a value that JSON has, for one of NumPy or a path."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError(f"a recipe holds text, numbers, true or false, lists and dicts, not {type(value).__name__}")
