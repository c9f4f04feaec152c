//! The `calyx` command: one file a subcommand.

mod build;
mod bundled;
mod check;
mod compile;
mod doc;
mod dump;
mod eval;
mod explain;
mod fmt;
mod lsp;
mod messages;
mod new;
mod repl;
mod report;
mod run;
mod test;
mod tradeoff;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Design gear systems: write a model as text, check it, run it.
///
/// A model is a text file ending in .cx. `calyx check` says what is wrong with it without running it; `calyx run` solves
/// it and writes a directory of results.
#[derive(Parser)]
#[command(
    name = "calyx",
    version,
    after_help = "Start with:
  calyx new pair                   a commented model that runs
  calyx run examples/spur_pair.cx"
)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Write a commented model that runs, to start from
    ///
    /// `calyx new pair.cx` writes that file, `calyx new pair` a directory with pair.cx in it. Nothing is overwritten.
    #[command(after_help = new::EXAMPLES)]
    New(new::New),
    /// Say everything that is wrong with a model, without solving anything
    ///
    /// Finds errors of the language, of dimensions and units, and of the gears themselves (undercut, pointed teeth,
    /// contact ratio below 1, interference, a body that nothing holds) at the params' defaults.
    #[command(after_help = check::EXAMPLES)]
    Check(check::Check),
    /// Run a model and write its results
    ///
    /// Prints a summary table and writes a directory with report.html (all of it, to be looked at), run.json (inputs, outputs,
    /// certificate), steps.csv (one row a position) and timing.json.
    #[command(after_help = run::EXAMPLES)]
    Run(run::Run),
    /// Make the report of a run again from its directory, as one page of HTML
    ///
    /// A run writes report.html by itself. This makes it anew: of a run of an earlier day, of one that was killed, or with what
    /// `calyx tradeoff` has measured since.
    #[command(after_help = report::EXAMPLES)]
    Report(report::Report),
    /// Make a model an executable that runs where there is no Calyx, or a library for programs in C
    ///
    /// The executable has its own `--help`, made from the model's doc comments, params and outputs, and writes the same bits
    /// as `calyx run`. It is linked by the system's C compiler ($CC, else cc) with the library libcalyx_rt.a, which is found
    /// beside `calyx`, in deps/ beside it (cargo puts it there), in ../lib/calyx, or in the user's data directory;
    /// CALYX_RT_LIBRARY names another.
    #[command(after_help = build::EXAMPLES)]
    Build(build::Build),
    /// Lay out models as all of them are laid out
    ///
    /// Changes blanks and line ends only; comments stay. A file with errors of syntax is left as it is.
    #[command(after_help = fmt::EXAMPLES)]
    Fmt(fmt::Fmt),
    /// Run the tests in files: functions marked with `test`
    #[command(after_help = test::EXAMPLES)]
    Test(test::Test),
    /// Say what a diagnostic means and how to mend it
    ///
    /// Without a code, lists all codes.
    #[command(after_help = explain::EXAMPLES)]
    Explain(explain::Explain),
    /// Measure speed against accuracy: a model at every level and knob, error against time for each output
    ///
    /// Runs the ladder of levels (plane sections to the finest meshes in three dimensions) and the knobs below them (mesh, contact grid,
    /// positions), each once, and compares all with the finest that is affordable. Prints a table with what is worth its time marked, and
    /// what to choose for which tolerance; writes it as tradeoff.csv, tradeoff.json and a picture, tradeoff.svg.
    #[command(after_help = tradeoff::EXAMPLES)]
    Tradeoff(tradeoff::Tradeoff),
    /// Compute an expression, or convert a quantity: calyx eval "3 inch to mm"
    #[command(after_help = eval::EXAMPLES)]
    Eval(eval::Eval),
    /// Enter statements and expressions one after another and see what they give
    ///
    /// Definitions and variables stay. An error is shown and leaves everything as it was. Nothing is solved: `analyze` is
    /// passed over.
    #[command(after_help = repl::EXAMPLES)]
    Repl(repl::Repl),
    /// Write reference pages from doc comments: of the library, of your modules, of a model's params and outputs
    #[command(after_help = doc::EXAMPLES)]
    Doc(doc::Doc),
    /// Serve an editor: diagnostics as you type, completion, hover and the rest
    ///
    /// Speaks the Language Server Protocol on standard input and output; editors start it by themselves.
    #[command(after_help = lsp::EXAMPLES)]
    Lsp(lsp::Lsp),
    /// Show a model at a stage of compilation: tokens, tree, types, ir, graph, clif or asm
    #[command(after_help = dump::EXAMPLES)]
    Dump(dump::Dump),
}

fn main() -> ExitCode {
    if let Some(status) = bundled::run() {
        return status;
    }
    match Arguments::parse().command {
        Command::New(command) => command.run(),
        Command::Check(command) => command.run(),
        Command::Run(command) => command.run(),
        Command::Report(command) => command.run(),
        Command::Build(command) => command.run(),
        Command::Fmt(command) => command.run(),
        Command::Test(command) => command.run(),
        Command::Explain(command) => command.run(),
        Command::Tradeoff(command) => command.run(),
        Command::Eval(command) => command.run(),
        Command::Repl(command) => command.run(),
        Command::Doc(command) => command.run(),
        Command::Lsp(command) => command.run(),
        Command::Dump(command) => command.run(),
    }
}
