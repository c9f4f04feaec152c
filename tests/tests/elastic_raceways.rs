//! Rollers in the bore of a gear and on an elastic pin: rotated as a whole, in equilibrium, on a
//! stiff gear or pin, with more terms, and in three dimensions.

use crate::models::{engine, ranges_with};
use crate::rolling_bearings::close;
use crate::seat_raceways::tube;
use calyx::Module;
use std::collections::BTreeMap;

/// A planet on needles under the force of a pinion, and one position.
struct Planet {
    bore: &'static str,
    fidelity: &'static str,
    harmonics: usize,
    /// Degree along the axis.
    degree: u8,
    estimates: &'static str,
    /// Young's modulus of the planet and of the rings, GPa.
    modulus: f64,
    /// Angle about which the whole is turned, degrees.
    turned: f64,
    /// Clearance, µm.
    clearance: f64,
    pin: Option<Pin>,
    /// Time of the position.
    time: &'static str,
}

/// Hollow pin of 34 mm and 42 mm in diameter, which is fixed 15 mm from its middle.
#[derive(Clone, Copy)]
struct Pin {
    /// Connection of the surface under the needles.
    how: &'static str,
    /// Young's modulus, GPa.
    modulus: f64,
    /// Only a strip of its bore is fixed.
    on_strip: bool,
    /// Further motion, the first factor of its frame.
    motion: &'static str,
}

const ENDS: &str = "gears.attachment(\"front\", pin, gears.plane_region(15 mm * e3, e3), fixed = TRUE);
gears.attachment(\"back\", pin, gears.plane_region(-15 mm * e3, e3), fixed = TRUE);";
const STRIP: &str = "gears.attachment(\"strip\", pin, gears.box_region(-6 mm * e1 - 18 mm * e2 - 16 mm * e3, 6 mm * e1 - 15 mm * e2 + 16 mm * e3), fixed = TRUE);";

const PLANET: Planet = Planet {
    bore: "raceway",
    fidelity: "plane",
    harmonics: 40,
    degree: 2,
    estimates: "none",
    modulus: 206.0,
    turned: 0.0,
    clearance: 20.0,
    pin: None,
    time: "0 s",
};

impl Planet {
    fn results(&self) -> BTreeMap<String, [f64; 2]> {
        let modulus = self.pin.map_or(206.0, |pin| pin.modulus);
        ranges_with(&self.model(), &[("pin.bdf", &tube([17.0, 21.0], 15.0, modulus))])
    }

    fn model(&self) -> String {
        let Planet { bore, fidelity, harmonics, degree, estimates, modulus, turned, clearance, pin, time } =
            self;
        // Azimuths count from the x axis of the body that the bearing is mounted on.
        let (pin, on_pin, azimuth) = match pin {
            None => (String::new(), "", "turned"),
            Some(Pin { how, on_strip, motion, .. }) => (
                format!(
                    "var pin = gears.nastran(\"pin\", \"pin.bdf\", units = \"N-mm-s\", frame := {motion}Translate(52.05 mm * e1) * Rotate(turned, e3));
{}
var seat = gears.attachment(\"seat\", pin,
    gears.cylinder_region(0 mm * e3, e3, radius = 21 mm, from = -11.5 mm, to = 11.5 mm), how = \"{how}\");
",
                    if *on_strip { STRIP } else { ENDS }
                ),
                "to = seat, ",
                "0 deg",
            ),
        };
        let series = match *bore {
            "raceway" => format!(", bore_harmonics = {harmonics}, bore_axial_degree = {degree}"),
            _ => String::new(),
        };
        format!(
            "import gears;
units mm_N_s;
var rack = gears.rack(module = 2 mm, tip_radius = 0.5 mm);
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);
var own = gears.material(youngs_modulus = {modulus} GPa, poissons_ratio = 0.3);
var turned = {turned} deg;
var pinion = gears.body(\"pinion\", gears.external(teeth = 20, rack = rack, face_width = 20 mm, material = steel),
    free = [\"theta_z\"], moment = 200 N*m * e3, frame := Rotate(turned, e3) * Rotate(100 rpm * Time, e3));
var rim = gears.simple_rim(diameter = 57 mm, inner_diameter = 50 mm, bore = \"{bore}\"{series});
var planet = gears.body(\"planet\", gears.external(teeth = 32, rack = rack, face_width = 20 mm, material = own, rim = rim),
    free = [\"u_x\", \"u_y\"], frame := Rotate(-100 rpm * 20 / 32 * Time, e3) * Translate(52.05 mm * e1) * Rotate(turned, e3));
{pin}var needles = gears.needle_bearing(\"needles\", planet, {on_pin}ring = \"outer\", count = 22, roller_diameter = 4 mm, roller_length = 18 mm,
    pitch_diameter = 46 mm, clearance = {clearance} um, azimuth = {azimuth}, ring_material = own);
var mesh = gears.mesh(pinion, planet);
output transmission_error := gears.transmission_error(mesh);
output x := gears.bearing_force(needles, \"x\");
output y := gears.bearing_force(needles, \"y\");
output mesh_force := gears.mesh_force(mesh);
output largest := gears.max_rolling_element_load(needles);
output fifth := gears.rolling_element_load(needles, 17);
output pressure := gears.max_bearing_pressure(needles);
output deflection := gears.bearing_deflection(needles, \"radial\");
output stress := gears.max_root_stress(planet);
analyze(\"quasi_static\", over = gears.times(from = {time}, to = {time}, count = 1), fidelity = \"{fidelity}\", error_estimates = \"{estimates}\");
"
        )
    }
}

const SCALARS: [&str; 6] =
    ["transmission_error", "mesh_force", "largest", "pressure", "deflection", "stress"];

#[test]
fn the_turned_whole_has_the_same_results() {
    let [own, turned] = [0.0, 37.0].map(|turned| Planet { turned, ..PLANET }.results());
    for name in SCALARS {
        close(name, turned[name][0], own[name][0], 1e-8, 0.0);
    }
    close("element", turned["fifth"][0], own["fifth"][0], 1e-8, own["largest"][0]);
}

#[test]
fn rollers_balance_the_teeth() {
    for fidelity in ["plane", "medium"] {
        let found = Planet { fidelity, ..PLANET }.results();
        let force = found["x"][0].hypot(found["y"][0]);
        close(fidelity, force, found["mesh_force"][0], 1e-8, 0.0);
    }
}

/// The results of stiff gears, with rings of the same material, approach those of a rigid raceway
/// as the compliance vanishes.
#[test]
fn a_stiff_gear_has_the_loads_of_a_rigid_raceway() {
    let difference = |modulus: f64, name: &str| {
        let of = |bore| Planet { bore, modulus, ..PLANET }.results()[name][0];
        let [rigid, elastic] = ["free", "raceway"].map(of);
        (elastic - rigid) / rigid
    };
    for name in ["largest", "pressure", "deflection"] {
        let [less, more] = [9e5, 9e4].map(|modulus| difference(modulus, name));
        assert!(less.abs() < 3e-3, "{name}: {less}");
        assert!((more / less - 10.0).abs() < 1.0, "{name}: {less} {more}");
    }
}

/// The half-space displacement that the series replaces makes results independent of its length.
#[test]
fn results_converge_with_the_harmonics() {
    let of = |harmonics| Planet { harmonics, ..PLANET }.results();
    let [some, many] = [30, 80].map(of);
    for name in SCALARS {
        close(name, some[name][0], many[name][0], 5e-3, 0.0);
    }
}

/// A clearance that the rollers of a rigid raceway leave open is closed all around by interference,
/// and both change the loads continuously.
#[test]
fn clearance_opens_and_closes_continuously() {
    let of = |clearance| Planet { clearance, ..PLANET }.results();
    let results = [-2.0, -1.0, 0.0, 1.0, 2.0].map(of);
    for name in ["largest", "transmission_error", "stress"] {
        let values = results.each_ref().map(|result| result[name][0]);
        let steps: Vec<f64> = values.windows(2).map(|two| two[1] - two[0]).collect();
        let largest = steps.iter().map(|step| step.abs()).fold(0.0, f64::max);
        assert!(largest < 0.1 * values[0].abs(), "{name}: {values:?}");
    }
}

const PIN: Pin = Pin { how: "raceway", modulus: 206.0, on_strip: false, motion: "" };

#[test]
fn needles_on_an_elastic_pin_balance_the_teeth() {
    let of = |turned| Planet { fidelity: "medium", turned, pin: Some(PIN), ..PLANET }.results();
    let [own, turned] = [0.0, 37.0].map(of);
    let force = own["x"][0].hypot(own["y"][0]);
    close("balance", force, own["mesh_force"][0], 1e-8, 0.0);
    for name in SCALARS {
        close(name, turned[name][0], own[name][0], 1e-7, 0.0);
    }
}

/// A pin whose seat rotates has the loads of one at rest in the same position. The gears are one
/// pitch further.
#[test]
fn a_rotating_pin_has_the_loads_of_one_at_rest() {
    let of = |time, motion| {
        let pin = Some(Pin { on_strip: true, motion, ..PIN });
        Planet { fidelity: "medium", pin, time, ..PLANET }.results()
    };
    let [straight, rotated, moved] =
        [of("0 s", ""), of("0 s", "Rotate(36 deg, e3) * "), of("0.03 s", "Rotate(200 rpm * Time, e3) * ")];
    // The strip is not next to the load any more.
    let [one, other] = [&straight, &rotated].map(|results| results["largest"][0]);
    assert!((one / other - 1.0).abs() > 0.01, "{one} {other}");
    for name in SCALARS {
        close(name, moved[name][0], rotated[name][0], 1e-7, 0.0);
    }
}

/// The results of stiff pins approach those of a rigid inner ring as the compliance vanishes. A
/// hollow pin of steel becomes oval.
#[test]
fn a_stiff_pin_has_the_loads_of_a_rigid_raceway() {
    let of = |how, modulus| {
        Planet { fidelity: "medium", pin: Some(Pin { how, modulus, ..PIN }), ..PLANET }.results()
    };
    let difference = |modulus: f64, name: &str| {
        let [rigid, elastic] = ["average", "raceway"].map(|how| of(how, modulus)[name][0]);
        (elastic - rigid) / rigid
    };
    for name in ["largest", "pressure", "stress"] {
        let [less, more, steel] = [9e5, 9e4, 206.0].map(|modulus| difference(modulus, name));
        println!("{name}: {:.1} % with a pin of steel", 100.0 * steel);
        assert!(less.abs() < 3e-3, "{name}: {less}");
        assert!((more / less - 10.0).abs() < 1.0, "{name}: {less} {more}");
    }
}

/// Raceways bend along their axis, which needs quadratic polynomials. The estimate of a series
/// without them shows their effect; that of the default series is small.
#[test]
#[ignore = "takes a minute: .ci/full runs it"]
fn error_estimates_contain_the_degree_along_the_axis() {
    let stress = |degree| {
        let planet = Planet { degree, fidelity: "medium", estimates: "cheap", ..PLANET };
        let module = Module::from_text(&engine(), "model.cx", &planet.model())
            .unwrap_or_else(|error| panic!("{error}"));
        let results = module.instantiate().solve().unwrap_or_else(|error| panic!("{error}"));
        let stress = results.summary_si("stress").unwrap_or_else(|error| panic!("{error}")).clone();
        (stress.mean, stress.error.expect("an estimate").total.mean)
    };
    let [(linear, its_error), (quadratic, own_error)] = [1, 2].map(stress);
    println!("linear {linear:e} +- {its_error:e}, quadratic {quadratic:e} +- {own_error:e}");
    let difference = (quadratic - linear).abs();
    assert!(difference > 2e-3 * quadratic, "{linear} {quadratic}");
    assert!(its_error > difference && its_error < 4.0 * difference, "{its_error} {difference}");
    assert!(own_error < 0.02 * quadratic, "{own_error}");
}
