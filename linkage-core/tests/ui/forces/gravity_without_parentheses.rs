use linkage_core::mechanism;

mechanism! {
    /// Double-toggle jaw crusher: eccentric, pitman, two toggle plates, swinging jaw.
    pub struct JawCrusher {
        input theta: angle;
        param gap = 40mm;
        load stone: force;
        ground E(0, 0), F(-560mm, -900mm), J(900mm, 100mm);
        crank EC(E) -> P { length: 18mm, angle: theta }
        rrr pitman(P), rear(F) -> K { lengths: (860mm, 590mm), mode: left }
        rrr front(K), jaw(J) -> T { lengths: (560mm, 1000mm), mode: right }
        point bite on jaw at (850mm, gap);
        mass 900kg on jaw at (500mm, 60mm) inertia 120(kg*m^2);
        mass 300kg on pitman uniform;
        gravity (0, -9.81m/s^2);
        spring rod between T and F { stiffness: 20(N/mm), free_length: 300mm }
        force (-stone, 0) in jaw on bite;
        output bite, jaw.angle, EC.drive, rear.F, rod.force, energy;
    }
}

fn main() {
    let forces = JawCrusher::new().forces(0.1, 30.0, 0.0, 2e5);
    println!("{:?}", forces.map(|forces| forces.EC.drive));
}
