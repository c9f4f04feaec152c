//! Checks that the example runs, and that its result is not worse than its start.

use std::process::Command;

#[test]
fn a_small_budget_does_no_harm() {
    let output = Command::new(env!("CARGO_BIN_EXE_embed-rust")).args(["3", "4"]).output().expect("it runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let said = String::from_utf8_lossy(&output.stdout);
    let errors: Vec<[f64; 2]> = said
        .lines()
        .filter(|line| line.contains("lbf*inch"))
        .map(|line| {
            let mut numbers = line.split_whitespace().rev().map(|word| word.parse().expect("a number"));
            [(); 2].map(|()| numbers.next().expect("two numbers"))
        })
        .collect();
    assert_eq!(errors.len(), 5, "{said}");
    let sum = |at: usize| errors.iter().map(|pair| pair[at]).sum::<f64>();
    assert!(sum(0) > 0.0 && sum(0) <= sum(1), "{said}");
}
