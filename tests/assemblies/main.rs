//! Lists of all assemblies at run time: `export assemblies;`.

mod drawn;
mod triads;
