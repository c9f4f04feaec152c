//! Arrays as tuples of bytes, type and shape: `numpy.frombuffer(bytes, type).reshape(shape)`.
//!
//! The stable ABI has no buffer protocol before Python 3.11, and the C interface of NumPy is not
//! needed for contiguous numbers.

use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// Element of an array.
pub trait Element: Copy {
    /// Type string of NumPy.
    const TYPE: &'static str;
    /// Bytes of a number in the order of this machine.
    type Bytes: AsRef<[u8]>;
    fn bytes(self) -> Self::Bytes;
}

macro_rules! element {
    ($type:ty, $name:literal, $size:literal) => {
        impl Element for $type {
            const TYPE: &'static str = $name;
            type Bytes = [u8; $size];
            fn bytes(self) -> [u8; $size] {
                self.to_ne_bytes()
            }
        }
    };
}

element!(f64, "f8", 8);
element!(i64, "i8", 8);
element!(u8, "u1", 1);

/// Array in Python: bytes, type string of NumPy, shape.
pub type Array<'py> = (Bound<'py, PyBytes>, &'static str, Vec<usize>);

/// Creates an array of as many dimensions as the shape has.
pub fn shaped<'py, T: Element>(py: Python<'py>, elements: &[T], shape: Vec<usize>) -> PyResult<Array<'py>> {
    let size = size_of::<T>();
    let bytes = PyBytes::new_with(py, size_of_val(elements), |buffer| {
        for (element, bytes) in elements.iter().zip(buffer.chunks_exact_mut(size)) {
            bytes.copy_from_slice(element.bytes().as_ref());
        }
        Ok(())
    })?;
    Ok((bytes, T::TYPE, shape))
}

/// Creates an array of one dimension.
pub fn array<'py, T: Element>(py: Python<'py>, elements: &[T]) -> PyResult<Array<'py>> {
    shaped(py, elements, vec![elements.len()])
}

/// Creates an array whose rows have `N` elements.
pub fn rows<'py, T: Element, const N: usize>(py: Python<'py>, rows: &[[T; N]]) -> PyResult<Array<'py>> {
    shaped(py, rows.as_flattened(), vec![rows.len(), N])
}
