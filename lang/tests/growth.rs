//! Tests that the size of the typed program grows linearly with the length of generated models.
//! `cargo bench -p calyx` measures the time.

use crate::library::Library;
use calyx_lang::check_program;
use calyx_lang::ir::Program;

fn program(text: &str) -> Program {
    let checked = check_program("model.cx", text, &Library::read());
    let found: Vec<_> = checked.diagnostics.iter().map(|d| format!("{} {}", d.code, d.message)).collect();
    assert_eq!(found, Vec::<String>::new());
    checked.program.expect("a program")
}

/// Returns the numbers of functions, sites, blocks and statements.
fn sizes(program: &Program) -> [usize; 4] {
    let blocks = || program.functions.iter().flat_map(|function| &function.blocks);
    let statements = blocks().map(|block| block.statements.len()).sum();
    [program.functions.len(), program.sites.len(), blocks().count(), statements]
}

#[test]
fn a_longer_model_gives_a_program_in_proportion() {
    let [one, two, three] =
        [1, 2, 3].map(|sections| sizes(&program(&crate::generator::model(20 + 48 * sections))));
    for at in 0..one.len() {
        assert!(two[at] > one[at], "each section adds something");
        assert_eq!(three[at] - two[at], two[at] - one[at], "each section adds the same");
    }
    // Per section: five called functions; one of them is instantiated for numbers only, because
    // types share representations.
    assert_eq!(two[0] - one[0], 5);
}

#[test]
fn chains_are_in_proportion_to_their_factors() {
    let [one, two, three] = [10, 20, 30].map(|factors| {
        let program = program(&crate::generator::chain(factors));
        program.sites.iter().map(|site| site.shared.len()).sum::<usize>()
    });
    assert_eq!(three - two, two - one);
}
