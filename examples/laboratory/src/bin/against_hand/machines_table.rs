// Written by `draw_mechanisms machines` of this package, which says how.

machine! { slider_crank: one [theta: angle] between [TURN; 2],
    { ground A(0, 0); guide rail through (0.076, 0.055) along 0deg; crank AB(A) -> B { length: 0.112, angle: theta }
      rrp BC(B), ram(rail) -> C { length: 0.212, offset: 0.0, mode: ahead } point P on BC at (0.257, -0.14); },
    output [P] [BC] [ram],
    slider_crank(0.112, Rail { origin: [0.076, 0.055], direction: [1.0, 0.0] }, Rod { length: 0.212, offset: 0.0, sense: 1.0 }, [0.257, -0.14]) -> SliderCrank }

machine! { slider_crank_oblique: one [theta: angle] between [TURN; 2],
    { ground A(0, 0); guide rail through (-0.041, 0.018) along 106deg; crank AB(A) -> B { length: 0.095, angle: theta }
      rrp BC(B), ram(rail) -> C { length: 0.646, offset: 0.0, mode: behind } point P on BC at (0.204, -0.038); },
    output [C P] [BC] [ram],
    slider_crank(0.095, Rail { origin: [-0.041, 0.018], direction: [-0.27563735581699905, 0.9612616959383189] }, Rod { length: 0.646, offset: 0.0, sense: -1.0 }, [0.204, -0.038]) -> SliderCrank }

machine! { shaper: one [theta: angle] between [TURN; 2],
    { ground A(0, 0), D(-0.095, -0.364); guide rail through (0.199, -0.08) along 0deg; crank AB(A) -> B { length: 0.131, angle: theta }
      rpr block(B), rod(D) { mode: behind } point E on rod at (0.389, 0.066);
      rrp EC(E), ram(rail) -> C { length: 0.698, offset: -0.051, mode: behind } },
    output [E] [rod] [ram],
    shaper(0.131, [-0.095, -0.364], -1.0, [0.389, 0.066], Rail { origin: [0.199, -0.08], direction: [1.0, 0.0] }, Rod { length: 0.698, offset: -0.051, sense: -1.0 }) -> Shaper }

machine! { press: one [theta: angle] between [TURN; 2],
    { ground A(0, 0), D(0.3, 0.055); guide rail through (-0.181, 0.084) along 0deg;
      crank AB(A) -> B { length: 0.059, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (0.426, 0.221), mode: right } point P on BC at (0.039, -0.006);
      rrp PE(P), ram(rail) -> E { length: 0.382, offset: 0.0, mode: behind } },
    output [E P] [BC DC] [ram],
    press(CrankDyad { crank: 0.059, dyad: Dyad { pivot: [0.3, 0.055], lengths: [0.426, 0.221], side: -1.0 } }, [0.039, -0.006], Rail { origin: [-0.181, 0.084], direction: [1.0, 0.0] }, Rod { length: 0.382, offset: 0.0, sense: -1.0 }) -> Press }

machine! { crossed_guides: one [theta: angle] between [[-0.9948376736367679, 1.2740903539558606]; 2],
    { ground A(0, 0); guide rail through (-0.141, -0.057) along -89deg; crank AB(A) -> B { length: 0.069, angle: theta }
      guide slot on AB through B along -7deg;
      prp shoe(slot), ram(rail) -> C { offsets: (0.064, 0.081) } },
    output [C] [] [ram],
    crossed_guides(0.069, [0.992546151641322, -0.12186934340514748], Rail { origin: [-0.141, -0.057], direction: [0.0174524064372836, -0.9998476951563913] }, [0.064, 0.081]) -> Crossed }

machine! { scotch_yoke: one [theta: angle] between [TURN; 2],
    { ground A(0, 0); guide rail through (0.108, 0.063) along 0deg; crank AB(A) -> B { length: 0.14, angle: theta }
      rpp block(B), ram(rail) { slot: 133deg, offsets: (0.009, 0.06) } },
    output [B] [] [block],
    scotch_yoke(0.14, Rail { origin: [0.108, 0.063], direction: [1.0, 0.0] }, [-0.6819983600624984, 0.7313537016191706], [0.009, 0.06]) -> Yoke }

machine! { rocker_guide: one [theta: angle] between [TURN; 2],
    { ground A(0, 0), D(0.193, 0.096), F(0.381, -0.115);
      crank AB(A) -> B { length: 0.051, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (0.135, 0.171), mode: left } guide slot on DC through (0.272, 0.1) along 60deg;
      rrp FE(F), shoe(slot) -> E { length: 0.511, offset: 0.088, mode: ahead } },
    output [C E] [DC FE] [shoe],
    rocker_guide(CrankDyad { crank: 0.051, dyad: Dyad { pivot: [0.193, 0.096], lengths: [0.135, 0.171], side: 1.0 } }, [0.272, 0.1], [0.5000000000000001, 0.8660254037844386], [0.381, -0.115], Rod { length: 0.511, offset: 0.088, sense: 1.0 }) -> RockerGuide }

machine! { five_bar: two [theta: angle, phi: angle] between [TURN; 2],
    { ground A(0, 0), D(0.405, 0.0); crank AB(A) -> B { length: 0.034, angle: theta }
      crank DE(D) -> E { length: 0.097, angle: phi }
      rrr BC(B), EC(E) -> C { lengths: (0.316, 0.343), mode: right } point P on BC at (0.229, -0.12); },
    output [C P] [BC EC] [],
    five_bar([0.034, 0.097], [0.405, 0.0], [0.316, 0.343], -1.0, [0.229, -0.12]) -> FiveBar }

machine! { arm: two [theta: angle, phi: angle] between [TURN; 2],
    { ground A(0, 0), D(0.739, 0.348); crank AB(A) -> B { length: 0.19, angle: theta }
      crank BC(B) -> C { length: 0.108, angle: phi, relative_to: AB }
      rpr block(C), rod(D) { offset: 0.028, mode: behind } point P on rod at (0.173, -0.081); },
    output [C P] [rod] [block],
    arm([0.19, 0.108], [0.739, 0.348], 0.028, -1.0, [0.173, -0.081]) -> Arm }

machine! { excavator: two [lift: length, reach: length] between [[0.16, 0.559], [0.188, 0.748]],
    { ground O(0, 0), F(0.283, -0.104);
      rrr lifter(F), boom(O) -> G { lengths: (lift, 0.32), mode: right }
      point K on boom at (0.268, 0.184); point J on boom at (0.61, -0.09);
      rrr pusher(K), stick(J) -> H { lengths: (reach, 0.375), mode: left }
      point P on stick at (0.09, -0.035); },
    output [H] [boom stick] [],
    excavator([0.283, -0.104], (0.32, -1.0), [[0.268, 0.184], [0.61, -0.09]], (0.375, 1.0), [0.09, -0.035]) -> Excavator }

every! { machines:
    slider_crank
    slider_crank_oblique
    shaper
    press
    crossed_guides
    scotch_yoke
    rocker_guide
    five_bar
    arm
    excavator
}
