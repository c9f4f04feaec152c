//! Operations that evaluated and symbolic expressions share.

/// Operations on numbers, truth values, vectors and transforms, shared by evaluated and symbolic
/// expressions. The comments give the representations of operands and result (N number, B bool, S
/// string, V vector, T transform).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Op {
    /// N,N -> N, as for all operations up to `Divide`. `Power` is `abi::math::pow`.
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    /// N -> N
    Negate,
    /// B -> B
    Not,
    /// N,N -> B
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    /// N,N or B,B or S,S or V,V -> B. The lowering expands arrays and tuples or compares them
    /// element by element.
    Equal,
    NotEqual,
    /// N -> N
    Sqrt,
    Abs,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Exp,
    Log,
    Floor,
    Ceil,
    Round,
    /// N,N -> N: the value of a registered table ([`calyx_abi::piecewise::registered`]) at a
    /// number.
    Spline,
    /// N,N -> N
    Atan2,
    Min,
    Max,
    /// N,N,N -> V
    Vector,
    /// V -> N
    X,
    Y,
    Z,
    Norm,
    /// V,V -> V
    AddVector,
    SubtractVector,
    Cross,
    /// V -> V
    NegateVector,
    /// N,V -> V
    Scale,
    /// V,V -> N
    Dot,
    /// V -> T: transformation into a frame translated by v: `x' = x - v`.
    Translate,
    /// N,V -> T: transformation into a frame rotated by the angle about the unit axis: `x' =
    /// R(angle, axis)^T x`.
    Rotate,
    /// T,T -> T: `(A * B) x = A (B x)`.
    Compose,
    /// T,V -> V: coordinates of the point in the frame.
    Apply,
    /// T -> T
    Inverse,
    /// T -> V: the frame's origin in ground coordinates.
    Origin,
    /// T,V -> V: the direction in ground coordinates of a vector given in the frame.
    Direction,
    /// T -> V, symbolic only: velocity and acceleration of the frame's origin, angular velocity and
    /// angular acceleration of the frame, in ground coordinates.
    Velocity,
    Acceleration,
    AngularVelocity,
    AngularAcceleration,
}
