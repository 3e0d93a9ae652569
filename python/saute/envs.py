"""Environments for Gymnasium: `saute/Steak-v1`, one steak in one pan (needs gymnasium: pip install 'saute[gym]').

    >>> import gymnasium
    >>> env = gymnasium.make("saute.envs:saute/Steak-v1", observation="cook")

**The task.** A steak of 15 to 35 mm lies in a hot pan. Once in each control period (1 s) one sets the hob and may turn the steak
over or take it out. When it is taken out, or when the time is over, it rests for five minutes on the board, the hob off, and the
episode ends.

**Action** `MultiDiscrete([10, 3])`: the setting of the hob, 0 to 9, of 250 W each; and 0 nothing, 1 turn over, 2 take out. A hand
that is still busy, or a steak that lies elsewhere, lets a turn go by.

**Reward**: 0, and at the end the score of `saute plan` in hundreds of points: the share of the section in the class of the target,
less what is missing of the crust, what is charred, what the core misses, lost mass, heat above 295 °C and work (docs/planning.md).
The best possible is below 1; a fire costs 1.

**Observation** `Box`, by preset. `cook` is what one sees from outside: see `COOK`. `scientist` adds what sensors would read: see
`SCIENTIST`. Each value is in the unit of its name, divided by the number beside it, so that it is of the order of one.
"""

from __future__ import annotations

import numpy as np

from . import Kitchen, KitchenBatch

try:
    import gymnasium
    from gymnasium import spaces
    from gymnasium.vector.utils import batch_space
except ImportError as error:
    raise ImportError("saute.envs needs gymnasium: pip install 'saute[gym]'") from error

ID = "saute/Steak-v1"

#: Settings of the hob [-] and the power of one of them [W].
HOB_SETTINGS = 10
HOB_W = 250.0
#: Choices of the thickness [mm] and the pan's temperature at the start [°C].
THICKNESS_MM = (15, 35)
PAN_C = (180, 240)

#: What a cook sees: name and scale of each value.
COOK = (
    ("time_s", 600.0),
    ("hob_w", 2250.0),
    ("since_flip_s", 300.0),
    ("flips", 10.0),
    ("in_pan", 1.0),
    ("thickness_mm", 30.0),
    ("top_lab_l", 100.0),
    ("top_lab_a", 100.0),
    ("top_lab_b", 100.0),
    ("top_browned_pct", 100.0),
    ("top_charred_pct", 100.0),
)
#: What a scientist reads besides.
SCIENTIST = (
    ("core_c", 100.0),
    ("core_peak_c", 100.0),
    ("top_c", 200.0),
    ("bottom_c", 200.0),
    ("pan_c", 250.0),
    ("lost_pct", 100.0),
    ("bottom_browned_pct", 100.0),
    ("bottom_charred_pct", 100.0),
)
PRESETS = {"cook": COOK, "scientist": COOK + SCIENTIST}

#: Spacing of the mesh over that of the default one [-] (docs/python.md has the table from which it was chosen).
COARSENESS = 2.0

#: Largest value of an observation, either way: what is beyond is cut off.
MOST = 10.0


class _Steaks:
    """Steaks in kitchens of their own, that step together."""

    def __init__(self, count, threads, observation, target, crust_pct, coarseness, control_s, max_s, rest_s):
        if observation not in PRESETS:
            raise ValueError(f"observation = {observation!r}: there are {', '.join(PRESETS)}")
        self.ticks = round(10 * control_s)
        if self.ticks < 1 or abs(self.ticks - 10 * control_s) > 1e-9:
            raise ValueError(f"control_s = {control_s}: give a multiple of 0.1 s")
        self.preset = PRESETS[observation]
        self.scales = np.array([scale for _, scale in self.preset])
        self.goal = {"target": target, "crust_pct": crust_pct}
        self.coarseness, self.max_s, self.rest_ticks = coarseness, max_s, round(10 * rest_s)
        self.observation_space = spaces.Box(-MOST, MOST, (len(self.preset),), np.float32)
        self.action_space = spaces.MultiDiscrete([HOB_SETTINGS, 3])
        first = self.kitchen(THICKNESS_MM[0], PAN_C[0])
        first.score(**self.goal)  # A target or a crust that means nothing is refused now.
        self.batch = KitchenBatch([first] * count, threads=threads)
        self.readings = self.batch.readings()
        self.thickness_mm = np.zeros(count)
        self.flips = np.zeros(count, dtype=int)
        self.flipped_s = np.zeros(count)

    def kitchen(self, thickness_mm, pan_c):
        """Returns a kitchen with the steak in the pan."""
        size = [120, 80, float(thickness_mm)]
        steak = {"id": "steak", "kind": "beef-lean", "size_mm": size, "outline": "plain"}
        kitchen = Kitchen({"pan": {"initial_c": float(pan_c)}, "food": [steak]}, coarseness=self.coarseness)
        kitchen.put("steak")
        return kitchen

    def begin(self, i, random, options):
        """Begins an episode in a kitchen: thickness and pan are drawn, or as the options say."""
        drawn = {
            "thickness_mm": int(random.integers(THICKNESS_MM[0], THICKNESS_MM[1] + 1)),
            "pan_c": int(random.integers(PAN_C[0], PAN_C[1] + 1)),
        }
        unknown = set(options or {}) - set(drawn)
        if unknown:
            raise ValueError(f"options may have thickness_mm and pan_c, not {', '.join(sorted(unknown))}")
        drawn.update(options or {})
        self.batch[i] = self.kitchen(**drawn)
        self.thickness_mm[i], self.flips[i], self.flipped_s[i] = drawn["thickness_mm"], 0, 0.0

    def look(self):
        """Reads all kitchens anew."""
        self.readings = self.batch.readings()

    def act(self, actions, live):
        """One control period in the kitchens that are live; returns which steaks were taken out and which are out of time."""
        before = self.readings
        can = live & (before["in_pan"][:, 0] > 0) & (before["busy"] == 0)
        turned, taken = can & (actions[:, 1] == 1), live & (actions[:, 1] == 2) & (before["in_pan"][:, 0] > 0)
        self.batch.hob(np.where(live, actions[:, 0] * HOB_W, before["hob_w"]), where=live.tolist())
        self.batch.flip("steak", where=turned.tolist())
        self.flips[turned] += 1
        self.flipped_s[turned] = before["time_s"][turned]
        self.batch.rest("steak", where=taken.tolist())
        self.readings = self.batch.step(self.ticks)
        late = live & ~taken & (self.readings["time_s"] >= self.max_s - 1e-6)
        return taken, late

    def settle(self, taken, late):
        """Lets the steaks of ended episodes rest; returns their scores in hundreds of points."""
        places = [int(i) for i in np.flatnonzero(taken | late)]
        scores = np.zeros(len(taken))
        if not places:
            return scores
        resting = KitchenBatch([self.batch[i] for i in places], threads=self.batch.threads)
        resting.hob(0.0)
        out = late[places] & (resting.readings()["in_pan"][:, 0] > 0)
        resting.rest("steak", where=out.tolist())
        resting.step(self.rest_ticks)
        scores[places] = resting.scores(flips=[int(self.flips[i]) for i in places], **self.goal) / 100
        for seat, i in enumerate(places):
            self.batch[i] = resting[seat]
        self.look()
        return scores

    def seen(self):
        """Returns the observations, one in each row."""
        readings = self.readings
        own = {
            "since_flip_s": readings["time_s"] - self.flipped_s,
            "flips": self.flips,
            "thickness_mm": self.thickness_mm,
        }
        columns = [own[name] if name in own else readings[name].reshape(len(readings)) for name, _ in self.preset]
        return np.clip(np.stack(columns, axis=1) / self.scales, -MOST, MOST).astype(np.float32)

    def said(self):
        """Returns what the information of a step holds, an array for each name."""
        names = ("time_s", "core_c", "core_peak_c", "pan_c")
        return {name: self.readings[name].reshape(len(self.readings)) for name in names} | {"flips": self.flips.copy()}


class SteakEnv(gymnasium.Env):
    """One steak in one pan; see the page of `saute.envs`.

    Args:
        observation: "cook" or "scientist".
        target: a class of doneness, or "core=54" [°C].
        crust_pct: browned share of the faces that is wanted [%].
        coarseness: spacing of the mesh over that of the default one [-], 1 to 8.
        control_s: control period [s], a multiple of 0.1.
        max_s: longest time in the pan [s].
        rest_s: time that it rests [s].
        render_mode: None, "rgb_array" or "human" (needs pygame).
        size: width and height of a picture [px].
    """

    metadata = {"render_modes": ["rgb_array", "human"], "render_fps": 10}

    def __init__(
        self,
        observation="scientist",
        target="medium",
        crust_pct=60.0,
        coarseness=COARSENESS,
        control_s=1.0,
        max_s=1200.0,
        rest_s=300.0,
        render_mode=None,
        size=(480, 360),
    ):
        if render_mode not in (None, *self.metadata["render_modes"]):
            raise ValueError(f"render_mode = {render_mode!r}: there are None, 'rgb_array' and 'human'")
        self._steaks = _Steaks(1, 1, observation, target, crust_pct, coarseness, control_s, max_s, rest_s)
        self.observation_space, self.action_space = self._steaks.observation_space, self._steaks.action_space
        self.render_mode, self._size = render_mode, tuple(size)
        self._window = None

    @property
    def kitchen(self):
        """The kitchen as it is now: a copy, to look at."""
        return self._steaks.batch[0]

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self._steaks.begin(0, self.np_random, options)
        self._steaks.look()
        self._show()
        return self._steaks.seen()[0], self._said()

    def step(self, action):
        live = np.array([True])
        taken, late = self._steaks.act(np.asarray(action).reshape(1, 2), live)
        reward = float(self._steaks.settle(taken, late)[0])
        self._show()
        return self._steaks.seen()[0], reward, bool(taken[0]), bool(late[0]), self._said()

    def render(self):
        if self.render_mode == "rgb_array":
            return self.kitchen.render(self._size).copy()
        return None

    def close(self):
        if self._window is not None:
            import pygame

            pygame.quit()
            self._window = None

    def _said(self):
        return {name: values[0].item() for name, values in self._steaks.said().items()}

    def _show(self):
        """Shows the present frame in a window, for people."""
        if self.render_mode != "human":
            return
        try:
            import pygame
        except ImportError as error:
            raise ImportError("render_mode='human' needs pygame: pip install 'saute[gym]'") from error
        frame = self.kitchen.render(self._size)
        if self._window is None:
            pygame.init()
            pygame.display.set_caption("saute")
            self._window = pygame.display.set_mode(self._size)
        pygame.event.pump()
        self._window.blit(pygame.surfarray.make_surface(frame.swapaxes(0, 1)), (0, 0))
        pygame.display.flip()


class SteakVectorEnv(gymnasium.vector.VectorEnv):
    """Many steaks, each in a pan of its own, that step together on all cores without Python between them.

    Every environment gives what `SteakEnv` gives with the same seed, for any number of threads. An environment that has ended
    begins anew in the next step, in which its action does not count.

    Args:
        num_envs: number of environments.
        threads: number of threads; None for all cores.
        The others are those of `SteakEnv`; there are no pictures.
    """

    metadata = {"autoreset_mode": gymnasium.vector.AutoresetMode.NEXT_STEP, "render_modes": []}

    def __init__(
        self,
        num_envs=1,
        threads=None,
        observation="scientist",
        target="medium",
        crust_pct=60.0,
        coarseness=COARSENESS,
        control_s=1.0,
        max_s=1200.0,
        rest_s=300.0,
    ):
        self.num_envs, self.render_mode = num_envs, None
        self._steaks = _Steaks(
            num_envs, threads, observation, target, crust_pct, coarseness, control_s, max_s, rest_s
        )
        self.single_observation_space = self._steaks.observation_space
        self.single_action_space = self._steaks.action_space
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._done = np.zeros(num_envs, dtype=bool)
        self._randoms = None

    def reset(self, *, seed=None, options=None):
        if seed is not None or self._randoms is None:
            seeds = [None] * self.num_envs if seed is None else seed
            if isinstance(seeds, (int, np.integer)):
                seeds = [int(seeds) + i for i in range(self.num_envs)]
            if len(seeds) != self.num_envs:
                raise ValueError(f"seed must be a number or {self.num_envs} numbers, not {len(seeds)}")
            self._randoms = [gymnasium.utils.seeding.np_random(one)[0] for one in seeds]
        for i, random in enumerate(self._randoms):
            self._steaks.begin(i, random, options)
        self._done[:] = False
        self._steaks.look()
        return self._steaks.seen(), self._steaks.said()

    def step(self, actions):
        actions = np.asarray(actions)
        if actions.shape != (self.num_envs, 2):
            raise ValueError(f"actions must have the shape ({self.num_envs}, 2), not {actions.shape}")
        again = self._done.copy()
        for i in np.flatnonzero(again):
            self._steaks.begin(int(i), self._randoms[i], None)
        if again.any():
            self._steaks.look()
        held = [(int(i), self._steaks.batch[int(i)]) for i in np.flatnonzero(again)]
        taken, late = self._steaks.act(actions, ~again)
        for i, kitchen in held:
            self._steaks.batch[i] = kitchen
        if held:
            self._steaks.look()
        self._done = taken | late
        rewards = self._steaks.settle(taken, late)
        return self._steaks.seen(), rewards, taken, late, self._steaks.said()


def register():
    """Makes the environments known to Gymnasium."""
    if ID not in gymnasium.registry:
        gymnasium.register(ID, entry_point="saute.envs:SteakEnv", vector_entry_point="saute.envs:SteakVectorEnv")


register()
