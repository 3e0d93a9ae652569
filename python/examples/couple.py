"""Couples another simulator to the kitchen at 240 Hz: it moves the pan, the kitchen reports the load on it and where the foods are.

    python couple.py [--seconds 4]

The other simulator is here a mass on springs and dampers that represents a robot's compliant wrist: its hand holds the pan, is
driven around a circle and is pulled down by what lies in the pan. Replace `Wrist` by your own: MuJoCo's `mj_step` or a callback of
ROS 2 gets the same numbers (docs/robots.md). No mesh passes between the two, only seven numbers for each pose and six for the load.
"""

import argparse
import math

import numpy as np

import saute

#: Rate at which both simulators exchange [Hz]: that of the kitchen's rigid steps.
RATE_HZ = 240


class Wrist:
    """A wrist that yields: the pan hangs on springs from the place where the arm commands it."""

    MASS_KG, STIFFNESS_N_M, DAMPING = 2.0, 2000.0, 0.7

    def __init__(self, home_m):
        self.home_m, self.at_m, self.speed_m_s = home_m, home_m.copy(), np.zeros(3)
        self.steps, self.log = 0, []

    def wanted_m(self):
        """Where the arm commands the pan: 30 mm above the hob, on a circle of 20 mm, once a second."""
        t = self.steps / RATE_HZ
        rise = min(t, 1.0)
        circle = 0.02 * rise * np.array([math.cos(2 * math.pi * t) - 1.0, math.sin(2 * math.pi * t)])
        return self.home_m + np.array([*circle, 0.03 * rise])

    def step(self, wrench, foods):
        """One step of 1/240 s: takes the load on the pan [N, N·m] and the poses of the foods, and returns that of the pan."""
        damping = 2 * self.DAMPING * math.sqrt(self.STIFFNESS_N_M * self.MASS_KG)
        # At rest the springs carry the pan; what lies in it comes on top.
        pull = self.STIFFNESS_N_M * (self.wanted_m() - self.at_m) - damping * self.speed_m_s + wrench[:3]
        self.speed_m_s += pull / self.MASS_KG / RATE_HZ
        self.at_m += self.speed_m_s / RATE_HZ
        self.log.append((self.steps / RATE_HZ, self.at_m[2], wrench[2], foods[0, 0]))
        self.steps += 1
        return [*self.at_m, 0.0, 0.0, 0.0, 1.0]


def couple(seconds):
    """Runs both simulators; returns the kitchen and the wrist."""
    kitchen = saute.Kitchen(food="beef-lean", id="steak", size_mm=(120, 80, 20), pan_c=180, coarseness=2)
    kitchen.put("steak")
    kitchen.step(10)
    wrist = Wrist(kitchen.pan_pose_m[:3].copy())
    kitchen.couple(wrist.step, n=round(60 * seconds))
    return kitchen, wrist


def main():
    parser = argparse.ArgumentParser(description="Couples another simulator to the kitchen at 240 Hz.")
    parser.add_argument("--seconds", type=float, default=4.0)
    kitchen, wrist = couple(parser.parse_args().seconds)
    print("   t [s]  pan z [mm]  load z [N]  steak x [mm]")
    for t, z, load, x in wrist.log[:: RATE_HZ // 4]:
        print(f"{t:8.3f}  {1e3 * z:10.2f}  {load:10.3f}  {1e3 * x:12.1f}")
    print(f"{wrist.steps} exchanges; core {kitchen['steak'].core_c:.1f} °C, pan {kitchen.pan_c:.0f} °C")


if __name__ == "__main__":
    main()
