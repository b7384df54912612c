//! Reads files of structured text by the crate `iec61131`: a line a file, or what it does not accept.

use std::process::ExitCode;

fn main() -> ExitCode {
    for path in std::env::args().skip(1) {
        let text = std::fs::read_to_string(&path).expect("the file can be read");
        match iec61131::Parser::new(&text).parse() {
            Ok(read) => println!("{}", read.declarations.len()),
            Err(error) => {
                println!("{path}: {error:?}");
                return ExitCode::FAILURE;
            }
        }
    }
    ExitCode::SUCCESS
}
