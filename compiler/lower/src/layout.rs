//! What the interpreter and the code generator must see alike in the typed program: which slots go where.

use calyx_abi::Repr;
use calyx_abi::blame;
use calyx_lang::ir::{Expr, ExternDecl, Function, Mode};
use calyx_lang::span::Span;

/// For each size the sum of those before it, and the sum of all.
pub fn running_sums(sizes: impl Iterator<Item = usize>) -> (Vec<usize>, usize) {
    let mut sum = 0;
    let mut before = Vec::new();
    for size in sizes {
        before.push(sum);
        sum += size;
    }
    (before, sum)
}

/// The arguments that are passed: those of `in` and `inout` parameters. An `out` parameter's argument, where the
/// call holds one, is not evaluated.
pub fn passed<'e>(function: &Function, arguments: &'e [Expr]) -> Vec<&'e Expr> {
    if arguments.len() != function.parameters.len() {
        return arguments.iter().collect();
    }
    let pairs = function.parameters.iter().zip(arguments);
    pairs.filter(|((_, mode), _)| *mode != Mode::Out).map(|(_, argument)| argument).collect()
}

/// Slots of an element of an array.
pub fn stride(array: &Repr) -> usize {
    match array {
        Repr::Array(element) => element.slots(),
        _ => 0,
    }
}

/// First slot of an element of a tuple; `None` if it is no tuple.
pub fn tuple_offset(tuple: &Repr, index: usize) -> Option<usize> {
    tuple_part(tuple, index).map(|(before, _)| before)
}

/// First slot and representation of an element of a tuple; `None` if it is no tuple.
pub fn tuple_part(tuple: &Repr, index: usize) -> Option<(usize, &Repr)> {
    match tuple {
        Repr::Tuple(parts) => Some((parts.get(..index)?.iter().map(Repr::slots).sum(), parts.get(index)?)),
        _ => None,
    }
}

/// Where the arguments of a call of a provided function are written, as [`blame::blame`] reads it.
pub fn blame_table(function: &ExternDecl, arguments: &[Expr], call: Span) -> Vec<u8> {
    let pairs = function.parameters.iter().zip(arguments);
    // A default's text stands in the declaration, outside of the call: such an argument has no place.
    let written = pairs.filter(|(_, argument)| {
        let at = argument.span;
        at.file == call.file && at.start >= call.start && at.end <= call.end
    });
    blame::encode(written.map(|((name, _), argument)| {
        (name.as_str(), (argument.span.file.0, argument.span.start, argument.span.end))
    }))
}
