//! Units of the quantities that the page shows in addition to outputs, by the model's system of
//! units.

/// A unit of plots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    pub name: &'static str,
    /// Value of the unit in SI.
    pub size: f64,
}

impl Unit {
    /// Converts a number in SI to this unit.
    pub fn of(self, si: f64) -> f64 {
        si / self.size
    }
}

/// Units of plots of contact and stress.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    pub length: Unit,
    pub force: Unit,
    pub line_load: Unit,
    pub stress: Unit,
    /// Thickness of a lubricant film.
    pub film: Unit,
    pub velocity: Unit,
    /// Power per length of a contact line.
    pub line_power: Unit,
}

const METRIC: Units = Units {
    length: Unit { name: "mm", size: 1e-3 },
    force: Unit { name: "N", size: 1.0 },
    line_load: Unit { name: "N/mm", size: 1e3 },
    stress: Unit { name: "MPa", size: 1e6 },
    film: Unit { name: "um", size: 1e-6 },
    velocity: Unit { name: "m/s", size: 1.0 },
    line_power: Unit { name: "W/mm", size: 1e3 },
};

const POUND: f64 = 4.4482216152605;
const INCH: f64 = 0.0254;

const IMPERIAL: Units = Units {
    length: Unit { name: "inch", size: INCH },
    force: Unit { name: "lbf", size: POUND },
    line_load: Unit { name: "lbf/inch", size: POUND / INCH },
    stress: Unit { name: "psi", size: POUND / (INCH * INCH) },
    film: Unit { name: "microinch", size: 1e-6 * INCH },
    velocity: Unit { name: "inch/s", size: INCH },
    line_power: Unit { name: "lbf/s", size: POUND },
};

impl Units {
    /// Returns the units of a system by its name: `SI`, `mm_N_s`, `inch_lbf_s`.
    pub fn of_system(name: &str) -> Units {
        if name == "inch_lbf_s" { IMPERIAL } else { METRIC }
    }
}

/// Returns the unit of time in which the longest of these times (s) is a number from 1 to 1000, or
/// seconds.
pub fn clock(times: impl Iterator<Item = f64>) -> Unit {
    const UNITS: [Unit; 3] =
        [Unit { name: "s", size: 1.0 }, Unit { name: "ms", size: 1e-3 }, Unit { name: "us", size: 1e-6 }];
    let longest = times.map(f64::abs).fold(0.0, f64::max);
    UNITS.into_iter().find(|unit| unit.of(longest) >= 1.0).unwrap_or(UNITS[0])
}
