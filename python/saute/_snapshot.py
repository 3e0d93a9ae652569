"""What a pickled kitchen is restored by."""

from __future__ import annotations

from ._core import Kitchen


def kitchen_of(snapshot, data=None):
    """Returns the kitchen of a snapshot, built with a folder of data."""
    return Kitchen.from_snapshot(snapshot, data)
