#!/usr/bin/env python3
"""Does what a page of the manual tells a reader to do, in an empty folder, and compares what it shows.

    .ci/first_hour.py PAGE.md [FOLDER]

A block whose paragraph before ends with "`NAME`:" becomes the file of that name. A block of `console` is typed: the lines
after "$ "; the lines below a command are what it has to print, and a line of "…" stands for any lines. The folder holds
the repository as `linkage`, and programs are installed into it.
"""
import os, re, shutil, subprocess, sys, tempfile

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))


def blocks(page):
    """The language, the text before, and the text of each block."""
    before, inside = [], None
    for line in page.split("\n"):
        if line.startswith("```"):
            if inside is None:
                inside = (line[3:].split(",")[0], " ".join(" ".join(before).split()), [])
            else:
                yield inside[0], inside[1], "\n".join(inside[2]) + "\n"
                before, inside = [], None
        elif inside is not None:
            inside[2].append(line)
        else:
            before.append(line)


def is_shown(printed, shown):
    parts = [re.escape(part) for part in shown.split("…\n")]
    return re.fullmatch("(?s)" + ".*".join(parts), printed) is not None


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        page = file.read()
    folder = sys.argv[2] if len(sys.argv) > 2 else tempfile.mkdtemp()
    os.makedirs(folder, exist_ok=True)
    if not os.path.exists(os.path.join(folder, "linkage")):
        os.symlink(ROOT, os.path.join(folder, "linkage"))
    environment = dict(os.environ, CARGO_INSTALL_ROOT=folder)
    environment["PATH"] = os.path.join(folder, "bin") + os.pathsep + environment["PATH"]
    typed = 0
    for language, before, text in blocks(page):
        named = re.search(r"`([\w./]+\.\w+)`[^`]*:$", before)
        if language == "console":
            for command in text.split("$ ")[1:]:
                line, shown = command.split("\n", 1)
                done = subprocess.run(line, shell=True, cwd=folder, env=environment, text=True,
                                      stdout=subprocess.PIPE, stderr=subprocess.PIPE)
                typed += 1
                if done.returncode or shown and not is_shown(done.stdout, shown):
                    sys.exit(f"{sys.argv[1]}: $ {line}\nstatus {done.returncode}\n{done.stdout}{done.stderr}\n"
                             f"the page shows:\n{shown}")
        elif named and language:
            path = os.path.join(folder, named.group(1))
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
    if not typed:
        sys.exit(f"{sys.argv[1]} tells nothing to type")
    print(f"{sys.argv[1]}: {typed} commands did what the page shows")
    if len(sys.argv) <= 2:
        shutil.rmtree(folder)


main()
