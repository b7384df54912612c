#!/usr/bin/env python3
"""Times a four-bar with a coupler point: as Rust's library, as printed C, and as C of CasADi.

Run from anywhere, by a Python that has casadi: tests/bare/against_casadi.py. Needs Cargo and gcc.
All three compute the same numbers, B, C and the coupler point with the directions of both bars, and their
first and second rates; CasADi's form checks nothing. Each is called in turns within one run, and the least of
all turns is taken. A latency is that of calls each of which waits for the number that the last one wrote last.
"""

import os
import subprocess
from pathlib import Path

import casadi

ROOT = Path(__file__).resolve().parents[2]
WORK = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "against_casadi"

DECLARATION = """
linkage_core::mechanism! {
    pub struct FourBar {
        input theta: angle;
        ground A(0, 0), D(304.8mm, 0);
        crank AB(A) -> B        { length: 101.6mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (254mm, 177.8mm), mode: left }
        point tip on BC at (300mm, -60mm);
        output BC, DC, B, C, tip;
        export c;
    }
}
"""

MANIFEST = f"""
[package]
name = "four_bar"
version = "0.0.0"
edition = "2024"
[lib]
path = "four_bar.rs"
crate-type = ["staticlib"]
[dependencies]
linkage-core = {{ path = "{ROOT}/linkage-core", default-features = false, features = ["macros", "std"] }}
[profile.release]
panic = "abort"
[workspace]
"""

PROGRAM = """
#include <stdio.h>
#include <string.h>
#include <time.h>
#include "four_bar.h"
LinkageStatus printed_motion(double, double, double, FourBarMotion *, LinkageError *);
LinkageStatus printed_position(double, FourBarPosition *, LinkageError *);
int casadi_motion(const double **, double **, long long *, double *, int);
int casadi_position(const double **, double **, long long *, double *, int);
#define CALLS 100000
#define TURNS 101
static double angles[1024];
static volatile double kept;
static double now(void) { struct timespec t; clock_gettime(CLOCK_MONOTONIC, &t); return t.tv_sec + 1e-9 * t.tv_nsec; }
#define TIMED(name, call) \\
    static double name(int waits) { \\
        double last = 0.0, sum = 0.0, begin = now(), to[26]; \\
        const double *from[1]; double *results[1] = { to }; double given[3] = { 0.0, 7.0, -3.0 }; int i; \\
        from[0] = given; (void)results; \\
        for (i = 0; i < CALLS; i++) { \\
            const double theta = angles[i & 1023] + (waits ? last * 1e-300 : 0.0); \\
            given[0] = theta; call; sum += last; \\
        } \\
        kept = sum; return (now() - begin) / CALLS * 1e9; \\
    }
TIMED(rust_motion, FourBarMotion m; four_bar_motion(theta, 7.0, -3.0, &m, NULL); last = m.acceleration.tip.y)
TIMED(c_motion, FourBarMotion m; printed_motion(theta, 7.0, -3.0, &m, NULL); last = m.acceleration.tip.y)
TIMED(their_motion, casadi_motion(from, results, NULL, NULL, 0); last = to[25])
TIMED(rust_position, FourBarPosition m; four_bar_position(theta, &m, NULL); last = m.tip.y)
TIMED(c_position, FourBarPosition m; printed_position(theta, &m, NULL); last = m.tip.y)
TIMED(their_position, casadi_position(from, results, NULL, NULL, 0); last = to[9])
static double (*const all[2][3])(int) = {
    { rust_motion, c_motion, their_motion }, { rust_position, c_position, their_position } };
int main(void)
{
    double best[2][3][2];
    int which, of, waits, turn, i;
    double off = 0.0;
    for (i = 0; i < 1024; i++) angles[i] = i * 0.00613;
    for (i = 0; i < 1024; i++) {
        FourBarMotion m; double to[26], given[3]; const double *from[1] = { given }; double *results[1] = { to };
        const double *const found = (const double *)&m; int k;
        given[0] = angles[i]; given[1] = 7.0; given[2] = -3.0;
        printed_motion(angles[i], 7.0, -3.0, &m, NULL);
        casadi_motion(from, results, NULL, NULL, 0);
        for (k = 0; k < 26; k++) {
            const double by = (found[k] - to[k]) / (k < 18 ? 1.0 : 100.0);
            off = by > off ? by : -by > off ? -by : off;
        }
    }
    for (i = 0; i < 12; i++) best[i / 6][i / 2 % 3][i % 2] = 1e9;
    for (turn = 0; turn < TURNS; turn++)
        for (which = 0; which < 2; which++)
            for (waits = 0; waits < 2; waits++)
                for (of = 0; of < 3; of++) {
                    const double t = all[which][of](waits);
                    if (t < best[which][of][waits]) best[which][of][waits] = t;
                }
    printf("both forms of C agree to %.0e\\n", off);
    for (which = 0; which < 2; which++)
        for (waits = 0; waits < 2; waits++) {
            const double c = best[which][1][waits];
            printf("%s, %s: C %.1f ns, Rust / C %.2f, CasADi / C %.2f\\n", which ? "position" : "motion",
                waits ? "latency" : "throughput", c, best[which][0][waits] / c, best[which][2][waits] / c);
        }
    return !(off < 1e-12);
}
"""


def run(*command, **options):
    options = {"check": True, "cwd": WORK} | options
    subprocess.run([str(part) for part in command], **options)


def theirs():
    """The four-bar as CasADi derives it from its closed form."""
    theta, rate, second = (casadi.SX.sym(name) for name in ("theta", "rate", "second"))
    a, b, c = 0.1016, 0.254, 0.1778
    B, D = a * casadi.vertcat(casadi.cos(theta), casadi.sin(theta)), casadi.DM([0.3048, 0])
    between = D - B
    square = casadi.sumsqr(between)
    share = (b * b - c * c + square) / (2 * square)
    height = casadi.sqrt(b * b / square - share * share)
    C = B + share * between + height * casadi.vertcat(-between[1], between[0])
    BC, DC = (C - B) / b, (C - D) / c
    tip = B + 0.3 * BC - 0.06 * casadi.vertcat(-BC[1], BC[0])
    position = casadi.vertcat(BC, DC, B, C, tip)
    turning = lambda u: u[0] * casadi.jacobian(u[1], theta) - u[1] * casadi.jacobian(u[0], theta)
    first = casadi.vertcat(turning(BC), turning(DC), casadi.jacobian(casadi.vertcat(B, C, tip), theta))
    acceleration = first * second + casadi.jacobian(first, theta) * rate * rate
    generator = casadi.CodeGenerator("theirs.c", {"casadi_int": "long long"})
    given = casadi.vertcat(theta, rate, second)
    motion = casadi.vertcat(position, first * rate, acceleration)
    generator.add(casadi.Function("casadi_motion", [given], [motion]))
    generator.add(casadi.Function("casadi_position", [given], [position]))
    generator.generate(f"{WORK}/")


def compared(flags, rust_flags):
    """Compiles all three for an instruction set, and runs them."""
    target = WORK / ("target" + rust_flags.replace("=", "_").replace(" ", ""))
    run("cargo", "build", "--release", "--offline", "--target-dir", target,
        env=os.environ | {"RUSTFLAGS": rust_flags})
    names = [f"-Dfour_bar_{name}=printed_{name}" for name in ("motion", "position", "motion_at", "position_at")]
    run("gcc", "-std=c99", *flags, *names, "-c", "printed/four_bar.c", "-o", "printed.o")
    run("gcc", "-std=c99", *flags, "-c", "printed/linkage_run.c", "-o", "run.o")
    run("gcc", *flags, "-c", "theirs.c", "-o", "theirs.o")
    run("gcc", "-std=gnu99", "-O2", "-Iprinted", "program.c", "printed.o", "run.o", "theirs.o",
        target / "release/libfour_bar.a", "-lm", "-lpthread", "-ldl", "-o", "program")
    print(" ".join(flags), flush=True)
    run(WORK / "program")


def main():
    WORK.mkdir(parents=True, exist_ok=True)
    (WORK / "four_bar.rs").write_text(DECLARATION)
    (WORK / "Cargo.toml").write_text(MANIFEST)
    (WORK / "Cargo.lock").write_bytes((ROOT / "Cargo.lock").read_bytes())
    (WORK / "program.c").write_text(PROGRAM)
    run("cargo", "run", "--quiet", "--offline", "-p", "linkage-command", "--", "export", "c",
        WORK / "four_bar.rs", "-o", WORK / "printed", "--only", "motion,position,f64", cwd=ROOT)
    theirs()
    compared(["-O2"], "")
    compared(["-O3", "-march=x86-64-v3"], "-C target-cpu=x86-64-v3")


if __name__ == "__main__":
    main()
