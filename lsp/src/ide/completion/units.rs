//! Completion of units after numbers and in formats: first those of the expected dimension and the
//! file's unit system.

use super::context::{CompletionSite, Operator, Value};
use super::item::{Insert, Item, ItemKind, Rank, Subject};
use super::request::Request;
use crate::ide::callee;
use crate::ide::shape::{Fit, Shape};
use calyx_lang::analysis::NameKind;
use calyx_lang::dimension::{Dimension, Rational};
use calyx_lang::lexer::Kind;
use calyx_lang::units::{Unit, UnitSystem};

/// Compound units common in engineering, in the order they are offered.
const COMPOUND: &[&str] = &[
    "N*m",
    "N*mm",
    "kN*m",
    "lbf*inch",
    "lbf*ft",
    "rad/s",
    "deg/s",
    "rad/s^2",
    "mm^2",
    "cm^2",
    "m^2",
    "inch^2",
    "mm^3",
    "cm^3",
    "m^3",
    "inch^3",
    "mm^4",
    "inch^4",
    "1/mm",
    "1/m",
    "1/inch",
    "m/s",
    "mm/s",
    "inch/s",
    "ft/s",
    "m/s^2",
    "mm/s^2",
    "inch/s^2",
    "ft/s^2",
    "N/mm",
    "N/um",
    "N/m",
    "lbf/inch",
    "N*m/rad",
    "N*mm/rad",
    "lbf*inch/rad",
    "mm/N",
    "um/N",
    "inch/lbf",
    "kg/m^3",
    "g/cm^3",
    "tonne/mm^3",
    "lbm/inch^3",
    "lbf*s^2/inch^4",
    "kg*m^2",
    "kg*mm^2",
    "lbf*inch*s^2",
    "N*s/m",
    "N*s/mm",
    "lbf*s/inch",
    "N*m*s/rad",
    "lbf*inch*s/rad",
    "Pa*s",
    "mm^2/s",
    "kg*m/s",
    "N*mm/s",
    "lbf*inch/s",
];

/// Units of systems other than metric ones.
const OF_INCH: &[&str] = &["inch", "ft", "mil", "microinch", "lbm", "slug", "lbf", "psi", "ksi", "Msi", "hp"];

/// Units seldom used for gears.
const SELDOM: &[&str] =
    &["m", "cm", "km", "ft", "J", "bar", "kgf", "MN", "Msi", "slug", "hour", "us", "rev", "arcmin", "arcsec"];

/// Preferred units of angle and angular velocity, in all unit systems.
const PREFERRED: &[(&str, &str)] = &[("Angle", "deg"), ("AngularVelocity", "rpm")];

/// A unit to offer.
struct Offered {
    name: String,
    dimension: Dimension,
    factor: f64,
}

/// Offers units after a number, or after a number with a unit and a `*` or `/`.
pub fn units(request: &Request<'_>, items: &mut Vec<Item>) {
    let expected = &request.expected;
    match &request.context.spot {
        CompletionSite::Unit(..) => {
            if let Some(wanted) = wanted(request) {
                offer(request, &expected.shape, wanted, items, &insert_behind_number);
            }
        }
        CompletionSite::Value(Value { operator: Operator::Factor(left, _), .. })
            if request.context.around.kind(left.start) == Some(Kind::Number)
                && request.quantity(left).is_some() =>
        {
            let dimension = expected.shape.dimension().or(expected.hint).filter(|d| !d.is_none());
            let wanted = ExpectedUnit { dimension, sure: true, rest: typed(request), compound: false };
            offer(request, &expected.shape, wanted, items, &|unit| unit.name.clone());
        }
        _ => {}
    }
}

/// Offers units in a format, of the dimension of the formatted value.
pub fn format_units(request: &Request<'_>, shape: &Shape, items: &mut Vec<Item>) {
    let wanted = ExpectedUnit {
        dimension: shape.dimension(),
        sure: true,
        rest: shape.dimension().is_none(),
        compound: true,
    };
    offer(request, shape, wanted, items, &|unit| unit.name.clone());
}

struct ExpectedUnit {
    dimension: Option<Dimension>,
    /// True if the type requires the dimension, false if a name only suggests it.
    sure: bool,
    /// True if units of other dimensions are offered too.
    rest: bool,
    /// True if compound units are offered too.
    compound: bool,
}

/// Returns the expected unit; `None` if no unit is valid after the number.
fn wanted(request: &Request<'_>) -> Option<ExpectedUnit> {
    let expected = &request.expected;
    let typed = typed(request);
    match &expected.shape {
        Shape::Number(Some(dimension)) | Shape::Vector(Some(dimension)) if dimension.is_none() => {
            typed.then_some(ExpectedUnit { dimension: None, sure: true, rest: true, compound: false })
        }
        Shape::Number(Some(dimension)) | Shape::Vector(Some(dimension)) => {
            let sure = !expected.weak;
            Some(ExpectedUnit { dimension: Some(*dimension), sure, rest: typed || !sure, compound: true })
        }
        Shape::Named(name) if name == "String" || (name == "Bool" && !expected.weak) => None,
        // A declared dimension has declared units.
        Shape::Named(_) if !expected.weak => {
            Some(ExpectedUnit { dimension: None, sure: true, rest: typed, compound: false })
        }
        _ => Some(ExpectedUnit { dimension: expected.hint, sure: false, rest: true, compound: true }),
    }
}

fn typed(request: &Request<'_>) -> bool {
    !request.context.around.prefix().is_empty()
}

/// Formats `10 / inch`: a unit in the denominator follows the `/` without a number.
fn insert_behind_number(unit: &Offered) -> String {
    match unit.name.strip_prefix("1/") {
        Some(below) => format!("/ {below}"),
        None => unit.name.clone(),
    }
}

fn offer(
    request: &Request<'_>,
    shape: &Shape,
    wanted: ExpectedUnit,
    items: &mut Vec<Item>,
    written: &dyn Fn(&Offered) -> String,
) {
    let coherent = wanted.dimension.map(|dimension| request.system.unit_of(dimension).name);
    let preferred = wanted
        .dimension
        .and_then(|dimension| dimension.known_name())
        .and_then(|name| PREFERRED.iter().find(|(dimension, _)| *dimension == name).map(|(_, unit)| *unit));
    for (order, unit) in all(request, coherent.as_deref()).into_iter().enumerate() {
        let fits = wanted.dimension.is_some_and(|dimension| is_measured(unit.dimension, dimension));
        let compound = unit.name.contains(['*', '/', '^']);
        if !(fits || wanted.rest && !compound) || compound && !wanted.compound {
            continue;
        }
        let fit = match (fits, wanted.dimension) {
            (true, _) => 0,
            (false, None) => 1,
            (false, Some(_)) if !wanted.sure => 1,
            _ => 3,
        };
        let origin = if preferred.is_some_and(|preferred| unit.name == preferred) {
            0
        } else if preferred.is_none() && coherent.as_deref() == Some(&unit.name) {
            1
        } else if is_inch(&unit.name) == (request.system == UnitSystem::InchLbfS) || is_neutral(&unit) {
            2
        } else {
            3
        };
        let text = written(&unit);
        let seldom = if SELDOM.contains(&unit.name.as_str()) { 1000 } else { 0 };
        let rank = Rank { fit, origin, order: order as u32 + seldom };
        let mut item = Item::new(text.clone(), ItemKind::Unit, rank);
        item.detail = detail(&unit);
        item.insert = Insert::plain(text);
        item.subject = Some(Subject::Unit(unit.name));
        items.push(item);
    }
    own(request, shape, items);
}

/// Returns true if a unit has the expected dimension. Dimensions that differ in the exponent of
/// angle match for rates only, so that radians are not offered for a number.
fn is_measured(unit: Dimension, wanted: Dimension) -> bool {
    unit == wanted || (unit.fits(wanted) && !wanted.is_none() && !unit.is_none() && is_rate(wanted))
}

/// Returns true for frequency and angular velocity, which differ in the exponent of angle only.
fn is_rate(dimension: Dimension) -> bool {
    matches!(dimension.known_name(), Some("Frequency" | "AngularVelocity"))
}

/// Returns all builtin units and compound units, including the system's own unit of the expected
/// dimension.
fn all(request: &Request<'_>, coherent: Option<&str>) -> Vec<Offered> {
    let simple = Unit::all().iter().map(|unit| Offered {
        name: unit.name.to_string(),
        dimension: unit.dimension,
        factor: unit.factor,
    });
    // A variable with the name of a unit hides it, except directly after a number.
    let hidden = |name: &str| {
        let mut factors = name.split(['*', '/']).skip(1);
        factors.any(|factor| request.find(factor.split('^').next().unwrap_or(factor)).is_some())
    };
    let products = COMPOUND.iter().copied().chain(coherent.filter(|name| !COMPOUND.contains(name)));
    let products =
        products.filter(|name| name.contains(['*', '/', '^']) && !hidden(name)).filter_map(product);
    simple.chain(products).collect()
}

/// Parses a product of units, such as `lbf*s^2/inch`.
fn product(name: &str) -> Option<Offered> {
    let mut offered = Offered { name: name.to_string(), dimension: Dimension::NONE, factor: 1.0 };
    let mut divides = false;
    for part in name.split_inclusive(['*', '/']) {
        let factor = part.trim_end_matches(['*', '/']);
        let (unit, exponent) = factor.split_once('^').unwrap_or((factor, "1"));
        if unit != "1" {
            let unit = Unit::find(unit)?;
            let exponent: i32 = exponent.parse().ok()?;
            let exponent = if divides { -exponent } else { exponent };
            offered.dimension = offered.dimension.times(unit.dimension.power(Rational::integer(exponent))?);
            offered.factor *= unit.factor.powi(exponent);
        }
        divides = part.ends_with('/');
    }
    Some(offered)
}

fn is_inch(name: &str) -> bool {
    name.split(['*', '/', '^']).any(|factor| OF_INCH.contains(&factor))
}

/// Returns true for seconds and degrees, which belong to every system.
fn is_neutral(unit: &Offered) -> bool {
    let dimension = unit.dimension.without_angle();
    dimension.is_none() || matches!(dimension.known_name(), Some("Time" | "Frequency" | "Temperature"))
}

/// Formats dimension and value of a unit: `Moment, 0.112985 N*m`.
fn detail(unit: &Offered) -> String {
    let base = UnitSystem::Si.unit_of(unit.dimension).name;
    match unit.dimension.is_none() {
        true => shortest(unit.factor),
        false if base == unit.name => unit.dimension.to_string(),
        false => format!("{}, {} {base}", unit.dimension, shortest(unit.factor)),
    }
}

/// Formats up to six significant digits.
fn shortest(value: f64) -> String {
    let magnitude = if value == 0.0 { 0 } else { value.abs().log10().floor() as i32 };
    if !(-5..9).contains(&magnitude) {
        let text = format!("{value:.5e}");
        let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{exponent}", digits.trim_end_matches('0').trim_end_matches('.'));
    }
    let decimals = (5 - magnitude).max(0) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_string() } else { text }
}

/// Offers units that the program and its modules declare.
fn own(request: &Request<'_>, shape: &Shape, items: &mut Vec<Item>) {
    let mut known: Vec<_> =
        request.visible.iter().filter(|known| known.kind == NameKind::Unit).cloned().collect();
    for module in request.visible.iter().filter(|known| known.kind == NameKind::Module) {
        if let Some(path) = callee::module_path(request.database, &request.visible, &module.name) {
            let members = request.database.members(&path).into_iter();
            known.extend(members.filter(|known| known.kind == NameKind::Unit));
        }
    }
    for (order, unit) in known.iter().enumerate() {
        let ty = unit.ty.as_deref().unwrap_or_default();
        let detail = unit.declared.as_ref().and_then(|place| {
            let rest = request.database.text(&place.file)?.get(place.start as usize..)?;
            Some(format!("unit {}", rest.split([';', '\n']).next()?))
        });
        let fit = match shape.fit(&Shape::read(ty)) {
            Fit::Exactly => 0,
            Fit::Perhaps => 1,
            Fit::InPart | Fit::Not => 3,
        };
        let rank = Rank { fit, origin: 1, order: order as u32 };
        let mut item =
            Item::new(unit.name.to_string(), ItemKind::Unit, rank).detail(detail.unwrap_or_default());
        item.subject = unit.declared.clone().map(Subject::Declaration);
        items.push(item);
    }
}

#[cfg(test)]
mod tests {
    use super::{COMPOUND, product, shortest};

    #[test]
    fn products_are_units() {
        for name in COMPOUND {
            assert!(product(name).is_some(), "{name}");
        }
        let moment = product("lbf*inch").expect("a moment");
        assert_eq!(
            (moment.dimension.to_string().as_str(), shortest(moment.factor).as_str()),
            ("Moment", "0.112985")
        );
        assert_eq!(shortest(product("1/inch").expect("a curvature").factor), "39.3701");
        assert_eq!(shortest(1e9), "1e9");
        assert_eq!(shortest(0.001), "0.001");
        assert_eq!(shortest(6.89475729e9), "6.89476e9");
    }
}
