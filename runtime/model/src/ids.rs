//! Indices of the parts of a scene.

/// Index of a body in its scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BodyId(pub usize);
/// Index of a bearing in its scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BearingId(pub usize);
/// Index of an elastic connection in its scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ConnectionId(pub usize);
/// Index of a surface pair in its scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PairId(pub usize);
/// Index of an observable in its scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ObservableId(pub usize);
