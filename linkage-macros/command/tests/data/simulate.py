"""Validates an FMU and simulates it both ways; prints the last values, and what it says of what it refuses."""
import sys

import fmpy
from fmpy.validation import validate_fmu

path, mode = sys.argv[1:]
findings = validate_fmu(path)
print("findings", len(findings), *findings)
START = {"theta": 0.4, "theta_rate": 5.0, "drive of theta": 1.5, "work": 30.0, "counterweight": 2.5}
FORCES = ["theta.drive", "BC.C.x", "BC.C.y", "ram.way.normal", "kinetic energy", "potential energy"]


def simulated(kind, outputs, **options):
    result = fmpy.simulate_fmu(path, fmi_type=kind, output=outputs, **options)
    print(kind, *(repr(float(result[name][-1])) for name in outputs))


def refused(kind, outputs, start):
    """What the log says of the first step."""
    messages = []
    log = lambda environment, status, category, message: messages.append(message.decode())
    try:
        fmpy.simulate_fmu(path, fmi_type=kind, stop_time=0.1, output=outputs, start_values=start, logger=log)
    except Exception as error:
        print("refused", kind, type(error).__name__, *messages)


for kind in ["ModelExchange", "CoSimulation"]:
    if mode == "dynamic":
        simulated(
            kind, ["theta", "theta_rate", "C.y", "BC.cos", "BC.sin", *FORCES], stop_time=0.5, output_interval=0.01,
            relative_tolerance=1e-12,
            start_values=START)
        # Forces alone, at once: they need second rates that nobody has asked for.
        result = fmpy.simulate_fmu(path, fmi_type=kind, output=["theta.drive"], stop_time=1e-3, start_values=START)
        print("first", repr(float(result["theta.drive"][0])))
    elif mode == "jams":
        start = {"x": 0.04, "x_rate": 0.1, "beside": 0.8}
        if kind == "CoSimulation":
            simulated(kind, ["F.x"], stop_time=0.1, output_interval=0.1, start_values=start)
            refused(kind, ["x.drive"], start)
    else:
        start = {"theta": 0.4, "theta_rate": 5.0, "theta_acceleration": 2.0, "work": 30.0}
        outputs = ["C.y", "velocity of C.y", "acceleration of C.y", *FORCES]
        simulated(kind, outputs, stop_time=0.1, output_interval=0.1, start_values=start)
        refused(kind, ["C.y"], {"theta": 0.4, "rod": 0.05})
