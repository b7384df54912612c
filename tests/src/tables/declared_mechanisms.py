"""The mechanisms of `tests/src/mechanisms`, once more, for 150-digit arithmetic.

Each function places what its Rust declaration of the same name places, from the same decimal
dimensions, by the sign conventions of the language.
"""

from mpmath import hypot, sqrt

from truth_50 import I, prp, rpp, rpr, rrp, rrr, turn, unit


def four_bar(m):
    a, d = m.vec("0", "0"), m.vec("0.3048", "0")
    crank = turn(m.q[0])
    b = a + m("0.1016") * crank
    c = rrr(b, d, m("0.254"), m("0.1778"), +1)
    m.links.update(BC=unit(c - b), DC=unit(c - d))


def crank_rpp(m):
    crank = turn(m.q[0])
    b = m("0.4") * crank
    slot, yoke, block = rpp(b, m.vec("0", "-0.8"), turn(0), m.deg("90"), 0, 0)
    m.points.update(B=b)
    m.slides.update(yoke=yoke, block=block)


def six_bar(m):
    d = m.vec("0", "-1")
    b = m("0.4") * turn(m.q[0])
    rod, s2 = rpr(b, d, 0, +1)
    e = d + m("1.6") * rod
    slot, s5, s4 = rpp(e, m.vec("0", "0.8"), turn(0), m.deg("90"), 0, 0)
    m.points.update(E=e)
    m.links.update(rod=rod)
    m.slides.update(block=s2, ram=s5, pin=s4)


def flying_shear(m):
    d = m.vec("0.6657", "0")
    b = m("0.08") * turn(m.q[0])
    c = rrr(b, d, m("0.632"), m("0.374"), -1)
    u = unit(c - b)
    m.points.update(B=b, C=c, blade=b + m.vec("0.5", "-0.06") * u)
    m.links.update(BC=u, DC=unit(c - d))


def coupler_four_bar(m, mode=+1):
    a, d = m.vec("0.1", "-0.2"), m.vec("3.1", "0.4")
    crank = turn(m.q[0] + m("0.2"))
    b = a + m("1.1") * crank
    l1, l2 = m("3.2"), m("2.4")
    c = rrr(b, d, l1, l2, mode)
    bc, dc = unit(c - b), unit(c - d)
    p = b + m.vec("1.7", "-0.4") * bc
    q = d + m("1.3") * turn(m.deg("35")) * dc
    r = rrr(b, b + l1 * bc, m("2.1"), m("1.9"), -1)
    m.points.update(B=b, C=c, P=p, Q=q, R=r)
    m.links.update(AB=crank, BC=bc, DC=dc)


def inclined_slider_crank(m, mode=+1):
    rail = turn(m("0.15"))
    crank = turn(m.q[0])
    b = m("1") * crank
    c, slide = rrp(b, m.vec("0.5", "0.3"), rail, m("3.1"), m("0.22"), mode)
    bc = unit(c - b)
    p = b + m.vec("1.2", "0.5") * bc
    q = c + m("0.3") * turn(m.deg("50")) * rail
    m.points.update(B=b, C=c, P=p, Q=q)
    m.links.update(AB=crank, BC=bc, block=rail)
    m.slides.update(block=slide)


def offset_quick_return(m, mode=+1):
    d = m.vec("-0.3", "-2.1")
    crank = turn(m.q[0])
    b = m("1") * crank
    bar, slide = rpr(b, d, m("0.35"), mode)
    e = d + m.vec("3.7", "-0.4") * bar
    f = b + m.vec("0.2", "0.3") * bar
    m.points.update(B=b, E=e, F=f)
    m.links.update(AB=crank, block=bar, bar=bar)
    m.slides.update(block=slide)


def crossed_guides(m):
    crank = turn(m.q[0])
    b = m("1") * crank
    arm, post = crank * turn(m.deg("70")), turn(m.deg("80"))
    c, s1, s2 = prp(b, arm, m("0.1"), m.vec("2.5", "0"), post, m("-0.2"))
    w = c + m.vec("0.2", "0.1") * arm
    m.points.update(B=b, C=c, W=w)
    m.links.update(AB=crank, shoe=arm, block=post)
    m.slides.update(shoe=s1, block=s2)


def oblique_yoke(m):
    crank = turn(m.q[0])
    b = m("0.4") * crank
    rail, k = turn(m.deg("5")), m.vec("-1", "-0.8")
    slot, s1, s2 = rpp(b, k, rail, m.deg("75"), m("0.05"), m("-0.07"))
    w = k + s1 * rail + m.vec("0.3", "0.2") * rail
    v = b + m.vec("0.1", "-0.05") * slot
    m.points.update(B=b, W=w, V=v)
    m.links.update(AB=crank, yoke=rail, block=slot)
    m.slides.update(yoke=s1, block=s2)


def gantry(m):
    x, y = m.q
    bed = turn(m.deg("20"))
    p = m.vec("0.2", "-0.1") + (x + I * m("0.15")) * bed
    column = bed * turn(m.deg("100"))
    q = p + m.vec("0.05", "0.1") * bed + (y + I * m("-0.04")) * column
    m.points.update(P=p, Q=q)
    m.links.update(saddle=bed, quill=column)
    m.slides.update(saddle=x, quill=y)


def polar_arm(m):
    phi, r = m.q
    a = m.vec("0.3", "0.2")
    arm = turn(phi)
    groove = arm * turn(m("-0.4"))
    p = a + m.vec("0.25", "-0.1") * arm + (r + I * m("0.08")) * groove
    wrist = arm * turn(2 * phi)
    h = p + m("0.12") * wrist
    m.points.update(P=p, H=h)
    m.links.update(arm=arm, ram=groove, wrist=wrist)
    m.slides.update(ram=r)


def geared_five_bar(m):
    theta = m.q[0]
    d = m.vec("1.2", "0")
    ab, de = turn(theta), turn(-2 * theta + m.deg("15"))
    b = m("0.5") * ab
    e = d + m("0.4") * de
    c = rrr(b, e, m("1.1"), m("1.3"), +1)
    bc, ec = unit(c - b), unit(c - e)
    m.points.update(B=b, E=e, C=c, P=b + m.vec("0.6", "0.45") * bc)
    m.links.update(AB=ab, DE=de, BC=bc, EC=ec)


def rack_and_pinion(m):
    s = m.q[0]
    k = m.vec("0", "0.02")
    pinion = turn(s / m("0.02"))
    r = k + m("0.015") * pinion
    arm = pinion * turn(s / m("0.05") + m("0.3"))
    t = r + m("0.03") * arm
    c, slide = rrp(t, m.vec("0", "0.05"), turn(m.deg("180")), m("0.09"), 0, -1)
    m.points.update(R=r, T=t, C=c)
    m.links.update(pinion=pinion, arm=arm)
    m.slides.update(block=slide)


def excavator(m):
    lift, crowd, curl = m.q
    o, f = m.vec("0", "0"), m.vec("0.5", "-0.6")
    g = rrr(f, o, lift, m("2.6"), -1)
    boom = unit(g - o)
    s = o + m.vec("5.2", "-1.1") * boom
    h = o + m.vec("2.9", "0.5") * boom
    j = rrr(h, s, crowd, m("0.8"), -1)
    stick = unit(j - s)
    t = s + m.vec("-2.8", "0.3") * stick
    n = s + m.vec("-0.3", "0.7") * stick
    k = s + m.vec("-2.4", "0.35") * stick
    v = rrr(n, k, curl, m("0.6"), -1)
    w = rrr(v, t, m("0.55"), m("0.45"), -1)
    bucket = unit(w - t)
    tooth = t + m.vec("0.4", "-1.4") * bucket
    m.points.update(S=s, T=t, tooth=tooth)
    m.links.update(boom=boom, stick=stick, bucket=bucket)


def swinging_guide(m):
    theta, psi, s = m.q
    ab = turn(theta)
    b = m("0.5") * ab
    slot = ab * turn(psi)
    foot = m.vec("0.3", "0.1") * ab
    p = m.vec("-0.7", "0.4") + (m("0.4") * s + I * s * s / m("2"))
    length = sqrt(m("1.1") * m("1.1") + s * s)
    c, slide = rrp(p, foot, slot, length, s / 4, +1)
    pc = unit(c - p)
    q = p + (m("0.5") * s + I * hypot(s, m("0.3"))) * pc
    m.points.update(B=b, P=p, C=c, Q=q)
    m.links.update(AB=ab, PC=pc, block=slot)
    m.slides.update(block=slide)


def moving_bases(m):
    theta = m.q[0]
    a, d = m.vec("0", "0"), m.vec("3", "0.4")
    ab = turn(theta + m("0.2"))
    b = a + m("1.1") * ab
    de = turn(-2 * theta + m.deg("15"))
    e = d + m("0.3") * de
    c = rrr(b, e, m("3.2"), m("2.4"), +1)
    bc, ec = unit(c - b), unit(c - e)
    p = b + m("1.7") * turn(m("0.4")) * bc
    t = e + m("1.1") * turn(m("-0.4")) * ec
    pf, slide5 = None, None
    groove = ec * turn(m("0.5"))
    f, slide5 = rrp(p, e, groove, m("5.5"), m("0.12"), +1)
    pf = unit(f - p)
    g = p + m("2.2") * turn(m("0.2")) * pf
    bar, slide6 = rpr(g, t, m("-0.3"), -1)
    h = t + m.vec("1.4", "-0.5") * bar
    rail = bc * turn(m("-0.3"))
    slot, slide9, slide8 = rpp(h, p, rail, m("2"), m("0.01"), m("0.02"))
    y = p + slide9 * rail + m.vec("0.2", "0.3") * rail
    track = pf * turn(m("1.1"))
    u, slide10, slide11 = prp(p, rail, m("0.4"), g, track, m("0.05"))
    x = rrr(u, y, m("6.5"), m("5.5"), +1)
    m.points.update(C=c, F=f, H=h, Y=y, U=u, X=x)
    m.links.update(EC=ec, PF=pf, bar=bar, UX=unit(x - u))
    m.slides.update(block=slide5, sleeve=slide6, yoke=slide9, pin=slide8, shoe=slide10, slipper=slide11)


def variable_four_bar(m):
    theta, s = m.q
    ab, bed = turn(theta), turn(m.deg("30"))
    b = (m("1.1") + s / 10) * ab
    d = m.vec("3", "0.4") + (s + I * (s * s / m("2") + m("0.1"))) * bed
    l1, l2 = m("3.2") + s / 4, m("2.4") - s / 8
    c = rrr(b, d, l1, l2, +1)
    bc, dc = unit(c - b), unit(c - d)
    p = b + (m("1.7") + s / 2) * turn(s / m("3") - m("0.4")) * bc
    r = rrr(b, c, m("2.1") + s / 6, m("1.9") + s / 9, -1)
    m.points.update(B=b, D=d, C=c, P=p, R=r)
    m.links.update(AB=ab, cart=bed, BC=bc, DC=dc)
    m.slides.update(cart=s)


def variable_bar(m):
    theta, s = m.q
    ab, d = turn(theta), m.vec("-0.3", "-2.1")
    b = (m("1") + s / 4) * ab
    bar, slide = rpr(b, d, m("0.35") + s * s / m("2"), +1)
    e = d + (m("3.7") - s + I * s / 3) * bar
    m.points.update(B=b, E=e)
    m.links.update(AB=ab, block=bar, bar=bar)
    m.slides.update(block=slide)


def variable_cross(m):
    theta, s = m.q
    ab = turn(theta)
    b = m("1") * ab
    arm, post = ab * turn(m.deg("70") + s / m("2")), turn(m.deg("80"))
    e1, e2 = m("0.1") + s / 3, s * s / m("1") - m("0.2")
    c, s1, s2 = prp(b, arm, e1, m.vec("2.5", "0"), post, e2)
    w = c + (m("0.2") + I * s / 2) * arm
    m.points.update(B=b, C=c, W=w)
    m.links.update(AB=ab, shoe=arm, block=post)
    m.slides.update(shoe=s1, block=s2)


def variable_yoke(m):
    theta, s = m.q
    ab, rail = turn(theta), turn(m.deg("5"))
    b, k = m("0.4") * ab, m.vec("-1", "-0.8")
    e1, e2 = m("0.05") + s / 5, s * s / m("4") - m("0.07")
    slot, s1, s2 = rpp(b, k, rail, m.deg("75") + s / m("3"), e1, e2)
    w = k + (s1 + m("0.3") + I * s) * rail
    v = b + m.vec("0.1", "-0.05") * slot
    m.points.update(B=b, W=w, V=v)
    m.links.update(AB=ab, yoke=rail, block=slot)
    m.slides.update(yoke=s1, block=s2)


def variable_rod(m):
    theta, s = m.q
    ab, d = turn(theta), m.vec("2", "0.3")
    b = m("0.5") * ab
    table = turn(theta / 2 + s / m("1"))
    groove = table * turn(m.deg("40") - s / m("2"))
    foot = d + (s / 2 + I * m("0.1")) * table
    c, slide = rrp(b, foot, groove, m("2.5") + s * s / m("3"), s / 4, -1)
    m.points.update(B=b, C=c)
    m.links.update(AB=ab, table=table, BC=unit(c - b), block=groove)
    m.slides.update(block=slide)
