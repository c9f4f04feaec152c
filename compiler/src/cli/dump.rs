//! `calyx dump`: prints a model at a stage of compilation.

use crate::allow::AllowPath;
use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::check_file_allowing;
use calyx::dump::{Format, ProgramStage, TextStage, names, of_program, of_text, types};
use calyx::rt::console::print;
use calyx_abi::visible::visible;
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use std::process::ExitCode;

pub const EXAMPLES: &str = "Examples:
  calyx dump --stage types pair.cx
  calyx dump --stage ir --function area pair.cx
  calyx dump --stage graph --format dot pair.cx | dot -Tsvg > graph.svg

The format is for reading and can change in any version.";

/// A stage of compilation, in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Stage {
    /// Tokens with their positions
    Tokens,
    /// The syntax tree before name resolution
    Tree,
    /// Types and dimensions of the model's variables, params and outputs
    Types,
    /// The typed intermediate representation: functions as control-flow graphs, numbers in SI units
    Ir,
    /// The operations of every `:=` expression, after common subexpression elimination
    Graph,
    /// Cranelift intermediate representation
    Clif,
    /// Machine code for this machine
    Asm,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum GraphFormat {
    /// One operation per line
    #[default]
    Text,
    /// Graphviz format
    Dot,
}

#[derive(Args)]
pub struct Dump {
    /// The model (.cx file)
    file: PathBuf,
    /// Stage of compilation
    #[arg(long, value_enum)]
    stage: Stage,
    /// Only functions or `:=` expressions with this name (from `ir` on)
    #[arg(long, value_name = "NAME")]
    function: Option<String>,
    #[command(flatten)]
    allow: AllowPath,
    /// Format of graphs
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    format: GraphFormat,
}

impl Dump {
    pub fn run(self) -> ExitCode {
        let format = MessageFormat::Human;
        let stage = match self.stage {
            Stage::Tokens => return self.text(TextStage::Tokens),
            Stage::Tree => return self.text(TextStage::Tree),
            Stage::Types => None,
            Stage::Ir => Some(ProgramStage::Ir),
            Stage::Graph if self.format == GraphFormat::Dot => Some(ProgramStage::Graph(Format::Dot)),
            Stage::Graph => Some(ProgramStage::Graph(Format::Text)),
            Stage::Clif => Some(ProgramStage::Clif),
            Stage::Asm => Some(ProgramStage::Asm),
        };
        let checked = match check_file_allowing(&self.file, &self.allow.paths()) {
            Ok(checked) => checked,
            Err(error) => return format.unreadable(&self.file, &error),
        };
        format.diagnostics(&checked.diagnostics, &checked.files);
        let Some(stage) = stage else {
            // Types are known for valid declarations, even if others have errors.
            print!("{}", visible(&types(&checked.types)));
            return if checked.has_errors() { ExitCode::from(MODEL_ERROR) } else { ExitCode::SUCCESS };
        };
        let Some(program) = &checked.program else { return ExitCode::from(MODEL_ERROR) };
        if let Some(name) = &self.function {
            let known = names(program);
            if !known.contains(name) {
                format.failure(
                    &format!("the program has no function or `:=` expression `{name}`"),
                    &format!("it has {}", known.join(", ")),
                );
                return ExitCode::from(USAGE);
            }
        }
        match of_program(stage, program, &checked.files, self.function.as_deref()) {
            Ok(text) => {
                print!("{}", visible(&text));
                ExitCode::SUCCESS
            }
            Err(error) => {
                format.failure(&error.to_string(), "");
                ExitCode::from(MODEL_ERROR)
            }
        }
    }

    /// Prints a stage that every text has, with or without errors.
    fn text(&self, stage: TextStage) -> ExitCode {
        match std::fs::read_to_string(&self.file) {
            Ok(text) => {
                print!("{}", visible(&of_text(stage, &text)));
                ExitCode::SUCCESS
            }
            Err(error) => MessageFormat::Human.unreadable(&self.file, &error),
        }
    }
}
