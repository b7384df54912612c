"""Closed-form positions of the Assur groups, and exact motion by differentiating them.

Everything is computed with 150 digits. Velocities and accelerations come from central
differences of the positions along q(t) = q + q' t + q'' t^2 / 2, not from the formulas a solver
uses: the two can only agree by being right. Points and directions are complex numbers.
"""

from mpmath import mp, mpc, mpf, sqrt

mp.dps = 150
I = mpc(0, 1)
STEP = mpf(10) ** -20
NUDGE = mpf(10) ** -30


def dot(a, b):
    return a.real * b.real + a.imag * b.imag


def cross(a, b):
    return a.real * b.imag - a.imag * b.real


def turn(angle):
    return mpc(mp.cos(angle), mp.sin(angle))


def unit(v):
    return v / abs(v)


def rrr(b, d, l1, l2, side):
    """The inner pin; side is +1 left of the line from b to d, -1 right of it."""
    span = abs(d - b)
    along = (span**2 + l1**2 - l2**2) / (2 * span)
    across = side * sqrt(l1**2 - along**2)
    return b + (d - b) / span * mpc(along, across)


def rrp(b, foot, u, length, offset, sense):
    """The inner pin and its slide; sense is +1 ahead, -1 behind."""
    x, y = dot(b - foot, u), dot(b - foot, I * u)
    slide = x + sense * sqrt(length**2 - (offset - y) ** 2)
    return foot + (slide + I * offset) * u, slide


def rpr(b, d, offset, sense):
    """The bar's direction and the slide."""
    slide = sense * sqrt(abs(b - d) ** 2 - offset**2)
    return (b - d) / mpc(slide, offset), slide


def along_two(u1, u2, h):
    """x1, x2 with x1 u1 + x2 u2 = h."""
    return cross(h, u2) / cross(u1, u2), cross(u1, h) / cross(u1, u2)


def prp(k1, u1, e1, k2, u2, e2):
    """The inner pin and both slides."""
    slide1, minus_slide2 = along_two(u1, u2, k2 + e2 * I * u2 - k1 - e1 * I * u1)
    return k1 + (slide1 + I * e1) * u1, slide1, -minus_slide2


def rpp(b, k, u1, slot, e1, e2):
    """The slot's direction and the slides of yoke and block."""
    u2 = u1 * turn(slot)
    slide1, slide2 = along_two(u1, u2, b - k - e1 * I * u1 - e2 * I * u2)
    return u2, slide1, slide2


class Build:
    """What a mechanism's function is given: inputs, and dimensions that can be nudged."""

    def __init__(self, inputs, nudged):
        self.q, self.nudged, self.count = inputs, nudged, 0
        self.points, self.links, self.slides = {}, {}, {}

    def __call__(self, text):
        """A dimension; the decimal number is exact."""
        value = mpf(text)
        if self.count == self.nudged:
            value *= 1 + NUDGE
        self.count += 1
        return value

    def deg(self, text):
        return self(text) * mp.pi / 180

    def vec(self, x, y):
        return mpc(self(x), self(y))


def build(mechanism, inputs, nudged=None):
    m = Build(inputs, nudged)
    mechanism(m)
    return m


def states(mechanism, q, rate, second, nudged=None):
    """Every output as (position, velocity, acceleration), by its row's name."""

    def at(k):
        t = k * STEP
        moved = [a + b * t + c * t * t / 2 for a, b, c in zip(q, rate, second)]
        return build(mechanism, moved, nudged)

    now, around = at(0), {k: at(k) for k in (-3, -2, -1, 1, 2, 3)}

    def motion(pick):
        f = {k: pick(v) for k, v in around.items()}
        first = 45 * (f[1] - f[-1]) - 9 * (f[2] - f[-2]) + (f[3] - f[-3])
        twice = 270 * (f[1] + f[-1]) - 27 * (f[2] + f[-2]) + 2 * (f[3] + f[-3]) - 490 * pick(now)
        return pick(now), first / (60 * STEP), twice / (180 * STEP**2)

    rows = {}
    for name in now.points:
        three = motion(lambda s: s.points[name])
        rows[name + ".x"] = tuple(v.real for v in three)
        rows[name + ".y"] = tuple(v.imag for v in three)
    for name in now.links:
        z, dz, ddz = motion(lambda s: s.links[name])
        back = mp.conj(z)
        rows[name + ".angle"] = (mp.arg(z), (dz * back).imag, (ddz * back).imag)
    for name in now.slides:
        rows[name + ".slide"] = motion(lambda s: s.slides[name])
    return rows


def table_row(mechanism, q, rate, second):
    """Per output and order: the value, and its condition.

    The condition is the value's change per unit relative change of every dimension, input and
    rate, absolute values added up, and the value itself.
    """
    truth = states(mechanism, q, rate, second)
    conditions = {name: [abs(v) for v in three] for name, three in truth.items()}

    def add(nudged_rows):
        for name, three in nudged_rows.items():
            for order in range(3):
                change = abs(three[order] - truth[name][order])
                if name.endswith(".angle") and order == 0 and change > 3:
                    change = 0  # The angle jumped from pi to -pi; its neighbours carry the case.
                if change > mpf(10) ** -75:  # What is smaller is noise of the differences.
                    conditions[name][order] += change / NUDGE

    for i in range(build(mechanism, q).count):
        add(states(mechanism, q, rate, second, nudged=i))
    for vector in range(3):
        for i in range(len(q)):
            moved = [list(q), list(rate), list(second)]
            if moved[vector][i] != 0:
                moved[vector][i] *= 1 + NUDGE
                add(states(mechanism, *moved))
    return truth, conditions
