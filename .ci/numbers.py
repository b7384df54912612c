#!/usr/bin/env python3
"""Compares numbers of README and manual with what their commands print today.

    .ci/numbers.py              runs every command of .ci/numbers.txt and compares
    .ci/numbers.py --list       what would be run
    .ci/numbers.py WORD         runs those commands that hold the word

A line of .ci/numbers.txt has five fields between `|||`:

    page ||| words of the page with one `<number>` for each number ||| command ||| pattern ||| allowance

The pattern is a regular expression for the command's output, with a group for each number; its last match counts. The
allowance is a share of the page's number, or a number with `+-` in front of it. The words must stand on the page, so
that nobody changes one and forgets the other, and so must the command. `$SHEAR` is a file with the README's machine.
A command that ends with 77 cannot be run on this machine. Its rows are left out, and said to be.
"""
import os, re, subprocess, sys, tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
CANNOT_BE_RUN = 77
NUMBER = r"([-+−]?[0-9][0-9.,]*(?:e[-+]?[0-9]+)?)"


def rows():
    with open(os.path.join(ROOT, ".ci", "numbers.txt"), encoding="utf-8") as file:
        for nth, line in enumerate(file, 1):
            if line.strip() and not line.startswith("#"):
                fields = [field.strip() for field in line.split("|||")]
                if len(fields) != 5:
                    sys.exit(f".ci/numbers.txt:{nth}: five fields are needed")
                yield fields


def value(text):
    return float(text.replace("−", "-").replace(",", "").rstrip("."))


def joined(page):
    with open(os.path.join(ROOT, page), encoding="utf-8") as file:
        return re.sub(r"\s+", " ", file.read())


def printed(page, words):
    """The numbers of the page, or nothing where the words do not stand on it."""
    pattern = NUMBER.join(re.escape(part) for part in re.sub(r"\s+", " ", words).split("<number>"))
    found = re.search(pattern, joined(page))
    return found and [value(number) for number in found.groups()]


def shear(folder):
    """The first declaration of the README, in a file of its own."""
    with open(os.path.join(ROOT, "README.md"), encoding="utf-8") as file:
        text = re.search(r"(?ms)^```text\n(mechanism! \{.*?)^```", file.read()).group(1)
    path = os.path.join(folder, "shear.rs")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def output(command, path, seen):
    if command not in seen:
        run = command.replace("$SHEAR", path)
        done = subprocess.run(run, shell=True, cwd=ROOT, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        seen[command] = (done.returncode, done.stdout)
    return seen[command]


def judged(row, path, seen):
    """`right`, `wrong` or `left out`, and why."""
    page, words, command, pattern, allowance = row
    wanted = printed(page, words)
    if not wanted:
        return "wrong", f"{page} does not say `{words}`"
    status, text = output(command, path, seen)
    if status == CANNOT_BE_RUN:
        return "left out", command
    matches = re.findall(pattern, text)
    if not matches:
        last = "\n".join("  " + line for line in text.splitlines()[-20:])
        return "wrong", f"`{command}` ends with {status} and prints nothing that matches `{pattern}`:\n{last}"
    found = matches[-1] if isinstance(matches[-1], tuple) else (matches[-1],)
    found = [value(number) for number in found]
    if len(found) != len(wanted):
        return "wrong", f"{len(found)} numbers of `{pattern}` for {len(wanted)} of the page"
    for there, here in zip(wanted, found):
        by = float(allowance[2:]) if allowance.startswith("+-") else float(allowance) * abs(there)
        if not abs(here - there) <= by:
            return "wrong", f"{page} says {there:g}, `{command}` prints {here:g}"
    return "right", words


def leave_out(commands):
    """Tells CI what a missing tool leaves out."""
    if commands and "LINKAGE_SKIPS" in os.environ:
        with open(os.environ["LINKAGE_SKIPS"], "a", encoding="utf-8") as file:
            file.writelines(f"numbers: cannot be run here: {command}\n" for command in sorted(commands))


def main():
    word = " ".join(sys.argv[1:])
    chosen = [row for row in rows() if word in ("", "--list") or word in row[2]]
    if word == "--list":
        print("\n".join(f"{row[2]}  ({row[0]})" for row in chosen))
        return
    with tempfile.TemporaryDirectory() as folder:
        path, seen = shear(folder), {}
        verdicts = [judged(row, path, seen) for row in chosen]
    for verdict, text in verdicts:
        print(f"{verdict}: {text}")
    leave_out({text for verdict, text in verdicts if verdict == "left out"})
    sys.exit(any(verdict == "wrong" for verdict, _ in verdicts))


if __name__ == "__main__":
    main()
