//! Times of checking and compiling for four sizes of generated models: `cargo bench -p calyx`.

#[path = "../../lang/tests/support/generator.rs"]
mod generator;

use calyx::{Checked, Engine, ModelLoader, Module, check_text};
use calyx_lang::db::Database;
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

fn without_errors(checked: Checked) -> Checked {
    assert!(!checked.has_errors(), "{}", checked.render());
    checked
}

/// Language front end only: from text to typed program, without cached results.
#[divan::bench(args = [1_250, 2_500, 5_000, 10_000])]
fn check_cold(bencher: Bencher, lines: usize) {
    let (text, loader) = (generator::model(lines), ModelLoader::default());
    bencher.bench(|| calyx_lang::check_program("model.cx", black_box(&text), &loader));
}

/// Language front end only, for 20 and 40 components of a hundred lines, each with one instance.
#[divan::bench(args = [20, 40])]
fn check_components(bencher: Bencher, count: usize) {
    let (text, loader) = (generator::components(count), ModelLoader::default());
    without_errors(check_text("model.cx", &text));
    bencher.bench(|| calyx_lang::check_program("model.cx", black_box(&text), &loader));
}

/// Complete `calyx check`: also runs the model at its defaults, up to the first analysis.
#[divan::bench(args = [1_250, 2_500, 5_000, 10_000])]
fn check_and_elaborate(bencher: Bencher, lines: usize) {
    let text = generator::model(lines);
    bencher.bench(|| without_errors(check_text("model.cx", black_box(&text))));
}

/// Incremental check after a change of one function body.
#[divan::bench(args = [1_250, 2_500, 5_000, 10_000])]
fn check_after_an_edit(bencher: Bencher, lines: usize) {
    let text = generator::model(lines);
    let texts = [generator::with_edited_body(&text), text];
    let loader = ModelLoader::default();
    let mut database = Database::new(&loader);
    let mut turn = 0;
    let mut check = || {
        database.set_model("model.cx", &texts[turn % 2]);
        database.load_imports("model.cx", &loader);
        turn += 1;
        database.check("model.cx")
    };
    check();
    bencher.bench_local(check);
}

/// From text to machine code.
#[divan::bench(args = [250, 500, 1_000, 2_000])]
fn compile(bencher: Bencher, lines: usize) {
    let (engine, text) = (Engine::default(), generator::model(lines));
    bencher.bench(|| {
        Module::from_checked(&engine, without_errors(check_text("model.cx", black_box(&text)))).map(|_| ())
    });
}

/// From checked model to machine code.
#[divan::bench(args = [250, 500, 1_000, 2_000])]
fn machine_code(bencher: Bencher, lines: usize) {
    let (engine, text) = (Engine::default(), generator::model(lines));
    bencher
        .with_inputs(|| without_errors(check_text("model.cx", &text)))
        .bench_values(|checked| Module::from_checked(&engine, checked).map(|_| ()));
}

/// From text to machine code, for a product of frames with its first and second time derivatives.
#[divan::bench(args = [25, 50, 100])]
fn chain(bencher: Bencher, factors: usize) {
    let (engine, text) = (Engine::default(), generator::chain(factors));
    bencher.bench(|| {
        Module::from_checked(&engine, without_errors(check_text("model.cx", black_box(&text)))).map(|_| ())
    });
}
