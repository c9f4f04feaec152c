//! A module under construction: the functions and constants that its functions may reference.

use crate::backend::{Kernel, Lowered};
use crate::error::CodegenError;
use crate::function::FunctionLowering;
use crate::kernel;
use crate::listing::Listing;
use calyx_abi::entry::entry_points;
use calyx_abi::math::{self, MathFn};
use calyx_lang::ir::Program;
use calyx_lower::layout::running_sums;
use calyx_symbolic::Tape;
use cranelift_codegen::Context;
use cranelift_codegen::ir::{AbiParam, Signature, types};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_module::{DataDescription, DataId, FuncId, Linkage, Module};
use std::collections::HashMap;

/// State shared by all functions of a module.
pub struct ModuleLowering<'m, M: Module> {
    pub module: &'m mut M,
    pub program: &'m Program,
    /// Functions in order of `Program::functions`.
    pub functions: Vec<FuncId>,
    /// Functions in order of `Program::externs`.
    pub externs: Vec<FuncId>,
    /// Helpers and numeric functions, by link symbol.
    imports: HashMap<&'static str, FuncId>,
    /// For each param, the number of slots of all params before it.
    pub param_offsets: Vec<usize>,
    constants: HashMap<Vec<u8>, DataId>,
    context: Context,
    builder_context: FunctionBuilderContext,
    /// Receives code listings, if requested.
    listings: Option<&'m mut Vec<Listing>>,
}

impl<'m, M: Module> ModuleLowering<'m, M> {
    /// Declares everything that functions of the program may call.
    pub fn new(module: &'m mut M, program: &'m Program) -> Result<Self, CodegenError> {
        let slot_fn = slot_signature(module);
        let mut functions = Vec::new();
        for index in 0..program.functions.len() {
            let name = format!("calyx_function_{index}");
            functions.push(module.declare_function(&name, Linkage::Local, &slot_fn)?);
        }
        let mut externs = Vec::new();
        for row in &program.externs {
            externs.push(module.declare_function(&row.symbol, Linkage::Import, &slot_fn)?);
        }
        let mut imports = HashMap::new();
        for helper in entry_points() {
            let mut signature = module.make_signature();
            let words = std::iter::repeat_n(AbiParam::new(types::I64), helper.arguments + 1);
            signature.params.extend(words);
            signature.returns.push(AbiParam::new(types::I32));
            imports
                .insert(helper.symbol, module.declare_function(helper.symbol, Linkage::Import, &signature)?);
        }
        for &(symbol, function) in math::FUNCTIONS {
            let mut signature = module.make_signature();
            let (params, returns): (&[_], &[_]) = match function {
                MathFn::Unary(_) => (&[types::F64], &[types::F64]),
                MathFn::Binary(_) => (&[types::F64, types::F64], &[types::F64]),
                MathFn::Sincos(_) => (&[types::F64], &[types::F64; 2]),
                MathFn::SincosColumns(_) => (&[types::I64; 4], &[]),
                MathFn::Unsolved(_) => (&[types::I64], &[]),
                MathFn::Registered(_) => (&[types::F64; 3], &[types::F64]),
                MathFn::Piecewise(_) => (&[types::I64, types::F64], &[types::F64]),
            };
            signature.params.extend(params.iter().copied().map(AbiParam::new));
            signature.returns.extend(returns.iter().copied().map(AbiParam::new));
            imports.insert(symbol, module.declare_function(symbol, Linkage::Import, &signature)?);
        }
        let (param_offsets, _) = running_sums(program.params.iter().map(|param| param.repr.slots()));
        Ok(ModuleLowering {
            module,
            program,
            functions,
            externs,
            imports,
            param_offsets,
            constants: HashMap::new(),
            context: Context::new(),
            builder_context: FunctionBuilderContext::new(),
            listings: None,
        })
    }

    /// Enables listings of functions that are defined from now on.
    pub fn listed_in(mut self, listings: &'m mut Vec<Listing>) -> Self {
        self.listings = Some(listings);
        self
    }

    /// Defines all functions and kernels.
    pub fn lower(mut self, tapes: &[Tape]) -> Result<Lowered, CodegenError> {
        let signature = slot_signature(self.module);
        for (index, function) in self.program.functions.iter().enumerate() {
            let id = self.functions[index];
            self.define(id, signature.clone(), |module, builder| {
                FunctionLowering::new(module, builder, function)?.lower()
            })?;
        }
        let mut kernels = Vec::new();
        for (index, tape) in tapes.iter().enumerate() {
            let function = kernel::lower(&mut self, &format!("calyx_kernel_{index}"), tape)?;
            kernels.push(Kernel { function, inputs: tape.inputs, outputs: tape.outputs.len() });
        }
        Ok(Lowered { functions: self.functions, kernels })
    }

    /// Builds the body of a declared function and defines it.
    pub fn define(
        &mut self,
        id: FuncId,
        signature: Signature,
        build: impl FnOnce(&mut Self, FunctionBuilder) -> Result<(), CodegenError>,
    ) -> Result<(), CodegenError> {
        let mut context = std::mem::replace(&mut self.context, Context::new());
        let mut builder_context = std::mem::take(&mut self.builder_context);
        context.func.signature = signature;
        let built = build(self, FunctionBuilder::new(&mut context.func, &mut builder_context));
        if built.is_ok() {
            let clif = self.listings.is_some().then(|| context.func.display().to_string());
            context.set_disasm(clif.is_some());
            self.module.define_function(id, &mut context)?;
            if let (Some(listings), Some(clif)) = (&mut self.listings, clif) {
                let declared = self.module.declarations().get_function_decl(id);
                let asm = context.compiled_code().and_then(|code| code.vcode.clone()).unwrap_or_default();
                listings.push(Listing { symbol: declared.linkage_name(id).into_owned(), clif, asm });
            }
        }
        context.clear();
        self.context = context;
        self.builder_context = builder_context;
        built
    }

    /// Returns a helper or numeric function by its symbol.
    pub fn import(&self, symbol: &str) -> Result<FuncId, CodegenError> {
        self.imports.get(symbol).copied().ok_or(CodegenError::Malformed("a call of an unknown helper"))
    }

    /// Defines constant bytes; equal constants are stored once.
    pub fn constant(&mut self, bytes: &[u8]) -> Result<DataId, CodegenError> {
        if let Some(id) = self.constants.get(bytes) {
            return Ok(*id);
        }
        let id = self.module.declare_anonymous_data(false, false)?;
        let mut description = DataDescription::new();
        description.define(bytes.into());
        // Tables consist of numbers.
        description.set_align(8);
        self.module.define_data(id, &description)?;
        self.constants.insert(bytes.to_vec(), id);
        Ok(id)
    }
}

/// Returns the signature of [`calyx_abi::SlotFn`].
fn slot_signature<M: Module>(module: &M) -> Signature {
    let mut signature = module.make_signature();
    signature.params.extend([AbiParam::new(types::I64); 3]);
    signature.returns.push(AbiParam::new(types::I32));
    signature
}
