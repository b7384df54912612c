//! The arguments of the program, and its help.

use std::path::PathBuf;

use clap::{Parser, Subcommand};

/// The compiler of planar mechanisms: from drivers and Assur groups to static solvers.
///
/// A mechanism is declared in a Rust file by `mechanism! { … }`; the file may hold a whole program, and several
/// mechanisms. No Rust compiler is needed:
///
///     linkage check shear.rs               mistakes, at their line and column
///     linkage c shear.rs -o control/       flying_shear.h, flying_shear.c and the run-time
///     cc -std=c99 -O2 -c control/*.c
///     linkage fmu press.rs -o press.fmu    a model for simulators, FMI 3.0
#[derive(Debug, Parser)]
#[command(name = "linkage", version, verbatim_doc_comment, arg_required_else_help = true)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

/// A task for the compiler.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Say what is wrong with the declarations of some files
    #[command(verbatim_doc_comment)]
    Check {
        /// Rust programs
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
    },
    /// Print the Rust code that the declarations of a file become
    Expand {
        /// A Rust program
        file: PathBuf,
    },
    /// Print the solvers of a file as C99
    ///
    /// For each mechanism a header and a source, and once `linkage_run.h` and `linkage_run.c`, which all of them need;
    /// `linkage_root.c` too where a mechanism has an unknown, `linkage_friction.c` where joints rub.
    /// Functions, structs and status codes are those of `export c;`, and so are the answers, bit for bit.
    ///
    ///     linkage c shear.rs -o control/
    ///     linkage c shear.rs -o control/ --only motion_at,f32
    ///
    /// The sources are C99 and C++17, call nothing but <math.h>, and allocate nothing. Do not compile them with
    /// -ffast-math; a compiler other than gcc, clang and MSVC has to be told not to contract products into sums.
    #[command(verbatim_doc_comment)]
    C {
        /// A Rust program
        file: PathBuf,
        /// The folder to write to
        #[arg(short, long, value_name = "FOLDER", default_value = ".")]
        output: PathBuf,
        /// Entry points and widths to print, such as motion_at,f32; all of them without this
        #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
        only: Vec<String>,
    },
    /// Make an FMU (FMI 3.0) of the mechanism of a file
    ///
    /// It is made for model exchange and for co-simulation, as sources and, where `cc` is there, as a library for this
    /// machine. Where masses are declared for every input, the inputs and their rates are states, moved by the efforts
    /// of the drives and by loads; elsewhere, or with --kinematic, inputs and both their rates are given. Numeric
    /// parameters are tunable; modes are as declared. A pose out of reach is fmi3Discard, with the group's name in the
    /// log.
    ///
    ///     linkage fmu press.rs -o press.fmu
    #[command(verbatim_doc_comment)]
    Fmu {
        /// A Rust program with one mechanism
        file: PathBuf,
        /// The FMU to write
        #[arg(short, long, value_name = "FILE")]
        output: PathBuf,
        /// Take inputs and their rates as given, whatever has mass
        #[arg(long)]
        kinematic: bool,
    },
}
