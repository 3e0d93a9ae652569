"""A steak in a small kitchen, quick enough for every test."""

import pytest

import saute

RECIPE = {
    "title": "a thin steak",
    "pan": {"kind": "carbon-steel-26", "initial_c": 180},
    "food": [{"id": "steak", "kind": "beef-lean", "size_mm": [80, 60, 15], "initial_c": 5}],
    "step": [
        {"hob_w": 1000},
        {"put": "steak"},
        {"at_s": 8, "flip": "steak"},
        {"after_s": 8, "rest": "steak"},
        {"at_s": 20, "end": True},
    ],
}


@pytest.fixture
def kitchen():
    """A steak that waits next to a pan at 180 °C, on a coarse mesh."""
    return saute.Kitchen(RECIPE, coarseness=3.0)


@pytest.fixture
def frying(kitchen):
    """The same steak after two seconds in the pan."""
    kitchen.hob(w=1000)
    kitchen.put("steak")
    kitchen.step(20)
    return kitchen
