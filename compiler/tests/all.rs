//! All tests of the command and of the embedding API, except those that measure the memory of their
//! process, as one program: it is linked once, and slow tests of different files run in parallel.

mod artifact;
mod check_and_run;
mod cli;
mod determinism;
mod directories;
mod docs;
mod editors;
mod embed_c;
mod embedding;
mod executables;
mod explain;
mod host;
mod kernels;
mod library;
mod lsp;
mod memory_limit;
mod optimize;
mod planetary;
mod remedies;
mod results;
mod runner;
mod sensitivities;
mod settings_override;
mod signals;
mod studio;
mod support;
mod sweep;
mod sweep_plan;
mod sweep_slurm;
mod tradeoff;
