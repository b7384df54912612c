#!/usr/bin/env python3
"""Eighteen timed points and five poses by scipy, by pylinkage and by linkage-design: error, evaluations, and seconds
of one processor.

Run from anywhere, by a Python that has scipy: linkage-core/design/tests/against_scipy.py. Needs Cargo. What pip has
not installed is skipped by its name.
The ten numbers of a four-bar with a coupler point are sought within the same ranges: by differential evolution, by
least squares and SLSQP from the same random starts with differences, and by linkage-design, with exact slopes, first
with all ten numbers free and then with place, turn and size eliminated. An evaluation is a machine at all eighteen
inputs. The five poses are those of a hidden four-bar, which pylinkage's synthesis is asked for, too.
"""

import subprocess
import time
from pathlib import Path

try:
    import numpy as np
    from scipy.optimize import differential_evolution, least_squares, minimize
except ImportError as missing:
    print(f"against_scipy: skipped, the package `scipy` is not installed ({missing})")
    raise SystemExit

ROOT = Path(__file__).resolve().parents[3]
TARGETS = np.array([
    [0.5, 1.1], [0.4, 1.1], [0.3, 1.1], [0.2, 1.0], [0.1, 0.9], [0.05, 0.75], [0.02, 0.6], [0.0, 0.5], [0.0, 0.4],
    [0.03, 0.3], [0.1, 0.25], [0.15, 0.2], [0.2, 0.3], [0.3, 0.4], [0.4, 0.5], [0.5, 0.7], [0.6, 0.9], [0.6, 1.0],
])
TURN = np.arange(18) * np.pi / 9
RANGES = [(0.05, 5.0)] * 4 + [(-3.0, 3.0)] * 4 + [(0.0, 2 * np.pi)] * 2
WIDE = [(1e-3, 50.0)] * 4 + [(-50.0, 50.0)] * 4 + [(-2 * np.pi, 4 * np.pi)] * 2
SECONDS = 30
evaluations = 0


def residuals(numbers):
    """The point's misses, none where the four-bar cannot be assembled."""
    global evaluations
    evaluations += 1
    a, b, c, d, px, py, x, y, tilt, start = numbers
    crank = a * np.exp(1j * (start + TURN))
    line = d - crank
    length = np.abs(line)
    cos = (b * b - c * c + length**2) / (2 * b * length)
    if np.any(np.abs(cos) > 1):
        return None
    coupler = line / length * (cos + 1j * np.sqrt(1 - cos * cos))
    point = x + 1j * y + np.exp(1j * tilt) * (crank + (px + 1j * py) * coupler)
    return np.concatenate([point.real - TARGETS[:, 0], point.imag - TARGETS[:, 1]])


def cost(numbers):
    a, b, c, d = numbers[:4]
    short = max(a + d - b - c, a + b - d - c, a + c - d - b, 0)
    found = residuals(numbers)
    return 10 + short if found is None else found @ found + (short > 0) * (1 + short)


def row(name, error, count, seconds):
    print(f"{name:44} {error:12.9f} {count:12,} {seconds:8.2f}", flush=True)


def by_scipy():
    global evaluations
    for seed in range(2):
        evaluations, begun = 0, time.process_time()
        found = differential_evolution(
            cost, RANGES, maxiter=1000, popsize=10, tol=1e-10, seed=seed, polish=False, updating="immediate"
        )
        row(f"scipy, differential evolution, seed {seed}", found.fun, evaluations, time.process_time() - begun)
    missed = lambda numbers: (lambda found: np.full(36, 3.0) if found is None else found)(residuals(numbers))
    squares = lambda numbers: (lambda found: found @ found)(missed(numbers))
    from_starts("least squares", lambda start: least_squares(missed, start, bounds=np.array(WIDE).T, max_nfev=200))
    from_starts("SLSQP", lambda start: minimize(squares, start, method="SLSQP", bounds=WIDE, options={"maxiter": 200}))


def from_starts(name, search):
    """The best end of searches from random starts, which are the same for every method."""
    global evaluations
    draw, best, evaluations, begun, starts = np.random.default_rng(0), np.inf, 0, time.process_time(), 0
    while time.process_time() - begun < SECONDS:
        start = np.array([draw.uniform(*ends) for ends in RANGES])
        if cost(start) < 10:
            best, starts = min(best, cost(search(start).x)), starts + 1
    row(f"scipy, {name} with differences, {starts} starts", best, evaluations, time.process_time() - begun)


def by_pylinkage():
    try:
        from pylinkage.synthesis import Pose, motion_generation
    except ImportError as missing:
        return print(f"against_scipy: skipped, the package `pylinkage` is not installed ({missing})")
    begun = time.process_time()
    poses = [Pose(*pose) for pose in hidden_poses()]
    found = motion_generation(poses, max_solutions=None, require_grashof=False).solutions
    seconds = time.process_time() - begun
    print(f"{'pylinkage, five poses of a hidden four-bar':44} {len(found):>3} solutions {'':11} {seconds:8.2f}")


def hidden_poses():
    """Where the coupler of a four-bar is at five angles of its crank: x, y and its turn."""
    a, b, c, d, px, py, x, y, tilt = 1.0, 2.6, 2.2, 3.0, 1.4, 0.9, 0.3, -0.2, 0.2
    for k in range(5):
        crank = a * np.exp(1j * (0.4 + 0.55 * k))
        line = d - crank
        length = abs(line)
        cos = (b * b - c * c + length**2) / (2 * b * length)
        coupler = line / length * (cos + 1j * np.sqrt(1 - cos * cos))
        point = x + 1j * y + np.exp(1j * tilt) * (crank + (px + 1j * py) * coupler)
        yield point.real, point.imag, float(np.angle(coupler * np.exp(1j * tilt)) + 0.3)


def by_design():
    test = ["--test", "design", "curves::raced", "--", "--ignored", "--nocapture", "--test-threads=1"]
    ran = subprocess.run(
        ["cargo", "test", "-q", "--release", "-p", "linkage-design", *test],
        cwd=ROOT, check=True, capture_output=True, text=True,
    )
    for line in ran.stdout.splitlines():
        if line.startswith("raced:"):
            name, error, count, seconds = line.removeprefix("raced:").split(";")
            row(name.strip(), float(error), int(count), float(seconds))


print(f"{'':44} {'error':>12} {'evaluations':>12} {'seconds':>8}")
by_scipy()
by_pylinkage()
by_design()
