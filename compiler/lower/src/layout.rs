//! The slot layout of the typed program, shared by the interpreter and the code generator.

use calyx_abi::Repr;
use calyx_abi::blame;
use calyx_lang::ir::{Expr, ExternDecl, Function, Mode};
use calyx_lang::span::Span;

/// Returns for each size the sum of the sizes before it, and the total.
pub fn running_sums(sizes: impl Iterator<Item = usize>) -> (Vec<usize>, usize) {
    let mut sum = 0;
    let mut before = Vec::new();
    for size in sizes {
        before.push(sum);
        sum += size;
    }
    (before, sum)
}

/// Returns the arguments that are passed: those of `in` and `inout` parameters. The argument of an
/// `out` parameter is not evaluated.
pub fn passed<'e>(function: &Function, arguments: &'e [Expr]) -> Vec<&'e Expr> {
    if arguments.len() != function.parameters.len() {
        return arguments.iter().collect();
    }
    let pairs = function.parameters.iter().zip(arguments);
    pairs.filter(|((_, mode), _)| *mode != Mode::Out).map(|(_, argument)| argument).collect()
}

/// Returns the number of slots per array element.
pub fn stride(array: &Repr) -> usize {
    match array {
        Repr::Array(element) => element.slots(),
        _ => 0,
    }
}

/// Returns the first slot of a tuple element; `None` if the representation is not a tuple.
pub fn tuple_offset(tuple: &Repr, index: usize) -> Option<usize> {
    tuple_part(tuple, index).map(|(before, _)| before)
}

/// Returns the first slot and the representation of a tuple element; `None` if the representation
/// is not a tuple.
pub fn tuple_part(tuple: &Repr, index: usize) -> Option<(usize, &Repr)> {
    match tuple {
        Repr::Tuple(parts) => Some((parts.get(..index)?.iter().map(Repr::slots).sum(), parts.get(index)?)),
        _ => None,
    }
}

/// Returns the source locations of the arguments of an engine call, encoded for [`blame::blame`].
pub fn blame_table(function: &ExternDecl, arguments: &[Expr], call: Span) -> Vec<u8> {
    let pairs = function.parameters.iter().zip(arguments);
    // The text of a default is in the declaration, outside the call, so that argument has no
    // location.
    let written = pairs.filter(|(_, argument)| {
        let at = argument.span;
        at.file == call.file && at.start >= call.start && at.end <= call.end
    });
    blame::encode(written.map(|((name, _), argument)| {
        (name.as_str(), (argument.span.file.0, argument.span.start, argument.span.end))
    }))
}
