#!/usr/bin/env python3
"""Runs solvers on an emulated Cortex-M4: instructions of one call, and the same bits as here.

Optional; needs a nightly toolchain, Rust's sources, and qemu-system-arm. Debian has both of the
latter: the packages rust-src and qemu-system-arm. Where the toolchain has no sources of its own,
give the directory `library` of them; they should be as old as the toolchain:

    tests/bare/cortex_m4/run.py [LIBRARY]

It ends with 77 where what Rust's sources are built from cannot be had: their packages come from crates.io.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import printed

ROOT = Path(__file__).resolve().parents[3]
HERE = ROOT / "tests/bare/cortex_m4"
WORK = ROOT / "target/cortex_m4"
TARGET = "thumbv7em-none-eabihf"


def cargo(*arguments, **environment):
    subprocess.run(["cargo", "+nightly", *arguments], cwd=WORK, check=True,
                   env=os.environ | environment)


def fetch(**environment):
    """The packages that `core` is built from. Cargo resolves those of the whole standard library."""
    try:
        cargo("fetch", "--quiet", "-Zbuild-std=core", "--target", TARGET, **environment)
    except (OSError, subprocess.CalledProcessError):
        print("left out: no nightly toolchain, no sources of Rust, or not the packages that are needed", file=sys.stderr)
        raise SystemExit(printed.CANNOT_BE_RUN)


def main():
    WORK.mkdir(parents=True, exist_ok=True)
    manifest = (HERE / "package.toml").read_text().replace("@ROOT@", str(ROOT))
    (WORK / "Cargo.toml").write_text(manifest)
    shutil.copy(ROOT / "Cargo.lock", WORK)
    # Cargo's own tests give it sources by this variable; there is no public way.
    sources = {"__CARGO_TESTS_ONLY_SRC_ROOT": sys.argv[1]} if len(sys.argv) > 1 else {}
    fetch(**sources)
    script = f"-C link-arg=-T{HERE / 'memory.x'}"
    cargo("build", "--quiet", "--release", "-Zbuild-std=core", "--target", TARGET,
          RUSTFLAGS=script, **sources)
    cargo("build", "--quiet", "--release")
    program = WORK / f"target/{TARGET}/release/cortex-m4"
    emulator = ["qemu-system-arm", "-M", "mps2-an386", "-nographic", "-icount", "shift=0",
                "-semihosting-config", "enable=on,target=native", "-kernel", program]
    there = subprocess.run(emulator, check=True, text=True, stdout=subprocess.PIPE,
                           stderr=subprocess.STDOUT, timeout=120)
    here = subprocess.run([WORK / "target/release/cortex-m4"], check=True, text=True,
                          capture_output=True)
    ours = {tuple(line.split(";")[:2]): line.split(";")[3] for line in here.stdout.splitlines()}
    print("| instructions of | f64 | f32 |\n|---|---|---|")
    counts, different = {}, []
    for line in there.stdout.splitlines():
        name, number, count, bits = line.split(";")
        counts.setdefault(name, {})[number] = count
        if ours.pop((name, number)) != bits:
            different.append(f"{name} in {number}")
    for name, count in counts.items():
        print(f"| {name} | {count['f64']} | {count['f32']} |")
    if ours or different:
        raise SystemExit(f"not the same bits as on this machine: {different}; missing: {ours}")
    print("\nThe same bits as on this machine, all of them.")


if __name__ == "__main__":
    main()
