"""Where the four-bar of `SwingingFourBar` rests on its torsion spring, and how it swings there, in 50 digits.

Knows nothing of kinematic coefficients: pins by circles, energies of a pose and of two poses, everything else by
differences in 120 digits. `python3 swinging_four_bar.py > swinging_four_bar.txt`."""
from mpmath import mp, mpf, sqrt, cos, sin, atan2, pi, diff, findroot, nstr
mp.dps = 120
L1, L2, L3, L0 = mpf(250)/1000, mpf(510)/1000, mpf(500)/1000, mpf(750)/1000
M1, M2, M3 = mpf("0.05221"), mpf("0.10421"), mpf("0.10221")
G, K, FREE = mpf("9.81"), mpf(2), pi/2

def pose(q):
    b = (L1*cos(q), L1*sin(q))
    dx, dy = L0 - b[0], -b[1]
    d2 = dx*dx + dy*dy
    along = (L2**2 - L3**2 + d2)/(2*d2)
    aside = sqrt(L2**2/d2 - along**2)          # left of the way from B to D
    c = (b[0] + along*dx - aside*dy, b[1] + along*dy + aside*dx)
    return b, c, atan2(c[1] - b[1], c[0] - b[0]), atan2(c[1], c[0] - L0)

def bodies(q):
    """Mass, centre, inertia about it, angle."""
    b, c, coupler, rocker = pose(q)
    half = lambda p, r: ((p[0] + r[0])/2, (p[1] + r[1])/2)
    return [(M1, half((0, 0), b), M1*L1**2/12, q), (M2, half(b, c), M2*L2**2/12, coupler),
            (M3, half(c, (L0, 0)), M3*L3**2/12, rocker)]

def potential(q):
    return sum(m*G*at[1] for m, at, _, _ in bodies(q)) + K*(pose(q)[3] - FREE)**2/2

def mass(q):
    """Twice the kinetic energy at a unit rate: what bodies move by, over a step and its opposite."""
    slope = lambda f: diff(f, q, h=mpf(10)**-35, method="step", direction=0)
    total = mpf(0)
    for i in range(3):
        m, _, j, _ = bodies(q)[i]
        vx, vy, w = (slope(lambda x: bodies(x)[i][1][0]), slope(lambda x: bodies(x)[i][1][1]),
                     slope(lambda x: bodies(x)[i][3]))
        total += m*(vx**2 + vy**2) + j*w**2
    return total

def slope_of_potential(q): return diff(potential, q, h=mpf(10)**-35)
rest = findroot(slope_of_potential, mpf("0.6"), tol=mpf(10)**-110)
square = diff(potential, rest, 2, h=mpf(10)**-30)/mass(rest)
assert square > 0
print("# Rest in rad and the square of the natural frequency in 1/s^2: swinging_four_bar.py, mpmath, 120 digits.")
print(nstr(rest, 50)); print(nstr(square, 50))
# An angle off the rest, and the second rate there, at rest and at 3 rad/s, without drive.
q = mpf("1.25")
half_slope = diff(mass, q, h=mpf(10)**-20)/2
for rate in (0, 3):
    print(nstr((-slope_of_potential(q) - half_slope*rate**2)/mass(q), 50))
