//! Instruction counts of a call, read from the disassembly of this very program: other work of the machine
//! does not change them.

use std::collections::HashMap;
use std::process::Command;

/// Along the longest way through a function that calls nothing, which is that of a pose that needs no
/// second look.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Count {
    pub(crate) instructions: usize,
    /// Additions, products, divisions and roots, of one number or of several at once.
    pub(crate) arithmetic: usize,
    /// Operands that are constants in memory.
    pub(crate) constants: usize,
    /// Instructions that move numbers between the halves of registers.
    pub(crate) shuffles: usize,
}

/// An instruction with its operands, by its address.
struct Instruction {
    address: u64,
    mnemonic: String,
    operands: String,
}

/// The functions of this program by their paths; none where there is no `objdump`.
pub(crate) fn counts() -> Option<HashMap<String, Count>> {
    let program = std::env::current_exe().ok()?;
    let arguments = ["-d", "-C", "--no-show-raw-insn", "-j", ".text"];
    let output = Command::new("objdump").args(arguments).arg(program).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout);
    let mut counts = HashMap::new();
    for function in text.split("\n\n") {
        let mut lines = function.lines();
        let Some(name) = lines.next().and_then(path) else { continue };
        if ["made", "by_hand"].iter().any(|way| name.ends_with(way)) {
            let body: Vec<_> = lines.filter_map(instruction).collect();
            counts.insert(name, longest(&body));
        }
    }
    (!counts.is_empty()).then_some(counts)
}

/// `against_hand::kernels::s1_motion::made` of `0000000000012340 <against_hand::…::made>:`.
fn path(line: &str) -> Option<String> {
    let name = line.split_once('<')?.1.strip_suffix(">:")?;
    // The old mangling ends with a hash.
    let name =
        name.rsplit_once("::h").filter(|(_, hash)| hash.len() == 16).map_or(name, |(n, _)| n);
    name.strip_prefix("against_hand::").map(str::to_owned)
}

fn instruction(line: &str) -> Option<Instruction> {
    let (address, rest) = line.split_once(":\t")?;
    let address = u64::from_str_radix(address.trim(), 16).ok()?;
    let (mnemonic, operands) = rest.trim().split_once(' ').unwrap_or((rest.trim(), ""));
    Some(Instruction { address, mnemonic: mnemonic.into(), operands: operands.trim().into() })
}

/// The way to a `ret` with most arithmetic, going backwards over what stands before where it leads.
fn longest(body: &[Instruction]) -> Count {
    let places: HashMap<u64, usize> =
        body.iter().enumerate().map(|(k, i)| (i.address, k)).collect();
    let target = |instruction: &Instruction| {
        let address = instruction.operands.split(' ').next()?;
        places.get(&u64::from_str_radix(address, 16).ok()?).copied()
    };
    let mut known = vec![None; body.len()];
    fn from(
        at: usize,
        body: &[Instruction],
        target: &impl Fn(&Instruction) -> Option<usize>,
        known: &mut [Option<Option<Count>>],
    ) -> Option<Count> {
        let instruction = body.get(at)?;
        if let Some(count) = known[at] {
            return count;
        }
        // A loop leads nowhere.
        known[at] = Some(None);
        let mnemonic = &instruction.mnemonic[..];
        let rest = match mnemonic {
            "ret" => Some(Count::default()),
            "call" | "ud2" => None,
            "jmp" => target(instruction).and_then(|to| from(to, body, target, known)),
            _ => {
                let next = from(at + 1, body, target, known);
                let branch = if mnemonic.starts_with('j') { target(instruction) } else { None };
                let there = branch.and_then(|to| from(to, body, target, known));
                let most = |count: &Option<Count>| count.map(|count| count.arithmetic);
                if most(&there) > most(&next) { there } else { next }
            }
        };
        let count = rest.map(|rest| rest.with(instruction));
        known[at] = Some(count);
        count
    }
    from(0, body, &target, &mut known).unwrap_or_default()
}

impl Count {
    fn with(self, Instruction { mnemonic, operands, .. }: &Instruction) -> Self {
        let name = mnemonic.strip_prefix('v').unwrap_or(mnemonic);
        let starts = |with: &[&str]| with.iter().any(|start| name.starts_with(start));
        let is_arithmetic = starts(&["add", "sub", "mul", "div", "sqrt", "fm", "fnm"])
            && starts(&["fm", "fnm"]) | name.ends_with("sd") | name.ends_with("pd");
        let is_shuffle = starts(&["unpck", "shuf", "perm", "movddup", "movhl", "movlh", "insert"])
            || starts(&["extract", "blend", "movhp", "movlp", "palign", "pshuf", "broadcast"]);
        let is_constant = operands.contains("(%rip)") && name != "lea";
        Self {
            instructions: self.instructions + 1,
            arithmetic: self.arithmetic + usize::from(is_arithmetic),
            constants: self.constants + usize::from(is_constant),
            shuffles: self.shuffles + usize::from(is_shuffle),
        }
    }
}
