"""Gymnasium, which is optional."""

from __future__ import annotations

try:
    import gymnasium
    from gymnasium import spaces
    from gymnasium.vector.utils import batch_space
except ImportError as error:
    raise ImportError("saute.envs needs gymnasium: pip install 'saute[gym]'") from error

__all__ = ["batch_space", "gymnasium", "spaces"]
