#!/usr/bin/env python3
"""A knee and an ankle with a closed loop at rest, by MuJoCo.

    python3 -m venv target/python
    target/python/bin/pip install mujoco==4.0.0
    target/python/bin/python tests/robots/against_mujoco.py
    target/python/bin/python tests/robots/against_mujoco.py --write

MuJoCo's joints are a tree; the rod's end is tied to the foot's pin by a constraint, which is soft. Two servos hold
knee and arm against gravity until nothing moves. The angles, the servos' torques and how far the pin is open
are compared with `mujoco.csv`, or written there; the tests of this folder compare that file with the solver. Where
MuJoCo is not installed the comparison is skipped and says so.
"""

import csv
import math
import pathlib
import sys

TABLE = pathlib.Path(__file__).parent / "mujoco.csv"
COLUMNS = ["knee", "motor", "ankle", "knee_torque", "motor_torque", "gap", "speed"]
# Bends of the knee and angles of the arm that the servos are set to.
COMMANDED = [(-0.1, -0.1), (-0.5, -0.2), (-0.9, -1.2), (-1.4, -1.0), (-1.9, -1.6), (-0.3, 0.2), (-1.0, -0.6)]

MODEL = """
<mujoco>
  <compiler angle="radian"/>
  <option gravity="0 -9.81 0" timestep="0.0002" integrator="implicitfast" tolerance="1e-14" iterations="200"/>
  <worldbody>
    <body name="shank">
      <joint name="knee" axis="0 0 1" damping="2"/>
      <inertial pos="0.2 0 0" mass="3" diaginertia="0.04 0.04 0.04"/>
      <body name="foot" pos="0.4 0 0">
        <joint name="ankle" axis="0 0 1" damping="0.5"/>
        <inertial pos="0.03 0 0" mass="1" diaginertia="0.0003 0.0003 0.0003"/>
        <site name="H" pos="0.06 0 0"/>
      </body>
    </body>
    <body name="arm">
      <joint name="motor" axis="0 0 1" damping="0.5"/>
      <inertial pos="0.025 0 0" mass="0.3" diaginertia="0.0000625 0.0000625 0.0000625"/>
      <body name="rod" pos="0.05 0 0">
        <joint name="pin" axis="0 0 1" damping="0.01"/>
        <inertial pos="0.2 0 0" mass="0.25" diaginertia="0.003333333333333333 0.003333333333333333 0.003333333333333333"/>
        <site name="end" pos="0.4 0 0"/>
      </body>
    </body>
  </worldbody>
  <equality>
    <connect site1="end" site2="H" solref="0.0008 1" solimp="0.9999 0.9999 0.001"/>
  </equality>
  <actuator>
    <position joint="knee" kp="5000" kv="50"/>
    <position joint="motor" kp="5000" kv="10"/>
  </actuator>
</mujoco>
"""


def closed(knee, motor):
    """Angles of foot and rod that close the loop, on the left of the line from the arm's pin to the ankle."""
    shank = knee - math.pi / 2
    a = complex(0.4 * math.cos(shank), 0.4 * math.sin(shank))
    b = complex(0.05 * math.cos(motor), 0.05 * math.sin(motor))
    reach = abs(a - b)
    along = (reach**2 + 0.4**2 - 0.06**2) / (2 * reach)
    h = b + complex(along, math.sqrt(0.4**2 - along**2)) * (a - b) / reach
    rod, foot = h - b, h - a
    angle = lambda z: math.atan2(z.imag, z.real)
    return angle(foot) - shank, angle(rod) - motor


def at_rest(mujoco, knee, motor):
    """A row of the table."""
    model = mujoco.MjModel.from_xml_string(MODEL)
    data = mujoco.MjData(model)
    joint = {name: model.joint(name).qposadr[0] for name in ["knee", "ankle", "motor", "pin"]}
    ankle, pin = closed(knee, motor)
    data.qpos[joint["knee"]], data.qpos[joint["motor"]] = knee - math.pi / 2, motor
    data.qpos[joint["ankle"]], data.qpos[joint["pin"]] = ankle, pin
    data.ctrl[:] = [knee - math.pi / 2, motor]
    for _ in range(20_000):
        mujoco.mj_step(model, data)
    mujoco.mj_forward(model, data)
    apart = data.site("end").xpos - data.site("H").xpos
    return {
        "knee": data.qpos[joint["knee"]] + math.pi / 2,
        "motor": data.qpos[joint["motor"]],
        "ankle": data.qpos[joint["ankle"]] - math.pi / 2,
        "knee_torque": data.actuator_force[0],
        "motor_torque": data.actuator_force[1],
        "gap": math.hypot(*apart),
        "speed": max(abs(data.qvel)),
    }


def main():
    """Writes the table, or compares with it."""
    try:
        import mujoco
    except ImportError:
        print("against_mujoco: skipped, the package `mujoco` is not installed")
        return
    rows = [at_rest(mujoco, *angles) for angles in COMMANDED]
    if "--write" in sys.argv:
        with open(TABLE, "w", encoding="ascii", newline="") as file:
            file.write(f"# Written by against_mujoco.py, MuJoCo {mujoco.__version__}; radians, newton-metres, metres.\n")
            table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
            table.writeheader()
            table.writerows(rows)
        print(f"against_mujoco: {len(rows)} poses written")
        return
    with open(TABLE, encoding="ascii") as file:
        stored = list(csv.DictReader(line for line in file if not line.startswith("#")))
    assert len(stored) == len(rows), "the table has other poses"
    for row, known in zip(rows, stored):
        assert row["speed"] < 1e-6, f"it still moves: {row}"
        for name in COLUMNS[:5]:
            # Another version or machine rounds differently; a pin that is open by less turns the foot by less.
            slack = max(row["gap"], float(known["gap"])) / 0.05 * (100 if "torque" in name else 2)
            assert abs(row[name] - float(known[name])) < slack, f"{name}: {row[name]} {known[name]}"
    print(f"against_mujoco: {len(rows)} poses at rest as stored, the pin open by {max(row['gap'] for row in rows):.1e} m at most")


if __name__ == "__main__":
    main()
