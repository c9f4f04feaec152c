//! Lubrication of a gear mesh: friction, flash temperature and film thickness at a point of
//! contact.
//!
//! All formulas are local: they use the line load, the relative curvature and the rolling
//! velocities of the point. See `docs/theory/tribology.md`.

use std::f64::consts::PI;

/// Absolute temperature of 0 degrees Celsius, K.
const CELSIUS: f64 = 273.15;
/// Blok's coefficient of the flash temperature of a band with a semi-elliptic heat flux (ISO/TS
/// 6336-20).
const BLOK: f64 = 1.11;

/// Base oil of a lubricant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BaseOil {
    /// Mineral oil.
    #[default]
    Mineral,
    /// Polyalphaolefin.
    Polyalphaolefin,
    /// Polyglycol.
    Polyglycol,
}

/// Lubricating oil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oil {
    /// Kinematic viscosities at 40 and at 100 degrees Celsius, m²/s.
    pub viscosities: [f64; 2],
    /// Density at 15 degrees Celsius, kg/m³.
    pub density: f64,
    /// Base oil.
    pub base: BaseOil,
}

impl Oil {
    /// Returns the kinematic viscosity at a temperature in degrees Celsius, m²/s:
    /// log(log(nu + 0.7)) is linear in log(T), with nu in mm²/s (ASTM D341).
    pub fn kinematic_viscosity(&self, celsius: f64) -> f64 {
        let double_log = |viscosity: f64| (1e6 * viscosity + 0.7).log10().ln();
        let [at_40, at_100] = self.viscosities.map(double_log);
        let slope = (at_40 - at_100) / ((100.0 + CELSIUS) / (40.0 + CELSIUS)).ln();
        let value = at_40 - slope * ((celsius + CELSIUS) / (40.0 + CELSIUS)).ln();
        1e-6 * (10f64.powf(value.exp()) - 0.7)
    }

    /// Returns the dynamic viscosity at a temperature in degrees Celsius, Pa s. The density falls
    /// by 0.7 kg/m³ per kelvin (ISO/TS 6336-22).
    pub fn dynamic_viscosity(&self, celsius: f64) -> f64 {
        self.kinematic_viscosity(celsius) * (self.density - 0.7 * (celsius + 273.0 - 289.0))
    }

    /// Returns the pressure-viscosity coefficient at a temperature in degrees Celsius, 1/Pa (ISO/TS
    /// 6336-22).
    pub fn pressure_viscosity(&self, celsius: f64) -> f64 {
        let at_38 = self.dynamic_viscosity(38.0);
        let [scale, exponent] = match self.base {
            BaseOil::Mineral => [2.657e-8, 0.1348],
            BaseOil::Polyalphaolefin => [1.466e-8, 0.0507],
            BaseOil::Polyglycol => [1.392e-8, 0.1572],
        };
        scale * at_38.powf(exponent) * (1.0 + 516.0 * (1.0 / (celsius + 273.0) - 1.0 / 311.0))
    }

    /// Lubricant factor `X_L` of the coefficient of friction (ISO/TS 6336-22).
    fn friction_factor(&self) -> f64 {
        match self.base {
            BaseOil::Mineral => 1.0,
            BaseOil::Polyalphaolefin => 0.8,
            BaseOil::Polyglycol => 0.7,
        }
    }
}

/// Lubrication of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lubrication {
    /// The oil.
    pub oil: Oil,
    /// Temperature of the oil that is supplied to the mesh, degrees Celsius.
    pub oil_temperature: f64,
    /// Bulk temperature of the teeth, degrees Celsius.
    pub bulk_temperature: f64,
    /// Mean of the arithmetic roughnesses of both flanks, m.
    pub roughness: f64,
    /// Constant coefficient of friction; `None` for the local one of [`Lubrication::friction`].
    pub friction: Option<f64>,
    /// Thermal contact coefficients of both bodies, sqrt(conductivity · density · specific heat),
    /// W s^0.5/(m² K).
    pub thermal_contact: [f64; 2],
}

/// Rolling contact at a point of a contact line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingContact {
    /// Normal force per length of the contact line, N/m.
    pub line_load: f64,
    /// Sum of both curvatures across the contact line, 1/m.
    pub curvature: f64,
    /// Contact modulus, 1/E* = 1/E'1 + 1/E'2, Pa.
    pub modulus: f64,
    /// Velocities with which both surfaces move through the contact, across the contact line, m/s.
    pub rolling: [f64; 2],
    /// Velocities with which both surfaces move along the contact line, m/s.
    pub along: [f64; 2],
    /// Sliding speed, m/s: magnitude of the difference of both velocities, across and along.
    pub sliding: f64,
    /// Loaded length of the contact line, m.
    pub length: f64,
}

impl RollingContact {
    /// Half-width of the Hertzian contact of the line load, m (Johnson, eq. 4.43).
    pub fn half_width(&self) -> f64 {
        (4.0 * self.line_load / (PI * self.modulus * self.curvature)).sqrt()
    }

    /// Largest pressure of the Hertzian contact of the line load, Pa.
    pub fn hertz_pressure(&self) -> f64 {
        (self.line_load * self.modulus * self.curvature / PI).sqrt()
    }

    /// Magnitude of the sum of both rolling velocities, m/s.
    pub fn sum_velocity(&self) -> f64 {
        (self.rolling[0] + self.rolling[1]).abs()
    }

    /// Returns the velocities that determine the time for which each surface is heated, m/s: width
    /// of the contact over this time. A surface leaves the contact across the contact line or, if
    /// it hardly moves in that direction, at its end.
    fn passing_velocities(&self) -> [f64; 2] {
        let aspect = 2.0 * self.half_width() / self.length;
        [0, 1].map(|side| self.rolling[side].abs().max(aspect * self.along[side].abs()))
    }
}

impl Lubrication {
    /// Returns the local coefficient of friction: a constant, or that of ISO/TS 6336-22 with the
    /// local load, sum of velocities and radius of relative curvature,
    /// `0.045 (w/(v_sum rho))^0.2 eta^-0.05 X_R X_L` with `X_R = 2.2 (Ra/rho)^0.25`, in N/mm, m/s,
    /// mm, mPa s and um. 0 without motion.
    pub fn friction(&self, contact: &RollingContact) -> f64 {
        let (radius, sum) = (1e3 / contact.curvature, contact.sum_velocity());
        self.friction.unwrap_or_else(|| {
            if sum == 0.0 {
                return 0.0;
            }
            let rough = 2.2 * (1e6 * self.roughness / radius).powf(0.25);
            let viscosity = 1e3 * self.oil.dynamic_viscosity(self.oil_temperature);
            let load = 1e-3 * contact.line_load / (sum * radius);
            0.045 * load.powf(0.2) * viscosity.powf(-0.05) * rough * self.oil.friction_factor()
        })
    }

    /// Returns the frictional power per length of the contact line, W/m.
    pub fn friction_power(&self, contact: &RollingContact) -> f64 {
        self.friction(contact) * contact.line_load * contact.sliding
    }

    /// Returns Blok's flash temperature, K:
    /// `1.11 mu w |v1 - v2| / (sqrt(2 b) (B1 sqrt(v1) + B2 sqrt(v2)))`, with the Hertzian
    /// half-width `b` and the thermal contact coefficients `B` (ISO/TS 6336-20). 0 without sliding.
    /// The velocity of a surface that hardly moves across the contact line is the one for which the
    /// time of heating is the same.
    pub fn flash_temperature(&self, contact: &RollingContact) -> f64 {
        BLOK * self.heating(contact)
    }

    /// Contact temperature, degrees Celsius: bulk temperature plus flash temperature.
    pub fn contact_temperature(&self, contact: &RollingContact) -> f64 {
        self.bulk_temperature + self.flash_temperature(contact)
    }

    /// Returns the flash temperature of a heat flux of unit coefficient, K.
    fn heating(&self, contact: &RollingContact) -> f64 {
        let power = self.friction_power(contact);
        if power == 0.0 {
            return 0.0;
        }
        let passing = contact.passing_velocities();
        let cooling: f64 = (0..2).map(|side| self.thermal_contact[side] * passing[side].sqrt()).sum();
        power / ((2.0 * contact.half_width()).sqrt() * cooling)
    }

    /// Returns the least film thickness of Dowson and Higginson with the thermal correction of
    /// ISO/TS 6336-22, m: `1.6 rho G_M^0.6 U^0.7 W^-0.13 S^0.22`. 0 without motion.
    pub fn film_thickness(&self, contact: &RollingContact) -> f64 {
        let (radius, modulus) = (1.0 / contact.curvature, 2.0 * contact.modulus);
        let sum = contact.sum_velocity();
        if sum == 0.0 {
            return 0.0;
        }
        // The flash temperature of this standard is that of a band with a uniform heat flux.
        let flash = 2.0 / PI.sqrt() * self.heating(contact);
        let [hot, bulk] = [self.bulk_temperature + flash, self.bulk_temperature]
            .map(|celsius| [self.oil.pressure_viscosity(celsius), self.oil.dynamic_viscosity(celsius)]);
        let material = bulk[0] * modulus;
        let speed = bulk[1] * sum / (2.0 * modulus * radius);
        let load = 2.0 * PI * (contact.hertz_pressure() / modulus).powi(2);
        let sliding = hot[0] * hot[1] / (bulk[0] * bulk[1]);
        1.6 * radius * material.powf(0.6) * speed.powf(0.7) * load.powf(-0.13) * sliding.powf(0.22)
    }

    /// Returns the specific film thickness: film thickness over mean roughness.
    pub fn specific_film_thickness(&self, contact: &RollingContact) -> f64 {
        self.film_thickness(contact) / self.roughness
    }
}
