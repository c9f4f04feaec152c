//! Places code that was stored as data in memory.
//!
//! All requirements of the code memory are checked first, so that malformed bytes never cause a
//! panic.

use crate::backend::{Backend, Effort, Kernel, Lowered, native_isa};
use crate::code::{FunctionCode, LoadError, ModuleCode, Relocation, Target};
use crate::error::CodegenError;
use crate::jit::{Jit, JitModule, Symbols};
use calyx_abi::Extern;
use cranelift_module::{DataDescription, FuncId, Linkage, Module, ModuleReloc, ModuleRelocTarget};

/// Largest alignment of code or data: a page.
const MOST_ALIGNED: u64 = 4096;

/// Allowed addends of addresses: offsets of the program counter, too small to leave the target.
const ADDENDS: std::ops::RangeInclusive<i64> = -16..=16;

/// Limit of a module's address space, which relative addresses can span.
const MOST_SPACE: usize = 256 << 20;

/// Checks the code and places it in memory. The code reaches helpers, numeric functions and
/// `externs`, but nothing else.
pub fn load(code: &ModuleCode, externs: &[Extern]) -> Result<JitModule, LoadError> {
    check(code)?;
    let symbols = Symbols::new(externs);
    if let Some(symbol) = code.imports.iter().find(|symbol| !symbols.contains(symbol)) {
        return Err(LoadError::Unknown(symbol.clone()));
    }
    place(code, symbols).map_err(LoadError::Memory)
}

fn check(code: &ModuleCode) -> Result<(), LoadError> {
    let malformed = |what| Err(LoadError::Malformed(what));
    let aligned = |alignment: u64| alignment.is_power_of_two() && alignment <= MOST_ALIGNED;
    for function in &code.functions {
        if function.bytes.is_empty() || !aligned(function.alignment) {
            return malformed("a function that is empty or lies crooked");
        }
        if !function.relocations.iter().all(|relocation| is_sound(relocation, function, code)) {
            return malformed("an address of what is not there");
        }
    }
    if !code.data.iter().all(|data| aligned(data.alignment)) {
        return malformed("data that lies crooked");
    }
    if space(code).is_none_or(|space| space > MOST_SPACE) {
        return malformed("more than a module can hold");
    }
    let there = |function: u32| (function as usize) < code.functions.len();
    let kernels = code.kernels.iter().all(|kernel| there(kernel.function));
    if !kernels || !code.program.iter().all(|function| there(function.function)) {
        return malformed("an entry that is not there");
    }
    if code.main as usize >= code.program.len() {
        return malformed("no top level");
    }
    Ok(())
}

/// Returns `true` if a relocation is within its function, has an existing target, and can reach it.
fn is_sound(relocation: &Relocation, function: &FunctionCode, code: &ModuleCode) -> bool {
    let end = (relocation.offset as usize).checked_add(relocation.kind.width());
    let target = match relocation.target {
        // The engine may be at any address.
        Target::Import(number) => {
            (number as usize) < code.imports.len() && relocation.kind.is_absolute() && relocation.addend == 0
        }
        Target::Function(number) => (number as usize) < code.functions.len(),
        Target::Data(number) => (number as usize) < code.data.len(),
    };
    target && end.is_some_and(|end| end <= function.bytes.len()) && ADDENDS.contains(&relocation.addend)
}

/// Returns an upper bound of the address space for the code: in the worst case each function and
/// constant starts a page, and a far call of AArch64 takes 24 additional bytes.
fn space(code: &ModuleCode) -> Option<usize> {
    let page = MOST_ALIGNED as usize;
    let functions =
        code.functions.iter().map(|function| function.bytes.len() + 24 * function.relocations.len());
    let data = code.data.iter().map(|data| data.bytes.len());
    functions.chain(data).try_fold(2 * page, |sum, bytes| sum.checked_add(bytes.checked_add(2 * page)?))
}

fn place(code: &ModuleCode, symbols: Symbols) -> Result<JitModule, CodegenError> {
    let mut jit = Jit::with_address_space(
        native_isa(Effort::Speed)?,
        symbols,
        space(code).unwrap_or(MOST_SPACE),
        code.program.iter().map(|function| function.signature.clone()).collect(),
        calyx_lang::ir::FunctionId(code.main),
    )?;
    let module = jit.module();
    // The code is complete, so the signatures are not used.
    let unknown = module.make_signature();
    let mut imports = Vec::new();
    for symbol in &code.imports {
        imports.push(module.declare_function(symbol, Linkage::Import, &unknown)?);
    }
    let mut functions = Vec::new();
    for _ in &code.functions {
        functions.push(module.declare_anonymous_function(&unknown)?);
    }
    let mut data = Vec::new();
    for constant in &code.data {
        let id = module.declare_anonymous_data(false, false)?;
        let mut description = DataDescription::new();
        description.define(constant.bytes.as_slice().into());
        description.set_align(constant.alignment);
        module.define_data(id, &description)?;
        data.push(id);
    }
    let name = |target: Target| -> ModuleRelocTarget {
        match target {
            Target::Import(number) => imports[number as usize].into(),
            Target::Function(number) => functions[number as usize].into(),
            Target::Data(number) => data[number as usize].into(),
        }
    };
    for (&id, function) in functions.iter().zip(&code.functions) {
        let relocations = function.relocations.iter().map(|relocation| ModuleReloc {
            offset: relocation.offset,
            kind: relocation.kind.kind(),
            name: name(relocation.target),
            addend: relocation.addend,
        });
        let relocations: Vec<_> = relocations.collect();
        module.define_function_bytes(id, function.alignment, &function.bytes, &relocations)?;
    }
    let entry = |number: u32| -> FuncId { functions[number as usize] };
    let kernels = code.kernels.iter().map(|kernel| Kernel {
        function: entry(kernel.function),
        inputs: kernel.inputs as usize,
        outputs: kernel.outputs as usize,
    });
    let lowered = Lowered {
        functions: code.program.iter().map(|function| entry(function.function)).collect(),
        kernels: kernels.collect(),
    };
    jit.finish(lowered)
}
