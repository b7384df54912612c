"""Writes `slopes.txt`: derivatives of the mechanisms in `tests/src/mechanisms/differentiated.rs` by
each of their inputs and dimensions, with 150 digits (`python3 slopes.py`, needs mpmath).

Each function places what the Rust declaration of the same name places; its numbers are the inputs
and then the parameters, in their order. Derivatives are central differences.
"""

from mpmath import arg, mp, mpf

from generate import HERE, number, rounded_up
from truth_50 import I, prp, rpp, rpr, rrp, rrr, turn, unit

STEP = mpf(10) ** -40
NUDGE = mpf(10) ** -30


def at(x, y):
    return x + I * y


def bars(numbers, mode):
    theta, ax, ay, dx, dy, r, l1, l2, px, py, phase = numbers
    d = at(dx, dy)
    b = at(ax, ay) + r * turn(theta + phase)
    c = rrr(b, d, l1, l2, mode)
    bc, dc = unit(c - b), unit(c - d)
    return {"C": c, "P": b + at(px, py) * bc, "BC.angle": arg(bc), "DC.angle": arg(dc)}


def press(numbers, mode):
    theta, kx, ky, r, l, e, p, slope, beta = numbers
    b = at(mpf("0.25"), mpf("-0.5")) + r * turn(theta)
    c, slide = rrp(b, at(kx, ky), turn(slope), l, e, mode)
    bc = unit(c - b)
    return {"C": c, "P": b + p * turn(beta) * bc, "BC.angle": arg(bc), "block.slide": slide}


def quick_return(numbers, mode):
    theta, dx, dy, r, e, px, py, phase = numbers
    d = at(dx, dy)
    b = at(mpf("0.25"), mpf("-0.5")) + r * turn(theta + phase)
    bar, slide = rpr(b, d, e, mode)
    return {"P": d + at(px, py) * bar, "bar.angle": arg(bar), "block.slide": slide}


def crossed_guides(numbers, mode):
    theta, kx, ky, r, e1, e2, tilt, slope = numbers
    b = r * turn(theta)
    c, s1, s2 = prp(b, turn(theta + tilt), e1, at(kx, ky), turn(slope), e2)
    return {"C": c, "shoe.slide": s1, "block.slide": s2}


def yoke(numbers, mode):
    theta, kx, ky, r, e1, e2, px, py, slope, slot = numbers
    rail, k = turn(slope), at(kx, ky)
    u2, s1, s2 = rpp(r * turn(theta), k, rail, slot, e1, e2)
    p = k + (s1 + at(px, py)) * rail
    return {"P": p, "yoke.slide": s1, "block.angle": arg(u2), "block.slide": s2}


def manipulator(numbers, mode):
    s, phi, z, kx, ky, e, r, gx, gy, w, l, slope, tilt, phase = numbers
    ram = turn(slope)
    p = at(kx, ky) + at(s, e) * ram
    arm = ram * turn(phi)
    q = p + r * arm
    # A crank's frame has its origin at its pivot.
    point = p + at(gx, gy) * arm + at(z, w) * arm * turn(tilt)
    wrist = ram * turn(phase - 2 * (slope + phi))
    return {"Q": q, "R": point, "T": point + l * wrist, "wrist.angle": arg(wrist)}


CASES = [
    (bars, [1.25, 0.25, -0.125, 2.5, 0.5, 0.75, 2.25, 1.75, 1.5, -0.5, 0.375]),
    (bars, [-2.5, 0.0, 0.25, 2.0, -0.5, 0.5, 1.75, 2.5, -0.5, 0.25, -1.0]),
    (press, [0.75, 0.5, -0.25, 0.5, 2.0, 0.25, 1.25, 0.625, -0.5]),
    (press, [-1.875, -0.5, 0.375, 0.75, 1.5, 0.0, 0.75, -2.25, 2.0]),
    (quick_return, [0.5, 0.375, -1.75, 0.75, 0.25, 3.0, -0.5, 1.125]),
    (quick_return, [2.75, -0.5, -1.25, 1.0, -0.5, 1.5, 0.75, -0.25]),
    (crossed_guides, [0.625, 1.5, -0.5, 0.75, 0.25, -0.125, 1.25, 0.5]),
    (yoke, [-0.875, -1.25, 0.75, 0.5, 0.25, -0.375, 0.5, -0.25, 0.75, 1.25]),
    (manipulator, [0.5, -0.75, 0.25, 0.5, -0.25, 0.125, 0.75, 0.25, -0.375, 0.25, 0.5, 0.625, -1.5, 2.0]),
]
MODES = {bars: 2, press: 2, quick_return: 2}


def rows(mechanism, numbers, mode):
    """The scalar rows by name, in the order of the outputs."""
    values = {}
    for name, value in mechanism(numbers, mode).items():
        if "." in name:
            values[name] = value
        else:
            values[name + ".x"], values[name + ".y"] = value.real, value.imag
    return values


def slopes(mechanism, numbers, mode, by):
    ahead, behind = list(numbers), list(numbers)
    ahead[by] += STEP
    behind[by] -= STEP
    up, down = (rows(mechanism, each, mode) for each in (ahead, behind))
    return [(up[name] - down[name]) / (2 * STEP) for name in up]


def column(mechanism, numbers, mode, by):
    """Every row's derivative, and its condition: its change per unit relative change of every
    number, absolute values added up, and its own size."""
    truth = slopes(mechanism, numbers, mode, by)
    conditions = [abs(value) for value in truth]
    for k, x in enumerate(numbers):
        if x != 0:
            nudged = [*numbers[:k], x * (1 + NUDGE), *numbers[k + 1 :]]
            for i, value in enumerate(slopes(mechanism, nudged, mode, by)):
                change = abs(value - truth[i])
                conditions[i] += change / NUDGE if change > mpf(10) ** -70 else 0
    return " | ".join(f"{number(v)} {rounded_up(c)}" for v, c in zip(truth, conditions))


def case(mechanism, numbers, mode):
    exact = [mpf(x) for x in numbers]
    given = " ".join(repr(float(x)) for x in numbers)
    yield f"case {'declared' if mode > 0 else 'flipped'} | {given}"
    for by in range(len(numbers)):
        yield "  " + column(mechanism, exact, mode, by)


def main():
    text = "# Derivatives of `tests/src/mechanisms/differentiated.rs` by their inputs and dimensions.\n"
    text += "# Computed with 150 digits by `slopes.py` of this folder; no published source.\n"
    for mechanism in dict.fromkeys(mechanism for mechanism, _ in CASES):
        lines = []
        for other, numbers in CASES:
            if other is mechanism:
                for mode in (+1, -1)[: MODES.get(mechanism, 1)]:
                    lines += case(mechanism, numbers, mode)
        names = rows(mechanism, [mpf(x) for x in numbers], +1)
        text += f"\ntable {mechanism.__name__.upper()}\noutputs {' '.join(names)}\n"
        text += "\n".join(lines) + "\n"
    (HERE / "slopes.txt").write_text(text)
    print(len(text))


if __name__ == "__main__":
    main()
