//! The arguments of the program, and its help.

use std::path::PathBuf;

use crate::mjcf::Plane;
use clap::error::{ContextKind, ContextValue};
use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};

/// The flags that verbs have in common.
const FLAGS: &str = "\
Wherever they apply:
  -o PATH                what is written: a folder where several files come, a file otherwise
  --machine NAME         one mechanism of several
  --inputs SET,…         one named set of inputs, or some of them
  --between theta=0..90deg, --at theta=2rad, --rate theta=2, --load cut=1kN
                         what is looked at: ranges, values and rates of inputs, loads
  --set crank=90mm       another value of a parameter than the declared one
  --only ENTRY,WIDTH,…   fewer entry points and widths, such as motion_at,f32
  --json                 what is told, as JSON
  --stale                write nothing, and end with status 1 where what stands there is not what would be written";

/// The compiler of planar mechanisms: from drivers and Assur groups to static solvers.
///
/// A mechanism is declared by `mechanism! { … }` in a Rust file, which may hold a whole program and several mechanisms;
/// or a file holds nothing but what stands between these braces. No Rust compiler is needed:
///
///     linkage check shear.rs                      mistakes, at their line and column
///     linkage report shear.rs                     errors that are proved, in f32 and f64
///     linkage import machine.json -o machine.rs   a machine of PMKS+, pyslvs or pylinkage as a declaration
///     linkage page shear.rs -o shear.html         a page on which the machine is dragged
///     linkage draw shear.rs -o shear.svg          a picture of a pose
///     linkage export c shear.rs -o control/       flying_shear.h, flying_shear.c and the run-time
///     cc -std=c99 -O2 -c control/*.c
///     linkage export st shear.rs -o plc/          function blocks for a PLC, IEC 61131-3
///     linkage export fmu press.rs -o press.fmu    a model for simulators, FMI 3.0
///
/// The exit status is 0, 1 where a mechanism has a mistake or a file is stale, or 2 where the arguments or a file cannot be
/// used.
#[derive(Debug, Parser)]
#[command(name = "linkage", version, verbatim_doc_comment, arg_required_else_help = true, after_help = FLAGS)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

/// The arguments; where they are none, the program ends and says what is nearest to a mistaken verb: `export fmu` to `fmu`,
/// and all verbs where none is near.
pub(crate) fn parsed() -> Arguments {
    Arguments::try_parse().unwrap_or_else(|mut error| {
        if let Some(ContextValue::String(word)) = error.get(ContextKind::InvalidSubcommand) {
            let format = Format::from_str(word, false).map(|_| vec![format!("export {word}")]);
            let has_near = error.get(ContextKind::SuggestedSubcommand).is_some();
            let verbs = || {
                let command = Arguments::command();
                command.get_subcommands().map(|verb| verb.get_name().to_string()).collect()
            };
            if format.is_ok() || !has_near {
                let near = ContextValue::Strings(format.unwrap_or_else(|_| verbs()));
                error.insert(ContextKind::SuggestedSubcommand, near);
            }
        }
        error.exit()
    })
}

/// A task for the compiler.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Say what is wrong with the declarations of some files
    ///
    /// A line says how many mistakes there are; where there is none, the exit status is 0. Notes are about mechanisms
    /// that have a solver: they change no status. With NO_COLOR there are no colours.
    ///
    ///     linkage check shear.rs press.rs
    ///     linkage check shear.rs --set crank=90mm --json
    #[command(verbatim_doc_comment)]
    Check(Check),
    /// Prove how large the rounding errors of a solver are, and tell what it costs
    ///
    /// For each result: the largest value, what no error exceeds in f32 and in f64, with fused operations and without, and
    /// where it is worst; what a dimension changes; where the fast path is shown to answer, and next to a limit the bound
    /// by its distance; operations. Angles go over a full turn, parameters are at their defaults.
    ///
    ///     linkage report shear.rs
    ///     linkage report shear.rs --between theta=0deg..90deg --within 1um --width f32
    ///     linkage report press.rs --rate theta=12 --load press=400N --only forces --json
    ///
    /// With --within the exit status is 1 where an error is not shown to be within.
    #[command(verbatim_doc_comment)]
    Report(ReportArguments),
    /// Print a machine of PMKS+, pyslvs, pylinkage or MuJoCo as a declaration
    ///
    ///     linkage import 'https://app.pmksplus.com/?2P.Fe.K,0.1011.MA,A,0,0,0…' -o machine.rs
    ///     linkage import machine.json --unit m
    ///     linkage import machine.txt --drive 0,1
    ///     linkage import robot.xml
    #[command(verbatim_doc_comment)]
    Import(Import),
    /// Write a page on which the machine is dragged
    ///
    ///     linkage page shear.rs -o shear.html
    ///     linkage page shear.rs -o shear.html --set crank=90mm --between theta=-90deg..90deg --rate theta=12(rad/s)
    ///
    /// It is one file that asks for nothing of the network. Values are written as in the language; bare ones are in SI units.
    #[command(verbatim_doc_comment)]
    Page(Page),
    /// Draw a machine in one pose, as SVG
    ///
    ///     linkage draw shear.rs -o pose.svg
    ///     linkage draw shear.rs -o pose.svg --at theta=120deg --set crank=90mm
    ///
    /// Without --at a drawn machine stands as its declaration draws it, and an angle is one radian.
    #[command(verbatim_doc_comment)]
    Draw(Draw),
    /// Print the solvers of a file as C99, as structured text, as an FMU, or as Rust
    ///
    /// c: for each mechanism a header and a source, and once `linkage_run.h` and `linkage_run.c`, which all of them need;
    /// `linkage_root.c` too where a mechanism has an unknown, `linkage_friction.c` where joints rub.
    /// Functions, structs and status codes are those of `export c;`, and so are the answers, bit for bit.
    ///
    ///     linkage export c shear.rs -o control/
    ///     linkage export c shear.rs -o control/ --only motion_at,f32
    ///     linkage export c arm.rs -o acme/ --prefix acme
    ///     linkage export c robot.rs -o control/ --inputs motors,hand
    ///
    /// A machine with several sets of inputs has a solver each, and files under its own name, which carry poses, rates,
    /// efforts and inertias over from one set to another.
    ///
    /// With a prefix the solvers of two suppliers, of one name and from two versions, stand in one program. A folder with
    /// sources of another version is left alone, since its run-time would be overwritten. Names of inputs and outputs, the
    /// version and a hash of the declaration stand in the header and in the object.
    ///
    /// The sources are C99 and C++17, call nothing but <math.h>, and allocate nothing. Do not compile them with
    /// -ffast-math; a compiler other than gcc, clang and MSVC has to be told not to contract products into sums.
    ///
    /// st: for each mechanism a text of types and function blocks of IEC 61131-3, and once `linkage_run.st`, which all of
    /// them need. A block is an entry point's fast path in LREAL or REAL: `status` is 0 and results have the bits of
    /// printed C, or `status` and `refused` tell what is to blame and results are zero. Next to a limit it refuses what
    /// printed C decides without rounding. No block meets an infinity. Searches and friction are refused.
    ///
    ///     linkage export st shear.rs -o plc/ --only motion,f64
    ///     linkage export st shear.rs -o plc/ --sines controller
    ///
    /// fmu: a model of one mechanism for model exchange and for co-simulation (FMI 3.0), as sources and, where `cc` is
    /// there, as a library for this machine. Where masses are declared for every input, the inputs and their rates are
    /// states, moved by the efforts of the drives and by loads; elsewhere, or with --kinematic, inputs and both their
    /// rates are given. Numeric parameters are tunable; modes are as declared. A pose out of reach is fmi3Discard, with
    /// the group's name in the log.
    ///
    ///     linkage export fmu press.rs -o press.fmu
    ///     linkage export fmu robot.rs -o robot.fmu --inputs motors
    ///
    /// mjcf: a drawing as bodies of MuJoCo. Loops are held by `connect`, a distance that is driven is a tendon, limits are
    /// those of stops, and the keyframe `drawn` is the drawing. With --tree there are no loops: joints follow the one that is
    /// driven by polynomials, whose worst error stands beside them.
    ///
    ///     linkage export mjcf robot.rs -o robot.xml --inputs motors --plane xz
    ///
    /// rust: the code that the declarations become.
    #[command(verbatim_doc_comment)]
    Export(Export),
}

/// The mechanisms of a file that are taken, and their parameters.
#[derive(Debug, Args)]
pub(crate) struct Chosen {
    /// The mechanism to take; all of them without this
    #[arg(long, value_name = "NAME")]
    pub machine: Option<String>,
    /// The named sets of inputs to take; all of them without this
    #[arg(long, value_name = "SET,…", value_delimiter = ',')]
    pub inputs: Vec<String>,
    /// Another value of a parameter than the declared one, as in the language: crank=90mm
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
}

/// Where a text or files go.
#[derive(Debug, Args)]
pub(crate) struct Target {
    /// The path to write: a folder where several files come, a file otherwise. Without this a single text goes to standard
    /// output, and files go beside the source
    #[arg(short, long, value_name = "PATH")]
    pub output: Option<PathBuf>,
    /// Write nothing, and end with status 1 where what stands there is not what would be written
    #[arg(long)]
    pub stale: bool,
}

/// The arguments of `check`.
#[derive(Debug, Args)]
pub(crate) struct Check {
    /// Rust programs, or declarations
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    #[command(flatten)]
    pub chosen: Chosen,
    /// Print mistakes and notes as JSON: a list of mechanisms, each with its messages
    #[arg(long)]
    pub json: bool,
}

/// The arguments of `report`.
#[derive(Debug, Args)]
pub(crate) struct ReportArguments {
    /// A Rust program, or a declaration
    pub file: PathBuf,
    #[command(flatten)]
    pub chosen: Chosen,
    /// The range of an input or a parameter: theta=0deg..180deg
    #[arg(long, value_name = "NAME=FROM..TO")]
    pub between: Vec<String>,
    /// The value of an input that is held: lift=2.3m
    #[arg(long, value_name = "NAME=VALUE")]
    pub at: Vec<String>,
    /// A load, zero without this: press=400N
    #[arg(long, value_name = "NAME=VALUE")]
    pub load: Vec<String>,
    /// The rate of an input: theta=12. Without it bounds are multiples of rates, and forces are at rest
    #[arg(long, value_name = "NAME=RATE")]
    pub rate: Vec<String>,
    /// Entry points; without this motion, forces and dynamics
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub only: Vec<String>,
    /// End with status 1 where an error in this unit is not shown to be within: 1um
    #[arg(long, value_name = "ERROR")]
    pub within: Option<String>,
    /// The error of the target's own sine and cosine, where printed C is compiled with these: 2^-20
    #[arg(long, value_name = "ERROR")]
    pub sine_error: Option<String>,
    /// The error of its own square root in last places, likewise: 1
    #[arg(long, value_name = "PLACES")]
    pub sqrt_error: Option<String>,
    /// One width alone
    #[arg(long, value_parser = ["f32", "f64"])]
    pub width: Option<String>,
    /// As JSON, in SI
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub target: Target,
}

/// The arguments of `import`.
#[derive(Debug, Args)]
pub(crate) struct Import {
    /// An address of PMKS+, or a file with an address, a pyslvs expression, pylinkage's JSON or a planar model of MuJoCo; `-`
    /// is standard input
    pub source: String,
    /// The name of the mechanism
    #[arg(long)]
    pub name: Option<String>,
    /// The unit of coordinates. An address states its own; elsewhere it is the millimetre
    #[arg(long, value_parser = ["m", "mm", "cm", "in", "ft"])]
    pub unit: Option<String>,
    /// Two joints of a pyslvs expression, by their indices: the link through both is turned about the first. One joint
    /// twice: its block is slid
    #[arg(long, value_name = "I,J")]
    pub drive: Vec<String>,
    #[command(flatten)]
    pub target: Target,
}

/// The arguments of `page`.
#[derive(Debug, Args)]
pub(crate) struct Page {
    /// A Rust program, or a declaration
    pub file: PathBuf,
    #[command(flatten)]
    pub chosen: Chosen,
    #[command(flatten)]
    pub target: Target,
    /// A heading in place of the mechanism's name
    #[arg(long)]
    pub title: Option<String>,
    /// The value of a load
    #[arg(long, value_name = "NAME=VALUE")]
    pub load: Vec<String>,
    /// The ends of the slider of an input, a parameter or a load
    #[arg(long, value_name = "NAME=FROM..TO")]
    pub between: Vec<String>,
    /// The rate of an input at which velocities, accelerations and forces are shown
    #[arg(long, value_name = "NAME=VALUE")]
    pub rate: Vec<String>,
    /// Outputs and forces whose curves are offered, the first one at first; all of them without this
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub curves: Vec<String>,
}

/// The arguments of `draw`.
#[derive(Debug, Args)]
pub(crate) struct Draw {
    /// A Rust program, or a declaration
    pub file: PathBuf,
    #[command(flatten)]
    pub chosen: Chosen,
    #[command(flatten)]
    pub target: Target,
    /// The value of an input
    #[arg(long, value_name = "NAME=VALUE")]
    pub at: Vec<String>,
    /// A heading
    #[arg(long)]
    pub title: Option<String>,
}

/// The arguments of `export`.
#[derive(Debug, Args)]
pub(crate) struct Export {
    /// The language or the format
    #[arg(value_enum)]
    pub format: Format,
    /// A Rust program, or a declaration
    pub file: PathBuf,
    #[command(flatten)]
    pub chosen: Chosen,
    #[command(flatten)]
    pub target: Target,
    /// For c and st: entry points and widths to print, such as motion_at,f32; all of them without this
    #[arg(long, value_name = "ENTRY,WIDTH,…", value_delimiter = ',')]
    pub only: Vec<String>,
    /// For c and st: a word in front of the names of functions, types and files, the run-time's too: `acme` for `acme_arm_motion`
    #[arg(long, value_name = "WORD")]
    pub prefix: Option<String>,
    /// For st: sines and cosines that are printed, with the bits of printed C, or SIN and COS of the controller
    #[arg(long, value_enum)]
    pub sines: Option<Sines>,
    /// For fmu: take inputs and their rates as given, whatever has mass
    #[arg(long)]
    pub kinematic: bool,
    /// For mjcf: the plane of the drawing in space; xz without this, z up
    #[arg(long, value_enum)]
    pub plane: Option<Plane>,
    /// For mjcf: no loops; the other joints follow the driven one by polynomials
    #[arg(long)]
    pub tree: bool,
    /// For mjcf --tree: the range of the input
    #[arg(long, value_name = "NAME=FROM..TO")]
    pub between: Vec<String>,
}

/// The language or the format of a solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    C,
    St,
    Fmu,
    Mjcf,
    Rust,
}

/// Where a block's sines and cosines come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Sines {
    Printed,
    Controller,
}

impl Format {
    /// The word that is typed.
    pub(crate) fn word(self) -> String {
        let value = self.to_possible_value();
        value.map(|value| value.get_name().to_string()).unwrap_or_default()
    }
}
