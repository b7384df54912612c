#!/usr/bin/env python3
"""The parts of a search on many machines, by Dask's `distributed`.

    cargo build --release -p atlas
    python3 -m venv target/python
    target/python/bin/pip install distributed==2026.8.0
    target/python/bin/python examples/atlas/cluster.py my_path.txt --grid 80,41,29 --parts 1000 --workers 2
    target/python/bin/python examples/atlas/cluster.py my_path.txt --grid 80,41,29 --parts 1000 \\
        --scheduler tcp://10.0.0.1:8786 --program /opt/atlas

Without `--scheduler` so many workers are started on this machine, of one thread each. The program must be at the
same path on every machine; no other file is shared: the path goes out with each part, and its list comes back.
A part whose file is whole is not run again, a part whose worker dies is run by another, and the
result is that of a single process, bit for bit, as long as all machines round alike; where they do not, the
merge says so.

Why Dask and not Ray: both run a function on many machines and run it again where one dies. Dask's is
25 packages and 70 MB, all in Python, so that it installs wherever Python does; Ray's is 285 MB of binaries for a
few systems, with an object store for data that programs like this one do not have.
"""

import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import time

PROGRAM = pathlib.Path("target/release/atlas")
# Parts whose list does not arrive whole are run again, so often in all.
ROUNDS = 3


def run_part(part, parts, program, drawn, grid):
    """One part on the machine of a worker: the text of its file, which is checked where it arrives."""
    with tempfile.TemporaryDirectory() as directory:
        out = pathlib.Path(directory, "part.txt")
        arguments = [program, "--grid", grid, "--part", f"{part}/{parts}", "--out", str(out)]
        if drawn is not None:
            path = pathlib.Path(directory, "path.txt")
            path.write_text(drawn, encoding="utf-8")
            arguments.append(str(path))
        # Workers are as many as cores.
        environment = {**os.environ, "RAYON_NUM_THREADS": "1"}
        subprocess.run(arguments, check=True, env=environment, capture_output=True)
        return out.read_text(encoding="ascii")


def keep(text, file):
    """Writes a part's file; who reads it meanwhile finds all of it or nothing."""
    beside = file.with_suffix(f".{os.getpid()}.unfinished")
    with open(beside, "w", encoding="ascii") as unfinished:
        unfinished.write(text)
        unfinished.flush()
        os.fsync(unfinished.fileno())
    os.replace(beside, file)


class Search:
    """A search in parts, whose files are in one directory."""

    def __init__(self, program, path, grid, parts, directory):
        self.program, self.path, self.grid, self.parts = str(program), path, grid, parts
        self.directory = pathlib.Path(directory)
        self.directory.mkdir(parents=True, exist_ok=True)

    def call(self, *arguments, **options):
        """Calls the program on this machine."""
        path = [] if self.path is None else [str(self.path)]
        arguments = [self.program, *path, "--grid", self.grid, *map(str, arguments)]
        return subprocess.run(arguments, check=True, text=True, **options)

    def missing(self):
        """The numbers of parts that have no whole file."""
        listed = self.call("--missing", self.parts, self.directory, capture_output=True)
        return [int(number) for number in listed.stdout.split()]

    def file_of(self, part):
        """Where a part's list is kept."""
        return self.directory / f"part-{part}-of-{self.parts}.txt"

    def run(self, client, on_part=None):
        """Runs what is missing on the client's workers; calls `on_part` after each."""
        from distributed import as_completed

        drawn = None if self.path is None else pathlib.Path(self.path).read_text(encoding="utf-8")
        for _ in range(ROUNDS):
            missing = self.missing()
            if not missing:
                return
            start, done = time.monotonic(), 0
            arguments = [self.parts, self.program, drawn, self.grid]
            futures = client.map(run_part, missing, *[[one] * len(missing) for one in arguments], pure=False)
            of = dict(zip([future.key for future in futures], missing))
            for future, text in as_completed(futures, with_results=True):
                part, done = of[future.key], done + 1
                keep(text, self.file_of(part))
                seconds = time.monotonic() - start
                left = seconds / done * (len(missing) - done)
                print(f"part {part}: {done} of {len(missing)}, {left:.0f} s to go", flush=True)
                if on_part is not None:
                    on_part(part)
        sys.exit(f"parts {self.missing()} do not arrive whole; look at the workers' disks and network")


def main():
    """Starts or joins workers, runs and merges."""
    parser = argparse.ArgumentParser(description="A search of four-bars in parts, on Dask's distributed.")
    parser.add_argument("path", nargs="?", help="the drawn path")
    parser.add_argument("--grid", default="40,21,15", help="lengths, columns and rows of the grid")
    parser.add_argument("--parts", type=int, default=64, help="how many parts")
    parser.add_argument("--workers", type=int, default=os.cpu_count(), help="workers on this machine")
    parser.add_argument("--scheduler", help="the address of a scheduler that runs already")
    parser.add_argument("--directory", default="target/atlas/parts", help="where the parts' files are kept")
    parser.add_argument("--program", default=PROGRAM, help="the program, at the same path on every machine")
    parser.add_argument("--best", default="target/atlas/best.csv", help="where the refined list is written")
    arguments = parser.parse_args()

    from distributed import Client, LocalCluster

    search = Search(
        pathlib.Path(arguments.program).absolute(),
        arguments.path,
        arguments.grid,
        arguments.parts,
        arguments.directory,
    )
    if arguments.scheduler:
        with Client(arguments.scheduler) as client:
            search.run(client)
    else:
        workers = {"n_workers": arguments.workers, "threads_per_worker": 1, "dashboard_address": None}
        with LocalCluster(**workers) as cluster, Client(cluster) as client:
            search.run(client)
    search.call("--merge", arguments.parts, arguments.directory, "--best", arguments.best)


if __name__ == "__main__":
    main()
