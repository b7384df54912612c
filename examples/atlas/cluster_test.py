#!/usr/bin/env python3
"""A search on two workers, of which one is killed, and a part's file that is cut in half.

    cargo build --release -p atlas
    target/python/bin/python examples/atlas/cluster_test.py

The result must be that of one process, byte for byte, and no part may be run that has a whole file. Where
`distributed` is not installed the test is skipped and says so. Another program than the release build's is an
argument.
"""

import pathlib
import signal
import os
import subprocess
import sys
import tempfile
import time

import cluster

GRID = "8,5,4"
PARTS = 12
REFINED = 3
PATH = pathlib.Path(__file__).parent / "paths" / "d.txt"


class Accidents:
    """Kills a worker that is busy after the first part, and cuts the first part's file after the fourth."""

    def __init__(self, client, search):
        self.client, self.search = client, search
        self.parts, self.killed, self.unfinished = [], None, []

    def __call__(self, part):
        self.parts.append(part)
        if len(self.parts) == 1:
            self.kill()
        if len(self.parts) == 4:
            file = self.search.file_of(self.parts[0])
            text = file.read_bytes()
            file.write_bytes(text[: len(text) // 2])

    def kill(self):
        """Kills a worker's process without warning, while it runs a part."""
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline:
            busy = {address: keys for address, keys in self.client.processing().items() if keys}
            workers = self.client.scheduler_info(n_workers=-1)["workers"]
            for address, keys in busy.items():
                if address in workers:
                    process = self.client.run(os.getpid, workers=[address])[address]
                    self.killed, self.unfinished = process, list(keys)
                    os.kill(process, signal.SIGKILL)
                    return
            time.sleep(0.01)
        raise AssertionError("no worker is busy")


def alone(program, directory):
    """The result of one process."""
    best = directory / "alone.csv"
    arguments = [str(program), str(PATH), "--grid", GRID, "--refine", str(REFINED), "--best", str(best)]
    subprocess.run(arguments, check=True, capture_output=True, cwd=directory)
    return best.read_bytes()


def merged(search, directory):
    """The result of the parts."""
    best = directory / "merged.csv"
    arguments = ["--refine", REFINED, "--merge", search.parts, search.directory, "--best", best]
    search.call(*arguments, capture_output=True, cwd=directory)
    return best.read_bytes()


def test(program, directory):
    """Runs, with accidents and again, and compares."""
    from distributed import Client, LocalCluster

    wanted = alone(program, directory)
    assert wanted.count(b"\n") == 1 + REFINED, wanted
    search = cluster.Search(program, PATH, GRID, PARTS, directory / "parts")
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as workers:
        with Client(workers) as client:
            accidents = Accidents(client, search)
            search.run(client, accidents)
            assert accidents.killed and accidents.unfinished, "no worker was killed while it ran a part"
            # Every part once, and the one that was cut a second time.
            every = sorted(range(1, PARTS + 1))
            assert sorted(accidents.parts[:PARTS]) == every, accidents.parts
            assert accidents.parts[PARTS:] == accidents.parts[:1], accidents.parts
            assert merged(search, directory) == wanted, "the result is not that of one process"

            # What is whole is kept: nothing runs, and no file is touched.
            before = {file: file.stat().st_mtime_ns for file in search.directory.iterdir()}
            assert len(before) == PARTS, before
            again = []
            search.run(client, again.append)
            after = {file: file.stat().st_mtime_ns for file in search.directory.iterdir()}
            assert again == [] and before == after, "a part that was whole ran again"

            # Without its first part a search is not merged.
            search.file_of(1).unlink()
            try:
                merged(search, directory)
            except subprocess.CalledProcessError as error:
                assert "part 1/12: there is no such file" in error.stderr, error.stderr
            else:
                raise AssertionError("a search was merged without one of its parts")
    print(f"cluster_test: passed, worker {accidents.killed} killed while it ran {len(accidents.unfinished)} parts")


def main():
    """Skips, or tests in a directory that is removed."""
    try:
        import distributed  # noqa: F401
    except ImportError:
        print("cluster_test: skipped, the package `distributed` is not installed")
        return
    program = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else cluster.PROGRAM).absolute()
    with tempfile.TemporaryDirectory() as directory:
        test(program, pathlib.Path(directory))


if __name__ == "__main__":
    main()
