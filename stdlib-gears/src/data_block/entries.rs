//! Entries of a data block: symbols, names, units and the format of their values.

use crate::host::LengthUnit;

/// Value of an entry.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// Number in SI.
    Number(f64),
    /// Name, such as that of a material.
    Text(String),
}

impl From<f64> for Value {
    fn from(number: f64) -> Value {
        Value::Number(number)
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Value {
        Value::Text(text.to_owned())
    }
}

/// Kind of an entry, which determines its unit and its format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EntryKind {
    /// Name.
    Text,
    /// Integer.
    Count,
    /// Dimensionless number.
    Number,
    /// Length.
    Length,
    /// Tolerance of a flank, micrometres or microinches.
    Tolerance,
    /// Diametral pitch.
    Pitch,
    /// Angle.
    Angle,
    /// Mass.
    Mass,
    /// Moment of inertia.
    Inertia,
}

/// Unit in which values are displayed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DisplayUnit {
    /// Name; empty for numbers.
    pub name: &'static str,
    /// Size in SI.
    pub factor: f64,
}

/// Size of the avoirdupois pound, kg.
const POUND: f64 = 0.453_592_37;
/// Significant digits of masses and moments of inertia.
const DIGITS: i32 = 5;

impl EntryKind {
    /// SI unit; empty for numbers and names.
    pub fn si(self) -> &'static str {
        match self {
            EntryKind::Text | EntryKind::Count | EntryKind::Number => "",
            EntryKind::Length | EntryKind::Tolerance => "m",
            EntryKind::Pitch => "1/m",
            EntryKind::Angle => "rad",
            EntryKind::Mass => "kg",
            EntryKind::Inertia => "kg*m^2",
        }
    }

    /// Returns the unit of a drawing with this unit of lengths.
    pub fn unit(self, length: LengthUnit) -> DisplayUnit {
        let metric = length.name == "mm";
        let unit = |name, factor| DisplayUnit { name, factor };
        match self {
            EntryKind::Text | EntryKind::Count | EntryKind::Number => unit("", 1.0),
            EntryKind::Length => unit(length.name, length.metres),
            EntryKind::Tolerance if metric => unit("um", 1e-6),
            EntryKind::Tolerance => unit("microinch", 0.0254e-6),
            EntryKind::Pitch if metric => unit("1/mm", 1.0 / length.metres),
            EntryKind::Pitch => unit("1/inch", 1.0 / length.metres),
            EntryKind::Angle => unit("deg", std::f64::consts::PI / 180.0),
            EntryKind::Mass if metric => unit("kg", 1.0),
            EntryKind::Mass => unit("lbm", POUND),
            EntryKind::Inertia if metric => unit("kg*mm^2", length.metres * length.metres),
            EntryKind::Inertia => unit("lbm*inch^2", POUND * length.metres * length.metres),
        }
    }

    /// Formats a value without its unit: millimetres and degrees with four decimals, inches with
    /// five, masses and moments of inertia with five significant digits.
    pub fn shown(self, value: &Value, length: LengthUnit) -> String {
        let number = match value {
            Value::Text(text) => return text.clone(),
            Value::Number(number) => number / self.unit(length).factor,
        };
        let decimals = match self {
            EntryKind::Text | EntryKind::Count => 0,
            EntryKind::Tolerance if length.name != "mm" => 0,
            EntryKind::Tolerance => 1,
            EntryKind::Length if length.name != "mm" => 5,
            EntryKind::Mass | EntryKind::Inertia if number != 0.0 && number.is_finite() => {
                (DIGITS - 1 - number.abs().log10().floor() as i32).clamp(0, 12) as usize
            }
            _ => 4,
        };
        let text = format!("{number:.decimals$}");
        // Rounding to zero leaves the sign of a small negative number.
        match text.strip_prefix('-') {
            Some(digits) if digits.bytes().all(|digit| matches!(digit, b'0' | b'.')) => digits.to_owned(),
            _ => text,
        }
    }
}

/// Entry of a data block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Name in `run.json`: the symbol, if it is unique.
    pub key: &'static str,
    /// Symbol of ISO 21771 or DIN 21773; empty for names.
    pub symbol: &'static str,
    /// Term.
    pub name: &'static str,
    /// Kind of its value.
    pub kind: EntryKind,
    /// True for the first entry of a group.
    pub starts_group: bool,
}

/// Entry whose key is its symbol.
const fn of(symbol: &'static str, name: &'static str, kind: EntryKind) -> Entry {
    keyed(symbol, symbol, name, kind)
}

const fn keyed(key: &'static str, symbol: &'static str, name: &'static str, kind: EntryKind) -> Entry {
    Entry { key, symbol, name, kind, starts_group: false }
}

const fn named(key: &'static str, name: &'static str) -> Entry {
    keyed(key, "", name, EntryKind::Text)
}

const fn first(entry: Entry) -> Entry {
    Entry { starts_group: true, ..entry }
}

/// Entries of a gear, in the order of display.
pub const GEAR_ENTRIES: &[Entry] = &[
    first(of("z", "number of teeth", EntryKind::Count)),
    named("type", "type"),
    of("P_nd", "normal diametral pitch", EntryKind::Pitch),
    of("P_td", "transverse diametral pitch", EntryKind::Pitch),
    of("m_n", "normal module", EntryKind::Length),
    of("m_t", "transverse module", EntryKind::Length),
    of("alpha_n", "normal pressure angle", EntryKind::Angle),
    of("alpha_t", "transverse pressure angle", EntryKind::Angle),
    of("beta", "helix angle", EntryKind::Angle),
    named("hand", "hand of the helix"),
    of("beta_b", "base helix angle", EntryKind::Angle),
    of("p_z", "lead", EntryKind::Length),
    named("rack", "basic rack"),
    of("h_aP", "addendum of the rack, in modules", EntryKind::Number),
    of("h_fP", "dedendum of the rack, in modules", EntryKind::Number),
    of("rho_fP", "fillet radius of the rack, in modules", EntryKind::Number),
    of("s_pr", "residual undercut by the protuberance", EntryKind::Length),
    of("x", "profile shift coefficient", EntryKind::Number),
    of("x_E", "generating profile shift coefficient", EntryKind::Number),
    of("k", "tip alteration coefficient", EntryKind::Number),
    of("x - x_min", "profile shift above undercut", EntryKind::Number),
    of("x_E - x_Emin", "generating profile shift above undercut", EntryKind::Number),
    first(of("d", "reference diameter", EntryKind::Length)),
    of("d_b", "base diameter", EntryKind::Length),
    of("d_a", "tip diameter", EntryKind::Length),
    of("d_Fa", "tip form diameter", EntryKind::Length),
    of("d_Ff", "root form diameter", EntryKind::Length),
    of("d_FfE", "root form diameter, generated", EntryKind::Length),
    of("d_f", "root diameter, nominal", EntryKind::Length),
    of("d_fE", "root diameter, generated", EntryKind::Length),
    of("h", "tooth depth, nominal", EntryKind::Length),
    of("h_E", "tooth depth, generated", EntryKind::Length),
    first(of("s_n", "normal tooth thickness, nominal", EntryKind::Length)),
    of("s_ns", "normal tooth thickness, maximum", EntryKind::Length),
    of("s_nm", "normal tooth thickness, mean", EntryKind::Length),
    of("s_ni", "normal tooth thickness, minimum", EntryKind::Length),
    of("s_t", "transverse tooth thickness, nominal", EntryKind::Length),
    of("s_ts", "transverse tooth thickness, maximum", EntryKind::Length),
    of("s_tm", "transverse tooth thickness, mean", EntryKind::Length),
    of("s_ti", "transverse tooth thickness, minimum", EntryKind::Length),
    named("thickness_limit", "thickness in the analysis"),
    of("s_an", "normal tooth thickness at the tip, nominal", EntryKind::Length),
    of("s_anE", "normal tooth thickness at the tip, generated", EntryKind::Length),
    keyed("span_teeth", "k", "number of teeth of the span", EntryKind::Count),
    of("W_k", "span measurement, nominal", EntryKind::Length),
    of("W_ks", "span measurement, maximum", EntryKind::Length),
    of("W_km", "span measurement, mean", EntryKind::Length),
    of("W_ki", "span measurement, minimum", EntryKind::Length),
    of("D_M", "ball diameter", EntryKind::Length),
    of("M_dK", "dimension over balls, nominal", EntryKind::Length),
    of("M_dKs", "dimension over balls, upper limit", EntryKind::Length),
    of("M_dKm", "dimension over balls, mean", EntryKind::Length),
    of("M_dKi", "dimension over balls, lower limit", EntryKind::Length),
    first(named("accuracy_grade", "accuracy grade")),
    of("f_pt", "single pitch tolerance", EntryKind::Tolerance),
    of("F_p", "total cumulative pitch tolerance", EntryKind::Tolerance),
    of("F_alpha", "total profile tolerance", EntryKind::Tolerance),
    of("f_falpha", "profile form tolerance", EntryKind::Tolerance),
    of("f_Halpha", "profile slope tolerance, plus and minus", EntryKind::Tolerance),
    of("F_beta", "total helix tolerance", EntryKind::Tolerance),
    of("f_fbeta", "helix form tolerance", EntryKind::Tolerance),
    of("f_Hbeta", "helix slope tolerance, plus and minus", EntryKind::Tolerance),
    of("F_r", "runout tolerance", EntryKind::Tolerance),
    first(of("b", "face width", EntryKind::Length)),
    named("material", "material"),
    keyed("mass", "m", "mass", EntryKind::Mass),
    keyed("inertia", "J", "moment of inertia about the axis", EntryKind::Inertia),
];

/// Entries that both gears of a mesh have in common.
pub const MESH_ENTRIES: &[Entry] = &[
    first(of("a", "centre distance", EntryKind::Length)),
    of("a_d", "reference centre distance", EntryKind::Length),
    of("u", "gear ratio", EntryKind::Number),
    of("alpha_wt", "transverse operating pressure angle", EntryKind::Angle),
    of("alpha_wn", "normal operating pressure angle", EntryKind::Angle),
    of("beta_w", "operating helix angle", EntryKind::Angle),
    of("epsilon_alpha", "transverse contact ratio", EntryKind::Number),
    of("epsilon_beta", "overlap ratio", EntryKind::Number),
    of("epsilon_gamma", "total contact ratio", EntryKind::Number),
    of("g_alpha", "length of the path of contact", EntryKind::Length),
    of("j_bn", "normal backlash", EntryKind::Length),
    of("j_wt", "circumferential backlash", EntryKind::Length),
    of("j_wt_min", "circumferential backlash, minimum", EntryKind::Length),
    of("j_wt_max", "circumferential backlash, maximum", EntryKind::Length),
    keyed("tip_margin", "", "margin to interference of the tips", EntryKind::Angle),
];

/// Entries of each gear of a mesh.
pub const MEMBER_ENTRIES: &[Entry] = &[
    first(of("d_w", "operating pitch diameter", EntryKind::Length)),
    of("d_Nf", "start of active profile (SAP), diameter", EntryKind::Length),
    of("d_LPSTC", "lowest single-tooth contact (LPSTC), diameter", EntryKind::Length),
    of("d_HPSTC", "highest single-tooth contact (HPSTC), diameter", EntryKind::Length),
    of("d_Na", "end of active profile (EAP), diameter", EntryKind::Length),
    of("c_F", "active profile above the root form circle", EntryKind::Length),
    of("c_FE", "active profile above the generated root form circle", EntryKind::Length),
    of("c", "tip clearance at the root, nominal", EntryKind::Length),
    of("c_E", "tip clearance at the root, generated", EntryKind::Length),
    of("zeta_max", "largest specific sliding", EntryKind::Number),
    of("j_phi", "angular backlash", EntryKind::Angle),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_unique() {
        for entries in [GEAR_ENTRIES, MESH_ENTRIES, MEMBER_ENTRIES] {
            for (index, entry) in entries.iter().enumerate() {
                assert!(entries[..index].iter().all(|other| other.key != entry.key), "{}", entry.key);
            }
        }
    }

    #[test]
    fn values_have_the_digits_of_a_drawing() {
        let (mm, inch) = (LengthUnit::default(), LengthUnit::of_system("inch_lbf_s"));
        for (kind, value, unit, text) in [
            (EntryKind::Count, 19.0, mm, "19"),
            (EntryKind::Length, 0.066_245_3, mm, "66.2453"),
            (EntryKind::Length, 0.0254, inch, "1.00000"),
            (EntryKind::Length, -1e-12, mm, "0.0000"),
            (EntryKind::Angle, 14_f64.to_radians(), mm, "14.0000"),
            (EntryKind::Pitch, 10.0 / 0.0254, inch, "10.0000"),
            (EntryKind::Mass, 0.679_41, mm, "0.67941"),
            (EntryKind::Mass, 453.592_37, inch, "1000.0"),
            (EntryKind::Inertia, 1.234_56e-4, mm, "123.46"),
            (EntryKind::Number, -0.1, mm, "-0.1000"),
        ] {
            assert_eq!(kind.shown(&Value::Number(value), unit), text);
        }
    }
}
