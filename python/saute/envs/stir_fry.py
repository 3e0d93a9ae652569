"""`saute/StirFry-v1`: a pan in the hand, a turner, and vegetables that are to be tender and brown and to stay in the pan.

**The task.** Carrot coins and leek rings lie in a hot pan with oil. Twenty times a second one holds the pan at a pose, leads the turner,
sets the hob and may pour oil. After `max_s` the vegetables are served and the episode ends; earlier if none of them is in the pan.

**Action** `Box(-1, 1, (11,))`, each value cut off at its ends:

| | value | from −1 to 1 |
|---|---|---|
| 0, 1 | pan to the right, away from the cook | ∓60 mm |
| 2 | pan lifted | 0 to 120 mm; below −0.9 it stands on the hob |
| 3, 4 | pan tilted towards the right, away from the cook | ∓25° |
| 5 | power of the hob | 0 to 2000 W |
| 6, 7 | tip of the turner in the pan, to the right, away | ∓90 mm |
| 8 | its height above the floor | 2 to 80 mm |
| 9 | it points to the left, away from the cook, to the right | ∓90° |
| 10 | above 0.5 the turner is in use; below −0.5, 2 g of oil are poured, once a second and 20 g at most | |

A pan that is lifted or off the ring takes little or no power. All motions are of bounded speed and force, as a hand's.

**Reward**: −1 over the number of vegetables for each one that falls out of the pan, when it falls; and at the end the score of `saute plan` in
hundreds of points for *tender*, as means over the vegetables: the share of the section that is tender, less what is missing of the crust
(30 % of each face), what is charred, what the core misses, lost mass, and heat of the pan above 295 °C (docs/planning.md). The best possible is
below 1; a fire costs 1.

**Observation** `Box`, by preset: values of the kitchen, then those of each vegetable, carrots first. `cook` is what one sees: `KITCHEN_COOK` and
`PIECE_COOK`. `scientist` adds what sensors would read. Each value is divided by the number next to it.
"""

from __future__ import annotations

import numpy as np

from .. import Kitchen, KitchenBatch
from ._gym import spaces
from ._shell import ManyKitchens, OneKitchen

#: Frames of 1/60 s in a step: 20 Hz.
FRAMES = 3
#: Reach of the pan [m], its lift [m], its tilt [rad].
REACH_M, LIFT_M, TILT = 0.06, 0.12, np.deg2rad(25.0)
#: Largest power of the hob [W].
HOB_W = 2000.0
#: Reach of the turner's tip [m], its lowest and highest place over the floor [m], its largest turn [rad].
TIP_M, TIP_LOW_M, TIP_HIGH_M, TIP_TURN = 0.09, 0.002, 0.08, np.pi / 2
#: Oil poured at once [g], time between two pours [s], most in an episode [g].
OIL_G, OIL_EVERY_S, MOST_OIL_G = 2.0, 1.0, 20.0
#: Oil in the pan at the start [g] and choices of the pan's temperature then [°C].
START_OIL_G, PAN_C = 8.0, (160, 200)
#: Targets of the vegetables.
GOAL = {"target": "tender", "crust_pct": 30.0, "scale": "vegetables"}
#: Sizes of the vegetables [mm] and their temperature at the start [°C].
CARROT_MM, LEEK_MM, FOOD_C = [24, 4], [24, 6], 15
#: Radii of the rings on which they are laid [mm], and how far from their places they may lie [mm].
RINGS_MM, STRAY_MM = (0.0, 40.0, 72.0), 3.0
#: Most vegetables of each kind [-]: so many fit onto the rings.
MOST_PIECES = 7
#: Ticks that they lie in the pan before an episode begins [-].
SETTLING_TICKS = 10

#: What a cook sees of the kitchen and of each vegetable; the pan's pose comes before both: place [m / 0.1] and quaternion.
KITCHEN_COOK = (("time_s", 300.0), ("hob_w", 2000.0), ("oil_poured_g", 20.0))
PIECE_COOK = (
    ("x_mm", 100.0),
    ("y_mm", 100.0),
    ("z_mm", 100.0),
    ("in_pan", 1.0),
    ("upside_down", 1.0),
    ("top_lab_l", 100.0),
    ("top_lab_a", 100.0),
    ("top_lab_b", 100.0),
    ("top_browned_pct", 100.0),
    ("top_charred_pct", 100.0),
)
#: What a scientist reads besides.
KITCHEN_SCIENTIST = (("pan_c", 250.0), ("oil_g", 20.0), ("water_g", 20.0))
PIECE_SCIENTIST = (
    ("core_c", 100.0),
    ("bottom_c", 200.0),
    ("lost_pct", 100.0),
    ("bottom_browned_pct", 100.0),
    ("bottom_charred_pct", 100.0),
    ("pan_force_n", 0.1),
)
PRESETS = {
    "cook": (KITCHEN_COOK, PIECE_COOK),
    "scientist": (KITCHEN_COOK + KITCHEN_SCIENTIST, PIECE_COOK + PIECE_SCIENTIST),
}
#: Largest value of an observation, either way: what is beyond is cut off.
MOST = 10.0


def turned(angles, axis):
    """Returns quaternions [x, y, z, w] of turns about an axis: 0, 1 or 2 for x, y or z."""
    quaternions = np.zeros((len(angles), 4))
    quaternions[:, axis], quaternions[:, 3] = np.sin(angles / 2), np.cos(angles / 2)
    return quaternions


def product(a, b):
    """Returns the products of quaternions: first turned by b, then by a."""
    vector = a[:, 3:] * b[:, :3] + b[:, 3:] * a[:, :3] + np.cross(a[:, :3], b[:, :3])
    scalar = a[:, 3] * b[:, 3] - (a[:, :3] * b[:, :3]).sum(1)
    return np.column_stack([vector, scalar])


class _StirFries:
    """Pans with vegetables that step together."""

    def __init__(self, count, threads, observation, carrots, leeks, coarseness, max_s):
        if observation not in PRESETS:
            raise ValueError(f"observation = {observation!r}: there are {', '.join(PRESETS)}")
        pieces = [("carrot", carrots), ("leek", leeks)]
        if any(not 0 <= n <= MOST_PIECES for _, n in pieces) or carrots + leeks == 0:
            raise ValueError(f"carrots and leeks must be 0 to {MOST_PIECES} each, and one of them more than 0")
        self.names = [f"{kind}-{i + 1}" for kind, n in pieces for i in range(n)]
        self.of_kitchen, self.of_piece = PRESETS[observation]
        self.coarseness, self.max_s = coarseness, max_s
        width = 7 + len(self.of_kitchen) + len(self.names) * len(self.of_piece)
        self.observation_space = spaces.Box(-MOST, MOST, (width,), np.float32)
        self.action_space = spaces.Box(-1.0, 1.0, (11,), np.float32)
        first = self.kitchen(np.random.default_rng(0), PAN_C[0])
        self.home = first.pan_pose_m.copy()
        self.batch = KitchenBatch([first] * count, threads=threads)
        self.readings = self.batch.readings()
        self.began_s, self.poured_g, self.poured_s = np.zeros(count), np.zeros(count), np.full(count, -np.inf)
        self.leads = np.zeros(count, dtype=bool)

    def kitchen(self, random, pan_c):
        """Returns a kitchen with the vegetables in the pan, on rings in a random order."""
        foods = [self.food(name) for name in self.names]
        kitchen = Kitchen({"pan": {"initial_c": float(pan_c)}, "food": foods}, coarseness=self.coarseness)
        kitchen.oil(START_OIL_G)
        for name, place in zip(random.permutation(self.names), places(len(self.names))):
            kitchen.put(str(name), place + random.uniform(-STRAY_MM, STRAY_MM, 2), heap=True)
        kitchen.step(SETTLING_TICKS)
        return kitchen

    @staticmethod
    def food(name):
        kind, number = name.split("-")
        kind, size = ("carrot-coin", CARROT_MM) if kind == "carrot" else ("leek-ring", LEEK_MM)
        return {"id": name, "kind": kind, "size_mm": size, "initial_c": FOOD_C, "seed": int(number)}

    def begin(self, i, random, options):
        """Begins an episode in a kitchen: the pan's temperature is drawn, or as the options say, and so are the places."""
        drawn = {"pan_c": int(random.integers(PAN_C[0], PAN_C[1] + 1))}
        unknown = set(options or {}) - set(drawn)
        if unknown:
            raise ValueError(f"options may have pan_c, not {', '.join(sorted(unknown))}")
        drawn.update(options or {})
        kitchen = self.kitchen(random, **drawn)
        self.batch[i] = kitchen
        self.began_s[i], self.poured_g[i], self.poured_s[i], self.leads[i] = kitchen.time_s, 0.0, -np.inf, False

    def look(self):
        """Reads all kitchens again."""
        self.readings = self.batch.readings()

    def act(self, actions, live):
        """One step of the kitchens that are live; returns which have nothing left in the pan, which are served, and the rewards."""
        before = self.readings
        actions = np.clip(np.nan_to_num(np.asarray(actions, dtype=float)), -1.0, 1.0)
        self.command(actions, live)
        self.readings = self.batch.step_frames(np.where(live, FRAMES, 0).tolist())
        fell = np.maximum(self.readings["spilled"] - before["spilled"], 0.0).sum(1)
        empty = live & (self.readings["spilled"].sum(1) >= len(self.names))
        served = live & ~empty & (self.readings["time_s"] - self.began_s >= self.max_s - 1e-6)
        rewards = np.where(live, -fell / len(self.names), 0.0)
        ended = empty | served
        if ended.any():
            rewards[ended] += self.batch.scores(where=ended.tolist(), **GOAL) / 100
        return empty, served, rewards

    def command(self, actions, live):
        """Hands, hob and oil."""
        mask = live.tolist()
        poses = self.pans(actions)
        self.batch.hold_pan(poses, where=mask)
        self.batch.hob((HOB_W * (actions[:, 5] + 1) / 2).tolist(), where=mask)
        leads = live & (actions[:, 10] > 0.5)
        self.batch.lead("turner", self.tips(actions), where=leads.tolist())
        self.batch.let_go(where=(live & ~leads & self.leads).tolist())
        self.leads = np.where(live, leads, self.leads)
        time_s = self.readings["time_s"]
        pours = live & (actions[:, 10] < -0.5) & (time_s - self.poured_s >= OIL_EVERY_S - 1e-6)
        pours &= self.poured_g <= MOST_OIL_G - OIL_G
        self.batch.oil(OIL_G, where=pours.tolist())
        self.poured_g[pours] += OIL_G
        self.poured_s[pours] = time_s[pours]

    def pans(self, actions):
        """Returns where the pans are to be held."""
        lift = np.where(actions[:, 2] < -0.9, 0.0, LIFT_M * (actions[:, 2] + 1) / 2)
        lies = actions[:, 2] < -0.9
        place = self.home[:3] + np.column_stack([REACH_M * actions[:, :2], lift])
        right, away = (np.where(lies, 0.0, TILT * actions[:, i]) for i in (3, 4))
        return np.column_stack([place, product(turned(right, 1), turned(-away, 0))])

    def tips(self, actions):
        """Returns where the tips of the turners are to be: over the pans as they are now."""
        height = TIP_LOW_M + (TIP_HIGH_M - TIP_LOW_M) * (actions[:, 8] + 1) / 2
        place = self.readings["pan_pose_m"][:, :3] + np.column_stack([TIP_M * actions[:, 6:8], height])
        return np.column_stack([place, turned(np.pi / 2 - TIP_TURN * actions[:, 9], 2)])

    def seen(self):
        """Returns the observations, one in each row."""
        readings = self.readings
        own = {"time_s": readings["time_s"] - self.began_s, "oil_poured_g": self.poured_g}
        pose = readings["pan_pose_m"].copy()
        pose[:, :3] = (pose[:, :3] - self.home[:3]) / 0.1
        kitchen = [(own[name] if name in own else readings[name])[:, None] / scale for name, scale in self.of_kitchen]
        pieces = np.stack([readings[name] / scale for name, scale in self.of_piece], axis=2)
        flat = np.concatenate([pose, *kitchen, pieces.reshape(len(readings), -1)], axis=1)
        return np.clip(flat, -MOST, MOST).astype(np.float32)

    def said(self):
        """Returns the information of a step, an array for each name."""
        readings = self.readings
        return {
            "time_s": readings["time_s"] - self.began_s,
            "pan_c": readings["pan_c"].copy(),
            "spilled": readings["spilled"].sum(1),
            "core_c": readings["core_c"].mean(1),
            "charred_pct": np.maximum(readings["top_charred_pct"], readings["bottom_charred_pct"]).max(1),
        }


def places(count):
    """Returns places on rings about the middle of the pan [mm]."""
    found = [np.zeros(2)]
    for radius, most in zip(RINGS_MM[1:], (6, 8)):
        wanted = min(most, count - len(found))
        angles = 2 * np.pi * np.arange(wanted) / max(wanted, 1)
        found += list(radius * np.column_stack([np.cos(angles), np.sin(angles)]))
    return found[:count]


class StirFryEnv(OneKitchen):
    """A pan in the hand, a turner and vegetables; see the page of `saute.envs.stir_fry`.

    Args:
        observation: "cook" or "scientist".
        carrots: number of carrot coins.
        leeks: number of leek rings.
        coarseness: spacing of the foods' meshes over that of the full one [-], 1 to 8.
        max_s: length of an episode [s].
        render_mode: None, "rgb_array" or "human" (needs pygame).
        size: width and height of a picture [px].
    """

    def __init__(
        self, observation="cook", carrots=5, leeks=5, coarseness=2.0, max_s=300.0, render_mode=None, size=(480, 360)
    ):
        super().__init__(_StirFries(1, 1, observation, carrots, leeks, coarseness, max_s), render_mode, size)


class StirFryVectorEnv(ManyKitchens):
    """Many pans that step together on all cores.

    Every environment gives what `StirFryEnv` gives with the same seed, for any number of threads. An environment that has ended
    begins again in the next step, in which its action does not count.

    Args:
        num_envs: number of environments.
        threads: number of threads; None for all cores.
        The others are those of `StirFryEnv`; there are no pictures.
    """

    def __init__(self, num_envs=1, threads=None, observation="cook", carrots=5, leeks=5, coarseness=2.0, max_s=300.0):
        super().__init__(_StirFries(num_envs, threads, observation, carrots, leeks, coarseness, max_s))
