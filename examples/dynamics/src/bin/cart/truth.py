"""The path of the cart over a turn of its crank, in 30 digits: `python3 truth.py` prints `truth.rs`.

The rocker's angle by the law of cosines, nothing of which the mechanism's compiler uses; the trim by
the secant method; the heading by Gauss-Legendre quadrature of its rate, and x and y by that of its
cosine and sine, all by mpmath in 40 digits. Panels halved once more change nothing in 32 digits.
"""
import sys
from mpmath import mp, mpf, acos, atan2, cos, sin, tan, sqrt, pi, nstr, findroot
from mpmath.calculus.quadrature import GaussLegendre

mp.dps = 40
GROUND, CRANK, COUPLER, ROCKER = mpf(110) / 1000, mpf(20) / 1000, mpf(100) / 1000, mpf(60) / 1000
WHEELBASE, ADVANCE, PARTS = mpf(2) / 10, mpf(3), 12


def rocker(theta):
    """Its angle: C is on the left of the way from B to D."""
    x, y = GROUND - CRANK * cos(theta), -CRANK * sin(theta)
    d2 = x * x + y * y
    at_d = acos((d2 + ROCKER**2 - COUPLER**2) / (2 * sqrt(d2) * ROCKER))
    return atan2(-y, -x) - at_d + (2 * pi if atan2(-y, -x) - at_d < -pi else 0)


NODES = [(x, w) for x, w in GaussLegendre(mp).calc_nodes(5, mp.prec)]


def integral(f, a, b):
    h, m = (b - a) / 2, (a + b) / 2
    return h * sum(w * f(m + h * x) for x, w in NODES)


def poses(trim, heading, panels):
    """At every twelfth of the turn; each panel is integrated from its own start."""
    bend = lambda turn: ADVANCE * tan(rocker(2 * pi * turn) - trim) / WHEELBASE
    at, found = [mpf(0), mpf(0), heading], []
    for part in range(PARTS):
        found.append(list(at))
        for panel in range(panels):
            a = mpf(part * panels + panel) / (PARTS * panels)
            b = a + mpf(1) / (PARTS * panels)
            psi0 = at[2]
            h, m = (b - a) / 2, (a + b) / 2
            dx = dy = mpf(0)
            for x, w in NODES:
                turn = m + h * x
                psi = psi0 + integral(bend, a, turn)
                dx += h * w * ADVANCE * cos(psi)
                dy += h * w * ADVANCE * sin(psi)
            at = [at[0] + dx, at[1] + dy, psi0 + integral(bend, a, b)]
    return found + [at]


def main():
    # Analytic and periodic: the trapezium rule is exact to 40 digits long before 720 points.
    angles = [rocker(2 * pi * k / 720) for k in range(720)]
    trim = findroot(lambda d: sum(tan(a - d) for a in angles), sum(angles) / 720)
    # What the program has is a double.
    trim = mpf(float(trim))
    # Set down at this heading, the cart comes back to its line: to 7 digits, which is no truth but a
    # choice.
    x, y, _ = poses(trim, mpf(0), 1)[-1]
    heading = mpf(float(nstr(atan2(-y, x), 7)))
    fine, coarse = poses(trim, heading, 2), poses(trim, heading, 1)
    apart = max(abs(p - q) for f, c in zip(fine, coarse) for p, q in zip(f, c))
    print("agree to", nstr(apart, 3), file=sys.stderr)
    print("//! The cart's path in 30 digits, rounded to `f64`; `truth.py` beside this file wrote it.\n")
    print("/// The rocker's angle with the wheel straight, in rad: the double itself.")
    print("pub(crate) const TRIM: f64 = %r;\n" % float(trim))
    print("/// The heading with which it sets out, in rad.")
    print("pub(crate) const HEADING: f64 = %r;\n" % float(heading))
    print("/// x and y in m, and the heading in rad, at every twelfth of a turn.")
    print("#[rustfmt::skip]\n#[allow(clippy::excessive_precision, clippy::unreadable_literal, reason = \"30 digits\")]")
    print("pub(crate) const POSES: [[f64; 3]; 13] = [")
    for pose in fine:
        print("    [%s]," % ", ".join(nstr(v, 30) if v else "0.0" for v in pose))
    print("];")


main()
