//! A module under construction: the functions and constants that its functions may reference.

use crate::backend::{Kernel, Lowered};
use crate::error::CodegenError;
use crate::function::{FunctionLowering, is_library};
use crate::kernel;
use crate::listing::Listing;
use calyx_abi::entry::entry_points;
use calyx_abi::math::{self, MathFn};
use calyx_lang::ir::Program;
use calyx_lower::layout::running_sums;
use calyx_symbolic::Tape;
use cranelift_codegen::Context;
use cranelift_codegen::control::ControlPlane;
use cranelift_codegen::ir::{AbiParam, ExternalName, Function, Signature, UserFuncName, types};
use cranelift_codegen::isa::{OwnedTargetIsa, TargetIsa};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_module::{DataDescription, DataId, FuncId, Linkage, Module, ModuleError, ModuleReloc};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::borrow::Borrow;
use std::collections::{HashMap, HashSet};

/// Number of functions that are compiled in parallel.
const SEVERAL: usize = 8;

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
    builder_context: FunctionBuilderContext,
    /// Functions whose bodies are built, but not compiled.
    built: Vec<(FuncId, Function)>,
    /// Settings for functions that run a few times, if they differ from those of the module.
    quick_isa: Option<OwnedTargetIsa>,
    /// Receives code listings, if requested.
    listings: Option<&'m mut Vec<Listing>>,
}

/// Machine code of a function.
struct Compiled {
    alignment: u64,
    bytes: Vec<u8>,
    relocations: Vec<ModuleReloc>,
    /// Intermediate representation and assembly, if listings are requested.
    listed: Option<[String; 2]>,
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
            builder_context: FunctionBuilderContext::new(),
            built: Vec::new(),
            quick_isa: None,
            listings: None,
        })
    }

    /// Compiles functions of the library, and functions of the model that no loop repeats, with
    /// these settings instead of those of the module, if they are given. The settings must differ
    /// in optimization and register allocation only: functions call each other.
    pub fn with_quick_isa(mut self, isa: Option<OwnedTargetIsa>) -> Self {
        if let Some(isa) = &isa {
            let own = self.module.isa();
            debug_assert_eq!(own.triple(), isa.triple());
            debug_assert_eq!(own.default_call_conv(), isa.default_call_conv());
            debug_assert_eq!(own.flags().is_pic(), isa.flags().is_pic());
            let flags =
                |isa: &dyn TargetIsa| isa.isa_flags().iter().map(|flag| flag.to_string()).collect::<Vec<_>>();
            debug_assert_eq!(flags(own), flags(&**isa));
        }
        self.quick_isa = isa;
        self
    }

    /// Enables listings of functions that are defined from now on.
    pub fn listed_in(mut self, listings: &'m mut Vec<Listing>) -> Self {
        self.listings = Some(listings);
        self
    }

    /// Defines and compiles all functions and kernels.
    pub fn lower(mut self, tapes: &[impl Borrow<Tape>]) -> Result<Lowered, CodegenError> {
        let signature = slot_signature(self.module);
        for (index, function) in self.program.functions.iter().enumerate() {
            let id = self.functions[index];
            self.define(id, signature.clone(), |module, builder| {
                FunctionLowering::new(module, builder, function)?.lower()
            })?;
        }
        let mut kernels = Vec::new();
        for (index, tape) in tapes.iter().map(Borrow::borrow).enumerate() {
            let function = kernel::lower(&mut self, &format!("calyx_kernel_{index}"), tape)?;
            kernels.push(Kernel { function, inputs: tape.inputs, outputs: tape.outputs.len() });
        }
        self.compile()?;
        Ok(Lowered { functions: self.functions, kernels })
    }

    /// Builds the body of a declared function. [`ModuleLowering::compile`] compiles it.
    pub fn define(
        &mut self,
        id: FuncId,
        signature: Signature,
        build: impl FnOnce(&mut Self, FunctionBuilder) -> Result<(), CodegenError>,
    ) -> Result<(), CodegenError> {
        let mut builder_context = std::mem::take(&mut self.builder_context);
        let mut function = Function::with_name_signature(UserFuncName::default(), signature);
        let result = build(self, FunctionBuilder::new(&mut function, &mut builder_context));
        self.builder_context = builder_context;
        self.built.extend(result.is_ok().then_some((id, function)));
        result
    }

    /// Compiles all functions that were built. They are compiled in parallel and defined in the
    /// order in which they were built, so that the module does not depend on the number of threads.
    pub fn compile(&mut self) -> Result<(), CodegenError> {
        let built = std::mem::take(&mut self.built);
        let (isa, listed) = (self.module.isa(), self.listings.is_some());
        let ids: Vec<FuncId> = built.iter().map(|(id, _)| *id).collect();
        let seldom = if self.quick_isa.is_some() { self.run_seldom(&built) } else { HashSet::new() };
        let isa_of = |id: FuncId| match &self.quick_isa {
            Some(quick) if seldom.contains(&id) => &**quick,
            _ => isa,
        };
        let compile = |context: &mut Context, (id, function): (FuncId, Function)| {
            compile(context, isa_of(id), (id, function), listed)
        };
        let compiled: Vec<Result<Compiled, CodegenError>> = match built.len() {
            // Starting threads would take longer.
            0..SEVERAL => {
                let mut context = Context::new();
                built.into_iter().map(|built| compile(&mut context, built)).collect()
            }
            _ => built.into_par_iter().map_init(Context::new, compile).collect(),
        };
        for (id, compiled) in ids.into_iter().zip(compiled) {
            let Compiled { alignment, bytes, relocations, listed } = compiled?;
            self.module.define_function_bytes(id, alignment, &bytes, &relocations)?;
            if let (Some(listings), Some([clif, asm])) = (&mut self.listings, listed) {
                let declared = self.module.declarations().get_function_decl(id);
                listings.push(Listing { symbol: declared.linkage_name(id).into_owned(), clif, asm });
            }
        }
        Ok(())
    }

    /// Returns the functions of the program that run a few times: those of the library, which build
    /// the scene or evaluate formulas, and those of the model except for functions with a loop,
    /// functions that call themselves, and all functions of the model that these call.
    fn run_seldom(&self, built: &[(FuncId, Function)]) -> HashSet<FuncId> {
        let bodies: HashMap<FuncId, &Function> = built.iter().map(|(id, body)| (*id, body)).collect();
        let repeats = |id: &FuncId| {
            let body = bodies.get(id);
            body.is_some_and(|body| has_loop(body) || callees(body).any(|called| called == *id))
        };
        let declared = self.functions.iter().zip(&self.program.functions);
        let of_model = declared.filter(|(_, function)| !is_library(self.program, function.span));
        let mut of_model: HashSet<FuncId> = of_model.map(|(&id, _)| id).collect();
        let mut seldom: HashSet<FuncId> = self.functions.iter().copied().collect();
        let mut left: Vec<FuncId> = of_model.iter().copied().filter(repeats).collect();
        while let Some(id) = left.pop() {
            // Each function of the model is visited once.
            if of_model.remove(&id) {
                seldom.remove(&id);
                left.extend(bodies.get(&id).into_iter().flat_map(|body| callees(body)));
            }
        }
        seldom
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

/// Returns true if a block of the function continues at itself or at an earlier block, as in loops
/// and after `catch`.
fn has_loop(function: &Function) -> bool {
    let mut seen = HashSet::new();
    function.layout.blocks().any(|block| {
        seen.insert(block);
        function.block_successors(block).any(|next| seen.contains(&next))
    })
}

/// Returns the functions that a function calls.
fn callees(function: &Function) -> impl Iterator<Item = FuncId> {
    let names = function.dfg.ext_funcs.values().map(|called| &called.name);
    names.filter_map(|name| match name {
        ExternalName::User(name) => Some(FuncId::from_u32(function.params.user_named_funcs()[*name].index)),
        _ => None,
    })
}

/// Compiles a function.
fn compile(
    context: &mut Context,
    isa: &dyn TargetIsa,
    (id, function): (FuncId, Function),
    listed: bool,
) -> Result<Compiled, CodegenError> {
    context.clear();
    context.func = function;
    let clif = listed.then(|| context.func.display().to_string());
    context.set_disasm(listed);
    let compiled = context.compile(isa, &mut ControlPlane::default());
    let alignment = compiled.map_err(ModuleError::from)?.buffer.alignment.into();
    let code = context.compiled_code().ok_or(CodegenError::Malformed("a function without code"))?;
    let relocations = code.buffer.relocs().iter();
    Ok(Compiled {
        alignment,
        bytes: code.code_buffer().to_vec(),
        relocations: relocations
            .map(|relocation| ModuleReloc::from_mach_reloc(relocation, &context.func, id))
            .collect(),
        listed: clif.map(|clif| [clif, code.vcode.clone().unwrap_or_default()]),
    })
}

/// Returns the signature of [`calyx_abi::SlotFn`].
fn slot_signature<M: Module>(module: &M) -> Signature {
    let mut signature = module.make_signature();
    signature.params.extend([AbiParam::new(types::I64); 3]);
    signature.returns.push(AbiParam::new(types::I32));
    signature
}
