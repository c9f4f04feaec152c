//! Hash maps and sets of the front end. Keys are small and numerous: locations, numbers of
//! variables and functions, short names. A fast hash without protection against crafted collisions
//! suits them.

pub(crate) use rustc_hash::{FxHashMap as HashMap, FxHashSet as HashSet};
