#!/usr/bin/env python3
"""A part of the atlas by pylinkage: the same curves, pose by pose, and the time they take.

    cargo run --release -p atlas
    python3 -m venv target/python
    target/python/bin/pip install pylinkage==1.3.0
    target/python/bin/python examples/atlas/compare.py

Reads target/atlas/curves.csv, which the first command writes, takes every fifty-third curve, lets pylinkage
step through its poses, and says how many poses a second that makes and how far its numbers are from ours. With
`--numba`, and numba installed beside it, its compiled stepping is used.
"""

import cmath
import csv
import math
import sys
import time

from pylinkage.actuators import Crank
from pylinkage.components import Ground
from pylinkage.dyads import FixedDyad, RRRDyad
from pylinkage.simulation import Linkage

EVERY = 53
PLACE = 4
# The quickest of so many runs counts: in it the machine did the least besides.
REPEATS = 5


def left_pin(crank_pin, pivot, coupler, follower):
    """The follower's pin left of the line from the crank's pin to the follower's pivot."""
    reach = pivot - crank_pin
    distance = abs(reach)
    along = (distance**2 + coupler**2 - follower**2) / (2 * distance)
    across = math.sqrt(max(coupler**2 - along**2, 0.0))
    return crank_pin + complex(along, across) * reach / distance


def four_bar(coupler, follower, base, point, step):
    """The linkage one step before the crank's angle 0; the coupler point is its component number PLACE.

    pylinkage takes the intersection of two circles that is nearer to where the pin was.
    """
    a, d = Ground(0.0, 0.0, name="A"), Ground(base, 0.0, name="D")
    crank = Crank(anchor=a, radius=1.0, angular_velocity=step, initial_angle=-step)
    c = RRRDyad(crank.output, d, distance1=coupler, distance2=follower)
    start = left_pin(cmath.rect(1.0, -step), complex(base, 0.0), coupler, follower)
    c.x, c.y = start.real, start.imag
    size, angle = cmath.polar(point)
    p = FixedDyad(crank.output, c, distance=size, angle=angle)
    return Linkage([a, d, crank, c, p])


def main():
    """Steps, compares and reports."""
    with open("target/atlas/curves.csv", encoding="ascii") as file:
        rows = [[float(number) for number in row] for row in csv.reader(file)][::EVERY]
    is_compiled = "--numba" in sys.argv
    poses, seconds, worst, other_branch = 0, 0.0, 0.0, 0
    for coupler, follower, base, along, across, *numbers in rows:
        ours = [complex(*xy) for xy in zip(numbers[::2], numbers[1::2])]
        step = math.tau / len(ours)
        if is_compiled and poses == 0:
            # Compiles the functions themselves, which is not what is timed.
            four_bar(coupler, follower, base, complex(along, across), step).step_fast(iterations=2)
        quickest = math.inf
        for _ in range(REPEATS):
            linkage = four_bar(coupler, follower, base, complex(along, across), step)
            if is_compiled:
                linkage.compile()
            start = time.perf_counter()
            if is_compiled:
                theirs = [complex(*xy) for xy in linkage.step_fast(iterations=len(ours))[:, PLACE]]
            else:
                theirs = [complex(*xy[PLACE]) for xy in linkage.step(iterations=len(ours))]
            quickest = min(quickest, time.perf_counter() - start)
        seconds += quickest
        poses += len(ours)
        apart = max(abs(one - two) for one, two in zip(ours, theirs))
        # Through a change point pylinkage goes on smoothly, where ours keeps its branch.
        has_change_point = min(coupler + follower - base - 1, abs(base - 1) - abs(coupler - follower)) < 1e-9
        if has_change_point and apart > 1e-3:
            other_branch += 1
        else:
            worst = max(worst, apart)
    print(f"{len(rows)} curves, {poses} poses: {poses / seconds:.0f} poses a second")
    print(f"apart by {worst:.1e} cranks at most, but for {other_branch} curves through change points")


if __name__ == "__main__":
    main()
