//! Parts of a scene by their indices.

/// A body of a scene, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BodyId(pub usize);
/// A bearing of a scene, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BearingId(pub usize);
/// A pair of surfaces of a scene, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PairId(pub usize);
/// An observable of a scene, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ObservableId(pub usize);
