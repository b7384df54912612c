#!/usr/bin/env python3
"""Compares the printed C of mechanisms with and without `double`, those of `mechanisms.rs` and of the tests of friction: each function in `float` is called
by the same random numbers, and by numbers some last places beside a limit, and answers with the same status, group and
name. Numbers may differ by rounding, seldom.

Needs a C compiler. The program `linkage` is the first argument; the second, if any, how often each function is called:

    tests/bare/without_double.py target/debug/linkage 20000
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
EFFORTS = ("work", "push", "friction", "brake", "gas")
ANGLES = ("theta", "psi", "first", "second", "shoulder", "cos", "swing")


def drawn(kind, name, place, is_parameter):
    """A number at random, after what its name says it is."""
    if kind == "int32_t":
        return "(double)mode()"
    if is_parameter:
        return f"changed((double){place})"
    if "_rate" in name or "_acceleration" in name:
        return "rate()"
    if name in EFFORTS or "drive" in name:
        return "effort()"
    words = {"sin": "amplitude()", "x": "stroke()", "h": "span()"} | dict.fromkeys(ANGLES, "angle()")
    return words.get(name, "length()")


def fields(header, record):
    body = re.search(rf"typedef struct {record} \{{\n(.*?)\}}", header, flags=re.S).group(1)
    return re.findall(r"^\s+(\w+) (\w+);$", body, flags=re.M)


def called(header, stem, name, arguments):
    """C functions that draw what a function is called with, and that call it both ways; and its row of the table."""
    declared, given, passed, parameters = "", [], "", ""
    *inputs, (kind_of_answer, answer), _ = arguments
    for kind, argument in inputs:
        number = kind.replace("const ", "").rstrip("*").strip()
        if "[" in argument:
            argument, count = argument[:-1].split("[")
            declared += f"    {number} {argument}_[{count}];\n"
            given += [(f"{argument}_[{at}]", number, argument, False) for at in range(int(count))]
        elif kind.startswith("const "):
            is_own = argument == "mechanism"
            line = f"    {number} {argument}_ = {f'{stem}_default_f32()' if is_own else '{ 0 }'};\n"
            declared += line
            parameters = line + "    (void)mechanism_;\n" if is_own else parameters
            for field_kind, field in fields(header, number):
                word = "_rate" if argument in ("rates", "accelerations") else "work" if argument == "loads" else field
                given.append((f"{argument}_.{field}", field_kind, word, is_own))
            argument = f"&{argument}"
            passed += f"{argument}_, "
            continue
        else:
            declared += f"    {number} {argument}_;\n"
            given.append((f"{argument}_", number, argument, False))
        passed += f"{argument}_, "
    answer, _, dimensions = answer.partition("[")
    dimensions = f"[{dimensions}" if dimensions else ""
    record, by = kind_of_answer.rstrip("*").strip(), "" if dimensions else "&"
    sets = ""
    for at, (place, kind, word, _) in enumerate(given):
        value = {"cos": f"cos(g[{at}]) * g[{at + 1}]", "sin": f"sin(g[{at - 1}]) * g[{at}]"}.get(word, f"g[{at}]")
        sets += f"    {place} = ({kind})({value});\n"
    draws = "".join(f"    g[{at}] = {drawn(kind, word, place, own)};\n" for at, (place, kind, word, own) in enumerate(given))
    modes = "".join("m" if kind == "int32_t" else "n" for _, kind, _, _ in given)
    code = f"""
static void draw_{name}(double *g)
{{
{parameters}{draws}}}

static void call_{name}(const double *g)
{{
    {record} {answer}_a{dimensions}, {answer}_b{dimensions};
    LinkageError a, b;
    LinkageStatus status;
{declared}{sets}    a = b = untold;
    memset(&{answer}_a, 0xa5, sizeof {answer}_a);
    memset(&{answer}_b, 0xa5, sizeof {answer}_b);
    status = {name}({passed}{by}{answer}_a, &a);
    compare(status, without_{name}({passed}{by}{answer}_b, &b), &{answer}_a, &{answer}_b, sizeof {answer}_a, 1, &a, &b);
}}
"""
    return code, f'    {{ "{name}", "{modes}", 1, draw_{name}, call_{name} }},\n'


def harness(folder):
    headers = {path.stem: path.read_text() for path in sorted(folder.glob("*.h")) if path.stem != "linkage_run"}
    code, table, names = "", "", []
    for stem, header in headers.items():
        for name, arguments in re.findall(r"^LinkageStatus (\w+_f32)\((.*)\);$", header, flags=re.M):
            pairs = [re.match(r"(.*?[ *])(\w+(?:\[.*\])?)$", argument).groups() for argument in arguments.split(", ")]
            pairs = [(kind.strip(), argument) for kind, argument in pairs]
            functions, row = called(header, stem, name, pairs)
            code += f"LinkageStatus without_{name}({arguments});\n{functions}"
            table += row
            names.append(name)
    text = (HERE / "printed_c.c").read_text()
    text = text.replace("/* HEADERS */\n", "".join(f'#include "{stem}.h"\n' for stem in headers))
    text = text.replace("/* FUNCTIONS */\n", f"{code}\nstatic const Function ALL[] = {{\n{table}}};\n")
    (folder / "harness.c").write_text(text)
    return names


def run(*command, **options):
    found = subprocess.run([str(part) for part in command], text=True, capture_output=True, **options)
    if found.returncode != 0:
        raise SystemExit(f"{found.stdout[-4000:]}{found.stderr[-4000:]}")
    return found.stdout


def compared(file, flags, calls):
    """Counts of functions, of answers and refusals that are alike, and of answers by other last places."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        run(Path(sys.argv[1]).resolve(), "export", "c", file, "-o", folder)
        names = harness(folder)
        sources = [path.name for path in sorted(folder.glob("*.c")) if path.name != "harness.c"]
        strict = ["-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-c"]
        for source in sources:
            run("gcc", *strict, source, "-o", f"with_{source}.o", cwd=folder)
            run("gcc", *strict, "-DLINKAGE_NO_DOUBLE", "-Wdouble-promotion", source, "-o", f"without_{source}.o", cwd=folder)
        # Of the build without `double` all names begin anew, so that both are in one program.
        run("ld", "-r", *[f"without_{source}.o" for source in sources], "-o", "without.o", cwd=folder)
        defined = re.findall(r"^\w+ [A-Z] (\w+)$", run("nm", "-g", "--defined-only", "without.o", cwd=folder), flags=re.M)
        (folder / "renamed").write_text("".join(f"{symbol} without_{symbol}\n" for symbol in defined))
        run("objcopy", "--redefine-syms=renamed", "without.o", cwd=folder)
        run("gcc", "-std=c99", "-O1", "-D_GNU_SOURCE", "-DWITHOUT_DOUBLE", *flags, "-Wall", "-Wextra", "-Wno-unused-function",
            "-Werror", "harness.c", "without.o", *[f"with_{source}.o" for source in sources], "-lm", "-o", "harness", cwd=folder)
        told = run("./harness", calls, cwd=folder)
        lines = [re.match(r"(\w+) (\w+) (\d+) answered (\d+) refused", line) for line in told.splitlines()]
        answered, refused = (sum(int(line[at]) for line in lines if line) for at in (3, 4))
        apart = sum(map(int, re.findall(r", (\d+) apart", told)))
        print(f"{file.name}: {len(names)} functions, {answered} answered and {refused} refused alike, {apart} by other last places")
        if len(names) < 100 or refused * 10 < answered or apart * 200 > answered:
            raise SystemExit(told)


def main():
    calls = sys.argv[2] if len(sys.argv) > 2 else "20000"
    compared(HERE / "mechanisms.rs", [], calls)
    compared(HERE.parent / "src/mechanisms/friction.rs", ["-DRUBS"], calls)


if __name__ == "__main__":
    main()
