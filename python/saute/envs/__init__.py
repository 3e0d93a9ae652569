"""Environments for Gymnasium (they need it: pip install 'saute[gym]').

    >>> import gymnasium
    >>> env = gymnasium.make("saute.envs:saute/Steak-v1", observation="cook")

`saute/Steak-v1` is one steak in one pan (`saute.envs.steak`); `saute/StirFry-v1` is a pan in the hand, a turner and vegetables
(`saute.envs.stir_fry`).
"""

from __future__ import annotations

from ._gym import gymnasium
from .steak import SteakEnv, SteakVectorEnv
from .stir_fry import StirFryEnv, StirFryVectorEnv

__all__ = ["SteakEnv", "SteakVectorEnv", "StirFryEnv", "StirFryVectorEnv", "register"]

#: Name of each environment, and what makes one and many of it.
ENVIRONMENTS = {
    "saute/Steak-v1": ("saute.envs.steak:SteakEnv", "saute.envs.steak:SteakVectorEnv"),
    "saute/StirFry-v1": ("saute.envs.stir_fry:StirFryEnv", "saute.envs.stir_fry:StirFryVectorEnv"),
}


def register():
    """Makes the environments known to Gymnasium."""
    for name, (one, many) in ENVIRONMENTS.items():
        if name not in gymnasium.registry:
            gymnasium.register(name, entry_point=one, vector_entry_point=many)


register()
