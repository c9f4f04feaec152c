//! Typed program of a compiled module, with the diagnostics of its check.
//!
//! A module compiled in this process has a typed program. A loaded module contains its sources
//! only; the first request that needs the typed program (kernels of symbolic functions, the source
//! of a NaN, the argument that an error concerns) checks them again.

use calyx_elaborate::{Checked, check_sources};
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::ir::{Program, SourceFile};
use calyx_lower::interpret::CallSites;
use std::sync::OnceLock;

/// Typed program and its derived data.
pub struct Typed {
    pub program: Program,
    pub call_sites: CallSites,
    /// Diagnostics of the check, at the default params.
    pub known: Vec<Diagnostic>,
}

impl Typed {
    pub fn new(program: Program, known: Vec<Diagnostic>) -> Typed {
        Typed { call_sites: CallSites::new(&program), program, known }
    }
}

/// Typed program, created at the first request if it is missing.
pub struct LazyTyped(OnceLock<Option<Box<Typed>>>);

impl LazyTyped {
    /// Wraps a program that was just checked.
    pub fn checked(typed: Typed) -> LazyTyped {
        LazyTyped(OnceLock::from(Some(Box::new(typed))))
    }

    /// Creates a typed program to be derived from sources, which were checked when they were
    /// compiled.
    pub fn of_sources() -> LazyTyped {
        LazyTyped(OnceLock::new())
    }

    /// Returns the typed program; `None` if the sources cannot be checked, although they were valid
    /// when they were compiled.
    pub fn get(&self, sources: &[SourceFile]) -> Option<&Typed> {
        let check = || {
            let Checked { program, diagnostics, .. } = check_sources(sources);
            Some(Box::new(Typed::new(program?, diagnostics)))
        };
        self.0.get_or_init(check).as_deref()
    }
}
