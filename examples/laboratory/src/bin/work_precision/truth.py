"""Writes truth.rs: what the mechanisms of this example do, to 50 digits.

    python3 truth.py > truth.rs

Positions are closed forms on complex numbers; velocities and accelerations are central
differences of them in 130 digits, not the formulas that any of the measured methods uses.
Dimensions are the decimal numbers of the declarations, exactly. Needs mpmath.
"""

from mpmath import mp, mpc, mpf, pi, sqrt

mp.dps = 130
STEP = mpf(10) ** -30
I = mpc(0, 1)


def m(x, y="0"):
    return mpc(mpf(x), mpf(y))


def dyad(b, d, l2, l3, side):
    """The directions of both bars from b and d to their common pin, left (+1) or right (-1)."""
    span = abs(d - b)
    along = (span**2 + mpf(l2) ** 2 - mpf(l3) ** 2) / (2 * span)
    squared = mpf(l2) ** 2 - along**2
    assert squared > (mpf(l2) / 10) ** 2, "too near a toggle for a comparison of speed"
    pin = b + (d - b) / span * mpc(along, side * sqrt(squared))
    return (pin - b) / mpf(l2), (pin - d) / mpf(l3)


def four_bar(crank):
    b = mpf("0.1016") * crank
    bc, dc = dyad(b, m("0.3048"), "0.254", "0.1778", 1)
    return [("P", b + m("0.15", "0.05") * bc), ("L", bc), ("L", dc)]


def six_bar(crank):
    b, d = mpf("0.4") * crank, m("0", "-1")
    block = abs(b - d)
    rod = (b - d) / block
    e = d + mpf("1.6") * rod
    return [("L", rod), ("S", block), ("S", e.real), ("S", e.imag - mpf("0.8"))]


def stephenson(crank):
    b = mpf("0.04") * crank
    bc, _ = dyad(b, m("0.1"), "0.11", "0.09", 1)
    p = b + m("0.07", "0.05") * bc
    _, fe = dyad(p, m("0.18", "0.06"), "0.12", "0.1", 1)
    return [("P", p), ("P", m("0.18", "0.06") + mpf("0.1") * fe), ("L", fe)]


def chain(crank):
    """Ten links: crank, then four dyads, each begun at a point of the last one's rocker."""
    start = mpf("0.04") * crank
    for k in range(4):
        d = m(["0.1", "0.2", "0.3", "0.4"][k])
        _, rocker = dyad(start, d, "0.11", "0.09", 1)
        start = d + m("0.06", "0.02") * rocker
    return [("P", d + mpf("0.09") * rocker), ("L", rocker)]


def motion(mechanism, angle, rate, second):
    """Components of position, velocity and acceleration of every output."""

    def at(t):
        return mechanism(mp.expj(angle + rate * t + second * t * t / 2))

    now, before, after = at(0), at(-STEP), at(STEP)
    orders = [[], [], []]
    for (kind, z), (_, y), (_, x) in zip(now, before, after):
        first, twice = (x - y) / (2 * STEP), (x - 2 * z + y) / STEP**2
        if kind == "L":
            # z is a unit vector: first = i omega z, twice = (i alpha - omega^2) z.
            orders[0] += [z.real, z.imag]
            orders[1] += [(first / z).imag]
            orders[2] += [(twice / z).imag]
        else:
            for order, value in zip(orders, (z, first, twice)):
                order += [value.real, value.imag] if kind == "P" else [value.real]
    return orders[0] + orders[1] + orders[2]


def words(value):
    high = float(value)
    low = f"{float(value - high):.2e}".replace("e-0", "e-").replace(".00e", "e")
    return f"({high!r}, {low})"


POSES = 32
TABLES = [("FOUR_BAR", four_bar, 250, 1000), ("SIX_BAR", six_bar, 10, 4),
          ("STEPHENSON", stephenson, 30, 100), ("CHAIN", chain, 30, 100)]

print("//! What the mechanisms do at [`ANGLES`], to 50 digits, as high and low word.")
print("//!")
print("//! Written by `truth.py` of this folder; no published source.")
print("#![cfg_attr(rustfmt, rustfmt_skip)]\n")
print("/// A number to about 19 digits.")
print("pub(crate) type Words = (f64, f64);\n")
print(f"/// Crank angles that both f32 and f64 hold exactly.")
angles = [mpf(1) / 16 + mpf(25 * k) / 128 for k in range(POSES)]
print(f"pub(crate) const ANGLES: [f64; {POSES}] = {[float(a) for a in angles]};")
for name, mechanism, rate, second in TABLES:
    rows = [motion(mechanism, angle, mpf(rate), mpf(second)) for angle in angles]
    print(f"\n/// At {rate} rad/s and {second} rad/s²: positions, velocities, accelerations.")
    print(f"pub(crate) const {name}: [[Words; {len(rows[0])}]; {POSES}] = [")
    for row in rows:
        print("    [" + ", ".join(words(v) for v in row) + "],")
    print("];")
