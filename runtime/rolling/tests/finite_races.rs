//! A short roller between races of finite width and thickness: elastic contacts against a
//! finite-element model.
//!
//! Roller and race are solid elements under loads that are spread across the contact line by a
//! Gaussian distribution. The difference of the finite-element deflection from that of a half-space
//! under the same load is smooth, and coarse meshes have it. Half-spaces have the rest, at the
//! half-widths of the contact. Everything is symmetric about the middle of the roller.

use crate::sample::cylindrical;
use calyx_fe::material::Material as Elastic;
use calyx_fe::solid::{SolidMesh, SolidModel};
use calyx_fe::{
    Block, Constraints, Curve, ElementOrder, MeshBuilder, PlaneMesh, Side, Solver, SparseVector, graded,
};
use calyx_numerics::quadrature::gauss_legendre;
use calyx_rolling::roller::strips::{Line, Strip, StripLoads, Strips, graded_strips};
use calyx_rolling::{
    ContactModel, ElasticContact, Material, Motion, Profile, RollerGeometry, RollerKind, RollerRow,
    RollingBearing, material::composite_modulus,
};
use std::f64::consts::{FRAC_PI_4, PI};

const LENGTH: f64 = 10e-3;
const DIAMETER: f64 = 10e-3;
const STRIPS: usize = 32;

/// Race: a block that is held at its back.
#[derive(Clone, Copy, Debug)]
struct Race {
    /// Width along the roller, m.
    width: f64,
    /// Thickness, m.
    thickness: f64,
}

/// Discretization.
#[derive(Clone, Copy, Debug)]
struct Fineness {
    order: u8,
    /// Number of elements along each edge of the models.
    elements: usize,
    /// Standard deviation of the load across the line, m.
    spread: f64,
}

/// Symmetry of a load about the middle of the roller.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Parity {
    Even,
    Odd,
}

impl Parity {
    fn sign(self) -> f64 {
        if self == Self::Even { 1.0 } else { -1.0 }
    }

    /// Returns whether a displacement along an axis vanishes in the middle of the roller.
    fn holds(self, axis: usize) -> bool {
        (axis == 2) == (self == Self::Even)
    }
}

fn plane_strain_modulus() -> f64 {
    Material::STEEL.youngs_modulus / (1.0 - Material::STEEL.poissons_ratio.powi(2))
}

/// Quarter of the section of a race: across the line from the symmetry plane, and down to the back.
fn race_section(race: Race, fineness: Fineness) -> PlaneMesh {
    let reach = 1.5 * DIAMETER;
    let count = fineness.elements;
    let block =
        Block::quadrilateral([[0.0, -race.thickness], [reach, -race.thickness], [reach, 0.0], [0.0, 0.0]])
            .divided(graded(count, 12.0), descending(count, 6.0))
            .named(Side::Top, "contact");
    MeshBuilder::new().block(block).finish(ElementOrder::full(fineness.order)).expect("one block")
}

fn descending(count: usize, ratio: f64) -> Vec<f64> {
    graded(count, 1.0 / ratio)
}

/// Quarter of the section of the roller, finer towards the contact at the top.
fn roller_section(fineness: Fineness) -> PlaneMesh {
    let (radius, half) = (0.5 * DIAMETER, 0.25 * DIAMETER);
    let count = fineness.elements;
    let corner = radius * FRAC_PI_4.sin();
    let along = graded(count, 12.0);
    let outwards = descending(count, 5.0);
    let square = Block::quadrilateral([[0.0, 0.0], [half, 0.0], [half, half], [0.0, half]])
        .divided(along.clone(), along.clone());
    let top = Block::new(
        Curve::line([0.0, half], [half, half]),
        Curve::line([half, half], [corner, corner]),
        Curve::arc([0.0; 2], radius, 2.0 * FRAC_PI_4, FRAC_PI_4),
        Curve::line([0.0, half], [0.0, radius]),
    )
    .divided(along.clone(), outwards.clone())
    .named(Side::Top, "contact");
    let side = Block::new(
        Curve::line([half, 0.0], [radius, 0.0]),
        Curve::arc([0.0; 2], radius, 0.0, FRAC_PI_4),
        Curve::line([half, half], [corner, corner]),
        Curve::line([half, 0.0], [half, half]),
    )
    .divided(outwards, along);
    let mut builder = MeshBuilder::new();
    for block in [square, top, side] {
        builder.block(block);
    }
    builder.finish(ElementOrder::full(fineness.order)).expect("three blocks")
}

/// Strips of half of the contact line.
fn half_strips() -> Vec<Strip> {
    graded_strips(LENGTH, STRIPS, |_| 0.5 * DIAMETER).split_off(STRIPS / 2)
}

/// Deflections of strips by unit loads per length on a strip and its mirror image, m²/N, by row.
type Compliance = Vec<Vec<f64>>;

/// Deflections by finite elements of a section between the stations. `held` states whether the
/// displacement of a node along an axis is zero.
fn by_finite_elements(
    section: &PlaneMesh,
    stations: &[f64],
    fineness: Fineness,
    held: impl Fn([f64; 3], usize) -> bool,
) -> Compliance {
    let mesh = SolidMesh::swept(section, stations, usize::from(fineness.order), &|[x, y], z| [x, y, z])
        .expect("sound stations");
    let model = SolidModel::new(mesh, Elastic::STEEL);
    let mut constraints = Constraints::new();
    for (node, &position) in model.mesh.nodes.iter().enumerate() {
        for axis in (0..3).filter(|&axis| held(position, axis)) {
            constraints.prescribe(3 * node + axis, 0.0);
        }
    }
    let solver = Solver::dissected(&model.stiffness(), &model.mesh.nodes, constraints).expect("constrained");
    let contact = model.mesh.face_set("contact").expect("named");
    let across = contact.chart.as_ref().expect("swept").s_range();
    let spread = fineness.spread;
    let unit = 1.0 / (spread * (2.0 * PI).sqrt());
    let strips = half_strips();
    let loads: Vec<SparseVector> = strips
        .iter()
        .map(|strip| {
            let ends = [strip.position - 0.5 * strip.length, strip.position + 0.5 * strip.length];
            let density = |_, _, point: &calyx_fe::solid::FacePoint| {
                // The distance along the surface of the roller; on the race there is no curvature.
                let [x, y, _] = point.position;
                let distance = if y > 0.0 { 0.5 * DIAMETER * x.atan2(y) } else { x };
                [0.0, unit * (-0.5 * (distance / spread).powi(2)).exp(), 0.0]
            };
            model.face_load_between(contact, [across, ends], density).expect("a chart")
        })
        .collect();
    let solutions: Vec<Vec<f64>> = loads
        .iter()
        .map(|load| solver.solve_one(&load.to_full(model.dof_count())).expect("memory"))
        .collect();
    // Half of the load of each strip acts on the model.
    let row = |(load, strip): (&SparseVector, &Strip)| {
        solutions.iter().map(|solution| load.dot(solution) / (0.5 * strip.length)).collect()
    };
    loads.iter().zip(&strips).map(row).collect()
}

/// Deflections of a half-space under the same loads.
fn by_half_space(spread: f64, images: bool, parity: Parity) -> Compliance {
    // Second difference of |x| asinh(|x|/s) - √(x² + s²).
    let integral = |[a, b]: [f64; 2], [c, d]: [f64; 2], s: f64| {
        let term = |x: f64| x.abs() * (x.abs() / s).asinh() - x.hypot(s);
        term(b - c) + term(a - d) - term(b - d) - term(a - c)
    };
    // The difference s = 2 σ eᵘ of two positions across the line has a density like exp(-e²ᵘ) eᵘ.
    let rule = gauss_legendre(48);
    let (from, to) = (-30.0f64, 1.9f64);
    let distances: Vec<(f64, f64)> = rule
        .iter()
        .map(|(x, weight)| {
            let u = 0.5 * (from + to + (to - from) * x);
            let s = 2.0 * u.exp();
            let density = 2.0 * (-0.25 * s * s).exp() / (2.0 * PI.sqrt());
            (s * spread, 0.5 * (to - from) * weight * density * s)
        })
        .collect();
    let strips = half_strips();
    let ends = |strip: &Strip| [strip.position - 0.5 * strip.length, strip.position + 0.5 * strip.length];
    let deflection = |own: &Strip, other: &Strip| {
        let [start, end] = ends(other);
        let loads = [(1.0, [start, end]), (parity.sign(), [-end, -start])];
        let mut sources = loads.to_vec();
        if images {
            for face in [0.5 * LENGTH, -0.5 * LENGTH] {
                sources.extend(loads.map(|(sign, [a, b])| (sign, [2.0 * face - b, 2.0 * face - a])));
            }
        }
        let both = |s: f64| -> f64 {
            sources.iter().map(|(sign, source)| sign * integral(ends(own), *source, s)).sum()
        };
        let mean: f64 = distances.iter().map(|(s, weight)| weight * both(*s)).sum();
        mean / (PI * plane_strain_modulus() * own.length)
    };
    strips.iter().map(|own| strips.iter().map(|other| deflection(own, other)).collect()).collect()
}

/// Deflections of roller and race beyond those of half-spaces, that of the roller with images of
/// the load in both ends, for even and odd loads.
struct Remainders<'a> {
    roller: &'a [Compliance; 2],
    race: &'a [Compliance; 2],
}

/// Stations along the roller from its middle, finer towards its end.
fn roller_stations(count: usize) -> Vec<f64> {
    descending(count, 12.0).iter().map(|x| 0.5 * LENGTH * x).collect()
}

const PARITIES: [Parity; 2] = [Parity::Even, Parity::Odd];

fn difference(own: Compliance, other: &Compliance) -> Compliance {
    let row = |(own, other): (Vec<f64>, &Vec<f64>)| own.iter().zip(other).map(|(a, b)| a - b).collect();
    own.into_iter().zip(other).map(row).collect()
}

fn is_zero(x: f64) -> bool {
    x.abs() < 1e-9
}

/// Remainder of the roller. The loads on both lines are mirror images of each other.
fn roller(fineness: Fineness) -> [Compliance; 2] {
    let (section, stations) = (roller_section(fineness), roller_stations(fineness.elements));
    PARITIES.map(|parity| {
        let found = by_finite_elements(&section, &stations, fineness, |position, axis| {
            let center = position.into_iter().all(is_zero);
            let plane = axis != 2 && is_zero(position[axis]);
            plane || is_zero(position[2]) && parity.holds(axis) || center
        });
        difference(found, &by_half_space(fineness.spread, true, parity))
    })
}

/// Remainder of a race.
fn race(race: Race, fineness: Fineness) -> [Compliance; 2] {
    let mut stations = roller_stations(fineness.elements);
    let margin = 0.5 * (race.width - LENGTH);
    let beyond = graded((fineness.elements / 3).max(1), 1.5);
    stations.extend(beyond.iter().skip(1).map(|x| 0.5 * LENGTH + margin * x));
    let section = race_section(race, fineness);
    PARITIES.map(|parity| {
        let found = by_finite_elements(&section, &stations, fineness, |position, axis| {
            let back = is_zero(position[1] + race.thickness);
            let plane = axis == 0 && is_zero(position[0]);
            back || plane || is_zero(position[2]) && parity.holds(axis)
        });
        difference(found, &by_half_space(fineness.spread, false, parity))
    })
}

/// Mean relief of a strip, m.
fn relief(profile: &Profile, strip: &Strip) -> f64 {
    let at = |x: f64| match profile {
        Profile::Crowned { radius } => 0.5 * x * x / radius,
        Profile::Logarithmic => -0.00035 * DIAMETER * (1.0 - (2.0 * x / LENGTH).powi(2)).ln(),
        _ => 0.0,
    };
    let points = gauss_legendre(4).into_iter();
    points.map(|(x, weight)| 0.5 * weight * at(strip.position + 0.5 * strip.length * x)).sum()
}

/// Contact of roller and race under a load at a tilt.
struct Contact {
    /// Approach of the roller's axis to the back of the race less the deflection of the race as a
    /// whole, m.
    approach: f64,
    /// Deflection of the race as a whole, m: the mean of that beyond a half-space by an even load.
    race: f64,
    /// Moment of the load about the middle of the roller, N m.
    moment: f64,
    loads: Vec<f64>,
    pressure: f64,
}

/// Returns the approach, m, at which a contact has a load, N.
fn approach_of(load: f64, at: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (0.0, 200e-6);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if at(middle) < load { low = middle } else { high = middle }
    }
    low
}

/// Contact of the finite bodies.
fn by_remainders(remainders: &Remainders<'_>, profile: &Profile, load: f64, tilt: f64) -> Contact {
    let strips = graded_strips(LENGTH, STRIPS, |_| 0.5 * DIAMETER);
    let half = STRIPS / 2;
    let of_half = |k: usize| if k < half { half - 1 - k } else { k - half };
    let beyond = |of_body: &[Compliance; 2], i: usize, j: usize| {
        let [own, other] = [i, j].map(of_half);
        let side = if (i < half) == (j < half) { 1.0 } else { -1.0 };
        0.5 * (of_body[0][own][other] + side * of_body[1][own][other]) / strips[j].length
    };
    let body = |i: usize, j: usize| beyond(remainders.roller, i, j) + beyond(remainders.race, i, j);
    let modulus = composite_modulus(&Material::STEEL, &Material::STEEL);
    // The images of the roller alone count for half of the deflection of both bodies.
    let contact = Strips::new(&[Line::with_free_ends(strips.clone(), 0.5)], modulus, body);
    let at = |approach: f64| {
        let approach = |strip: &Strip| approach + tilt * strip.position - relief(profile, strip);
        contact.loads(&strips.iter().map(approach).collect::<Vec<_>>()).expect("converged")
    };
    let sum = |found: &StripLoads, factor: &dyn Fn(&Strip) -> f64| -> f64 {
        found.loads.iter().zip(&strips).map(|(load, strip)| load * strip.length * factor(strip)).sum()
    };
    let approach = approach_of(load, |approach| sum(&at(approach), &|_| 1.0));
    let found = at(approach);
    let mut race = 0.0;
    for i in 0..STRIPS {
        for j in 0..STRIPS {
            race += beyond(remainders.race, i, j) * strips[i].length * strips[j].length;
        }
    }
    race *= load / (LENGTH * LENGTH);
    let pressure = (0..STRIPS).map(|k| found.pressure(k)).fold(0.0, f64::max);
    let moment = sum(&found, &|strip| strip.position);
    Contact { approach: approach - race, race, moment, loads: found.loads, pressure }
}

/// Contact of the engine's roller between raceways of this width with almost no curvature.
fn by_engine(width: Option<f64>, profile: &Profile, load: f64, tilt: f64) -> Contact {
    let row = RollerRow::new(RollerGeometry {
        kind: RollerKind::Cylindrical { clearance: 0.0 },
        count: 3,
        roller_diameter: DIAMETER,
        length: LENGTH,
        raceway_widths: [width; 2],
        pitch_diameter: 1000.0,
        profile: profile.clone(),
        ..cylindrical()
    });
    let elastic = ContactModel::Elastic(ElasticContact { strips: STRIPS, ..ElasticContact::default() });
    let bearing = RollingBearing::single(row.expect("valid").with_contact(elastic).expect("valid"));
    let state = |approach: f64| {
        // Half of the displacement is that of each contact; positions are towards -z.
        let displacement = [2.0 * approach, 0.0, 0.0, 0.0, -2.0 * tilt];
        let states = bearing.elements(&displacement, &Motion::REST).expect("finite");
        states[0].roller().expect("rollers").inner.clone()
    };
    let approach = approach_of(load, |approach| state(approach).load);
    let found = state(approach);
    Contact { approach, race: 0.0, moment: found.moment, loads: found.loads, pressure: found.pressure }
}

/// Deviations of the engine from finite elements, as parts of one.
struct Deviations {
    approach: f64,
    pressure: f64,
    /// Relative to the load with half of the length as arm.
    moment: f64,
    /// Largest deviation of a load per length, relative to the largest load per length.
    loads: f64,
}

fn deviations(found: &Contact, expected: &Contact, load: f64) -> Deviations {
    let most = expected.loads.iter().copied().fold(0.0, f64::max);
    let pairs = expected.loads.iter().zip(&found.loads);
    Deviations {
        approach: found.approach / expected.approach - 1.0,
        pressure: found.pressure / expected.pressure - 1.0,
        moment: (found.moment - expected.moment) / (0.5 * LENGTH * load),
        loads: pairs.map(|(a, b)| (a - b).abs() / most).fold(0.0, f64::max),
    }
}

/// Races that are little wider than the roller, and thinner than its diameter.
const USUAL: Race = Race { width: 1.2 * LENGTH, thickness: 0.75 * DIAMETER };

/// Loads, N, and tilts, rad.
const LOADS: [(f64, f64); 4] = [(1500.0, 0.0), (1500.0, 1e-3), (6000.0, 0.0), (6000.0, 1e-3)];

/// Mesh of races. Their remainder is as smooth as the distance of their faces.
const RACE: Fineness = Fineness { order: 3, elements: 4, spread: 0.6e-3 };

/// Approach, largest pressure, moment and loads per length of a roller with logarithmic profile,
/// aligned and tilted by 1 mrad. Without the width of the races, the loads at the ends are wrong.
#[test]
fn logarithmic_roller_has_the_loads_of_finite_elements() {
    let roller = roller(Fineness { order: 3, elements: 4, spread: 0.3e-3 });
    let race = race(USUAL, Fineness { order: 2, elements: 5, ..RACE });
    let remainders = Remainders { roller: &roller, race: &race };
    for (load, tilt) in LOADS {
        let expected = by_remainders(&remainders, &Profile::Logarithmic, load, tilt);
        let of = |width| deviations(&by_engine(width, &Profile::Logarithmic, load, tilt), &expected, load);
        let Deviations { approach, pressure, moment, loads } = of(Some(USUAL.width));
        let case = format!("{load} {tilt}: {approach} {pressure} {moment} {loads}");
        assert!(approach.abs() < 5e-3 && pressure.abs() < 5e-3 && moment.abs() < 5e-3, "{case}");
        assert!(loads < 0.02, "{case}");
        assert!(of(None).loads > 1.8 * loads, "{case}");
    }
}

/// Prints the deviations of the engine without and with the width of the races. Returns the largest
/// with it.
fn print(width: f64, profile: &Profile, remainders: &Remainders<'_>) -> f64 {
    let mut worst = 0.0f64;
    for (load, tilt) in LOADS {
        let expected = by_remainders(remainders, profile, load, tilt);
        println!(
            "  {load} N, {:.0} mrad: approach {:.3} µm, race as a whole {:.3} µm, pressure {:.1} MPa",
            tilt * 1e3,
            expected.approach * 1e6,
            expected.race * 1e6,
            expected.pressure * 1e-6
        );
        for (name, width) in [("without width", None), ("with width", Some(width))] {
            let found = deviations(&by_engine(width, profile, load, tilt), &expected, load);
            println!(
                "    {name:14} approach {:+.2} %, pressure {:+.2} %, moment {:+.2} %, loads {:.2} %",
                1e2 * found.approach,
                1e2 * found.pressure,
                1e2 * found.moment,
                1e2 * found.loads
            );
            if width.is_some() {
                let all = [found.approach, found.pressure, found.moment, found.loads];
                worst = all.iter().fold(worst, |most, x| most.max(x.abs()));
            }
        }
    }
    worst
}

/// Convergence with mesh and spread of the load, races of other width and thickness, and crowned
/// rollers, whose contact reaches the ends. The load of a contact of half-width 0.2 mm has the mean
/// logarithmic distance of a spread of 0.1 mm.
#[test]
#[ignore = "takes a minute"]
fn convergence_and_other_races() {
    let fineness = |elements, spread| Fineness { order: 3, elements, spread };
    let usual = race(USUAL, RACE);
    let crowned = Profile::Crowned { radius: 2.0 };
    let mut medium = None;
    for fineness in [fineness(4, 0.6e-3), fineness(6, 0.6e-3), fineness(5, 0.3e-3), fineness(6, 0.2e-3)] {
        let roller = roller(fineness);
        let remainders = Remainders { roller: &roller, race: &usual };
        for profile in [&Profile::Logarithmic, &crowned] {
            println!("{} elements, spread {} mm, {profile:?}", fineness.elements, fineness.spread * 1e3);
            let worst = print(USUAL.width, profile, &remainders);
            assert!(worst < if *profile == crowned { 0.07 } else { 0.015 });
        }
        if fineness.elements == 5 {
            medium = Some(roller);
        }
    }
    let roller = medium.expect("computed");
    for [width, thickness] in [[1.02, 0.75], [1.1, 0.75], [1.5, 0.75], [1.2, 0.5], [1.2, 1.0]] {
        let other = Race { width: width * LENGTH, thickness: thickness * DIAMETER };
        println!("race of width {width} L and thickness {thickness} D, logarithmic");
        let race = race(other, RACE);
        let worst = print(other.width, &Profile::Logarithmic, &Remainders { roller: &roller, race: &race });
        assert!(worst < 0.03, "{worst}");
    }
}
