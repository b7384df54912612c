#!/usr/bin/env python3
"""Prints what a list of all assemblies in printed C takes on an emulated Cortex-M4F: instructions of 60 random plates on three
bars, by `-icount`, and bytes of stack, by a painted one. The machine has no instructions in double precision.

Optional; needs arm-none-eabi-gcc with newlib, and qemu-system-arm. The program `linkage` is the argument:

    tests/bare/cortex_m4/lists.py target/debug/linkage

Without these tools it ends with 77.
"""

import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

import printed

MACHINE = printed.ROOT / "linkage-macros/command/tests/data/triad.rs"
# Bytes of stack, and instructions of the median list: a fifth more than were counted.
MOST_STACK, MOST = 13_000, 19_000_000

CALLER = """
#include "triad_assemblies.h"

/* A call of the emulator, which writes a text. */
static void say(const char *text)
{
    __asm__ volatile("mov r0, #4\\nmov r1, %0\\nbkpt 0xab" : : "r"(text) : "r0", "r1", "memory");
}

static void say_number(uint32_t number)
{
    char text[12] = { 0 };
    int at = 11;
    text[--at] = ' ';
    do {
        text[--at] = (char)('0' + number % 10u);
        number /= 10u;
    } while (number > 0u);
    say(&text[at]);
}

static volatile uint32_t *const timer = (volatile uint32_t *)0xE000E010u;
static uint32_t state = 60u;

static double unit(void)
{
    state = state * 1664525u + 1013904223u;
    return (double)(state >> 8) / 16777216.0;
}

#define PAINTED 8192u

/* Below the caller's frame, so that the next call grows into it. */
static void __attribute__((noinline)) paint(void)
{
    volatile uint32_t words[PAINTED];
    uint32_t at;
    for (at = 0; at < PAINTED; at++) {
        words[at] = 0xa5a5a5a5u;
    }
}

static uint32_t __attribute__((noinline)) unpainted(void)
{
    volatile uint32_t words[PAINTED];
    uint32_t at = 0;
    while (at < PAINTED && words[at] == 0xa5a5a5a5u) {
        at++;
    }
    return 4u * (PAINTED - at);
}

int main(void)
{
    const LinkageBudget budget = { LINKAGE_SAMPLES, LINKAGE_PIECES };
    int nth;
    timer[1] = 0xffffffu;
    timer[0] = 5u;
    for (nth = 0; nth < 60; nth++) {
        Triad machine = triad_default();
        LinkageAssembly found[TRIAD_ASSEMBLIES];
        LinkageAssemblies list;
        uint32_t before, taken, stack;
        machine.bx = 1.0 + 2.0 * unit();
        machine.by = unit() - 0.5;
        machine.cx = 2.0 * unit();
        machine.cy = 1.0 + unit();
        machine.first = 0.5 + unit();
        machine.second = 0.5 + 2.0 * unit();
        machine.third = 0.5 + 2.0 * unit();
        machine.side = 0.5 + unit();
        paint();
        timer[2] = 0u;
        before = timer[2];
        (void)triad_assemblies(&machine, 0.1 * nth, budget, found, &list, NULL);
        taken = (before - timer[2]) & 0xffffffu;
        stack = unpainted();
        say_number(taken);
        say_number(stack);
        say_number((uint32_t)list.outcome);
        say_number(list.count);
        say_number(list.samples);
        say("\\n");
    }
    return 0;
}
"""
# Nanoseconds, which are instructions, of a tick of the timer at 25 MHz.
TICK = 40


def main():
    printed.tools()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "triad.rs").write_text(MACHINE.read_text())
        (folder / "caller.c").write_text(CALLER)
        program = Path(sys.argv[1]).resolve()
        subprocess.run([program, "export", "c", "triad.rs", "-o", "."], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["arm-none-eabi-gcc", *printed.FLAGS, "-O2", "-I.", printed.HERE / "start.c", *folder.glob("*.c"),
                        "-lm", "-o", "program"], cwd=folder, check=True, stderr=subprocess.DEVNULL)
        told = subprocess.run(["qemu-system-arm", "-M", "mps2-an386", "-nographic", "-icount", "shift=0", "-semihosting-config",
                               "enable=on,target=native", "-kernel", "program"], cwd=folder, check=True, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=900).stdout
        rows = [[int(word) for word in line.split()] for line in told.splitlines()]
        taken, stack = sorted(TICK * row[0] for row in rows), max(row[1] for row in rows)
        proved, counts = sum(row[2] == 0 for row in rows), sorted(row[4] for row in rows)
        print(f"{len(rows)} plates on three bars, {proved} lists proved, {sum(row[3] for row in rows)} assemblies, "
              f"{statistics.median(counts):.0f} samples in the median and {counts[-1]} at most")
        median, most = statistics.median(taken) / 1e6, taken[-1] / 1e6
        print(f"{median:.1f} million instructions in the median, {most:.1f} at most, {stack} bytes of stack")
        if len(rows) != 60 or stack > MOST_STACK or statistics.median(taken) > MOST:
            raise SystemExit(f"not 60 lists, or more than {MOST_STACK} bytes, or {MOST} instructions")


if __name__ == "__main__":
    main()
