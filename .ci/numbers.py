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
"""
import os, re, subprocess, sys, tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
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


def fault(row, path, seen):
    page, words, command, pattern, allowance = row
    wanted = printed(page, words)
    if not wanted:
        return f"{page} does not say `{words}`"
    status, text = output(command, path, seen)
    matches = re.findall(pattern, text)
    if not matches:
        return f"`{command}` ends with {status} and prints nothing that matches `{pattern}`"
    found = matches[-1] if isinstance(matches[-1], tuple) else (matches[-1],)
    found = [value(number) for number in found]
    if len(found) != len(wanted):
        return f"{len(found)} numbers of `{pattern}` for {len(wanted)} of the page"
    for there, here in zip(wanted, found):
        by = float(allowance[2:]) if allowance.startswith("+-") else float(allowance) * abs(there)
        if not abs(here - there) <= by:
            return f"{page} says {there:g}, `{command}` prints {here:g}"
    return None


def main():
    word = " ".join(sys.argv[1:])
    chosen = [row for row in rows() if word in ("", "--list") or word in row[2]]
    if word == "--list":
        print("\n".join(f"{row[2]}  ({row[0]})" for row in chosen))
        return
    with tempfile.TemporaryDirectory() as folder:
        path, seen = shear(folder), {}
        faults = [fault(row, path, seen) for row in chosen]
    for row, text in zip(chosen, faults):
        print(f"{'wrong' if text else 'right'}: {text or row[1]}")
    sys.exit(any(faults))


if __name__ == "__main__":
    main()
