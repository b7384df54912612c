//! What `drive.py` asks rust-analyzer about; a mark is a comment, and stands in front of what is asked about.

use linkage_core::mechanism;

mechanism! {
    /// Shear of a strip mill.
    pub struct /*name*/Shear {
        /// Angle of the crank.
        input /*input*/theta: angle;
        /// The coupler's length.
        param /*param*/l = 632mm;
        ground A(0, 0), D(665.7mm, 0);
        crank AB(A) -> /*pin*/B { length: 80mm, angle: /*use of input*/theta }
        rrr BC(/*use of pin*/B), DC(D) -> C { lengths: (/*use of param*/l, 374mm), mode: right }
        /// Edge of the knife.
        point /*point*/blade on BC at (500mm, -60mm);
    }
}

mechanism! {
    struct Press {
        input /*first of inputs*/q, r: angle;
        load /*load*/cut: force;
        ground A(0, 0), D(1m, 0);
        crank AB(A) -> B { length: 0.2m, angle: q }
        crank DE(D) -> E { length: 0.2m, angle: r }
        rrr BC(B), EC(E) -> C { lengths: (0.8m, 0.8m), mode: left }
        mass 2kg on BC uniform;
        force (0, -/*use of load*/cut) on C;
        output C, q.drive;
    }
}

mod with_a_mistake {
    use linkage_core::mechanism;

    mechanism! {
        /// A shear with a mistake.
        pub struct Broken {
            /// Angle of the crank.
            input theta: angle;
            /// The coupler's length.
            param l = 632mm;
            ground A(0, 0), D(665.7mm, 0);
            crank AB(A) -> B { length: 80kg, angle: theta }
            rrr BC(B), DC(D) -> C { lengths: (l, 374mm), mode: right }
            /// Edge of the knife.
            point blade on BC at (500mm, -60mm);
        }
    }

    pub fn show() {
        let broken = /*broken solver*/Broken { /*broken param*/l: 0.6 };
        let p = broken./*broken method*/position(0.3).unwrap();
        println!("{}", p./*broken point*/blade.x);
    }
}

fn main() {
    let shear = /*use of name*/Shear { /*field of param*/l: 0.6 };
    let p = shear./*method*/position(0.3).unwrap();
    let m = shear.motion(0.3, 1.0, 0.0).unwrap();
    println!("{} {}", p./*field*/blade.x, p.BC.angle());
    println!("{} {}", m.velocity./*field of velocity*/blade.y, m.acceleration./*field of acceleration*/blade.y);
    let _: Option<&/*use of record*/ShearPosition<f64>> = Some(&p);
    let press = Press::new();
    let _ = press./*method of press*/forces([0.3, 0.2], [1.0, 1.0], [0.0, 0.0], 10.0);
    with_a_mistake::show();
}
