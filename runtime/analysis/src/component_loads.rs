//! Loads of the meshes and bearings of a scene over all positions of an analysis, whether or not
//! the model has outputs for them.

use serde::{Deserialize, Serialize};

/// Rolling elements of a bearing, which determine the exponent of its life.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RollingKind {
    /// Balls.
    Balls,
    /// Rollers.
    Rollers,
}

/// Part of a scene whose loads are recorded.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Component {
    /// Mesh of two gears, by their names.
    Mesh([String; 2]),
    /// Bearing.
    Bearing {
        /// Name of the bearing.
        name: String,
        /// Kind of its rolling elements; `None` for springs.
        kind: Option<RollingKind>,
    },
}

impl Component {
    /// Returns the name in tables.
    pub fn name(&self) -> String {
        match self {
            Component::Mesh([first, second]) => format!("{first} / {second}"),
            Component::Bearing { name, .. } => name.clone(),
        }
    }
}

/// Recorded quantity of a mesh or a bearing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LoadQuantity {
    /// Magnitude of the torque of a mesh on its first gear, N m.
    Torque,
    /// Normal force of a mesh on both flanks, N.
    MeshForce,
    /// Transmission error of a mesh, rad.
    TransmissionError,
    /// Largest contact pressure of a mesh on both flanks, away from edges, Pa.
    ContactPressure,
    /// Largest contact pressure of a mesh near edges, Pa.
    EdgePressure,
    /// Largest root stress of the first gear, Pa, if the model requests stresses of it.
    FirstRootStress,
    /// Largest root stress of the second gear, Pa, if the model requests stresses of it.
    SecondRootStress,
    /// Slope of parallel axes in the plane of action, rad.
    MisalignmentSlope,
    /// Offset of parallel axes in the plane of action, m.
    MisalignmentOffset,
    /// Error of the offset of crossed axes (E), m.
    OffsetError,
    /// Error of the shaft angle of crossed axes (Sigma), rad.
    ShaftAngleError,
    /// Frictional power loss of a mesh, W, if the model requests exactly one.
    FrictionLoss,
    /// Speed of the first gear of a mesh relative to the carrier of the mesh, rad/s.
    MeshSpeed,
    /// Radial force of a bearing, N.
    RadialForce,
    /// Axial force of a bearing on its first race, along its axis, N.
    AxialForce,
    /// Tilting moment of a bearing, N m.
    TiltingMoment,
    /// Largest contact pressure of rolling elements, Pa.
    ElementPressure,
    /// Dynamic equivalent reference load of a rolling bearing (ISO/TS 16281), N.
    EquivalentLoad,
    /// Damage of a rolling bearing per revolution: inverse of the basic reference rating life in
    /// revolutions, if the model requests exactly one.
    Damage,
    /// Damage per revolution by the modified rating life, if the model requests exactly one.
    ModifiedDamage,
    /// Frictional power loss of a rolling bearing, W, if the model requests exactly one.
    BearingLoss,
    /// Speed of the first race of a bearing relative to the second, rad/s.
    BearingSpeed,
}

/// Statistics of a quantity over all positions, SI.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LoadStatistics {
    /// Smallest value.
    pub min: f64,
    /// Mean over time.
    pub mean: f64,
    /// Largest value.
    pub max: f64,
}

/// Loads of a mesh or a bearing over all positions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ComponentLoads {
    /// The mesh or bearing.
    pub component: Component,
    /// Quantities that the fidelity and the model provide.
    pub quantities: Vec<(LoadQuantity, LoadStatistics)>,
}

impl ComponentLoads {
    /// Returns the statistics of a quantity.
    pub fn of(&self, quantity: LoadQuantity) -> Option<LoadStatistics> {
        self.quantities.iter().find(|(own, _)| *own == quantity).map(|(_, statistics)| *statistics)
    }
}
