//! Forces of whole mechanisms: published course works, balances, loads, bad input, derivatives.

mod balance;
mod dynamics;
mod inside;
mod interface;
mod outputs;
mod published;
mod pulled;
mod searched;
mod springs;
mod stops;
mod together;
