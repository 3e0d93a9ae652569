"""`saute/Steak-v1`: one steak in one pan.

**The task.** A steak of 15 to 35 mm lies in a hot pan. Once in each control period (1 s) one sets the hob and may turn the steak
over or take it out. When it is taken out, or when the time is over, it rests for five minutes on the board, the hob off, and the
episode ends.

**Action** `MultiDiscrete([10, 3])`: the setting of the hob, 0 to 9, of 250 W each; and 0 nothing, 1 turn over, 2 take out. A hand
that is still busy, or a steak that is elsewhere, lets a turn go by.

**Reward**: 0, and at the end the score of `saute plan` in hundreds of points: the share of the section in the class of the target,
less what is missing of the crust, what is charred, what the core misses, lost mass, heat above 295 °C and work (docs/planning.md).
The best possible is below 1; a fire costs 1.

**Observation** `Box`, by preset. `cook` is what one sees from outside: see `COOK`. `scientist` adds what sensors would read: see
`SCIENTIST`. Each value is in the unit of its name, divided by the number next to it, so that it is of the order of one.

**Mesh.** `mesh="reduced"` is that of forecasts: slices of few columns, a coarse pan and steps of half a second. `mesh="full"` is the
mesh of recipes, with bodies that move; a number is its spacing over that of the full one. docs/python.md compares them.
"""

from __future__ import annotations

import numpy as np

from .. import Kitchen, KitchenBatch
from ._gym import spaces
from ._shell import ManyKitchens, OneKitchen

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

#: Time before the end in which no turn begins [s] (chosen: the longest flip).
LAST_TURN_S = 3.0
#: Ticks that the steak lies in the pan before an episode begins [-] (chosen: after them it has settled).
SETTLING_TICKS = 10

#: Largest value of an observation, either way: what is beyond is cut off.
MOST = 10.0


def spacing(mesh):
    """Returns the spacing of a mesh over that of the full one, and whether it is reduced."""
    if mesh in ("reduced", "full"):
        return 1.0, mesh == "reduced"
    if isinstance(mesh, str):
        raise ValueError(f"mesh = {mesh!r}: there are 'reduced' and 'full', or a number from 1 to 8")
    return float(mesh), False


class _Steaks:
    """Steaks in separate kitchens that step together."""

    def __init__(self, count, threads, observation, target, crust_pct, mesh, control_s, max_s, rest_s):
        if observation not in PRESETS:
            raise ValueError(f"observation = {observation!r}: there are {', '.join(PRESETS)}")
        self.coarseness, self.reduced = spacing(mesh)
        self.ticks, self.rest_ticks = (self.whole_ticks(s, name) for s, name in ((control_s, "control_s"), (rest_s, "rest_s")))
        self.preset = PRESETS[observation]
        self.scales = np.array([scale for _, scale in self.preset])
        self.goal = {"target": target, "crust_pct": crust_pct}
        self.max_s = max_s
        self.observation_space = spaces.Box(-MOST, MOST, (len(self.preset),), np.float32)
        self.action_space = spaces.MultiDiscrete([HOB_SETTINGS, 3])
        first = self.kitchen(THICKNESS_MM[0], PAN_C[0])
        first.score(**self.goal)  # A target or a crust that means nothing is refused now.
        self.batch = KitchenBatch([first] * count, threads=threads, reduced=self.reduced)
        self.readings = self.batch.readings()
        self.thickness_mm = np.zeros(count)
        self.flips = np.zeros(count, dtype=int)
        self.flipped_s = np.zeros(count)

    def whole_ticks(self, seconds, name):
        """Returns a time in ticks."""
        unit = 5 if self.reduced else 1
        ticks = round(10 * seconds)
        if ticks < unit or ticks % unit or abs(ticks - 10 * seconds) > 1e-9:
            raise ValueError(f"{name} = {seconds}: give a multiple of {unit / 10} s")
        return ticks

    def kitchen(self, thickness_mm, pan_c):
        """Returns a kitchen with the steak in the pan."""
        size = [120, 80, float(thickness_mm)]
        steak = {"id": "steak", "kind": "beef-lean", "size_mm": size, "outline": "plain"}
        kitchen = Kitchen({"pan": {"initial_c": float(pan_c)}, "food": [steak]}, coarseness=self.coarseness)
        kitchen.put("steak")
        kitchen.step(SETTLING_TICKS)
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
        """Reads all kitchens again."""
        self.readings = self.batch.readings()

    def time_s(self):
        """Returns the times since the episodes began."""
        return self.readings["time_s"] - 0.1 * SETTLING_TICKS

    def act(self, actions, live):
        """One control period in the kitchens that are live; returns which steaks were taken out and which are out of time.

        The episodes that end rest in the same step; the scores are in hundreds of points.
        """
        before, time_s = self.readings, self.time_s()
        lies = live & (before["in_pan"][:, 0] > 0)
        in_time = time_s < self.max_s - LAST_TURN_S
        turned = lies & in_time & (before["busy"] == 0) & (actions[:, 1] == 1)
        taken = lies & (actions[:, 1] == 2)
        late = live & ~taken & (time_s + 0.1 * self.ticks >= self.max_s - 1e-6)
        self.batch.hob(np.where(live, actions[:, 0] * HOB_W, before["hob_w"]), where=live.tolist())
        self.flip(turned, time_s)
        self.batch.rest("steak", where=taken.tolist())
        self.readings = self.batch.step(np.where(live, self.ticks, 0).tolist())
        return taken, late, self.settle(taken, late)

    def flip(self, turned, time_s):
        """Turns steaks over, and notes it."""
        self.batch.flip("steak", where=turned.tolist())
        self.flips[turned] += 1
        self.flipped_s[turned] = time_s[turned]

    def settle(self, taken, late):
        """Lets the steaks of ended episodes rest; returns their scores in hundreds of points."""
        ended = taken | late
        scores = np.zeros(len(taken))
        if not ended.any():
            return scores
        self.batch.hob(0.0, where=ended.tolist())
        out = late & (self.readings["in_pan"][:, 0] > 0)
        self.batch.rest("steak", where=out.tolist())
        self.readings = self.batch.step(np.where(ended, self.rest_ticks, 0).tolist())
        scores[ended] = self.batch.scores(flips=self.flips.tolist(), where=ended.tolist(), **self.goal) / 100
        return scores

    def seen(self):
        """Returns the observations, one in each row."""
        readings, time_s = self.readings, self.time_s()
        own = {
            "time_s": time_s,
            "since_flip_s": time_s - self.flipped_s,
            "flips": self.flips,
            "thickness_mm": self.thickness_mm,
        }
        columns = [own[name] if name in own else readings[name].reshape(len(readings)) for name, _ in self.preset]
        return np.clip(np.stack(columns, axis=1) / self.scales, -MOST, MOST).astype(np.float32)

    def said(self):
        """Returns the information of a step, an array for each name."""
        names = ("core_c", "core_peak_c", "pan_c")
        read = {name: self.readings[name].reshape(len(self.readings)) for name in names}
        return {"time_s": self.time_s()} | read | {"flips": self.flips.copy()}


class SteakEnv(OneKitchen):
    """One steak in one pan; see the page of `saute.envs.steak`.

    Args:
        observation: "cook" or "scientist".
        target: a class of doneness, or "core=54" [°C].
        crust_pct: browned share of the faces that is the target [%].
        mesh: "reduced", "full", or the spacing of the mesh over that of the full one [-], 1 to 8.
        control_s: control period [s], a multiple of 0.1, on the reduced mesh of 0.5.
        max_s: longest time in the pan [s].
        rest_s: time that it rests [s].
        render_mode: None, "rgb_array" or "human" (needs pygame).
        size: width and height of a picture [px].
    """

    def __init__(
        self,
        observation="scientist",
        target="medium",
        crust_pct=60.0,
        mesh="reduced",
        control_s=1.0,
        max_s=1200.0,
        rest_s=300.0,
        render_mode=None,
        size=(480, 360),
    ):
        world = _Steaks(1, 1, observation, target, crust_pct, mesh, control_s, max_s, rest_s)
        super().__init__(world, render_mode, size)


class SteakVectorEnv(ManyKitchens):
    """Many steaks, each in its own pan, that step together on all cores without Python between them.

    Every environment gives what `SteakEnv` gives with the same seed, for any number of threads. An environment that has ended
    begins again in the next step, in which its action does not count.

    Args:
        num_envs: number of environments.
        threads: number of threads; None for all cores.
        The others are those of `SteakEnv`; there are no pictures.
    """

    def __init__(
        self,
        num_envs=1,
        threads=None,
        observation="scientist",
        target="medium",
        crust_pct=60.0,
        mesh="reduced",
        control_s=1.0,
        max_s=1200.0,
        rest_s=300.0,
    ):
        super().__init__(_Steaks(num_envs, threads, observation, target, crust_pct, mesh, control_s, max_s, rest_s))
