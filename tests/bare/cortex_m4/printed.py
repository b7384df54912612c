#!/usr/bin/env python3
"""Counts the instructions of a call of printed C on an emulated Cortex-M4F: the `motion_f32` of the manual's flying shear, a
four-bar with a parameter, in 72 poses. No call of the fast path may take more than MOST, or copy or clear memory. And the
bytes of a program that calls the example's `motion_f32` alone, without double: no more than LARGEST.

Optional; needs arm-none-eabi-gcc with newlib, and qemu-system-arm. Debian has them: gcc-arm-none-eabi,
libnewlib-arm-none-eabi, qemu-system-arm. The program `linkage` is the argument:

    tests/bare/cortex_m4/printed.py target/debug/linkage

Without these tools it ends with 77.
"""

import bisect
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
HERE = ROOT / "tests/bare/cortex_m4"
# What a script ends with that cannot be run on this machine.
CANNOT_BE_RUN = 77
MOST = 270
LARGEST = 8000
FLAGS = ["-std=c99", "-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard", "-ffunction-sections",
         "--specs=nano.specs", "--specs=nosys.specs", "-nostartfiles", f"-T{HERE / 'memory.x'}", "-Wl,--gc-sections",
         "-Wl,--no-warn-rwx-segments"]
FUNCTION = "flying_shear_motion_f32"
CALLER = """
#include "flying_shear.h"
int main(void)
{
    const FlyingShearF32 shear = flying_shear_default_f32();
    int i, status = 0;
    for (i = 0; i < 72; i++) {
        FlyingShearMotionF32 motion;
        LinkageError error;
        status |= (int)flying_shear_motion_f32(&shear, 0.0872664626f * (float)i, 12.0f, 0.5f, &motion, &error);
    }
    return status;
}
"""

ALONE = """
#include "flying_shear.h"
int main(void)
{
    FlyingShearMotionF32 motion;
    LinkageError error;
    return (int)flying_shear_motion_f32(0.3f, 12.0f, 0.5f, &motion, &error);
}
"""


def declaration():
    """The declaration on the manual's page about C."""
    page = (ROOT / "linkage-core/docs/controllers.md").read_text()
    return re.search(r"```text\n(mechanism! \{.*?\n\})\n```", page, flags=re.S).group(1)


def functions(program):
    """Addresses and names."""
    text = subprocess.run(["arm-none-eabi-objdump", "-d", program], check=True, text=True, capture_output=True).stdout
    return sorted((int(address, 16), name) for address, name in re.findall(r"^([0-9a-f]+) <(.*)>:", text, flags=re.M))


def counts(folder, *level):
    """The instructions of each call, by the function that they belong to."""
    program, log = folder / "program", folder / "log"
    sources = [str(path) for path in [HERE / "start.c", folder / "caller.c", *folder.glob("*linkage_*.c"), folder / "flying_shear.c"]]
    subprocess.run(["arm-none-eabi-gcc", *FLAGS, *level, f"-I{folder}", *sources, "-lm", "-o", program],
                   check=True, stderr=subprocess.DEVNULL)
    subprocess.run(["qemu-system-arm", "-M", "mps2-an386", "-nographic", "-semihosting-config", "enable=on,target=native",
                    "-singlestep", "-d", "nochain,exec", "-D", log, "-kernel", program], check=True, timeout=900)
    table = functions(program)
    addresses = [address for address, _ in table]
    calls, is_in = [], False
    for address in re.findall(r"\[[0-9a-f]+/([0-9a-f]+)/", log.read_text()):
        name = table[bisect.bisect_right(addresses, int(address, 16)) - 1][1]
        if name == FUNCTION and not is_in:
            calls.append({})
        is_in = name not in ("main", "moved") and (is_in or name == FUNCTION)
        if is_in:
            calls[-1][name] = calls[-1].get(name, 0) + 1
    return calls


def alone(folder):
    """Code and constants of a program that calls one function, with what a C library puts beside it."""
    solver, place = ROOT / "examples/c_controller/solver", folder / "alone"
    # Beside the caller stands another shear's header.
    place.mkdir()
    source, program = place / "call.c", place / "call"
    source.write_text(ALONE)
    flags = [flag for flag in FLAGS if flag != "-nostartfiles" and not flag.startswith("-T")]
    subprocess.run(["arm-none-eabi-gcc", *flags, "-Os", "-fdata-sections", "-DLINKAGE_NO_DOUBLE", f"-I{solver}", source,
                    *solver.glob("*.c"), "-lm", "-o", program], check=True, stderr=subprocess.DEVNULL)
    told = subprocess.run(["arm-none-eabi-size", program], check=True, text=True, capture_output=True).stdout
    return int(told.splitlines()[1].split()[0])


def tools():
    """Ends the program where it cannot be run."""
    missing = [name for name in ("arm-none-eabi-gcc", "qemu-system-arm") if not shutil.which(name)]
    if missing:
        print(f"left out: no {' and no '.join(missing)}", file=sys.stderr)
        raise SystemExit(CANNOT_BE_RUN)


def main():
    tools()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "shear.rs").write_text(declaration())
        (folder / "caller.c").write_text(CALLER)
        subprocess.run([Path(sys.argv[1]).resolve(), "export", "c", "shear.rs", "-o", "."], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        for level in ("-O2", "-O3", "-Os"):
            calls = counts(folder, level)
            totals = [sum(call.values()) for call in calls]
            print(f"{FUNCTION} {level}: {min(totals)} to {max(totals)} instructions in {len(calls)} calls")
            met = {name for call in calls for name in call}
            if max(totals) > MOST or met & {"memcpy", "memset"} or len(calls) != 72:
                raise SystemExit(f"more than {MOST}, or memory is copied or cleared: {sorted(met)}")
        bytes_of_it = alone(folder)
        print(f"{FUNCTION} alone, without double: {bytes_of_it} bytes")
        if bytes_of_it > LARGEST:
            raise SystemExit(f"more than {LARGEST}")


if __name__ == "__main__":
    main()
