//! Tests of the checker and its tools, one module per subject. They are one program: it is linked
//! once, and its tests run in parallel.

mod analysis;
mod check;
mod fixes;
mod format;
#[path = "support/formatting.rs"]
mod formatting;
mod fuzz;
#[path = "support/grammar.rs"]
mod grammar;
#[path = "support/library.rs"]
mod library;
mod offers;
mod robust;
mod sizes;
mod syntax;
