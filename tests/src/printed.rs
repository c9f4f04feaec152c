//! Output of a model that only prints.

use calyx::{Engine, Module};
use std::sync::{Arc, Mutex};

/// Compiles and runs the text of a model, and returns the lines that it prints. `name` is the name
/// of its file in messages.
///
/// # Panics
/// If the model has errors.
pub fn printed_lines(name: &str, text: &str) -> Vec<String> {
    let module = Module::from_text(&Engine::default(), name, text).unwrap_or_else(|error| panic!("{error}"));
    let mut instance = module.instantiate();
    let lines = Arc::new(Mutex::new(Vec::new()));
    let sink = lines.clone();
    instance.on_print(move |line| sink.lock().expect("one thread").push(line.to_owned()));
    instance.solve().unwrap_or_else(|error| panic!("{name}: {error}"));
    let lines = lines.lock().expect("one thread");
    lines.clone()
}

/// Returns the numbers that a model prints, one per line; see [`printed_lines`].
///
/// # Panics
/// If the model has errors, or a line is not a number.
pub fn printed_numbers(name: &str, text: &str) -> Vec<f64> {
    let number = |line: &String| line.parse().unwrap_or_else(|_| panic!("{name}: {line} is not a number"));
    printed_lines(name, text).iter().map(number).collect()
}
