#!/usr/bin/env python3
"""Machines that `linkage export mjcf` writes, beside the printed solver.

    python3 -m venv target/python
    target/python/bin/pip install mujoco==4.0.0
    cargo build -p linkage-command
    target/python/bin/python tests/robots/exported.py target/debug/linkage

Joints are set by the pins of the solver alone. Compared are: how far loops are open in the drawn pose; all pins; the
efforts of the inputs in motion, from MuJoCo's forces of the tree and its own derivatives of loops and actuators; and the
efforts at rest, where MuJoCo's solver holds the loops and servos the inputs. Where MuJoCo is not installed nothing is
compared, and it says so.
"""

import ctypes
import math
import pathlib
import re
import subprocess
import sys
import tempfile

MACHINES = pathlib.Path(__file__).parent.parent / "both_ways" / "heavy_machines.rs"
SETS = [
    ("HeavyExcavator", "cylinders", 0.3),
    ("HeavyFiveBar", "motors", 0.5),
    ("HeavyFiveBar", "hand", 0.04),
    ("HeavyHorst", "shock", 0.03),
    ("HeavyToggle", "crank_side", 0.5),
    ("HeavyAnkle", "joints", 0.5),
]
# Metres; sizes of the machine; shares of the sum of products; shares of the effort, where constraints are soft.
GAP, PINS, IN_MOTION, AT_REST = 1e-15, 4e-15, 1e-12, 1e-7
POSES = 1000


def snake(name):
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


class Solver:
    """A printed solver, called by the names in its header."""

    def __init__(self, folder, library, machine, chosen):
        self.name = machine + "".join(word.capitalize() for word in chosen.split("_"))
        self.stem = snake(self.name)
        header = (folder / f"{self.stem}.h").read_text()
        header = re.sub(r"/\*.*?\*/", "", header, flags=re.S)
        types = {"double": ctypes.c_double, "float": ctypes.c_float, "int32_t": ctypes.c_int32, "LinkageStatus": ctypes.c_int32,
                 "size_t": ctypes.c_size_t}
        for name, body in re.findall(r"typedef struct (\w+) \{(.*?)\}", header, flags=re.S):
            fields = []
            for kind, pointer, field, dimensions in re.findall(r"(\w+) (\*?)(\w+)((?:\[\d+\])*);", body.replace("const ", "")):
                of = ctypes.c_char_p if pointer else types[kind]
                for count in reversed(re.findall(r"\d+", dimensions)):
                    of = of * int(count)
                fields.append((field, of))
            types[name] = type(name, (ctypes.Structure,), {"_fields_": fields})
        self.types, self.library = types, library
        self.count = int(re.search(rf"define {self.stem.upper()}_INPUTS (\d+)", header)[1])
        labels = (ctypes.c_char_p * self.count).in_dll(library, f"{self.stem}_input_labels")
        self.inputs = [label.decode() for label in labels]
        self.drawn = list((ctypes.c_double * self.count).in_dll(library, f"{self.stem}_drawn"))
        self.forces = re.search(rf"{self.stem}_forces\(([^;]*)\);", header)[1]

    def given(self, numbers):
        if self.count == 1:
            return ctypes.c_double(numbers[0])
        return ctypes.byref(self.types[f"{self.name}Input"](*numbers))

    def motion(self, *given):
        found = self.types[f"{self.name}Motion"]()
        call = getattr(self.library, f"{self.stem}_motion")
        return None if call(*map(self.given, given), ctypes.byref(found), None) else found

    def drives(self, *given):
        found = self.types[f"{self.name}Forces"]()
        call = getattr(self.library, f"{self.stem}_forces")
        loads = self.forces.split(",")[3].strip()
        zero = ctypes.c_double(0.0) if "*" not in loads else ctypes.byref(self.types[f"{self.name}Loads"]())
        if call(*map(self.given, given), zero, ctypes.byref(found), None):
            return None
        return [getattr(getattr(found, name), "drive") for name in self.inputs]

    def mass(self, q):
        found = self.types[f"{self.name}Equations"]()
        call = getattr(self.library, f"{self.stem}_equations_of_motion")
        zero = ctypes.c_double(0.0) if "*" not in self.forces.split(",")[3] else ctypes.byref(self.types[f"{self.name}Loads"]())
        call(self.given(q), self.given([0.0] * self.count), zero, ctypes.byref(found), None)
        return [found.mass[i][i] for i in range(self.count)]


class Model:
    """The written model, whose joints are set by where pins are, how fast, and how fast that changes."""

    def __init__(self, text):
        self.model = mujoco.MjModel.from_xml_string(text)
        self.data = mujoco.MjData(self.model)
        self.refs = self.model.key("drawn").qpos.copy()
        sites = [self.model.site(i).name.split(".") for i in range(self.model.nsite)]
        self.pins = {}
        for name in sites:
            if len(name) == 2 and name[0] != "ground":
                self.pins.setdefault(name[0], []).append(name[1])
        self.ground = {name[1]: self.model.site(".".join(name)).pos[[0, 2]] for name in sites if name[0] == "ground" and len(name) == 2}
        self.forward(self.refs)
        self.gap = self.open()
        self.at_rest = {site: self.place(*site) for site in [(body, pin) for body in self.pins for pin in self.pins[body]]}
        places = [*self.at_rest.values(), *self.ground.values()]
        self.size = max(math.dist(p, q) for p in places for q in places)

    def place(self, body, pin):
        return self.data.site(f"{body}.{pin}").xpos[[0, 2]].copy()

    def forward(self, qpos, qvel=None):
        self.data.qpos = qpos
        self.data.qvel = 0.0 if qvel is None else qvel
        mujoco.mj_forward(self.model, self.data)

    def open(self):
        return max([0.0, *np.abs(self.data.efc_pos[: self.data.ne])])

    def at(self, record, pin):
        if pin in self.ground:
            return self.ground[pin] if record is not None else np.zeros(2)
        # A name that C has already has a tail.
        point = getattr(record, pin if hasattr(record, pin) else f"{pin}_")
        return np.array([point.x, point.y])

    def turn(self, motion, body):
        """Angle from the drawn pose, its rate and second rate."""
        pins = self.pins[body]
        if len(pins) < 2:
            return np.zeros(3)
        first, last = pins[0], pins[-1]
        at = lambda record, pin: self.ground[pin] if pin in self.ground else self.at(record, pin)
        moving = lambda record, pin: np.zeros(2) if pin in self.ground else self.at(record, pin)
        bar = at(motion.position, last) - at(motion.position, first)
        drawn = self.at_rest[body, last] - self.at_rest[body, first]
        cross = lambda p, q: p[0] * q[1] - p[1] * q[0]
        angle = math.atan2(cross(drawn, bar), drawn @ bar)
        rate, second = (moving(record, last) - moving(record, first) for record in (motion.velocity, motion.acceleration))
        return np.array([angle, cross(bar, rate) / (bar @ bar), cross(bar, second) / (bar @ bar)])

    def coordinates(self, motion):
        found = np.zeros((3, self.model.nv))
        for i in range(self.model.njnt):
            name, kind = self.model.joint(i).name.rsplit(".", 1)
            parent = self.model.body(self.model.body(name).parentid[0]).name
            if kind == "angle":
                found[:, i] = self.turn(motion, name) - (self.turn(motion, parent) if parent in self.pins else 0.0)
                found[0, i] = math.remainder(found[0, i], 2 * math.pi)
                continue
            pin, axis = self.pins[name][0], self.data.joint(i).xaxis[[0, 2]]
            records = (motion.position, motion.velocity, motion.acceleration)
            found[:, i] = [axis @ self.at(record, pin) for record in records]
            found[0, i] -= axis @ self.at_rest[name, pin]
        found[0] += self.refs
        return found

    def dense(self, values, rows, first, counts, columns):
        dense = np.zeros((rows, self.model.nv))
        for row in range(rows):
            for k in range(first[row], first[row] + counts[row]):
                dense[row, columns[k]] += np.ravel(values)[k]
        return dense

    def loops(self):
        data = self.data
        if mujoco.mj_isSparse(self.model):
            return self.dense(data.efc_J, data.ne, data.efc_J_rowadr, data.efc_J_rownnz, data.efc_J_colind)
        return np.array(data.efc_J).reshape(-1, self.model.nv)[: data.ne]

    def actuators(self):
        data = self.data
        return self.dense(data.actuator_moment, self.model.nu, data.moment_rowadr, data.moment_rownnz, data.moment_colind)


def in_motion(solver, model, reach, random):
    """The worst differences of pins and of efforts, and the count of poses."""
    pins, efforts, count = 0.0, 0.0, 0
    for _ in range(POSES):
        q = [at + reach * random.uniform(-1, 1) for at in solver.drawn]
        rates, seconds = random.uniform(-1, 1, solver.count), random.uniform(-1, 1, solver.count)
        motion, drives = solver.motion(q, rates, seconds), solver.drives(q, rates, seconds)
        if motion is None or drives is None:
            continue
        count += 1
        model.forward(model.refs)
        qpos, qvel, qacc = model.coordinates(motion)
        model.model.opt.disableflags = 0
        model.forward(qpos, qvel)
        for body, own in model.pins.items():
            for pin in own:
                if pin not in model.ground:
                    off = model.place(body, pin) - model.at(motion.position, pin)
                    pins = max(pins, math.hypot(*off) / model.size)
        top = np.vstack([model.loops(), model.actuators()])
        wanted = np.vstack([np.zeros((len(top) - solver.count, solver.count)), np.eye(solver.count)])
        ratios = np.linalg.lstsq(top, wanted, rcond=None)[0]
        model.data.qacc = qacc
        model.model.opt.disableflags = int(mujoco.mjtDisableBit.mjDSBL_CONSTRAINT)
        mujoco.mj_inverse(model.model, model.data)
        force = model.data.qfrc_inverse
        model.model.opt.disableflags = 0
        off = np.abs(ratios.T @ force - drives) / (np.abs(ratios).T @ np.abs(force) + np.abs(drives))
        efforts = max(efforts, off.max())
    return pins, efforts, count


def at_rest(solver, model, reach):
    """The worst share by which efforts differ, held by servos until nothing moves."""
    of, data, worst = model.model, model.data, 0.0
    of.opt.timestep, of.opt.iterations, of.opt.tolerance = 1e-4, 200, 1e-14
    for share in (-0.3, -0.1, 0.1, 0.3):
        q = [at + share * reach for at in solver.drawn]
        motion = solver.motion(q, [0.0] * solver.count, [0.0] * solver.count)
        drives = np.array(solver.drives(q, [0.0] * solver.count, [0.0] * solver.count))
        mujoco.mj_resetData(of, data)
        model.forward(model.refs)
        model.forward(model.coordinates(motion)[0])
        goal = data.actuator_length.copy()
        stiff = np.array(solver.mass(q)) * 100.0**2
        for _ in range(6000):
            data.ctrl = drives + stiff * (goal - data.actuator_length) - stiff / 50.0 * data.actuator_velocity
            mujoco.mj_step(of, data)
        mujoco.mj_forward(of, data)
        there = np.array(q) + data.actuator_length - goal
        own = np.array(solver.drives(there, [0.0] * solver.count, [0.0] * solver.count))
        worst = max(worst, np.max(np.abs(data.ctrl - own)) / np.max(np.abs(own)))
    return worst


def main():
    linkage, failed = sys.argv[1], False
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([linkage, "export", "c", MACHINES, "-o", folder], check=True, capture_output=True)
        sources = [path.name for path in folder.glob("*.c")]
        subprocess.run(["cc", "-std=c99", "-O1", "-shared", "-fPIC", "-o", "all.so", *sources, "-lm"], cwd=folder, check=True)
        library = ctypes.CDLL(str(folder / "all.so"))
        for machine, chosen, reach in SETS:
            solver = Solver(folder, library, machine, chosen)
            command = [linkage, "export", "mjcf", MACHINES, "--machine", machine, "--inputs", chosen, "--plane", "xz"]
            text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
            model = Model(text)
            pins, efforts, count = in_motion(solver, model, reach, np.random.default_rng(3))
            rest = at_rest(solver, model, reach)
            told = f"gap {model.gap:.1e} m, pins {pins:.1e}, in motion {efforts:.1e} over {count} poses, at rest {rest:.1e}"
            print(f"{machine} by {chosen}: {told}", flush=True)
            failed |= model.gap > GAP or pins > PINS or efforts > IN_MOTION or rest > AT_REST or count < POSES // 5
    sys.exit(failed)


try:
    import mujoco
    import numpy as np
except ImportError:
    print("skipped: exported models beside MuJoCo: it is not installed")
    sys.exit()
main()
