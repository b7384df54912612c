use linkage_core::mechanism;

mechanism! {}

fn main() {}
