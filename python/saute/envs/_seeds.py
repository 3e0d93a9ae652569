"""Random generators of environments that step together."""

from __future__ import annotations

import numpy as np

from ._gym import gymnasium


def generators(seed, count):
    """Returns a generator for each environment: from a list of seeds, from one and its successors, or unseeded."""
    seeds = [None] * count if seed is None else seed
    if isinstance(seeds, (int, np.integer)):
        seeds = [int(seeds) + i for i in range(count)]
    if len(seeds) != count:
        raise ValueError(f"seed must be a number or {count} numbers, not {len(seeds)}")
    return [gymnasium.utils.seeding.np_random(one)[0] for one in seeds]
