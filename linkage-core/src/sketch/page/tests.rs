//! The script's arithmetic and its decisions at limits, against those of the crate, to the bit.

mod cases;
mod node;

use std::format;
use std::string::String;

use cases::{Case, conditions, kernels};

/// The files that compute and decide.
const ARITHMETIC: [&str; 3] =
    [include_str!("kernels.js"), include_str!("limit.js"), include_str!("checks.js")];

/// Compares each line's answer with the script's own. Zeros of both signs differ, NaN are alike.
const COMPARE: &str = r#"
const number = (hex) => fromBits(parseInt(hex.slice(0, 8), 16), parseInt(hex.slice(8), 16));
const bits = (x) => Number.isNaN(x) ? "NaN" : [highBits(x), bytes.getUint32(4)].map((w) => w.toString(16).padStart(8, "0")).join("");
const functions = { sinCos, tan, asin, acos, atan, atan2, hypot, det, mulErr, addErr, exactSum: (...terms) => exactSum(terms) };
const answer = (name, given) => {
  if (functions[name]) return [functions[name](...given)].flat().map(bits).join(" ");
  const checks = new FirstError(), value = checks[name](...given, "group", "group");
  const { kind, group, by } = checks.error ?? {};
  return !kind ? bits(value) : by === undefined ? `${kind} ${group}` : `${kind} ${group} ${bits(by)}`;
};
const lines = require("fs").readFileSync(process.argv[2], "utf8").trim().split("\n");
let wrong = 0;
for (const line of lines) {
  const [asked, expected] = line.split(" : "), [name, ...given] = asked.split(" ");
  const found = answer(name, given.map(number));
  if (found !== expected && ++wrong <= 5) console.log(`${name} ${given.map(number)}: ${found} for ${expected}`);
}
console.log(`${lines.length} compared, ${wrong} wrong`);
process.exitCode = wrong ? 1 : 0;
"#;

/// On a target with fused operations the crate rounds otherwise than a script can.
fn compare(cases: impl Iterator<Item = Case>) {
    if cfg!(any(target_feature = "fma", target_arch = "aarch64")) {
        return;
    }
    let lines: String = cases.map(|case| format!("{case}\n")).collect();
    let script = format!("{}{COMPARE}", ARITHMETIC.concat());
    let Some(output) = node::run(&script, &lines) else { return };
    assert!(output.is_success, "{}", output.text);
}

#[test]
fn the_script_computes_the_same_bits() {
    compare(kernels());
}

#[test]
fn the_script_decides_alike_beside_limits() {
    compare(conditions());
}
