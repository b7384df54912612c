"""Validates an FMU and simulates it both ways; prints the last states, or what it says of a pose out of reach."""
import sys

import fmpy
from fmpy.validation import validate_fmu

path, mode = sys.argv[1:]
findings = validate_fmu(path)
print("findings", len(findings), *findings)
for kind in ["ModelExchange", "CoSimulation"]:
    messages = []
    log = lambda environment, status, category, message: messages.append(message.decode())
    if mode == "dynamic":
        result = fmpy.simulate_fmu(
            path, fmi_type=kind, stop_time=0.5, output_interval=0.01, relative_tolerance=1e-12,
            start_values={"theta": 0.4, "theta_rate": 5.0, "drive of theta": 1.5, "work": 30.0, "counterweight": 2.5},
            output=["theta", "theta_rate", "C.y"])
        print(kind, *(repr(float(result[name][-1])) for name in ["theta", "theta_rate", "C.y"]))
    else:
        result = fmpy.simulate_fmu(
            path, fmi_type=kind, stop_time=0.1, output_interval=0.1,
            start_values={"theta": 0.4, "theta_rate": 5.0, "theta_acceleration": 2.0},
            output=["C.y", "velocity of C.y", "acceleration of C.y"])
        print(kind, *(repr(float(result[name][-1])) for name in ["C.y", "velocity of C.y", "acceleration of C.y"]))
        try:
            fmpy.simulate_fmu(path, fmi_type=kind, stop_time=0.1, output=["C.y"],
                              start_values={"theta": 0.4, "rod": 0.05}, logger=log)
        except Exception as error:
            print("refused", kind, type(error).__name__, *messages)
