//! The Calyx language front end: from text to a checked, typed program.
//!
//! The crate does not depend on code generation or physics. Its stages are `text -> tokens ->
//! syntax tree -> names, types, dimensions -> typed program`. Every stage returns a value and
//! diagnostics; none fails. [`check_program`] runs all of them. The database ([`db`]) depends on
//! the parser and the checker, and neither depends on the database.

pub mod analysis;
pub mod ast;
pub mod check;
pub mod codes;
pub mod common_units;
mod components;
pub mod db;
pub mod declared;
pub mod deep_recursion;
pub mod description;
pub mod diagnostic;
pub mod dimension;
pub mod format;
mod hashed;
pub mod help;
pub mod ir;
pub mod lexer;
pub mod parser;
mod relocate;
pub mod render;
pub mod scope;
pub mod span;
mod threads;
pub mod tree_text;
pub mod units;
pub mod vocabulary;
pub mod walk;

pub use db::check_program;
