"""One kitchen, and many that step together, as environments of Gymnasium.

What they do is in a world: it has `batch`, `observation_space` and `action_space`, and the methods `begin(i, random, options)`, `look()`,
`act(actions, live)` (which kitchens ended by themselves, which are out of time, rewards), `seen()` and `said()`.
"""

from __future__ import annotations

import numpy as np

from ._gym import batch_space, gymnasium
from ._picture import Pictures
from ._seeds import generators


class OneKitchen(gymnasium.Env):
    """One kitchen, with pictures."""

    metadata = {"render_modes": list(Pictures.MODES), "render_fps": 20}

    def __init__(self, world, render_mode, size):
        self._world, self.render_mode, self._pictures = world, render_mode, Pictures(render_mode, size)
        self.observation_space, self.action_space = world.observation_space, world.action_space

    @property
    def kitchen(self):
        """The kitchen as it is now, to look at."""
        return self._world.batch[0]

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self._world.begin(0, self.np_random, options)
        self._world.look()
        self._pictures.show(self)
        return self._world.seen()[0], self._said()

    def step(self, action):
        ended, late, rewards = self._world.act(np.asarray(action)[None], np.array([True]))
        self._pictures.show(self)
        return self._world.seen()[0], float(rewards[0]), bool(ended[0]), bool(late[0]), self._said()

    def render(self):
        return self._pictures.frame(self)

    def close(self):
        self._pictures.close()

    def _said(self):
        return {name: values[0].item() for name, values in self._world.said().items()}


class ManyKitchens(gymnasium.vector.VectorEnv):
    """Many kitchens that step together. One that has ended begins again in the next step, in which its action does not count."""

    metadata = {"autoreset_mode": gymnasium.vector.AutoresetMode.NEXT_STEP, "render_modes": []}

    def __init__(self, world):
        self._world, self.num_envs, self.render_mode = world, len(world.batch), None
        self.single_observation_space, self.single_action_space = world.observation_space, world.action_space
        self.observation_space = batch_space(self.single_observation_space, self.num_envs)
        self.action_space = batch_space(self.single_action_space, self.num_envs)
        self._done = np.zeros(self.num_envs, dtype=bool)
        self._randoms = None

    def reset(self, *, seed=None, options=None):
        if seed is not None or self._randoms is None:
            self._randoms = generators(seed, self.num_envs)
        for i, random in enumerate(self._randoms):
            self._world.begin(i, random, {name: self._own(name, value, i) for name, value in (options or {}).items()})
        self._done[:] = False
        self._world.look()
        return self._world.seen(), self._world.said()

    def _own(self, name, value, i):
        """Returns the value of an option for one of the environments: it has a value for all, or a list of one for each."""
        if np.ndim(value) == 0:
            return value
        if len(value) != self.num_envs:
            raise ValueError(f"the option {name} must be a value or a list of {self.num_envs}, not of {len(value)}")
        return value[i]

    def step(self, actions):
        actions = np.asarray(actions)
        expected = self.action_space.shape
        if actions.shape != expected:
            raise ValueError(f"actions must have the shape {expected}, not {actions.shape}")
        again = self._done
        for i in np.flatnonzero(again):
            self._world.begin(int(i), self._randoms[i], None)
        if again.any():
            self._world.look()
        ended, late, rewards = self._world.act(actions, ~again)
        self._done = ended | late
        return self._world.seen(), rewards, ended, late, self._world.said()
