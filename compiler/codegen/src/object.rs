//! The back end that writes object files.

use crate::backend::{Backend, Lowered, TargetCpu, object_isa};
use crate::error::CodegenError;
use crate::function::SLOT;
use calyx_abi::Fingerprint;
use calyx_abi::description::ModuleTable;
use calyx_lang::ir::{FunctionId, Program};
use cranelift_codegen::Context;
use cranelift_codegen::ir::{AbiParam, InstBuilder, types};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_module::{DataDescription, DataId, FuncId, Linkage, Module, default_libcall_names};
use cranelift_object::{ObjectBuilder, ObjectModule};
use std::mem::{offset_of, size_of};

/// The contents of an object file other than the program's code.
#[derive(Clone, Debug)]
pub struct ObjectOptions<'p> {
    /// The model's name, a C identifier: the file exports `NAME_model`.
    pub name: &'p str,
    /// Returns the description as JSON.
    pub description: &'p str,
    /// Fingerprint of the engine that the code may call.
    pub abi: Fingerprint,
    pub cpu: TargetCpu,
    /// If `true`, the file exports `main`, so that linking it with the runtime library results in
    /// an executable.
    pub entry: bool,
}

impl<'p> ObjectOptions<'p> {
    /// Creates options for every processor of this architecture, without `main`.
    pub fn new(name: &'p str, description: &'p str, abi: Fingerprint) -> Self {
        ObjectOptions { name, description, abi, cpu: TargetCpu::Baseline, entry: false }
    }
}

/// Returns the symbol of the table of the model called `name`.
pub fn model_symbol(name: &str) -> String {
    format!("{name}_model")
}

/// A back end that writes an object file.
pub struct ObjectFile<'p> {
    module: ObjectModule,
    options: &'p ObjectOptions<'p>,
    main: FunctionId,
    /// Three functions per param: default, lower limit, upper limit.
    param_functions: Vec<Option<FunctionId>>,
}

impl<'p> ObjectFile<'p> {
    /// Starts the object file of a program.
    pub fn new(program: &Program, options: &'p ObjectOptions<'p>) -> Result<Self, CodegenError> {
        let builder = ObjectBuilder::new(object_isa(options.cpu)?, options.name, default_libcall_names())?;
        let ends = |param: &calyx_lang::ir::Param| [Some(param.default), param.low, param.high];
        Ok(ObjectFile {
            module: ObjectModule::new(builder),
            options,
            main: program.main,
            param_functions: program.params.iter().flat_map(ends).collect(),
        })
    }

    /// Defines constant bytes that contain addresses of functions.
    fn data(&mut self, bytes: Vec<u8>, functions: &[(usize, FuncId)]) -> Result<DataId, CodegenError> {
        let id = self.module.declare_anonymous_data(false, false)?;
        let mut data = DataDescription::new();
        // Empty data also needs an address.
        data.define(if bytes.is_empty() { [0].into() } else { bytes.into() });
        data.set_align(SLOT as u64);
        for &(offset, function) in functions {
            let function = self.module.declare_func_in_data(function, &mut data);
            data.write_function_addr(offset as u32, function);
        }
        self.module.define_data(id, &data)?;
        Ok(id)
    }

    /// Exports the [`ModuleTable`].
    fn table(&mut self, lowered: &Lowered) -> Result<DataId, CodegenError> {
        let function = |id: FunctionId| {
            let function = lowered.functions.get(id.0 as usize).copied();
            function.ok_or(CodegenError::Malformed("a function that is not there"))
        };
        let kernels = lowered.kernels.iter().enumerate();
        let kernels: Vec<_> = kernels.map(|(index, kernel)| (index * SLOT, kernel.function)).collect();
        let mut param_functions = Vec::new();
        for (index, id) in self.param_functions.iter().enumerate() {
            if let Some(id) = id {
                param_functions.push((index * SLOT, function(*id)?));
            }
        }
        let (kernel_bytes, param_bytes) = (kernels.len() * SLOT, self.param_functions.len() * SLOT);
        let parts = [
            (offset_of!(ModuleTable, kernels), self.data(vec![0; kernel_bytes], &kernels)?),
            (offset_of!(ModuleTable, param_functions), self.data(vec![0; param_bytes], &param_functions)?),
            (offset_of!(ModuleTable, description), self.data(self.options.description.into(), &[])?),
        ];

        let mut bytes = vec![0; size_of::<ModuleTable>()];
        for (offset, number) in [
            (offset_of!(ModuleTable, abi), self.options.abi.0),
            (offset_of!(ModuleTable, kernel_count), lowered.kernels.len() as u64),
            (offset_of!(ModuleTable, description_len), self.options.description.len() as u64),
        ] {
            bytes[offset..offset + SLOT].copy_from_slice(&number.to_ne_bytes());
        }
        let table =
            self.module.declare_data(&model_symbol(self.options.name), Linkage::Export, false, false)?;
        let mut data = DataDescription::new();
        data.define(bytes.into());
        data.set_align(SLOT as u64);
        let main = self.module.declare_func_in_data(function(self.main)?, &mut data);
        data.write_function_addr(offset_of!(ModuleTable, main) as u32, main);
        for (offset, part) in parts {
            let part = self.module.declare_data_in_data(part, &mut data);
            data.write_data_addr(offset as u32, part, 0);
        }
        self.module.define_data(table, &data)?;
        Ok(table)
    }

    /// Exports `main(argc, argv)`, which returns `calyx_rt_main(argc, argv, &NAME_model)`.
    fn entry(&mut self, table: DataId) -> Result<(), CodegenError> {
        let mut signature = self.module.make_signature();
        signature.params.extend([AbiParam::new(types::I32), AbiParam::new(types::I64)]);
        signature.returns.push(AbiParam::new(types::I32));
        let main = self.module.declare_function("main", Linkage::Export, &signature)?;
        let mut context = Context::new();
        context.func.signature = signature.clone();
        signature.params.push(AbiParam::new(types::I64));
        let runner = self.module.declare_function("calyx_rt_main", Linkage::Import, &signature)?;

        let mut builder_context = FunctionBuilderContext::new();
        let mut builder = FunctionBuilder::new(&mut context.func, &mut builder_context);
        let block = builder.create_block();
        builder.append_block_params_for_function_params(block);
        builder.switch_to_block(block);
        let mut arguments = builder.block_params(block).to_vec();
        let table = self.module.declare_data_in_func(table, builder.func);
        arguments.push(builder.ins().symbol_value(types::I64, table));
        let runner = self.module.declare_func_in_func(runner, builder.func);
        let call = builder.ins().call(runner, &arguments);
        let status = builder.inst_results(call).to_vec();
        builder.ins().return_(&status);
        builder.seal_all_blocks();
        builder.finalize(self.module.target_config());
        self.module.define_function(main, &mut context)?;
        Ok(())
    }
}

impl Backend for ObjectFile<'_> {
    type Module = ObjectModule;
    type Artifact = Vec<u8>;

    fn module(&mut self) -> &mut ObjectModule {
        &mut self.module
    }

    fn finish(mut self, lowered: Lowered) -> Result<Vec<u8>, CodegenError> {
        let table = self.table(&lowered)?;
        if self.options.entry {
            self.entry(table)?;
        }
        self.module.finish().emit().map_err(|error| CodegenError::Cranelift(error.to_string()))
    }
}
