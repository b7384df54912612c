#!/usr/bin/env python3
"""What a solver needs on the machine: instructions, stack and code, as the manual has them.

Run from anywhere: tests/bare/measure.py. Needs Cargo, gcc and valgrind. Everything is compiled
for this machine's plain instruction set; counts are of one call through the C interface.
"""

import os
import re
import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BARE = ROOT / "target/tmp/bare"
WORK = ROOT / "target/measure"
CALLS = 1000

# A pose that is solved in a straight line, and inputs that take the careful path to its end: an
# angle that needs the long reduction, a machine at its limit.
POSES = {
    "flying_shear": ("2.0", "1e9"),
    "tuned_four_bar": ("1.0", "1e9"),
    "slider_crank": ("1.0", "1e9"),
    "six_bar": ("1.0", "1e9"),
    "crossed_guides": ("1.0", "1e9"),
    "excavator": ("2.3125, 2.25, 1.90625", "2.3125, 2.25, 9.0"),
}
ENTRIES = ["position", "motion", "coefficients"]


def run(*command, **options):
    options = {"check": True, "text": True, "capture_output": True, "cwd": ROOT} | options
    try:
        return subprocess.run([str(part) for part in command], **options)
    except subprocess.CalledProcessError as error:
        raise SystemExit(f"{error}\n{error.stderr}") from error


def library(level):
    """The solvers at an optimisation level, and their headers."""
    # Writes the package and the headers.
    run("cargo", "test", "--test", "crates", "c_caller", "--", "--include-ignored")
    kept = WORK / f"solvers-{level}.a"
    environment = {"CARGO_PROFILE_RELEASE_OPT_LEVEL": level}
    run("cargo", "build", "--release", "--offline", "--target-dir", BARE / "target",
        cwd=BARE / "package", env=os.environ | environment)
    shutil.copy(BARE / "target/release/libbare.a", kept)
    return kept


def prototypes(mechanism):
    """The C functions of a mechanism: name and types of the arguments."""
    header = (BARE / f"{mechanism}.h").read_text()
    for name, arguments in re.findall(r"^LinkageStatus (\w+)\((.*)\);$", header, re.M):
        if re.sub(r"_f32$", "", name.removeprefix(mechanism + "_")) in ENTRIES:
            yield name, [argument.strip() for argument in arguments.split(",")]


def wrapper(mechanism, name, arguments):
    """A C function without arguments that calls one of a mechanism's in the pose at hand."""
    number = "float" if name.endswith("_f32") else "double"
    lines, passed = [], []
    for order, argument in enumerate(arguments):
        kind, variable = re.match(r"(.*?)(\w+(?:\[.*\])?)$", argument).groups()
        if variable == "mechanism":
            suffix = "_f32" if number == "float" else ""
            lines.append(f"static {kind.replace('*', '').replace('const ', '')}m;")
            lines.append(f"m = {mechanism}_default{suffix}();")
            passed.append("&m")
        elif variable == "error":
            passed.append("NULL")
        elif "[" in variable:
            lines.append(f"static {kind}answer{variable[variable.index('['):]};")
            passed.append("answer")
        elif kind.startswith("const "):
            values = ", ".join(f"({number})q[{i}]" for i in range(3))
            lines.append(f"{kind.replace('*', '')}q{order} = {{{values}}};")
            passed.append(f"&q{order}")
        elif "*" in kind:
            lines.append(f"static {kind.replace('*', '')}answer;")
            passed.append("&answer")
        else:
            passed.append(f"({number})q[0]" if order == 0 or "rate" not in variable else "1")
    return f"static void call_{name}(void)\n{{\n    " + "\n    ".join(
        [*lines, f"{name}({', '.join(passed)});"]) + "\n}\n"


def program(level_library):
    """A C program that calls every function, and says how much stack it takes."""
    source, table = [], []
    for mechanism in POSES:
        source.append(f'#include "{mechanism}.h"\n')
    source.append((ROOT / "tests/bare/measure.c").read_text())
    for mechanism, poses in POSES.items():
        for name, arguments in prototypes(mechanism):
            source.append(wrapper(mechanism, name, arguments))
            straight, careful = (f"(const double[3]){{{pose}}}" for pose in poses)
            table.append(f'measure(argc > 1, "{name}", call_{name}, {straight}, {careful});')
    source.append("int main(int argc, char **argv)\n{\n    (void)argv;\n    ")
    source.append("\n    ".join(table) + "\n    return 0;\n}\n")
    (WORK / "measure.c").write_text("".join(source))
    target = WORK / "measure"
    run("gcc", "-O1", "-g", "-Wall", f"-DCALLS={CALLS}", "-I", BARE, WORK / "measure.c",
        level_library, "-Wl,--gc-sections", "-o", target)
    return target


def stack(target):
    """Bytes of stack by function, in the deeper of its poses."""
    lines = (line.split() for line in run(target).stdout.splitlines())
    return {name: int(depth) for name, depth in lines}


def instructions(target):
    """Instructions of one call by function, in its first pose."""
    out = WORK / "callgrind.out"
    run("valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", target, "count")
    text = run("callgrind_annotate", "--inclusive=yes", "--threshold=100", out).stdout
    found = re.findall(r"^\s*([\d,]+) \(.*?\)\s+\S*?:?(\w+)(?: \[.*\])?$", text, re.M)
    return {name: round(int(count.replace(",", "")) / CALLS) for count, name in found}


def code(level_library, names):
    """Bytes of code by function: what no other solver needs, straight line and careful path; and the
    most that any of them needs beside, code and constants, which solvers share."""
    functions, whole = {}, {}
    for name in names:
        (WORK / "one.c").write_text(
            f"#include <stddef.h>\nvoid {name}(void);\n"
            f"void (*const volatile solvers[])(void) = {{{name}}};\n"
            "const size_t solver_count = 1;\n")
        run("gcc", "-O1", "-ffreestanding", "-nostdlib", "-static", "-Wl,--gc-sections",
            ROOT / "tests/bare/alone.c", WORK / "one.c", level_library, "-o", WORK / "one")
        # Symbols as they are: what is generic has one for each of its uses.
        symbols = re.findall(r"^\w+ (\w+) [tT] (\S+)$", run("nm", "-S", WORK / "one").stdout, re.M)
        functions[name] = {symbol: int(size, 16) for size, symbol in symbols}
        rows = [line.split() for line in run("size", "-A", WORK / "one").stdout.splitlines()]
        whole[name] = sum(int(row[1]) for row in rows if row and row[0] in (".text", ".rodata"))
    users = {}
    for name, each in functions.items():
        solver = next(solver for solver in POSES if name.startswith(solver))
        for symbol in each:
            users.setdefault(symbol, set()).add(solver)
    own = {name: sum(size for symbol, size in each.items() if len(users[symbol]) == 1)
           for name, each in functions.items()}
    return own, max(whole[name] - own[name] for name in names)


def children_time():
    times = os.times()
    return times.children_user + times.children_system


def build_times():
    """Seconds of one processor from nothing and after a change, of a library with one mechanism."""
    library, target = ROOT / "examples/c_caller/library", WORK / "build"
    shutil.rmtree(target, ignore_errors=True)
    shutil.copy(ROOT / "Cargo.lock", library / "Cargo.lock")
    times = []
    for _ in range(2):
        (library / "src/mechanism.rs").touch()
        begin = children_time()
        run("cargo", "build", "--release", "--offline", "--target-dir", target, cwd=library)
        times.append(children_time() - begin)
    return times


def main():
    WORK.mkdir(parents=True, exist_ok=True)
    fast, small = library("3"), library("s")
    target = program(fast)
    depth, count = stack(target), instructions(target)
    (size, shared), (smaller, smaller_shared) = code(fast, depth), code(small, depth)
    print("| solver | instructions f64, f32 | stack f64, f32 (bytes) | code f64, f32 (bytes) "
          "| at opt-level s |")
    print("|---|---|---|---|---|")
    for mechanism in POSES:
        for entry in ENTRIES:
            wide = f"{mechanism}_{entry}"
            pair = lambda found: f"{found[wide]}, {found[wide + '_f32']}"
            print(f"| {mechanism.replace('_', ' ')}, `{entry}` | {pair(count)} | {pair(depth)} "
                  f"| {pair(size)} | {pair(smaller)} |")
    print(f"\nBeside its own code a solver needs at most {shared} bytes of code and constants, "
          f"{smaller_shared} at opt-level s, which all solvers share.")
    first, again = build_times()
    print(f"A library with one mechanism takes {first:.1f} s of one processor to build from nothing "
          f"and {again:.1f} s after a change.")


if __name__ == "__main__":
    main()
