use linkage_core::mechanism;

mechanism! {
    /// A drawer that a hand pulls beside its guide, which jams where the hand is too far beside.
    pub struct Drawer {
        input x: length;
        param beside = 100mm;
        guide rail through (0, 0) along 0deg;
        guide path through (0, beside) along 0deg;
        slider hand(path) -> B { slide: x }
        rpp block(B), drawer(rail) { slot: 90deg }
        point F on drawer at (0, 0);
        force (-20N, 0) on F;
        friction 0.25 on drawer length 300mm;
        output F, x.drive;
    }
}
