#!/usr/bin/env python3
"""Counts the assemblies of trusses by homotopy, for the tests of `linkage-macros/compiler/src/chain/assemblies`.

    python3 -m pip install numpy
    python3 tests/assemblies/by_homotopy.py > linkage-macros/compiler/tests/chain/assemblies/counts.txt

A truss of n links has 3 (n - 1)/2 pins, each of two links, and no rigid part. The first link stands still. Nothing is shared with
the compiler's way: there is no cut, no dyad, no unknown and no circle. Every link turns by a number z from its drawing, and w stands for
1/z. The (n - 1)/2 loops are linear in z, and their mirror images linear in w. Homotopy follows all solutions of products of linear
forms to the equations z w = 1 of complex lengths, once a truss: those that stay finite are its complex assemblies. From there it follows
them to the lengths of a drawing. A solution whose numbers have length one and whose w are conjugates is an assembly.

A line is a drawing: the two links of each pin, the count of complex assemblies, the pins' places, the count of assemblies.
"""

import itertools
import random
import sys

import numpy as np


def has_no_rigid_part(count, pins):
    """Any set of links but all of them can move: 3 (k - 1) freedoms are more than twice its pins."""
    for size in range(2, count):
        for links in itertools.combinations(range(count), size):
            inside = sum(a in links and b in links for a, b in pins)
            if 3 * (size - 1) <= 2 * inside:
                return False
    return True


def shape(count, pins):
    """A number of a graph that all orders of its links share."""
    colours = [0] * count
    for _ in range(count):
        near = [tuple(sorted(colours[b if a == v else a] for a, b in pins if v in (a, b))) for v in range(count)]
        colours = [hash((colours[v], near[v])) for v in range(count)]
    matrix = np.zeros((count, count), dtype=object)
    for a, b in pins:
        matrix[a, b] = matrix[b, a] = 1
    walks, power = [], matrix
    for _ in range(count):
        power = power.dot(matrix)
        walks.append(tuple(sorted(power.diagonal())))
    return tuple(sorted(colours)), tuple(walks)


def trusses(count, wanted):
    """All trusses of so many links, by drawing graphs at random until all shapes are there."""
    rng, found = random.Random(1), {}
    joints = 3 * (count - 1) // 2
    while len(found) < wanted:
        stubs = [v for v in range(count) for _ in range(2)]
        stubs += [rng.randrange(count) for _ in range(2 * joints - len(stubs))]
        rng.shuffle(stubs)
        pins = sorted({tuple(sorted(stubs[i : i + 2])) for i in range(0, len(stubs), 2)})
        if len(pins) < joints or any(a == b for a, b in pins):
            continue
        key = shape(count, pins)
        if key not in found and has_no_rigid_part(count, pins):
            found[key] = pins
    return sorted(found.values())


class Loops:
    """The loops of a truss: rows of a matrix over the turning links, and a column for the link that stands."""

    def __init__(self, count, pins):
        self.count, self.pins = count, pins
        tree, reached = {0: []}, [0]
        for link in reached:
            for pin, ends in enumerate(pins):
                if link in ends:
                    other = ends[0] + ends[1] - link
                    if other not in tree:
                        tree[other] = tree[link] + [pin]
                        reached.append(other)
        used = {path[-1] for path in tree.values() if path}
        self.loops = [self.around(tree, ends, pin) for pin, ends in enumerate(pins) if pin not in used]

    def along(self, path):
        """The ways along links between the pins of a path that begins at the link that stands: (link, from, to)."""
        out, link = [], 0
        for before, pin in zip(path, path[1:]):
            a, b = self.pins[before]
            link = a + b - link
            out.append((link, before, pin))
        return out

    def around(self, tree, ends, pin):
        """The loop over a pin that the tree does not use: out on one side, back on the other, and along the link that stands."""
        first, second = (tree[end] + [pin] for end in ends)
        back = [(link, end, start) for link, start, end in reversed(self.along(second))]
        return self.along(first) + back + [(0, second[0], first[0])]

    def matrices(self, place):
        """L, c with L z + c = 0, where `place` is by link and pin."""
        rows = np.zeros((len(self.loops), self.count - 1), complex)
        rest = np.zeros(len(self.loops), complex)
        for row, loop in enumerate(self.loops):
            for link, start, end in loop:
                way = place[link, end] - place[link, start]
                if link == 0:
                    rest[row] += way
                else:
                    rows[row, link - 1] += way
        return rows, rest


def follow(system, x, smallest=1e-9):
    """All paths from t = 0 to 1: `system` gives values, derivatives and rates. Euler's step and Newton's iterations."""
    t, step = np.zeros(len(x)), np.full(len(x), 1e-2)
    runs = np.zeros(len(x), int)
    alive = np.ones(len(x), bool)

    def solved(matrix, right):
        try:
            return np.linalg.solve(matrix, right[..., None])[..., 0]
        except np.linalg.LinAlgError:
            return np.full(right.shape, np.nan)

    with np.errstate(all="ignore"):
        for _ in range(20000):
            todo = np.where(alive & (t < 1))[0]
            if not len(todo):
                break
            now, at, size = x[todo], t[todo], np.minimum(step[todo], 1 - t[todo])

            def rate(point, time):
                _, slopes, rates = system(point, time)
                return -solved(slopes, rates)

            first = rate(now, at)
            half = rate(now + first * (size / 2)[:, None], at + size / 2)
            to = now + half * size[:, None]
            good = np.ones(len(todo), bool)
            for iteration in range(3):
                values, slopes, _ = system(to, at + size)
                change = solved(slopes, values)
                to = to - change
                part = np.linalg.norm(change, axis=1) / (1e-3 + np.linalg.norm(to, axis=1))
                good &= part < (1e-3 if iteration == 0 else 1.0)
            good &= (part < 1e-9) & np.isfinite(to).all(axis=1)
            x[todo[good]], t[todo[good]] = to[good], np.minimum(at[good] + size[good], 1)
            runs[todo] = np.where(good, runs[todo] + 1, 0)
            longer = runs[todo] >= 3
            step[todo] = np.where(good, np.where(longer, 2 * step[todo], step[todo]), step[todo] / 2)
            runs[todo] = np.where(longer, 0, runs[todo])
            step = np.minimum(step, 0.1)
            alive[todo] = (step[todo] > smallest) & (np.linalg.norm(x[todo], axis=1) < 1e8)
    return x, t >= 1


class Complex:
    """A truss with complex lengths, and all of its solutions."""

    def __init__(self, loops, seed):
        self.loops = loops
        rng = np.random.default_rng(seed)
        any_of = lambda *size: (rng.normal(size=size) + 1j * rng.normal(size=size)) / 2**0.5
        keys = [(link, pin) for pin, ends in enumerate(loops.pins) for link in ends]
        self.own = [loops.matrices({key: any_of() for key in keys}) for _ in range(2)]
        turning = loops.count - 1
        half = turning // 2
        spaces = []
        for rows, rest in self.own:
            _, _, right = np.linalg.svd(rows)
            spaces.append((right[half:].conj().T, np.linalg.lstsq(rows, -rest, rcond=None)[0]))
        (za, zb), (wa, wb) = spaces
        first, second = any_of(turning, half + 1), any_of(turning, half + 1)
        gamma = np.exp(2j * np.pi * rng.uniform())
        starts = []
        for chosen in itertools.combinations(range(turning), half):
            others = [row for row in range(turning) if row not in chosen]
            root = lambda forms: np.linalg.solve(forms[:, :half], -forms[:, half])
            starts.append(np.concatenate([root(first[list(chosen)]), root(second[others])]))

        def system(x, t):
            p, q, t = x[:, :half], x[:, half:], t[:, None]
            z, w = p @ za.T + zb, q @ wa.T + wb
            y, v = p @ first[:, :half].T + first[:, half], q @ second[:, :half].T + second[:, half]
            end, start = z * w - 1, gamma * y * v
            by_p = t[..., None] * w[..., None] * za + (1 - t)[..., None] * gamma * v[..., None] * first[:, :half]
            by_q = t[..., None] * z[..., None] * wa + (1 - t)[..., None] * gamma * y[..., None] * second[:, :half]
            return t * end + (1 - t) * start, np.concatenate([by_p, by_q], 2), end - start

        x, there = follow(system, np.array(starts), 1e-10)
        x = x[there & (np.linalg.norm(x, axis=1) < 1e6)]
        self.z, self.w = x[:, :half] @ za.T + zb, x[:, half:] @ wa.T + wb

    def real(self, place):
        """The count of assemblies of a drawing; nothing where a path is lost or two have met."""
        turning = self.loops.count - 1
        half = turning // 2
        rows, rest = self.loops.matrices(place)
        ends = [(rows, rest), (rows.conj(), rest.conj())]

        def system(x, t):
            t = t[:, None]
            out, slopes, rates = [], np.zeros((len(x), 2 * turning, 2 * turning), complex), []
            for part in range(2):
                u = x[:, part * turning : (part + 1) * turning]
                (a, c), (b, d) = self.own[part], ends[part]
                now = (1 - t)[..., None] * a + t[..., None] * b
                out.append(np.einsum("kij,kj->ki", now, u) + (1 - t) * c + t * d)
                rates.append(u @ (b - a).T + (d - c))
                slopes[:, part * half : (part + 1) * half, part * turning : (part + 1) * turning] = now
            z, w = x[:, :turning], x[:, turning:]
            out.append(z * w - 1)
            rates.append(np.zeros_like(z))
            rows = np.arange(turning)
            slopes[:, 2 * half + rows, rows], slopes[:, 2 * half + rows, turning + rows] = w, z
            return np.concatenate(out, 1), slopes, np.concatenate(rates, 1)

        x, there = follow(system, np.concatenate([self.z, self.w], 1))
        apart = min((np.linalg.norm(a - b) for a, b in itertools.combinations(x, 2)), default=1.0)
        if not there.all() or apart < 1e-6:
            return None
        z, w = x[:, :turning], x[:, turning:]
        is_real = (np.abs(np.abs(z) - 1).max(1) < 1e-6) & (np.abs(w - z.conj()).max(1) < 1e-6)
        return int(is_real.sum())


def main():
    rng = random.Random(7)
    print("# python3 tests/assemblies/by_homotopy.py")
    for count, wanted, drawings in [(5, 1, 300), (7, 3, 40), (9, 28, 2)]:
        for pins in trusses(count, wanted):
            loops = Loops(count, pins)
            # A path that is lost once is not lost for other lengths.
            truss = max((Complex(loops, seed) for seed in range(3)), key=lambda one: len(one.z))
            for _ in range(drawings):
                real = None
                while real is None:
                    places = [(rng.randrange(1000), rng.randrange(1000)) for _ in pins]
                    place = {(link, pin): complex(*places[pin]) / 1000 for pin, ends in enumerate(pins) for link in ends}
                    real = truss.real(place)
                joints = " ".join(f"{a}{b}" for a, b in pins)
                at = " ".join(f"{x},{y}" for x, y in places)
                print(f"{joints}; {len(truss.z)}; {at}; {real}", flush=True)
            print(count, pins, len(truss.z), file=sys.stderr, flush=True)


if __name__ == "__main__":
    main()
