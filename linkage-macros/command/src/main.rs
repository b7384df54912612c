//! `linkage`: the compiler of mechanisms without a Rust compiler.
//!
//! The exit status is 0 where all is well, 1 where a machine has a mistake or a file is stale, 2 where the arguments
//! or a file cannot be used.

mod arguments;
mod check;
mod draw;
mod export;
mod fmu;
mod import;
mod messages;
mod mjcf;
mod output;
mod page;
mod parameters;
mod pose;
mod program;
mod proof;
mod report;
mod style;
mod values;
mod zip;

use std::process::ExitCode;

use crate::arguments::Command;
use crate::output::Failure;

fn main() -> ExitCode {
    match run(arguments::parsed().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure::Told) => ExitCode::from(1),
        Err(Failure::Unusable(why)) => {
            style::tell(&why);
            ExitCode::from(2)
        }
    }
}

fn run(command: Command) -> Result<(), Failure> {
    match command {
        Command::Check(arguments) => check::run(&arguments),
        Command::Report(arguments) => proof::run(&arguments),
        Command::Import(arguments) => import::run(&arguments),
        Command::Page(arguments) => page::run(&arguments),
        Command::Draw(arguments) => draw::run(&arguments),
        Command::Export(arguments) => export::run(&arguments),
    }
}
