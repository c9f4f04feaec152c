//! The `calyx` command, with one module per subcommand.

// The macros of the standard library panic if a pipe is closed; those of `rt::console` do not.
#![deny(clippy::print_stdout, clippy::print_stderr)]

mod allow;
mod build;
mod bundled;
mod check;
mod compile;
mod doc;
mod dry_run;
mod dump;
mod eval;
mod explain;
mod fmt;
mod lsp;
mod messages;
mod new;
mod optimize;
mod repl;
mod report;
mod run;
mod sensitivities;
mod solving;
mod sound;
mod studio;
mod sweep;
mod test;
mod tradeoff;
mod view;

use calyx::rt::former_options;
use clap::{CommandFactory, Parser, Subcommand};
use messages::MessageFormat;
use std::ffi::OsString;
use std::process::ExitCode;

/// Design gear systems: write a model as text, check it, run it.
///
/// A model is a text file with the extension .cx. `calyx check` reports its errors without solving
/// it; `calyx run` solves it and writes a directory of results.
#[derive(Parser)]
#[command(
    name = "calyx",
    version,
    after_help = "First steps:
  calyx new pair                   create a commented example model
  calyx run examples/spur_pair.cx"
)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Create a commented example model
    ///
    /// `calyx new pair.cx` creates that file, `calyx new pair` a directory with pair.cx in it.
    /// Existing files are never overwritten.
    #[command(after_help = new::EXAMPLES)]
    New(new::New),
    /// Check a model without solving it
    ///
    /// Reports errors of syntax, types, dimensions and units, and errors of the gear design
    /// (undercut, pointed teeth, contact ratio below 1, interference, a body without supports),
    /// with the default values of the params.
    #[command(after_help = check::EXAMPLES)]
    Check(check::Check),
    /// Run a model and write its results
    ///
    /// Prints a summary table and writes a directory with report.html (an illustrated report),
    /// run.json (inputs, outputs, solver residuals), steps.csv (one row per position) and
    /// timing.json.
    #[command(after_help = run::EXAMPLES)]
    Run(run::Run),
    /// Run a model at many values of its params
    ///
    /// Solves all combinations of the given values, several at a time, and writes a table with one
    /// row per case, sweep.csv, and a page with plots, sweep.html.
    #[command(after_help = sweep::EXAMPLES)]
    Sweep(Box<sweep::Sweep>),
    /// Find the values of params at which an output of a model is best
    ///
    /// Minimizes or maximizes a statistic of an output over several load cases, within bounds of
    /// other outputs, by local searches from several designs. Writes the best design as a params
    /// file, and a page with the searches, the active constraints and the influence of each
    /// variable.
    #[command(after_help = optimize::EXAMPLES)]
    Optimize(optimize::Optimize),
    /// Differentiate the outputs of a model with respect to its params
    ///
    /// Computes how outputs change by small changes of params, in the state of contact of the
    /// analysis, with estimated errors. Prints the params ranked by their effect, and writes tables
    /// and a page with plots.
    #[command(after_help = sensitivities::EXAMPLES)]
    Sensitivities(sensitivities::Sensitivities),
    /// Compute the sound of a vibrating surface from a universal file
    ///
    /// Reads a mesh and the motion of its nodes (UNV, datasets 2411, 2412, 55, 2414 and 58), which
    /// another structural solver, a measurement or `calyx run --unv` has written. Prints sound
    /// power, levels and radiation efficiency for each frequency or normal mode, and writes tables.
    #[command(after_help = sound::EXAMPLES)]
    Sound(Box<sound::Sound>),
    /// Set params, run a model and compare its results in the browser
    ///
    /// Starts a server on this computer, prints its address and opens it in the browser: a form of
    /// the model's params, its runs with their progress, and their results. The page follows
    /// changes of the model's file.
    #[command(after_help = studio::EXAMPLES)]
    Studio(studio::Studio),
    /// Regenerate the HTML report of a run
    ///
    /// Every run writes report.html. This command writes it again from the results: after an
    /// interrupted run, or to include the measurements of a later `calyx tradeoff`.
    #[command(after_help = report::EXAMPLES)]
    Report(report::Report),
    /// Write the three-dimensional view of a run as one HTML file
    ///
    /// The page shows the gears, shafts, bearings and housings of the run at all positions, with
    /// contact pressure, forces, and the deformed meshes of a run with --vtu. It needs neither a
    /// server nor a network, so it can be sent to others.
    #[command(after_help = view::EXAMPLES)]
    View(view::View),
    /// Compile a model to a standalone executable or a C library
    ///
    /// The executable needs no Calyx installation. It has its own `--help`, generated from the
    /// model's doc comments, params and outputs, and its results are identical to those of `calyx
    /// run`. The system's C compiler ($CC, else cc) links it with the library libcalyx_rt.a. Calyx
    /// searches this library in its own directory, in deps/ below it (where cargo writes it), in
    /// ../lib/calyx and in the user's data directory; CALYX_RT_LIBRARY names another path.
    #[command(after_help = build::EXAMPLES)]
    Build(build::Build),
    /// Format source files
    ///
    /// Changes only white space; comments are kept. A file with syntax errors is not changed.
    #[command(after_help = fmt::EXAMPLES)]
    Fmt(fmt::Fmt),
    /// Run the test functions in source files
    #[command(after_help = test::EXAMPLES)]
    Test(test::Test),
    /// Explain a diagnostic code, or the plan of a model's analysis
    ///
    /// Without an argument, lists all codes.
    #[command(after_help = explain::EXAMPLES)]
    Explain(explain::Explain),
    /// Measure accuracy against computing time for the fidelity levels and settings
    ///
    /// Runs the model once at each fidelity level (from two-dimensional models to the finest
    /// three-dimensional meshes) and for each setting (mesh, contact grid, positions), and compares
    /// the results with the finest affordable run. Prints a table that marks the efficient settings
    /// and recommends a setting for each tolerance. Writes the table as tradeoff.csv, tradeoff.json
    /// and a plot, tradeoff.svg.
    #[command(after_help = tradeoff::EXAMPLES)]
    Tradeoff(tradeoff::Tradeoff),
    /// Evaluate an expression or convert units: calyx eval "3 inch to mm"
    #[command(after_help = eval::EXAMPLES)]
    Eval(eval::Eval),
    /// Start an interactive session
    ///
    /// Evaluates statements and expressions one after another. Definitions and variables persist. A
    /// statement with an error has no effect. `analyze` is skipped: a session solves nothing.
    #[command(after_help = repl::EXAMPLES)]
    Repl(repl::Repl),
    /// Generate reference pages from doc comments
    #[command(after_help = doc::EXAMPLES)]
    Doc(doc::Doc),
    /// Start the language server for editors
    ///
    /// Implements the Language Server Protocol on standard input and output: diagnostics,
    /// completion, hover, and more. Editors start it automatically.
    #[command(after_help = lsp::EXAMPLES)]
    Lsp(lsp::Lsp),
    /// Print an intermediate representation of a model: tokens, tree, types, ir, graph, clif or asm
    #[command(after_help = dump::EXAMPLES)]
    Dump(dump::Dump),
}

impl Command {
    /// Returns the format of warnings of the command; `None` if it prints only errors.
    fn warnings(&self) -> Option<MessageFormat> {
        match self {
            Command::Run(command) => command.warnings(),
            Command::Tradeoff(command) => command.warnings(),
            Command::Sweep(command) => command.warnings(),
            Command::Optimize(command) => command.warnings(),
            Command::Sensitivities(command) => command.warnings(),
            Command::Sound(command) => command.warnings(),
            _ => Some(MessageFormat::Human),
        }
    }
}

/// Returns warnings about options that were called by their former names.
fn former_names() -> Vec<String> {
    let arguments: Vec<OsString> = std::env::args_os().collect();
    let mut command = Arguments::command();
    command.build();
    let named = arguments.get(1).and_then(|name| command.find_subcommand(name));
    named.map_or_else(Vec::new, |command| former_options::warnings(command, &arguments[2..]))
}

fn main() -> ExitCode {
    if let Some(status) = bundled::run() {
        return status;
    }
    let command = Arguments::parse().command;
    if let Some(format) = command.warnings() {
        former_names().iter().for_each(|warning| format.warning(warning));
    }
    match command {
        Command::New(command) => command.run(),
        Command::Check(command) => command.run(),
        Command::Run(command) => command.run(),
        Command::Sweep(command) => command.run(),
        Command::Optimize(command) => command.run(),
        Command::Sensitivities(command) => command.run(),
        Command::Sound(command) => command.run(),
        Command::Studio(command) => command.run(),
        Command::Report(command) => command.run(),
        Command::View(command) => command.run(),
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
