#!/usr/bin/env python3
"""Prints what a call of printed C takes at worst on a Cortex-M4F, the `motion_f32` of the manual's flying shear, with
LINKAGE_NO_DOUBLE and without: instructions of the fast and of the slow path in poses beside limits, at angles of any size;
bytes of code; and bytes of stack by -fstack-usage along the deepest chain of calls.

Without `double` no object may ask for software double, and no number may be larger than stated below. Optional; needs
arm-none-eabi-gcc with newlib, and qemu-system-arm. The program `linkage` is the argument:

    tests/bare/cortex_m4/worst_case.py target/debug/linkage

Without these tools it ends with 77.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

import printed

# Of a build without `double`, by its level: instructions of the slow path, bytes of code, bytes of stack.
MOST = {"-O2": (5000, 10400, 900), "-Os": (7200, 8600, 950)}
FAST = printed.MOST
NO_DOUBLE = "-DLINKAGE_NO_DOUBLE"

# Cranks some last places beside both limits of the four-bar, at angles that take it there; large angles among them.
CALLER = """
#include "flying_shear.h"
#include <string.h>

static float moved(float x, int places)
{
    int32_t bits;
    memcpy(&bits, &x, sizeof bits);
    bits += places;
    memcpy(&x, &bits, sizeof bits);
    return x;
}

int main(void)
{
    static const float angles[8] = { 3.14159274f, 0.0f, 9.42477798f, 3.14159274e6f, 1.0e30f, 3.1411f, 3.5e7f, 1.0e-3f };
    FlyingShearF32 shear = flying_shear_default_f32();
    int i, status = 0;
    for (i = 0; i < 272; i++) {
        FlyingShearMotionF32 motion;
        LinkageError error;
        shear.crank = moved((i & 1) != 0 ? 0.3403f : 0.9237f, (i >> 4) - 8);
        status |= (int)flying_shear_motion_f32(&shear, angles[(i >> 1) & 7], 12.0f, 0.5f, &motion, &error);
    }
    return status;
}
"""
ALONE = """
#include "flying_shear.h"
volatile float given[3];
int main(void)
{
    const FlyingShearF32 shear = flying_shear_default_f32();
    FlyingShearMotionF32 motion;
    LinkageError error;
    return (int)flying_shear_motion_f32(&shear, given[0], given[1], given[2], &motion, &error);
}
"""


def run(*command, **options):
    return subprocess.run([str(part) for part in command], check=True, text=True, capture_output=True, **options).stdout


def code(folder, flags):
    """Bytes of code and constants of a program that calls nothing else, by the command in the manual."""
    (folder / "alone.c").write_text(ALONE)
    run("arm-none-eabi-gcc", "-std=c99", "-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard",
        "-ffunction-sections", "-fdata-sections", "--specs=nano.specs", "--specs=nosys.specs", "-Wl,--gc-sections", *flags,
        "-I.", "alone.c", "flying_shear.c", "linkage_run.c", "-lm", "-o", "alone", cwd=folder)
    return int(run("arm-none-eabi-size", "alone", cwd=folder).splitlines()[1].split()[0])


def stack(folder, flags):
    """Bytes of stack along the deepest chain of calls, and the function that it begins with. Functions of libraries count
    for what they push."""
    options = [*printed.FLAGS, *flags, "-fstack-usage", "-I."]
    objects = []
    for source in ("flying_shear.c", "linkage_run.c"):
        objects.append(source.replace(".c", ".o"))
        run("arm-none-eabi-gcc", *options[:-1], "-I.", "-c", source, "-o", objects[-1], cwd=folder)
    frames = {}
    for usage in folder.glob("*.su"):
        for place, size, kind in (line.split("\t") for line in usage.read_text().splitlines()):
            assert kind in ("static", "dynamic,bounded"), f"{place} has a stack without a bound"
            frames[place.rsplit(":", 1)[1]] = int(size)
    calls, name = {}, None
    for line in run("arm-none-eabi-objdump", "-dr", *objects, cwd=folder).splitlines():
        if begins := re.match(r"^[0-9a-f]+ <(.*)>:", line):
            name = begins.group(1)
        elif callee := re.search(r"R_ARM_THM_(?:CALL|JUMP24)\s+(\S+)", line):
            calls.setdefault(name, set()).add(callee.group(1))
        elif callee := re.search(r"\tbl?\S*\s+[0-9a-f]+ <([^+>]+)>", line):
            calls.setdefault(name, set()).add(callee.group(1))

    def deep(name, above):
        assert name not in above, f"{name} calls itself"
        return frames.get(name, 0) + max((deep(other, above | {name}) for other in calls.get(name, ()) if other != name), default=0)

    return deep(printed.FUNCTION, frozenset())


def asked_for(folder, flags):
    """What the objects ask for in software double."""
    listed = ""
    for source in ("flying_shear.c", "linkage_run.c"):
        run("arm-none-eabi-gcc", *printed.FLAGS[:5], *flags, "-I.", "-c", source, "-o", "asked.o", cwd=folder)
        listed += run("arm-none-eabi-nm", "-u", "asked.o", cwd=folder)
    return sorted(name for name in set(listed.split()) if re.match(r"__aeabi_(c?d|\w+2d$)|__\w+df\w*$", name))


def main():
    printed.tools()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "shear.rs").write_text(printed.declaration())
        (folder / "caller.c").write_text(CALLER)
        run(Path(sys.argv[1]).resolve(), "export", "c", "shear.rs", "-o", ".", cwd=folder)
        wrong = []
        for level in ("-O2", "-Os"):
            for flags in ([level, NO_DOUBLE], [level]):
                calls = printed.counts(folder, *flags)
                totals = [sum(call.values()) for call in calls]
                fast = [total for total in totals if total <= FAST]
                found = (max(totals), code(folder, flags), stack(folder, flags))
                print(f"{' '.join(flags)}: {len(calls)} calls, fast path {max(fast)} instructions in {len(fast)} of them, "
                      f"slow path {found[0]} at most, {found[1]} bytes of code, {found[2]} bytes of stack")
                if NO_DOUBLE in flags:
                    wrong += asked_for(folder, flags)
                    wrong += [f"{it} with {level}" for it, most in zip(found, MOST[level]) if it > most]
        if wrong:
            raise SystemExit(f"more than stated: {wrong}")


if __name__ == "__main__":
    main()
