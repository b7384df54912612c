//! Blocks beside the functions of printed C: what a block answers, the fast path of C answers, with the same bits; what it
//! refuses, that refuses, but for numbers that no machine has.

use std::env;
use std::fs;

use linkage_compiler::c;
use proc_macro2::TokenStream;

use super::evaluator::Machine;
use super::poses::{Random, Told, at_a_limit, at_random, strange, told};
use super::reader::{Project, Unit};
use super::skipped::skipped;
use super::{all, folder, in_c, texts};

#[test]
fn some_blocks_answer_as_c_does_to_the_last_bit() {
    let whole = env::var_os("LINKAGE_WHOLE").is_some();
    compare(if whole { 1 } else { 41 }, 12);
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn every_block_answers_as_c_does_to_the_last_bit() {
    let Some(Counts { poses, answered, refused, .. }) = compare(1, 24) else { return };
    assert!(
        poses > 100_000 && answered > 30_000 && refused > 10_000,
        "{poses} {answered} {refused}"
    );
}

#[derive(Debug, Default)]
pub(super) struct Counts {
    pub poses: usize,
    pub answered: usize,
    pub refused: usize,
    /// Poses of a machine of about a metre that only the block refuses, as too large.
    lost: usize,
}

/// The parts that are compared beside one another: half of the time a compiler is waited for.
const PARTS: usize = 4;

/// Compares every so many declarations; none without a compiler.
fn compare(every: usize, each: usize) -> Option<Counts> {
    let parts = std::thread::scope(|scope| {
        // Tokens stay with the thread that reads them.
        let part = |part| scope.spawn(move || compare_part(every, each, part));
        let parts: Vec<_> = (0..PARTS).map(part).collect();
        parts.into_iter().map(|part| part.join().expect("all are equal")).collect::<Vec<_>>()
    });
    let (mut counts, mut looked, mut printed) = (Counts::default(), 0, 0);
    for part in parts {
        let (of_part, of_all) = part?;
        counts.poses += of_part.poses;
        counts.answered += of_part.answered;
        counts.refused += of_part.refused;
        counts.lost += of_part.lost;
        printed += of_all[0];
        looked += of_all[1];
    }
    assert!(printed > looked / 2, "{printed} of {looked}");
    // A hundredth of them has a dimension that is drawn next to nothing.
    assert!(counts.lost * 100 <= counts.poses, "{counts:?}");
    println!("{printed} declarations, {counts:?}");
    Some(counts)
}

/// The counts of a part, and how many of its declarations are printed.
fn compare_part(every: usize, each: usize, part: usize) -> Option<(Counts, [usize; 2])> {
    let mut counts = Counts::default();
    let chosen = all().into_iter().step_by(every).enumerate();
    let chosen: Vec<(usize, (String, TokenStream))> =
        chosen.filter(|(nth, _)| nth % PARTS == part).collect();
    let mut printed = 0;
    for (nth, of) in &chosen {
        printed += usize::from(counts.compare_one(of, each, &format!("{every}_{nth}"), *nth)?);
    }
    Some((counts, [printed, chosen.len()]))
}

impl Counts {
    /// True for a declaration that is printed; none without a compiler. The folder is its own.
    pub(super) fn compare_one(
        &mut self,
        (path, tokens): &(String, TokenStream),
        each: usize,
        own: &str,
        seed: usize,
    ) -> Option<bool> {
        let Some((texts, only)) = texts(tokens) else { return Some(false) };
        let mut project = Project::default();
        texts.iter().rev().for_each(|file| project.read(&file.text));
        let blocks: Vec<&Unit> = project
            .order
            .iter()
            .map(|name| &project.units[name])
            .filter(|unit| unit.is_block)
            .collect();
        let machine = Machine { project: &project };
        let calls = calls(&machine, &blocks, each, seed as u64);
        let calls = calls.unwrap_or_else(|why| panic!("{path}, {}: {why}", texts[0].name));
        let files = c(tokens.clone(), only, None).expect("C is printed");
        let place = folder(own);
        let given: Vec<_> = calls.iter().map(|call| (call.function, call.given.clone())).collect();
        let Some(answers) = in_c::answers(&place, &files, &blocks, &given) else {
            skipped("structured text beside C: no cc");
            return None;
        };
        fs::remove_dir_all(&place).expect("it was made here");
        for (call, answer) in calls.iter().zip(&answers) {
            let name = &blocks[call.function].name;
            self.add(call, answer, &format!("{path}: {name} of {:?}", call.given));
        }
        Some(true)
    }

    fn add(&mut self, call: &Call, answer: &in_c::Answer, of: &str) {
        let Told { status, refused, numbers } = &call.told;
        self.poses += 1;
        if *status == 0 {
            self.answered += 1;
            assert!(answer.is_fast, "{of}: C refuses, and the block tells {numbers:?}");
            let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            assert_eq!(
                bits(numbers),
                bits(&answer.numbers),
                "{of}: {numbers:?}, C {:?}",
                answer.numbers
            );
            assert_eq!(refused, "", "{of}");
            return;
        }
        self.refused += 1;
        assert!(numbers.iter().all(|x| x.to_bits() == 0), "{of}: {numbers:?}");
        assert!(!refused.is_empty() && refused != "before", "{of}");
        let is_of_size = [-1, -3].contains(status);
        assert!(is_of_size || !answer.is_fast, "{of}: C answers, and the block refuses {refused}");
        self.lost += usize::from(answer.is_fast && !call.is_strange);
    }
}

struct Call {
    function: usize,
    given: Vec<f64>,
    told: Told,
    is_strange: bool,
}

/// Calls of all blocks, so many at random of each, a third as many of strange numbers, and those next to limits.
fn calls(
    machine: &Machine<'_>,
    blocks: &[&Unit],
    each: usize,
    seed: u64,
) -> Result<Vec<Call>, String> {
    let mut calls = Vec::new();
    for (function, block) in blocks.iter().enumerate() {
        let mut random = Random::new(1000 * seed + function as u64);
        let mut own: Vec<Call> = Vec::new();
        let call = |given: Vec<f64>, is_strange| -> Result<Call, String> {
            let told =
                told(machine, block, &given).map_err(|why| format!("{why}, of {given:?}"))?;
            Ok(Call { function, given, told, is_strange })
        };
        for _ in 0..each {
            own.push(call(at_random(block, &mut random), false)?);
        }
        let inside = own.iter().find(|call| call.told.status == 0).map(|call| call.given.clone());
        let outside = own.iter().find(|call| call.told.status > 0).map(|call| call.given.clone());
        if let (Some(inside), Some(outside)) = (inside, outside) {
            for given in at_a_limit(machine, block, [&inside, &outside], &mut random)? {
                own.push(call(given, false)?);
            }
        }
        for _ in 0..each / 3 {
            let given = at_random(block, &mut random);
            own.push(call(strange(block, given, &mut random), true)?);
        }
        calls.extend(own);
    }
    Ok(calls)
}
