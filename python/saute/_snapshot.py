"""What a pickled kitchen is restored by."""

from __future__ import annotations

from ._core import Kitchen


def kitchen_of(snapshot):
    """Returns the kitchen of a snapshot."""
    return Kitchen.from_snapshot(snapshot)
