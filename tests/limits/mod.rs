//! At the limits of assembly and of the numbers, and near them: as right as the data allow, and
//! beyond them the refusal that is right.

mod at_the_limit;
mod compensated;
mod constant_lengths;
mod double_words;
mod exact_inputs;
mod hard_cases;
mod margins;
mod margins_beyond;
mod near_limits;
mod overflow;
mod refusals;
mod resolvers;
mod right_or_refused;
mod slides;
mod statuses;
