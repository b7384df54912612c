#!/usr/bin/env python3
"""Asks rust-analyzer what an editor asks, about the declarations of `ui/shear.rs`, and fails on a wrong answer.

It needs `rustup component add rust-analyzer` and nothing else. The package that it opens depends on
`linkage-core`, as a user's does: hidden methods are hidden from other crates alone.
"""

import os
import pathlib
import shutil
import sys
import time

from client import Editor

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
TARGET = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))

PACKAGE = f"""
[package]
name = "in-an-editor"
version = "0.0.0"
edition = "2024"

[dependencies]
linkage-core = {{ path = "{ROOT}/linkage-core", default-features = false, features = ["macros"] }}

[workspace]
"""

# Without a check at every change: the build of the macro is all that is waited for.
SETTINGS = {
    "checkOnSave": False,
    "cachePriming": {"enable": False},
    "cargo": {"extraArgs": ["--offline"], "targetDir": str(TARGET / "editor" / "target")},
}

# What a solver of this mechanism has, besides what the standard library gives to all types.
METHODS = {
    "position", "velocity", "motion", "coefficients", "position_at", "velocity_at", "motion_at", "lift",
    "solve_position", "solve_velocity", "solve_motion", "solve_coefficients", "solve_position_at",
    "solve_velocity_at", "solve_motion_at", "sweep_position", "sweep_velocity", "sweep_motion",
}
OF_ALL_TYPES = {
    "clone", "clone_from", "clone_into", "eq", "ne", "into", "try_into", "to_owned", "borrow", "borrow_mut",
    "type_id",
}


def package():
    """The package on disk, with the source as it stands in the repository."""
    root = TARGET / "editor"
    (root / "src").mkdir(parents=True, exist_ok=True)
    (root / "Cargo.toml").write_text(PACKAGE)
    shutil.copy(ROOT / "Cargo.lock", root / "Cargo.lock")
    shutil.copy(HERE / "ui" / "shear.rs", root / "src" / "main.rs")
    return root


def completions(file):
    """Exactly what there is is offered."""
    offered = set(file.completions("method"))
    yield offered - OF_ALL_TYPES == METHODS, sorted((offered - OF_ALL_TYPES) ^ METHODS)
    offered = set(file.completions("method of press"))
    forces = {"forces", "statics", "forward_dynamics", "equations_of_motion", "state_rates"}
    yield forces <= offered, sorted(forces - offered)
    absent = {"margins", "sensitivity", "jacobian", "position_at", "sketch", "film", "energy"}
    yield not offered & absent, sorted(offered & absent)


def hovers(file):
    """One definition and its words at a name that is declared, and units at fields."""
    for mark, says in [
        ("name", "Shear of a strip mill."),
        ("input", "made by `input theta`"),
        ("use of input", "made by `input theta`"),
        ("first of inputs", "`q` in rad"),
        ("load", "made by `load cut`"),
        ("use of load", "made by `load cut`"),
        ("param", "Parameter `l` in m; as declared 0.632."),
        ("field of param", "The coupler's length."),
        ("field", "Edge of the knife."),
        ("field of acceleration", "acceleration in m/s²"),
        ("method", "Costs "),
    ]:
        text = file.hover(mark)
        yield says in text, (mark, says, text)
        # Each definition is a block behind that of its module.
        yield text.count("```rust") <= 2, (mark, text)


def hovers_under_a_mistake(file):
    """The user's words and kinds, and nothing that is not known."""
    for mark, says in [
        ("broken solver", "has mistakes"),
        ("broken param", "The coupler's length."),
        ("broken method", "Positions of the outputs."),
        ("broken point", "Edge of the knife."),
    ]:
        text = file.hover(mark)
        yield says in text, (mark, says, text)
        derived = ["Cost", "as declared", "no operation", "closed form", "coordinates", "turns fully"]
        yield not [word for word in derived if word in text], (mark, text)


def definitions(file):
    """Every use leads to the token that declares the name."""
    for mark, name, line in [
        ("use of input", "theta", "input"),
        ("use of pin", "B", "crank AB(A)"),
        ("use of param", "l", "param"),
        ("use of load", "cut", "load"),
        ("field of param", "l", "param"),
        ("field", "blade", "point"),
        ("field of velocity", "blade", "point"),
        ("broken point", "blade", "point"),
        ("use of name", "Shear", "pub struct"),
    ]:
        found = file.definition(mark)
        is_there = len(found) == 1 and found[0][0] == name and found[0][1].startswith(line)
        yield is_there, (mark, found)
    # No token declares the name of a record.
    found = file.definition("use of record")
    yield ("mechanism!", "mechanism! {") in found, found


def renames(file):
    """A new name, given where the old one is declared, reaches every record and every use.

    A field names one definition, and the records of position, velocity and acceleration have one each: an
    editor that is asked at a field changes the declaration and the uses of that record alone.
    """
    at = lambda *marks: sorted((p["line"], p["character"]) for p in map(file.place, marks))
    found = file.renamed("point", "edge")
    wanted = at("point", "field", "field of velocity", "field of acceleration")
    yield found == wanted, (found, wanted)
    found = file.renamed("name", "Cutter")
    yield found == at("name", "use of name"), found
    found = file.renamed("use of pin", "M")
    yield found == at("pin", "use of pin"), found
    found = file.renamed("param", "coupler")
    yield found == at("param", "use of param", "field of param"), found
    found = file.renamed("input", "crank_angle")
    yield found == at("input", "use of input"), found


def main():
    begin = time.monotonic()
    root = package()
    editor = Editor(root, SETTINGS)
    file = editor.open(root / "src" / "main.rs")
    editor.wait(300)
    wrong = 0
    for check in [completions, hovers, hovers_under_a_mistake, definitions, renames]:
        answers = list(check(file))
        failed = [why for is_right, why in answers if not is_right]
        wrong += len(failed)
        print(f"{check.__name__}: {len(answers) - len(failed)} of {len(answers)} right")
        for why in failed:
            print("  wrong:", *(why if isinstance(why, tuple) else [why]))
    editor.close()
    print(f"{time.monotonic() - begin:.0f} s")
    sys.exit(min(wrong, 1))


if __name__ == "__main__":
    main()
