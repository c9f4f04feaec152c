//! The typed program of a compiled module, and what checking it found.
//!
//! A module that was compiled here has them. One that was loaded does without: it brings its sources along, and whoever asks
//! what only the typed program knows (kernels of symbolic functions, where NaN arose, whom an error blames) has them checked
//! again, once.

use calyx_elaborate::{Checked, check_sources};
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::ir::{Program, SourceFile};
use calyx_lower::interpret::CallSites;
use std::sync::OnceLock;

/// A typed program and what follows from it.
pub struct Typed {
    pub program: Program,
    pub call_sites: CallSites,
    /// What checking found, at the params' defaults.
    pub known: Vec<Diagnostic>,
}

impl Typed {
    pub fn new(program: Program, known: Vec<Diagnostic>) -> Typed {
        Typed { call_sites: CallSites::new(&program), program, known }
    }
}

/// A typed program that is there, or made when it is first asked for.
pub struct LazyTyped(OnceLock<Option<Box<Typed>>>);

impl LazyTyped {
    /// Of a program that was just checked.
    pub fn checked(typed: Typed) -> LazyTyped {
        LazyTyped(OnceLock::from(Some(Box::new(typed))))
    }

    /// Of sources that were checked when they were compiled.
    pub fn of_sources() -> LazyTyped {
        LazyTyped(OnceLock::new())
    }

    /// The typed program; `None` if these sources cannot be checked, which they could when they were compiled.
    pub fn get(&self, sources: &[SourceFile]) -> Option<&Typed> {
        let check = || {
            let Checked { program, diagnostics, .. } = check_sources(sources);
            Some(Box::new(Typed::new(program?, diagnostics)))
        };
        self.0.get_or_init(check).as_deref()
    }
}
