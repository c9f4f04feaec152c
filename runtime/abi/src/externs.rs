//! Functions that the engine provides to programs. One macro turns a list of ordinary Rust bodies
//! into the interpreter's table, the symbol table of machine code and the link symbols.

use crate::call::Slot;
use crate::context::{Context, RuntimeError, codes};
use crate::entry::guarded;
use crate::heap::{OBJECT, Object, SymbolicValue};
use crate::limits;
use crate::shape::Shape;
use std::sync::Arc;

/// Value that is passed between programs and the engine.
pub trait Value: Sized {
    const SHAPE: Shape;
    /// Reads the value; `None` if the slots do not contain such a value (a defect of the caller,
    /// not of the program).
    fn read(context: &Context, slots: &[Slot]) -> Option<Self>;
    fn write(self, context: &mut Context, slots: &mut [Slot]);
    /// Returns the heap memory required to read the value, bytes.
    fn bytes_to_read(_context: &Context, _slots: &[Slot]) -> u64 {
        0
    }
    /// Returns the heap memory required to write the value, bytes.
    fn bytes_to_write(&self) -> u64 {
        0
    }
    /// Returns whether the value contains NaN.
    fn has_nan(&self) -> bool {
        false
    }
}

/// Handle of an object of the engine: an index into one of its tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Handle(pub u64);

impl Value for () {
    const SHAPE: Shape = Shape::Unit;
    fn read(_: &Context, _: &[Slot]) -> Option<Self> {
        Some(())
    }
    fn write(self, _: &mut Context, _: &mut [Slot]) {}
}

impl Value for f64 {
    const SHAPE: Shape = Shape::Number;
    fn read(_: &Context, slots: &[Slot]) -> Option<Self> {
        slots.first().map(|&slot| f64::from_bits(slot))
    }
    fn write(self, _: &mut Context, slots: &mut [Slot]) {
        slots[0] = self.to_bits();
    }
    fn has_nan(&self) -> bool {
        self.is_nan()
    }
}

impl Value for bool {
    const SHAPE: Shape = Shape::Bool;
    fn read(_: &Context, slots: &[Slot]) -> Option<Self> {
        slots.first().map(|&slot| slot != 0)
    }
    fn write(self, _: &mut Context, slots: &mut [Slot]) {
        slots[0] = u64::from(self);
    }
}

impl Value for String {
    const SHAPE: Shape = Shape::String;
    fn read(context: &Context, slots: &[Slot]) -> Option<Self> {
        context.heap.str(*slots.first()?).map(str::to_owned)
    }
    fn write(self, context: &mut Context, slots: &mut [Slot]) {
        slots[0] = context.heap.string(&self);
    }
    fn bytes_to_read(context: &Context, slots: &[Slot]) -> u64 {
        slots.first().and_then(|&slot| context.heap.str(slot)).map_or(0, |text| text.len() as u64)
    }
    fn bytes_to_write(&self) -> u64 {
        OBJECT + self.len() as u64
    }
}

impl Value for [f64; 3] {
    const SHAPE: Shape = Shape::Vector;
    fn read(_: &Context, slots: &[Slot]) -> Option<Self> {
        Some([0, 1, 2].map(|i| slots.get(i).map_or(f64::NAN, |&slot| f64::from_bits(slot))))
    }
    fn write(self, _: &mut Context, slots: &mut [Slot]) {
        for (slot, component) in slots.iter_mut().zip(self) {
            *slot = component.to_bits();
        }
    }
    fn has_nan(&self) -> bool {
        self.iter().any(|component| component.is_nan())
    }
}

impl Value for Handle {
    const SHAPE: Shape = Shape::Handle;
    fn read(_: &Context, slots: &[Slot]) -> Option<Self> {
        slots.first().map(|&slot| Handle(slot))
    }
    fn write(self, _: &mut Context, slots: &mut [Slot]) {
        slots[0] = self.0;
    }
}

/// Symbolic value with the representation of the Calyx declaration.
pub struct Symbolic<const KIND: u8>(pub Arc<SymbolicValue>);
/// `Symbolic(Number)`
pub type SymbolicNumber = Symbolic<0>;
/// `Symbolic(Transform)`
pub type SymbolicTransform = Symbolic<2>;

impl<const KIND: u8> Value for Symbolic<KIND> {
    const SHAPE: Shape = match KIND {
        0 => Shape::Symbolic(&Shape::Number),
        1 => Shape::Symbolic(&Shape::Vector),
        _ => Shape::Symbolic(&Shape::Transform),
    };
    fn read(context: &Context, slots: &[Slot]) -> Option<Self> {
        context.heap.symbolic(*slots.first()?).map(Symbolic)
    }
    fn write(self, context: &mut Context, slots: &mut [Slot]) {
        slots[0] = context.heap.insert(Object::Symbolic(self.0));
    }
}

impl<T: Value> Value for Vec<T> {
    const SHAPE: Shape = Shape::Array(&T::SHAPE);
    fn read(context: &Context, slots: &[Slot]) -> Option<Self> {
        let (flat, stride) = context.heap.array(*slots.first()?)?;
        if stride == 0 {
            return Some(Vec::new());
        }
        flat.chunks(stride).map(|element| T::read(context, element)).collect()
    }
    fn write(self, context: &mut Context, slots: &mut [Slot]) {
        let stride = T::SHAPE.slots();
        let mut flat = vec![0; stride * self.len()];
        for (element, place) in self.into_iter().zip(flat.chunks_mut(stride.max(1))) {
            element.write(context, place);
        }
        slots[0] = context.heap.insert(Object::array(stride, flat));
    }
    fn bytes_to_read(context: &Context, slots: &[Slot]) -> u64 {
        let Some((flat, stride)) = slots.first().and_then(|&slot| context.heap.array(slot)) else { return 0 };
        let elements = flat.chunks(stride.max(1));
        elements.map(|element| size_of::<T>() as u64 + T::bytes_to_read(context, element)).sum()
    }
    fn bytes_to_write(&self) -> u64 {
        let slots = size_of::<Slot>() * T::SHAPE.slots() * self.len();
        OBJECT + slots as u64 + self.iter().map(Value::bytes_to_write).sum::<u64>()
    }
    fn has_nan(&self) -> bool {
        self.iter().any(Value::has_nan)
    }
}

/// The value of an optional parameter: `= none` in its declaration. Zero is a value.
impl<T: Value> Value for Option<T> {
    const SHAPE: Shape = Shape::Optional(&T::SHAPE);
    fn read(context: &Context, slots: &[Slot]) -> Option<Self> {
        match slots.split_first()? {
            (0, _) => Some(None),
            (_, value) => T::read(context, value).map(Some),
        }
    }
    fn write(self, context: &mut Context, slots: &mut [Slot]) {
        slots.fill(0);
        if let (Some(value), Some((present, rest))) = (self, slots.split_first_mut()) {
            *present = 1;
            value.write(context, rest);
        }
    }
    fn bytes_to_read(context: &Context, slots: &[Slot]) -> u64 {
        match slots.split_first() {
            Some((&present, value)) if present != 0 => T::bytes_to_read(context, value),
            _ => 0,
        }
    }
    fn bytes_to_write(&self) -> u64 {
        self.as_ref().map_or(0, Value::bytes_to_write)
    }
    fn has_nan(&self) -> bool {
        self.as_ref().is_some_and(Value::has_nan)
    }
}

/// Iterator over the arguments of a call.
pub struct Arguments<'a> {
    slots: &'a [Slot],
}

impl Arguments<'_> {
    /// Returns the next argument, which the declaration calls `name`, and rejects NaN.
    ///
    /// # Errors
    /// E0722 if it contains NaN; internal if the slots do not contain such a value.
    pub fn take_number<T: Value>(&mut self, context: &Context, name: &str) -> Result<T, RuntimeError> {
        let value: T = self.take(context)?;
        if !value.has_nan() {
            return Ok(value);
        }
        let mut error = RuntimeError::new(
            codes::NOT_A_NUMBER,
            format!("`{name}` is not a number"),
            "look for 0/0, inf - inf or the root of a negative number",
        );
        error.argument = Some(name.into());
        Err(error)
    }

    /// Returns the next argument.
    ///
    /// # Errors
    /// Internal if the slots do not contain such a value; E0707 if it takes too much memory.
    pub fn take<T: Value>(&mut self, context: &Context) -> Result<T, RuntimeError> {
        let count = T::SHAPE.slots().min(self.slots.len());
        let (now, rest) = self.slots.split_at(count);
        self.slots = rest;
        limits::request_memory(context, T::bytes_to_read(context, now))?;
        T::read(context, now).ok_or_else(|| {
            RuntimeError::new(
                codes::INTERNAL,
                "a value of the wrong kind reached the engine",
                "this is a defect of Calyx; please report it with the model",
            )
        })
    }
}

/// Runs the body of a provided function: stores its result or error and catches panics.
///
/// # Safety
/// As for [`crate::SlotFn`]; `args` must have `count` slots and `ret` those of `T::SHAPE`.
pub unsafe fn call<T: Value>(
    ctx: *mut Context,
    args: *const Slot,
    count: usize,
    ret: *mut Slot,
    body: impl FnOnce(&mut Context, Arguments) -> Result<T, RuntimeError>,
) -> i32 {
    let guarded_body = |context: &mut Context| {
        // SAFETY: the caller guarantees the pointers; a slice of no slots needs no valid pointer.
        let slots = if count == 0 { &[][..] } else { unsafe { std::slice::from_raw_parts(args, count) } };
        limits::check(context)?;
        let value = body(context, Arguments { slots })?;
        let width = T::SHAPE.slots();
        // SAFETY: as above.
        let ret =
            if width == 0 { &mut [][..] } else { unsafe { std::slice::from_raw_parts_mut(ret, width) } };
        limits::request_memory(context, value.bytes_to_write())?;
        value.write(context, ret);
        Ok(())
    };
    // SAFETY: the caller guarantees the context.
    unsafe { guarded(ctx, guarded_body) }
}

/// Declares provided functions:
///
/// ```
/// calyx_abi::externs! {
///     /// Twice the number.
///     Pure fn calyx_example_twice(_context, x: f64) -> f64 { Ok(2.0 * x) }
/// }
/// assert_eq!(EXTERNS[0].symbol, "calyx_example_twice");
/// ```
///
/// NaN arguments are rejected, except by functions of the language itself (`calyx_std_`), which
/// treat NaN like any number. Each function becomes an exported C symbol of type [`crate::SlotFn`]
/// and a row of the constant `EXTERNS`.
#[macro_export]
macro_rules! externs {
    ($(
        $(#[$meta:meta])*
        $purity:ident fn $symbol:ident($context:ident $(, $argument:ident : $type:ty)* $(,)?) -> $result:ty $body:block
    )*) => {
        $(
            $(#[$meta])*
            ///
            /// # Safety
            /// As for `calyx_abi::SlotFn`.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $symbol(
                ctx: *mut $crate::Context,
                args: *const $crate::Slot,
                ret: *mut $crate::Slot,
            ) -> i32 {
                let count = 0 $(+ <$type as $crate::externs::Value>::SHAPE.slots())*;
                // SAFETY: the caller has the same obligations.
                unsafe {
                    $crate::externs::call::<$result>(ctx, args, count, ret, |$context, #[allow(unused)] mut arguments| {
                        let library = !stringify!($symbol).starts_with("calyx_std_");
                        $(let $argument: $type = if library {
                            arguments.take_number($context, stringify!($argument))?
                        } else {
                            arguments.take($context)?
                        };)*
                        let _ = library;
                        $body
                    })
                }
            }
        )*

        /// Functions declared here, for the interpreter and the compiler.
        pub const EXTERNS: &[$crate::Extern] = &[$(
            $crate::Extern {
                symbol: stringify!($symbol),
                purity: $crate::Purity::$purity,
                params: &[$((stringify!($argument), <$type as $crate::externs::Value>::SHAPE)),*],
                result: <$result as $crate::externs::Value>::SHAPE,
                call: $symbol,
            }
        ),*];
    };
}
