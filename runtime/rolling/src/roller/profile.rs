//! Relief of a roller profile.

use crate::error::{RollingError, positive};
use libm::log;

/// Relief of the roller profile along a contact line: the gap at distance x from mid-length when
/// the contact just touches there.
#[derive(Clone, Debug, PartialEq)]
pub enum Profile {
    /// Straight contact line.
    Straight,
    /// Logarithmic relief of ISO/TS 16281: 0.00035 D ln(1 / (1 - (2x/L)²)).
    Logarithmic,
    /// Circular crown: x² / (2R).
    Crowned {
        /// Crown radius R, m.
        radius: f64,
    },
    /// Relief by linear interpolation in a table with increasing positions.
    Table {
        /// Pairs of position from mid-length and relief, m.
        points: Vec<[f64; 2]>,
    },
}

impl Profile {
    /// Checks crown radius or table.
    pub(super) fn check(&self, length: f64) -> Result<(), RollingError> {
        match self {
            Self::Straight | Self::Logarithmic => Ok(()),
            Self::Crowned { radius } => positive("crown radius", *radius),
            Self::Table { points } => {
                let finite = points.iter().flatten().all(|value| value.is_finite());
                let increasing = points.windows(2).all(|pair| pair[0][0] < pair[1][0]);
                let spans = points.len() > 1
                    && points[0][0] <= -0.49 * length
                    && points[points.len() - 1][0] >= 0.49 * length;
                if finite && increasing && spans {
                    return Ok(());
                }
                Err(RollingError::input(
                    "the table of the roller profile does not have increasing positions over the roller's length",
                    format!(
                        "give pairs of position and relief from {:.4} mm to {:.4} mm",
                        -0.5e3 * length,
                        0.5e3 * length
                    ),
                )
.of("profile_relief"))
            }
        }
    }

    /// Returns the relief, m, at a position on a roller of this length and diameter, m.
    pub(super) fn relief(&self, position: f64, length: f64, diameter: f64) -> f64 {
        match self {
            Self::Straight => 0.0,
            Self::Logarithmic => {
                let relative = 2.0 * position / length;
                -0.00035 * diameter * log(1.0 - relative * relative)
            }
            Self::Crowned { radius } => 0.5 * position * position / radius,
            Self::Table { points } => {
                let last = points.len() - 1;
                let at = points.partition_point(|point| point[0] <= position).clamp(1, last);
                let ([from, first], [to, second]) = (points[at - 1], points[at]);
                let part = ((position - from) / (to - from)).clamp(0.0, 1.0);
                first + part * (second - first)
            }
        }
    }
}
