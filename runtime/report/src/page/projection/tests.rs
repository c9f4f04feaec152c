use super::*;
use crate::flank_tables::{FlankRow, FlankTables, ON_EDGE, ON_FLANK, ON_ROOT};
use crate::page::read::{End, Loaded, Position};

const LENGTH: f64 = 0.025;
const HEIGHT: f64 = 0.008;

/// Flank of a tooth that grows towards the heel. Mirror images have the other surface, and their
/// columns run from the heel if `reversed`.
fn flank(body: &str, mate: &str, surface: u32, shape: &str, reversed: bool) -> Vec<FlankRow> {
    let row = |part: &str, column: usize, row: usize| {
        let (x, y) = (column as f64 / 8.0, row as f64 / 6.0);
        let part_of_face = if reversed { 1.0 - x } else { x };
        let height = if part == ON_ROOT { 0.0 } else { 1e-3 + y * HEIGHT * (0.8 + 0.4 * part_of_face) };
        FlankRow {
            body: body.into(),
            mate: mate.into(),
            flank: "drive".into(),
            surface,
            shape: shape.into(),
            conical: true,
            part: part.into(),
            column,
            row,
            along_face: x,
            along_profile: y,
            axial: -0.05,
            radius: 0.03,
            distance: LENGTH * part_of_face,
            height,
        }
    };
    let nodes = (0..=8).flat_map(|column| (0..=6).map(move |row| (column, row)));
    let nodes = nodes.map(|(column, index)| row(if index == 6 { ON_EDGE } else { ON_FLANK }, column, index));
    nodes.chain((0..=8).map(|column| row(ON_ROOT, column, 0))).collect()
}

/// Contact line with the largest pressure away from edges.
fn loaded() -> Loaded {
    Loaded {
        step: 0,
        first_body: "pinion".into(),
        first_tooth: 0,
        second_body: "gear".into(),
        second_tooth: 0,
        flank: "drive".into(),
        side: String::new(),
        first_radius: 0.03,
        first_roll_angle: None,
        second_radius: 0.07,
        second_roll_angle: None,
        axial: Some(-0.05),
        length: 1e-3,
        force: 100.0,
        line_load: 1e5,
        pressure: 1.5e9,
        edge_pressure: 2.5e9,
        sliding_velocity: None,
        friction_power: None,
        flash_temperature: None,
        film_thickness: None,
    }
}

/// A run with a spot of pressure, a path and an ease-off; `left` has the mirror image.
fn run(left: bool) -> Run {
    let own = u32::from(left);
    let mut flanks = flank("pinion", "gear", own, "concave", left);
    flanks.extend(flank("gear", "pinion", 1 - own, "convex", left));
    let face = |x: f64| if left { 1.0 - x } else { x };
    let point = |body: &str, mate: &str, surface: u32, column: usize, row: usize, edge: bool| PressurePoint {
        body: body.into(),
        mate: mate.into(),
        flank: "drive".into(),
        surface,
        column,
        row,
        along_face: face((column as f64 + 0.5) / COLUMNS as f64),
        along_profile: (row as f64 + 0.5) / ROWS as f64,
        pressure: if edge { 0.0 } else { 1.5e9 },
        edge_pressure: if edge { 2.5e9 } else { 0.0 },
    };
    let pattern = [("pinion", "gear", own), ("gear", "pinion", 1 - own)].map(|(body, mate, surface)| {
        [(40, 30, false), (41, 30, false), (60, 63, true)]
            .map(|(column, row, edge)| point(body, mate, surface, column, row, edge))
    });
    let path = (0..4).map(|step| PathPoint {
        step,
        first_body: "pinion".into(),
        first_tooth: 0,
        second_body: "gear".into(),
        second_tooth: 0,
        flank: "drive".into(),
        force: 100.0 * (step + 1) as f64,
        edge_force: 0.0,
        first_along_face: face(0.4 + 0.05 * step as f64),
        first_along_profile: 0.9 - 0.2 * step as f64,
        second_along_face: face(0.4),
        second_along_profile: 0.2,
    });
    let ease_off = (0..81).map(|index| {
        let (column, row) = (index / 9, index % 9);
        let (x, y) = (column as f64 / 8.0, row as f64 / 8.0);
        let off = 80e-6 * ((x - 0.5).powi(2) + (y - 0.5).powi(2));
        EaseOffRow {
            first_body: "pinion".into(),
            second_body: "gear".into(),
            flank: "drive".into(),
            column,
            row,
            first_along_face: face(x),
            first_along_profile: y,
            second_along_face: face(x),
            second_along_profile: 1.0 - y,
            ease_off: off,
            gap: off,
        }
    });
    let unloaded = (-12..=12).map(|k: i32| UnloadedRow {
        first_body: "pinion".into(),
        second_body: "gear".into(),
        flank: "drive".into(),
        pitch: 0.26,
        rotation: 0.02 * f64::from(k),
        transmission_error: 1e-6 * f64::from(k * k),
        touches: k.abs() <= 6,
        edge: false,
        first_along_face: face(0.5),
        first_along_profile: 0.5 + 0.03 * f64::from(k),
        second_along_face: face(0.5),
        second_along_profile: 0.5 - 0.03 * f64::from(k),
    });
    let position = |step: usize| Position {
        time: step as f64,
        cycle: 0.25 * step as f64,
        roll: 0.1 * step as f64,
        point: String::new(),
    };
    Run {
        head: serde_json::json!({}),
        end: End::Finished,
        timing: None,
        positions: (0..4).map(position).collect(),
        outputs: Vec::new(),
        contact: vec![loaded()],
        contact_pattern: pattern.into_iter().flatten().collect(),
        contact_path: path.collect(),
        flanks: FlankTables { flanks, unloaded: unloaded.collect(), ease_off: ease_off.collect() },
        stresses: Vec::new(),
        elements: Vec::new(),
        laminae: Vec::new(),
        pictures: Vec::new(),
        bodies: Vec::new(),
        forced_response: Vec::new(),
        radiated_sound: crate::radiated_sound::SoundTables::default(),
        natural_frequencies: Vec::new(),
        modes: Vec::new(),
        sensitivities: Vec::new(),
        tradeoff: None,
        files: Vec::new(),
    }
}

fn text(run: &Run) -> String {
    section(run, Units::of_system("mm_N_s")).into_string()
}

/// Returns the largest coordinates of the points of an element of a drawing.
fn reach(element: &str) -> [i32; 4] {
    let points = element.split("points=\"").nth(1).unwrap().split('"').next().unwrap();
    let at: Vec<[i32; 2]> = points
        .split_whitespace()
        .map(|point| {
            let (x, y) = point.split_once(',').unwrap();
            [x.parse().unwrap(), y.parse().unwrap()]
        })
        .collect();
    let ends = |k: usize| {
        let values = || at.iter().map(|point| point[k]);
        [values().min().unwrap(), values().max().unwrap()]
    };
    let ([a, b], [c, d]) = (ends(0), ends(1));
    [a, b, c, d]
}

#[test]
fn every_tooth_has_its_boundaries_flanks_and_scales() {
    let run = run(false);
    let page = text(&run);
    let drawings: Vec<&str> = page.split("<svg ").skip(1).collect();
    // Loaded and unloaded contact on both gears, transmission error, load sharing.
    assert_eq!(drawings.len(), 6);
    for drawing in &drawings[..4] {
        for name in ["toe", "heel", "tip", "root", "height above the root [mm]"] {
            assert!(drawing.contains(&format!("\n{name}\n")), "{name}");
        }
    }
    assert!(drawings[0].contains("\npressure [MPa]\n") && drawings[2].contains("\nease-off [um]\n"));
    for text in ["pinion, concave flank (drive)", "gear, convex flank (drive)", "2500 MPa", "1500 MPa"] {
        assert!(page.contains(text), "{text}");
    }
    assert_eq!(page.matches("contact of an edge: higher").count(), 2);
    // A flank that is not curved has the name of its side.
    let mut straight = run;
    straight.flanks.flanks.iter_mut().for_each(|row| row.shape = "straight".into());
    let page = text(&straight);
    assert!(page.contains("pinion, counter-clockwise flank (drive), and gear, clockwise flank"));
}

#[test]
fn pictures_are_true_to_scale_and_patterns_inside_the_outline() {
    let page = text(&run(false));
    let drawing = page.split("<svg ").nth(1).unwrap();
    let outline = drawing.split("<polyline").find(|part| part.contains("stroke-width=\"4\"")).unwrap();
    let [left, right, top, bottom] = reach(outline);
    let scale = f64::from(right - left) / LENGTH;
    let height = 1e-3 + 1.2 * HEIGHT;
    assert!((f64::from(bottom - top) / (height * scale) - 1.0).abs() < 0.01);
    let patches: Vec<&str> = drawing.split("<polygon").skip(2).collect();
    assert_eq!(patches.len(), 3);
    for patch in patches {
        let [x0, x1, y0, y1] = reach(patch);
        assert!(x0 >= left && x1 <= right && y0 >= top && y1 <= bottom);
    }
    let [x0, ..] = reach(drawing.split("<polygon").nth(2).unwrap());
    assert!((f64::from(x0 - left) / f64::from(right - left) - 40.0 / 96.0).abs() < 0.01, "{x0}");
}

#[test]
fn left_and_right_hands_have_the_same_pictures() {
    let [right, left] = [run(false), run(true)].map(|run| text(&run));
    let drawings = |page: &str| -> Vec<Vec<[i32; 4]>> {
        let drawing = |drawing: &str| -> Vec<[i32; 4]> {
            let elements = drawing.split('<').filter(|element| element.contains("points=\""));
            let mut all: Vec<[i32; 4]> = elements.map(reach).collect();
            all.sort_unstable();
            all
        };
        page.split("<svg ").skip(1).map(drawing).collect()
    };
    let (right, left) = (drawings(&right), drawings(&left));
    for (drawing, (one, other)) in right.iter().zip(&left).enumerate() {
        assert!(!one.is_empty());
        // Contour lines cross the halves of their cells in the other direction.
        let patterns = !(2..=3).contains(&drawing);
        assert!(!patterns || one == other, "{drawing}");
    }
}

/// Contour lines and paths of rounding errors are not drawn.
#[test]
fn conjugate_flanks_have_a_plain_picture() {
    let mut run = run(false);
    run.flanks.ease_off.iter_mut().for_each(|row| (row.ease_off, row.gap) = (1e-6 * row.ease_off, 0.0));
    let page = text(&run);
    // The caption is also the text for screen readers.
    assert_eq!(page.matches("These flanks are conjugate").count(), 4);
    assert!(!page.contains("path of contact without load"));
    assert!(page.contains("ease-off [um]"));
}

#[test]
fn the_ease_off_has_the_unit_of_the_model() {
    let run = run(false);
    let inches = section(&run, Units::of_system("inch_lbf_s")).into_string();
    assert!(inches.contains("ease-off [microinch]") && !inches.contains("ease-off [um]"));
    assert!(inches.contains("a marking compound of 250 microinch"));
    assert!(text(&run).contains("a marking compound of 6.35 um"));
}

#[test]
fn runs_of_parallel_axes_have_no_section() {
    let mut run = run(false);
    run.flanks = FlankTables::default();
    assert!(text(&run).is_empty() && bodies(&run).is_empty());
}
