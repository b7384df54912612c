"""Writes the computed tables of this folder: `python3 generate.py` (needs mpmath)."""

from math import ceil, floor, log10
from pathlib import Path

from mpmath import cos, mp, mpf, pi, sin

import declared_mechanisms as declared
from truth_50 import table_row

HERE = Path(__file__).parent


def number(x):
    """An f64 and what is missing from it, to about 22 digits together."""
    if abs(x) < mpf(10) ** -60:  # Zero, but for the noise of differentiating.
        return "0.0 0.0"
    high = float(x)
    low = x - mpf(high)
    return f"{high!r} 0.0" if abs(low) < mpf(10) ** -60 else f"{high!r} {float(low):.6e}"


def rounded_up(x):
    """Two digits, not less than x."""
    if x < mpf(10) ** -60:
        return "0.0"
    exponent = floor(log10(float(x))) - 1
    return repr(float(f"{ceil(float(x) / 10.0**exponent)}e{exponent}"))


def floats(values):
    return " ".join(repr(float(v)) for v in values)


def table(name, mechanism, rows):
    """One table, with a pose per (inputs, rates, second rates)."""
    lines, names = [], None
    for q, rate, second in rows:
        exact = [[mpf(x) for x in vector] for vector in (q, rate, second)]
        truth, conditions = table_row(mechanism, *exact)
        names = names or list(truth)
        lines.append("pose " + " | ".join(floats(vector) for vector in (q, rate, second)))
        for row in names:
            orders = zip(truth[row], conditions[row])
            lines.append("  " + " | ".join(f"{number(t)} {rounded_up(c)}" for t, c in orders))
    return "\n".join([f"table {name}", "outputs " + " ".join(names), *lines]) + "\n"


def write(file, about, tables):
    text = f"# {about}\n"
    text += "# Computed with 150 digits by `generate.py` of this folder; no published source.\n"
    for each in tables:
        text += "\n" + table(*each)
    (HERE / file).write_text(text)
    print(file, len(text))


def turns(angles, omega, alpha):
    return [([a], [omega], [alpha]) for a in angles]


def single_groups():
    angles = [-3.0, -0.625, 0.5, 1.75]
    for mode, sign in (("", +1), ("_FLIPPED", -1)):
        yield (
            "COUPLER_FOUR_BAR" + mode,
            lambda m, s=sign: declared.coupler_four_bar(m, s),
            turns(angles, 2.5, -3.25),
        )
        yield (
            "INCLINED_SLIDER_CRANK" + mode,
            lambda m, s=sign: declared.inclined_slider_crank(m, s),
            turns(angles, -1.5, 4.5),
        )
        yield (
            "OFFSET_QUICK_RETURN" + mode,
            lambda m, s=sign: declared.offset_quick_return(m, s),
            turns(angles, 3.0, 1.25),
        )
    yield "CROSSED_GUIDES", declared.crossed_guides, turns(angles, 2.0, -0.75)
    yield "OBLIQUE_YOKE", declared.oblique_yoke, turns(angles, -4.0, 2.5)


def drivers():
    two = [
        ([0.5, 0.75], [1.5, -0.25], [-2.0, 3.0]),
        ([-1.25, 0.375], [0.0, 2.0], [0.5, 0.0]),
        ([2.5, 1.5], [-3.0, 0.5], [0.0, -1.0]),
    ]
    yield "GANTRY", declared.gantry, two
    yield "POLAR_ARM", declared.polar_arm, two
    yield "GEARED_FIVE_BAR", declared.geared_five_bar, turns([-2.5, -1.0, 0.25, 1.75], 3.5, -2.0)
    yield "RACK_AND_PINION", declared.rack_and_pinion, turns([-0.015625, 0.0078125, 0.03125], 0.25, 0.5)
    yield "EXCAVATOR", declared.excavator, [
        ([2.3125, 2.25, 1.90625], [0.25, -0.125, 0.0625], [0.5, 0.25, -0.125]),
        ([2.625, 2.5, 2.125], [-0.125, 0.1875, 0.25], [0.0625, -0.5, 0.25]),
        ([2.8125, 3.125, 2.25], [0.0, 0.25, 0.0], [0.25, 0.0, 0.125]),
    ]
    yield "SWINGING_GUIDE", declared.swinging_guide, [
        ([0.5, 0.25, 0.375], [1.5, -0.5, 0.25], [0.75, 2.0, -0.5]),
        ([1.5, -0.75, 0.625], [-2.0, 1.0, 0.5], [0.0, -1.5, 1.25]),
        ([-1.0, 2.0, 0.3125], [0.5, 0.0, -0.75], [2.5, 0.25, 0.0]),
    ]


def variable_dimensions():
    rows = [
        ([0.5, 0.25], [1.5, -0.5], [-2.0, 3.0]),
        ([-1.25, 0.375], [0.0, 2.0], [0.5, 0.0]),
        ([2.5, 0.5], [-3.0, 0.75], [0.0, -1.0]),
    ]
    yield "VARIABLE_FOUR_BAR", declared.variable_four_bar, rows
    yield "VARIABLE_BAR", declared.variable_bar, rows
    yield "VARIABLE_CROSS", declared.variable_cross, rows
    yield "VARIABLE_YOKE", declared.variable_yoke, rows
    yield "VARIABLE_ROD", declared.variable_rod, rows


def shear_rows():
    """The drive law of the mill, theta = pi/12 (1 - cos(pi t/15)) + 115 deg, every 1.5 s."""
    for i in range(11):
        turn = pi * i / 10
        theta = pi / 12 * (1 - cos(turn)) + 115 * pi / 180
        omega = pi**2 / 180 * sin(turn)
        alpha = pi**3 / 2700 * cos(turn)
        at_rest = abs(omega) < mpf(10) ** -60
        yield [float(theta)], [0.0 if at_rest else float(omega)], [float(alpha)]


def degrees(step):
    return [k * step * mp.pi / 180 for k in range(360 // step + 1)]


def main():
    write(
        "four_bar.txt",
        "Four-bar 304.8/101.6/254.0/177.8 mm at 250 rad/s: every 5° of a turn.",
        [("FOUR_BAR", declared.four_bar, turns(degrees(5), 250, 0))],
    )
    write(
        "rpp_systems.txt",
        "A crank with an RPP group, and the six-bar crank + RPR + RPP, at 10 rad/s.",
        [
            ("CRANK_RPP", declared.crank_rpp, turns(degrees(30), 10, 0)),
            ("SIX_BAR", declared.six_bar, turns(degrees(30), 10, 0)),
        ],
    )
    write(
        "flying_shear.txt",
        "Strip-mill flying shear under its drive law, every 1.5 s over 15 s.",
        [("FLYING_SHEAR", declared.flying_shear, list(shear_rows()))],
    )
    write("single_groups.txt", "One group each, with offsets, in both modes.", single_groups())
    write(
        "variable_dimensions.txt",
        "Every dimension that a group or a point has, depending on an input.",
        variable_dimensions(),
    )
    write("drivers.txt", "Sliders, geared and relative cranks, lengths that are inputs.", drivers())
    write(
        "moving_bases.txt",
        "A mechanism of fourteen links: every group stands on something that moves.",
        [("MOVING_BASES", declared.moving_bases, turns([-1.5, 0.25, 1.5, 2.75], 1.25, -2.5))],
    )


if __name__ == "__main__":
    main()
