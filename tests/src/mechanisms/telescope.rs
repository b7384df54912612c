//! A body whose parts move against each other, and what acts between them.

use linkage_core::mechanism;

mechanism! {
    /// A rod slides in a crank, on a spring between its end and the crank's pin.
    pub struct Telescope {
        input theta: angle;
        input s: length;
        param k = 40(N/m);
        param c = 3(N*s/m);
        load pull: force;
        ground A(0, 0);
        crank AB(A) -> B { length: 0.7m, angle: theta }
        point T on AB at (0.2m + s, 0.1m);
        gravity (0, -9.81);
        mass 2kg on AB at T;
        mass 1kg on AB uniform;
        spring coil between T and B { stiffness: k, free_length: 0.3m, damping: c }
        force pull + 2(N*s/m) * rate(distance(T, B)) between T and B;
        output theta.drive, s.drive, AB.drive, AB.A, coil.force, coil.length, energy;
    }
}
