"""Lets MuJoCo hold the pan: its rigid bodies and the kitchen's heat, at 240 Hz.

    pip install mujoco
    python couple_mujoco.py [--seconds 4]

In MuJoCo a hand (a mocap body) is driven around a circle; a weld that yields joins it to the pan. The kitchen returns the load of
what lies in the pan, which MuJoCo applies to it, and the poses of the foods, which are mocap bodies there, to be drawn. Run with
MuJoCo 4.0. No mesh passes between the two.
"""

import argparse
import math

import mujoco
import numpy as np

import saute

#: Rate at which both simulators exchange [Hz]: that of the kitchen's rigid steps.
RATE_HZ = 240

#: The pan's mass is at the centre of its floor, where the kitchen's wrench acts; at another place, shift the torque by the arm.
MODEL = f"""
<mujoco>
  <option timestep="{1 / RATE_HZ}" gravity="0 0 -9.80665"/>
  <worldbody>
    <body name="hand" mocap="true"/>
    <body name="pan" gravcomp="1">
      <freejoint/>
      <inertial pos="0 0 0" mass="1.2" diaginertia="0.01 0.01 0.02"/>
      <geom type="cylinder" size="0.1 0.002" contype="0" conaffinity="0" mass="0"/>
    </body>
    <body name="steak" mocap="true"><geom type="box" size="0.06 0.04 0.01" contype="0" conaffinity="0"/></body>
  </worldbody>
  <equality><weld body1="hand" body2="pan" solref="0.04 1"/></equality>
</mujoco>
"""


class Held:
    """The pan in MuJoCo's hand."""

    def __init__(self, pose):
        self.model = mujoco.MjModel.from_xml_string(MODEL)
        self.data = mujoco.MjData(self.model)
        body = lambda name: mujoco.mj_name2id(self.model, mujoco.mjtObj.mjOBJ_BODY, name)
        self.pan = body("pan")
        self.hand, self.steak = (self.model.body_mocapid[body(name)] for name in ("hand", "steak"))
        self.home_m, self.steps, self.log = pose[:3].copy(), 0, []
        self.data.qpos[:3] = self.data.mocap_pos[self.hand] = self.home_m

    def wanted_m(self):
        """Where the hand is: 30 mm above the hob, on a circle of 20 mm, once a second."""
        t = self.steps / RATE_HZ
        rise = min(t, 1.0)
        circle = 0.02 * rise * np.array([math.cos(2 * math.pi * t) - 1.0, math.sin(2 * math.pi * t)])
        return self.home_m + np.array([*circle, 0.03 * rise])

    def step(self, wrench, foods):
        """One step of 1/240 s: takes the load on the pan [N, N·m] and the poses of the foods, and returns that of the pan."""
        self.data.mocap_pos[self.hand] = self.wanted_m()
        self.data.xfrc_applied[self.pan] = wrench
        # MuJoCo's quaternions begin with w, the kitchen's end with it.
        self.data.mocap_pos[self.steak], self.data.mocap_quat[self.steak] = foods[0, :3], foods[0, [6, 3, 4, 5]]
        mujoco.mj_step(self.model, self.data)
        self.steps += 1
        self.log.append((self.data.xpos[self.pan].copy(), wrench[2], foods[0, :3].copy()))
        return [*self.data.xpos[self.pan], *self.data.xquat[self.pan][[1, 2, 3, 0]]]


def couple(seconds):
    """Runs both simulators; returns the kitchen and the hand."""
    kitchen = saute.Kitchen(food="beef-lean", id="steak", size_mm=(120, 80, 20), pan_c=180, coarseness=2)
    kitchen.put("steak")
    kitchen.step(10)
    held = Held(kitchen.pan_pose_m)
    kitchen.couple(held.step, n=round(60 * seconds))
    return kitchen, held


def main():
    parser = argparse.ArgumentParser(description="Lets MuJoCo hold the pan at 240 Hz.")
    parser.add_argument("--seconds", type=float, default=4.0)
    kitchen, held = couple(parser.parse_args().seconds)
    places, loads, foods = (np.array(column) for column in zip(*held.log[RATE_HZ:]))
    weight_n = 9.80665 * kitchen["steak"].mass_g / 1000
    print(f"mean load {-loads.mean():.2f} N downwards, weight of the steak {weight_n:.2f} N")
    print(f"the pan went {np.ptp(places[:, 0]) * 1000:.0f} mm to and fro, the steak in it {np.ptp(foods[:, 0]) * 1000:.0f} mm")
    print(f"core {kitchen['steak'].core_c:.1f} °C, pan {kitchen.pan_c:.0f} °C")


if __name__ == "__main__":
    main()
