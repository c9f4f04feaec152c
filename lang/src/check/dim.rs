//! Dimensions during inference: a known dimension times powers of dimension variables.
//!
//! Dimensions form a vector space over the rationals, so unification solves one linear equation:
//! any variable in it can be expressed by the others. Angle is soft and never causes a mismatch,
//! but is stored for display.

use crate::dimension::{Dimension, Rational};
use smallvec::{SmallVec, smallvec};

/// A dimension variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct DimVar(pub u32);

/// The product `fixed * v1^e1 * v2^e2 ...`; no exponent is zero.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Dim {
    pub fixed: Dimension,
    /// The variables and their exponents, in order of the variables. Few dimensions have several.
    pub unknowns: SmallVec<[(DimVar, Rational); 1]>,
}

impl Dim {
    pub fn none() -> Dim {
        Dim::known(Dimension::NONE)
    }

    pub fn known(fixed: Dimension) -> Dim {
        Dim { fixed, unknowns: SmallVec::new() }
    }

    pub fn unknown(variable: DimVar) -> Dim {
        Dim { fixed: Dimension::NONE, unknowns: smallvec![(variable, Rational::ONE)] }
    }

    pub fn times(&self, other: &Dim) -> Dim {
        self.combine(other, 1)
    }

    pub fn over(&self, other: &Dim) -> Dim {
        self.combine(other, -1)
    }

    /// Returns the product for the sign 1, the quotient for -1.
    fn combine(&self, other: &Dim, sign: i64) -> Dim {
        let fixed = if sign < 0 { self.fixed.over(other.fixed) } else { self.fixed.times(other.fixed) };
        let mut unknowns = self.unknowns.clone();
        for &(variable, exponent) in &other.unknowns {
            let found = unknowns.binary_search_by_key(&variable, |(own, _)| *own);
            let before = found.map_or(Rational::ZERO, |at| unknowns[at].1);
            // Exponents beyond 32 bits are meaningless; keeping the old value avoids a failure.
            let sum = before.sum(exponent, sign).unwrap_or(before);
            match found {
                Ok(at) if sum.is_zero() => {
                    unknowns.remove(at);
                }
                Ok(at) => unknowns[at].1 = sum,
                Err(_) if sum.is_zero() => {}
                Err(at) => unknowns.insert(at, (variable, sum)),
            }
        }
        Dim { fixed, unknowns }
    }

    /// Returns a power; `None` if an exponent is out of range (see [`Dimension::power`]).
    pub fn power(&self, exponent: Rational) -> Option<Dim> {
        if exponent.is_zero() {
            return Some(Dim::none());
        }
        let powers = self.unknowns.iter().map(|&(variable, e)| Some((variable, multiply(e, exponent)?)));
        Some(Dim { fixed: self.fixed.power(exponent)?, unknowns: powers.collect::<Option<_>>()? })
    }

    /// Removes a variable.
    pub fn remove(&mut self, variable: DimVar) {
        self.unknowns.retain(|(own, _)| *own != variable);
    }

    /// Returns the variables in order.
    pub fn variables(&self) -> impl Iterator<Item = DimVar> {
        self.unknowns.iter().map(|(variable, _)| *variable)
    }

    /// Returns the dimension if it has no variables.
    pub fn as_known(&self) -> Option<Dimension> {
        self.unknowns.is_empty().then_some(self.fixed)
    }
}

fn multiply(a: Rational, b: Rational) -> Option<Rational> {
    a.product(b).filter(|e| e.numerator().abs() <= 1000 && e.denominator() <= 1000)
}

/// Solves `dim = 1` for a variable, given its exponent in `dim`.
pub fn solve(dim: &Dim, variable: DimVar, exponent: Rational) -> Option<Dim> {
    let mut rest = dim.clone();
    rest.remove(variable);
    rest.power(Rational::new(-i64::from(exponent.denominator()), i64::from(exponent.numerator()))?)
}
