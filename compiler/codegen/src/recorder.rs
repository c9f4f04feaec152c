//! Back end that stores machine code as data ([`ModuleCode`]), for loading by another process.
//!
//! Cranelift identifies functions and data by ids. Stored code identifies them by indices, and the
//! functions of the engine by their symbols.

use crate::backend::{Backend, Lowered, TargetCpu, position_dependent_isa};
use crate::code::{
    DataCode, FunctionCode, KernelFunction, ModuleCode, ProgramFunction, Relocation, RelocationKind, Target,
};
use crate::error::CodegenError;
use crate::jit::Signature;
use calyx_lang::ir::Program;
use cranelift_codegen::control::ControlPlane;
use cranelift_codegen::isa::{OwnedTargetIsa, TargetIsa};
use cranelift_codegen::{Context, ir};
use cranelift_module::{
    DataDescription, DataId, FuncId, Init, Linkage, Module, ModuleDeclarations, ModuleError, ModuleReloc,
    ModuleRelocTarget, ModuleResult,
};
use std::collections::HashMap;
use std::io;

/// Cranelift module that stores the definitions it receives.
pub struct Recorder {
    isa: OwnedTargetIsa,
    declarations: ModuleDeclarations,
    /// Defined functions, in order of definition.
    functions: Vec<(FuncId, Recorded)>,
    /// Defined data, in order of definition.
    data: Vec<(DataId, DataCode)>,
    /// Signatures of the program's functions.
    signatures: Vec<Signature>,
    /// Index of the main function.
    main: u32,
}

/// Code of a function, whose relocations refer to Cranelift ids.
struct Recorded {
    bytes: Vec<u8>,
    alignment: u64,
    relocations: Vec<ModuleReloc>,
}

impl Recorder {
    /// Creates a recorder for the code of a program.
    ///
    /// # Errors
    /// Cranelift does not support the machine.
    pub fn new(program: &Program, cpu: TargetCpu) -> Result<Self, CodegenError> {
        Ok(Recorder {
            isa: position_dependent_isa(cpu)?,
            declarations: ModuleDeclarations::default(),
            functions: Vec::new(),
            data: Vec::new(),
            signatures: program.functions.iter().map(Signature::new).collect(),
            main: program.main.0,
        })
    }
}

impl Backend for Recorder {
    type Module = Recorder;
    type Artifact = ModuleCode;

    fn module(&mut self) -> &mut Recorder {
        self
    }

    fn finish(self, lowered: Lowered) -> Result<ModuleCode, CodegenError> {
        let mut numbers = Numbers {
            functions: self.functions.iter().map(|(id, _)| *id).zip(0..).collect(),
            data: self.data.iter().map(|(id, _)| *id).zip(0..).collect(),
            declarations: &self.declarations,
            imports: Vec::new(),
            import_numbers: HashMap::new(),
        };
        let mut functions = Vec::new();
        for (_, recorded) in self.functions {
            let relocations = recorded.relocations.iter().map(|relocation| numbers.relocation(relocation));
            let relocations = relocations.collect::<Result<_, _>>()?;
            let Recorded { bytes, alignment, .. } = recorded;
            functions.push(FunctionCode { bytes, alignment, relocations });
        }
        let program = lowered
            .functions
            .iter()
            .zip(self.signatures)
            .map(|(id, signature)| Ok(ProgramFunction { function: numbers.function(*id)?, signature }));
        let program = program.collect::<Result<_, CodegenError>>()?;
        let kernels = lowered.kernels.iter().map(|kernel| {
            Ok(KernelFunction {
                function: numbers.function(kernel.function)?,
                inputs: count(kernel.inputs)?,
                outputs: count(kernel.outputs)?,
            })
        });
        let kernels = kernels.collect::<Result<_, CodegenError>>()?;
        let data = self.data.into_iter().map(|(_, data)| data).collect();
        Ok(ModuleCode { imports: numbers.imports, functions, data, program, kernels, main: self.main })
    }
}

/// Converts a number of values of a kernel.
fn count(number: usize) -> Result<u32, CodegenError> {
    number.try_into().map_err(|_| CodegenError::Malformed("a kernel with more than 2^32 values"))
}

/// Indices of functions and data by Cranelift id.
struct Numbers<'d> {
    functions: HashMap<FuncId, u32>,
    data: HashMap<DataId, u32>,
    declarations: &'d ModuleDeclarations,
    /// Symbols of the functions of the engine, in order of first use.
    imports: Vec<String>,
    import_numbers: HashMap<FuncId, u32>,
}

impl Numbers<'_> {
    /// Returns the index of a defined function.
    fn function(&self, id: FuncId) -> Result<u32, CodegenError> {
        let number = self.functions.get(&id).copied();
        number.ok_or(CodegenError::Malformed("a function that was not defined"))
    }

    /// Converts the target of a relocation.
    fn target(&mut self, name: &ModuleRelocTarget) -> Result<Target, CodegenError> {
        let foreign =
            CodegenError::Malformed("a call of a function that is neither in the program nor in the engine");
        let ModuleRelocTarget::User { index, .. } = name else { return Err(foreign) };
        if !ModuleDeclarations::is_function(name) {
            let number = self.data.get(&DataId::from_u32(*index)).copied();
            return number.map(Target::Data).ok_or(CodegenError::Malformed("data that was not defined"));
        }
        let id = FuncId::from_u32(*index);
        let declared = self.declarations.get_function_decl(id);
        if declared.linkage != Linkage::Import {
            return Ok(Target::Function(self.function(id)?));
        }
        if let Some(&number) = self.import_numbers.get(&id) {
            return Ok(Target::Import(number));
        }
        let number = self.imports.len() as u32;
        self.imports.push(declared.linkage_name(id).into_owned());
        self.import_numbers.insert(id, number);
        Ok(Target::Import(number))
    }

    /// Converts a relocation.
    fn relocation(&mut self, relocation: &ModuleReloc) -> Result<Relocation, CodegenError> {
        let ModuleReloc { offset, kind, addend, .. } = *relocation;
        let known = RelocationKind::new(kind);
        let kind = known.ok_or_else(|| {
            CodegenError::Cranelift(format!("relocations of kind {kind:?} cannot be stored"))
        })?;
        Ok(Relocation { offset, kind, target: self.target(&relocation.name)?, addend })
    }
}

impl Module for Recorder {
    fn isa(&self) -> &dyn TargetIsa {
        &*self.isa
    }

    fn declarations(&self) -> &ModuleDeclarations {
        &self.declarations
    }

    fn declare_function(
        &mut self,
        name: &str,
        linkage: Linkage,
        signature: &ir::Signature,
    ) -> ModuleResult<FuncId> {
        self.declarations.declare_function(name, linkage, signature).map(|(id, _)| id)
    }

    fn declare_anonymous_function(&mut self, signature: &ir::Signature) -> ModuleResult<FuncId> {
        self.declarations.declare_anonymous_function(signature)
    }

    fn declare_data(
        &mut self,
        name: &str,
        linkage: Linkage,
        writable: bool,
        tls: bool,
    ) -> ModuleResult<DataId> {
        self.declarations.declare_data(name, linkage, writable, tls).map(|(id, _)| id)
    }

    fn declare_anonymous_data(&mut self, writable: bool, tls: bool) -> ModuleResult<DataId> {
        self.declarations.declare_anonymous_data(writable, tls)
    }

    fn define_function_with_control_plane(
        &mut self,
        id: FuncId,
        context: &mut Context,
        control_plane: &mut ControlPlane,
    ) -> ModuleResult<()> {
        let alignment = context.compile(self.isa(), control_plane)?.buffer.alignment;
        let code = context.compiled_code().ok_or_else(|| unsupported("a function without code"))?;
        let relocations = code.buffer.relocs().iter();
        let relocations =
            relocations.map(|relocation| ModuleReloc::from_mach_reloc(relocation, &context.func, id));
        let relocations: Vec<_> = relocations.collect();
        self.define_function_bytes(id, alignment.into(), code.code_buffer(), &relocations)
    }

    fn define_function_bytes(
        &mut self,
        id: FuncId,
        alignment: u64,
        bytes: &[u8],
        relocations: &[ModuleReloc],
    ) -> ModuleResult<()> {
        let least = u64::from(self.isa.function_alignment().minimum).max(self.isa.symbol_alignment());
        let recorded = Recorded {
            bytes: bytes.to_vec(),
            alignment: alignment.max(least),
            relocations: relocations.to_vec(),
        };
        self.functions.push((id, recorded));
        Ok(())
    }

    fn define_data(&mut self, id: DataId, data: &DataDescription) -> ModuleResult<()> {
        let Init::Bytes { contents } = &data.init else { return Err(unsupported("data without content")) };
        if !data.function_relocs.is_empty() || !data.data_relocs.is_empty() {
            return Err(unsupported("data with addresses"));
        }
        let alignment = data.align.unwrap_or(1);
        self.data.push((id, DataCode { bytes: contents.to_vec(), alignment }));
        Ok(())
    }
}

/// Returns the error of an operation that this back end does not support. The lowering never
/// requests one.
fn unsupported(what: &str) -> ModuleError {
    ModuleError::Allocation { err: io::Error::other(format!("{what} cannot be stored")) }
}
