//! Flank tolerances of an accuracy grade by ISO 1328-1, for data blocks and K-charts.
//!
//! The library module `iso1328` has the same formulas, and the clauses of the standard; a test
//! compares both. The formulas are numerical-value equations: millimetres give micrometres.

use crate::error::{GeometryError, sentence};

/// Limits of the reference diameter, the normal module and the face width, mm (ISO 1328-1:1995,
/// 5.2).
const DIAMETERS: &[f64] =
    &[5.0, 20.0, 50.0, 125.0, 280.0, 560.0, 1000.0, 1600.0, 2500.0, 4000.0, 6000.0, 8000.0, 10000.0];
const MODULES: &[f64] = &[0.5, 2.0, 3.5, 6.0, 10.0, 16.0, 25.0, 40.0, 70.0];
const FACE_WIDTHS: &[f64] = &[4.0, 10.0, 20.0, 40.0, 80.0, 160.0, 250.0, 400.0, 650.0, 1000.0];

/// Edition of ISO 1328-1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edition {
    /// Accuracy grades 0 to 12.
    Of1995,
    /// Flank tolerance classes 1 to 11.
    Of2013,
}

impl Edition {
    /// Edition by its year.
    pub fn named(year: &str) -> Edition {
        if year == "1995" { Edition::Of1995 } else { Edition::Of2013 }
    }

    /// Year of the edition.
    pub fn year(self) -> f64 {
        match self {
            Edition::Of1995 => 1995.0,
            Edition::Of2013 => 2013.0,
        }
    }

    /// Name of the standard.
    pub fn standard(self) -> &'static str {
        match self {
            Edition::Of1995 => "ISO 1328-1:1995",
            Edition::Of2013 => "ISO 1328-1:2013",
        }
    }

    /// Evaluation range of a profile, as a fraction of the active length.
    pub fn profile_share(self) -> f64 {
        match self {
            Edition::Of1995 => 0.92,
            Edition::Of2013 => 0.95,
        }
    }

    fn grades(self) -> [f64; 2] {
        match self {
            Edition::Of1995 => [0.0, 12.0],
            Edition::Of2013 => [1.0, 11.0],
        }
    }
}

/// Flank tolerances of a gear, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlankTolerances {
    /// Accuracy grade or flank tolerance class.
    pub grade: u8,
    /// Edition of the standard.
    pub edition: Edition,
    /// Single pitch deviation.
    pub f_pt: f64,
    /// Total cumulative pitch deviation.
    pub total_pitch: f64,
    /// Total, form and slope deviation of the profile: `F_alpha`, `f_falpha`, `f_Halpha`.
    pub profile: [f64; 3],
    /// Total, form and slope deviation of the helix: `F_beta`, `f_fbeta`, `f_Hbeta`.
    pub helix: [f64; 3],
    /// Radial runout.
    pub runout: f64,
}

impl FlankTolerances {
    /// Returns the tolerances for a reference diameter, normal module and face width, m.
    ///
    /// # Errors
    /// E0901: the edition has no such grade. E0900: a dimension is outside of its scope.
    pub fn new(
        edition: Edition,
        grade: f64,
        [diameter, module, face_width]: [f64; 3],
    ) -> Result<FlankTolerances, GeometryError> {
        let [least, most] = edition.grades();
        if !(grade >= least && grade <= most && grade.fract() == 0.0) {
            return Err(GeometryError::error(
                "E0901",
                "accuracy_grade",
                sentence![text edition.standard(), " has no accuracy grade ", number grade],
                sentence!["give a whole number from ", number least, " to ", number most],
            ));
        }
        let dimensions = [
            ("reference diameter", diameter, DIAMETERS, [5.0, 15_000.0]),
            ("normal module", module, MODULES, [0.5, 70.0]),
            ("face width", face_width, FACE_WIDTHS, [4.0, 1200.0]),
        ];
        let mut sizes = [0.0; 3];
        for (size, (name, value, limits, scope)) in sizes.iter_mut().zip(dimensions) {
            let found = match edition {
                Edition::Of1995 => range_mean(1e3 * value, limits),
                Edition::Of2013 => Some(1e3 * value).filter(|value| (scope[0]..=scope[1]).contains(value)),
            };
            let ends = match edition {
                Edition::Of1995 => {
                    [limits.first(), limits.last()].map(|end| end.copied().unwrap_or(f64::NAN))
                }
                Edition::Of2013 => scope,
            };
            *size = found.ok_or_else(|| out_of_scope(edition, name, value, ends.map(|end| 1e-3 * end)))?;
        }
        let factor = 2_f64.powf(0.5 * (grade - 5.0));
        let of = |at_grade_5: f64| 1e-6 * rounded(factor * at_grade_5);
        let [d, m, b] = sizes;
        let [f_pt, total_pitch, runout, profile, helix] = match edition {
            Edition::Of1995 => grade_5_of_1995(d, m, b),
            Edition::Of2013 => class_5_of_2013(d, m, b),
        };
        Ok(FlankTolerances {
            grade: grade as u8,
            edition,
            f_pt: of(f_pt[0]),
            total_pitch: of(total_pitch[0]),
            profile: profile.map(of),
            helix: helix.map(of),
            runout: of(runout[0]),
        })
    }
}

/// Error for a dimension outside of the scope (m) of an edition.
fn out_of_scope(edition: Edition, name: &'static str, value: f64, [least, most]: [f64; 2]) -> GeometryError {
    GeometryError::error(
        "E0900",
        "accuracy_grade",
        sentence![text edition.standard(), " has no tolerances for a ", text name, " of ", length value],
        sentence![
            "its scope extends from ", length least, " to ", length most,
            "; leave `accuracy_grade` out, or use `iso1328.flank_tolerances` with `extrapolate = TRUE`"
        ],
    )
}

/// Geometric mean of the range that contains a dimension.
fn range_mean(value: f64, limits: &[f64]) -> Option<f64> {
    let inside = |pair: &&[f64]| value >= limits[0] && value <= pair[1];
    limits.windows(2).find(inside).map(|pair| (pair[0] * pair[1]).sqrt())
}

/// Tolerances of grade 5 before rounding, um: f_pt, F_p and F_r in the first element of the first
/// three arrays, then total, form and slope deviation of profile and helix.
fn grade_5_of_1995(d: f64, m: f64, b: f64) -> [[f64; 3]; 5] {
    let (root_d, root_m, root_b) = (d.sqrt(), m.sqrt(), b.sqrt());
    let helix_part = 0.07 * root_d + 0.45 * root_b + 3.0;
    [
        [0.3 * (m + 0.4 * root_d) + 4.0, 0.0, 0.0],
        [0.3 * m + 1.25 * root_d + 7.0, 0.0, 0.0],
        [0.24 * m + 1.0 * root_d + 5.6, 0.0, 0.0],
        [
            3.2 * root_m + 0.22 * root_d + 0.7,
            2.5 * root_m + 0.17 * root_d + 0.5,
            2.0 * root_m + 0.14 * root_d + 0.5,
        ],
        [0.1 * root_d + 0.63 * root_b + 4.2, helix_part, helix_part],
    ]
}

/// Tolerances of class 5 before rounding, um, in the order of [`grade_5_of_1995`].
fn class_5_of_2013(d: f64, m: f64, b: f64) -> [[f64; 3]; 5] {
    let profile_slope = 0.4 * m + 0.001 * d + 4.0;
    let profile_form = 0.55 * m + 5.0;
    let helix_slope = 0.05 * d.sqrt() + 0.35 * b.sqrt() + 4.0;
    let helix_form = 0.07 * d.sqrt() + 0.45 * b.sqrt() + 4.0;
    let total_pitch = 0.002 * d + 0.55 * d.sqrt() + 0.7 * m + 12.0;
    let total = |form: f64, slope: f64| (slope * slope + form * form).sqrt();
    [
        [0.001 * d + 0.4 * m + 5.0, 0.0, 0.0],
        [total_pitch, 0.0, 0.0],
        [0.9 * total_pitch, 0.0, 0.0],
        [total(profile_form, profile_slope), profile_form, profile_slope],
        [total(helix_form, helix_slope), helix_form, helix_slope],
    ]
}

/// Rounded tolerance, um (ISO 1328-1:1995, 5.4; ISO 1328-1:2013, 5.2.3).
fn rounded(value: f64) -> f64 {
    match value {
        _ if value > 10.0 => value.round(),
        _ if value >= 5.0 => (2.0 * value).round() / 2.0,
        _ => (10.0 * value).round() / 10.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of the tables of ISO 1328-1:1995 for d from 50 to 125 mm, m from 2 to 3.5 mm and b from
    /// 20 to 40 mm, grade 6.
    #[test]
    fn grade_6_of_1995_has_the_values_of_its_tables() {
        let found = FlankTolerances::new(Edition::Of1995, 6.0, [0.088, 0.003, 0.030]).unwrap();
        let um = |values: [f64; 3]| values.map(|value| (1e7 * value).round() / 10.0);
        assert_eq!(um([found.f_pt, found.total_pitch, found.runout]), [8.5, 27.0, 21.0]);
        assert_eq!(um(found.profile), [11.0, 8.5, 7.0]);
        assert_eq!(um(found.helix), [12.0, 8.5, 8.5]);
    }

    #[test]
    fn grades_and_dimensions_outside_of_the_standard_are_errors() {
        let code = |edition, grade, size| FlankTolerances::new(edition, grade, size).unwrap_err().code;
        assert_eq!(code(Edition::Of2013, 12.0, [0.1, 0.003, 0.03]), "E0901");
        assert_eq!(code(Edition::Of1995, 6.5, [0.1, 0.003, 0.03]), "E0901");
        assert_eq!(code(Edition::Of2013, f64::NAN, [0.1, 0.003, 0.03]), "E0901");
        assert_eq!(code(Edition::Of1995, 6.0, [0.1, 0.000_3, 0.03]), "E0900");
        assert_eq!(code(Edition::Of2013, 6.0, [0.1, 0.003, 0.003]), "E0900");
    }
}
