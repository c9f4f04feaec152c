//! Compares flank modifications of the library with their closed forms, and the pictures of
//! `docs/howto/microgeometry.md` with the modifications that they show. `CALYX_BLESS=1` rewrites
//! the pictures.

use calyx_tests::printed::printed_numbers;
use calyx_tests::root;
use std::fmt::Write;

/// Largest difference from a closed form, relative to an amount of one micrometre.
const ROUNDING: f64 = 1e-11;

/// Amount of a modification at a point of a flank.
struct Row {
    /// Function of `gears.cx` that creates the gear with the modification.
    gear: String,
    modification: String,
    /// Roll angle, rad, as text.
    roll: String,
    /// Axial position, mm, as text.
    position: String,
    flank: String,
    /// Amount removed, um.
    amount: f64,
}

fn rows() -> Vec<Row> {
    let path = root().join("stdlib-gears/tests/data/microgeometry.csv");
    let text = std::fs::read_to_string(path).expect("the data");
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines
        .map(|line| {
            let cells: Vec<String> = line.split('|').map(str::to_owned).collect();
            let [gear, modification, roll, position, flank, amount] =
                <[String; 6]>::try_from(cells).unwrap_or_else(|_| panic!("not a row: {line}"));
            let amount = amount.parse().unwrap_or_else(|_| panic!("not a number: {line}"));
            Row { gear, modification, roll, position, flank, amount }
        })
        .collect()
}

/// Amounts in um that a program prints for these points, with the gears of `gears.cx`.
fn amounts<'r>(points: impl Iterator<Item = [&'r str; 5]>) -> Vec<f64> {
    let mut text = std::fs::read_to_string(root().join("tests/microgeometry/gears.cx")).expect("the model");
    for [gear, modification, roll, position, flank] in points {
        let point = format!("{roll} rad, {position} mm, \"{flank}\"");
        let amount = format!("gears.modification_amount({gear}({modification}), {point}) / (1 um)");
        writeln!(text, "print({amount});").expect("text grows");
    }
    printed_numbers("gears.cx", &text)
}

#[test]
fn modifications_agree_with_their_closed_forms() {
    let rows = rows();
    let points = rows
        .iter()
        .map(|row| [&row.gear, &row.modification, &row.roll, &row.position, &row.flank].map(String::as_str));
    let found = amounts(points);
    assert_eq!(found.len(), rows.len());
    let mut wrong = String::new();
    for (row, found) in rows.iter().zip(found) {
        if (found - row.amount).abs() > ROUNDING * row.amount.abs().max(1.0) {
            let Row { gear, modification, roll, position, flank, amount } = row;
            let point = format!("{roll} rad, {position} mm, {flank}");
            writeln!(wrong, "{gear} {modification} at {point}: {found} is not {amount}").unwrap();
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
    assert!(rows.len() > 500, "only {} rows", rows.len());
}

/// Compares a picture of the page with the drawing.
fn compare(name: &str, drawing: &str) {
    let path = root().join("docs/pictures").join(name);
    if std::env::var_os("CALYX_BLESS").is_some() {
        std::fs::write(&path, drawing).expect("writable");
        return;
    }
    let drawn = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(drawn == drawing, "{name} differs; CALYX_BLESS=1 draws it again");
}

/// Frames a drawing of this size on white.
fn picture([width, height]: [f64; 2], content: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
         height=\"{height}\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n{content}</svg>\n"
    )
}

fn text(x: f64, y: f64, anchor: &str, color: &str, words: &str) -> String {
    format!("<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" fill=\"{color}\">{words}</text>\n")
}

fn polyline(points: &[[f64; 2]], color: &str, width: f64) -> String {
    let points: Vec<String> = points.iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
    format!(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\"/>\n",
        points.join(" ")
    )
}

#[test]
fn the_picture_of_relief_shapes_shows_the_amounts() {
    const FROM: f64 = 0.44;
    const TO: f64 = 0.566;
    let shapes = [
        ("linear", "\"linear\"", "#0b5fa5"),
        ("progressive, exponent 1.5", "\"progressive\", exponent = 1.5", "#2e7d32"),
        ("quadratic, arc", "\"quadratic\"", "#b03a2e"),
        ("arc", "\"arc\"", "#b03a2e"),
        ("progressive, exponent 4", "\"progressive\", exponent = 4", "#7b4ea3"),
    ];
    let rolls: Vec<String> =
        (0..=60).map(|step| format!("{:.4}", FROM + (TO - FROM) * f64::from(step) / 60.0)).collect();
    let modifications = shapes.map(|(_, shape, _)| {
        format!("gears.tip_relief(20 um, start_roll_angle = 0.46 rad, shape = {shape})")
    });
    let points = modifications.iter().flat_map(|modification| {
        rolls.iter().map(move |roll| ["spur", modification.as_str(), roll.as_str(), "0", "left"])
    });
    let found = amounts(points);
    let x = |step: usize| 60.0 + 380.0 * step as f64 / 60.0;
    let y = |amount: f64| 40.0 + 9.0 * amount;
    let start = 60.0 + 380.0 * (0.46 - FROM) / (TO - FROM);
    let mut content = polyline(&[[50.0, y(0.0)], [450.0, y(0.0)]], "#888888", 1.0);
    for (at, words) in [(start, "start"), (440.0, "tip circle")] {
        content += &polyline(&[[at, 30.0], [at, 250.0]], "#bbbbbb", 1.0);
        content += &text(at, 22.0, "middle", "#333333", words);
    }
    let mut row: u8 = 0;
    for ((name, _, color), curve) in shapes.iter().zip(found.chunks(rolls.len())) {
        let line: Vec<[f64; 2]> = curve.iter().enumerate().map(|(step, a)| [x(step), y(*a)]).collect();
        content += &polyline(&line, color, 2.0);
        // The arc lies on the quadratic shape, whose label names both.
        if *name != "arc" {
            content += &text(132.0, 158.0 + 20.0 * f64::from(row), "start", color, name);
            row += 1;
        }
    }
    content += &text(250.0, 268.0, "middle", "#333333", "roll angle, or roll length, from root to tip");
    content += &text(452.0, y(0.0) + 4.0, "start", "#333333", "0");
    content += &text(452.0, y(20.0) + 4.0, "start", "#333333", "depth");
    compare("relief_shapes.svg", &picture([500.0, 280.0], &content));
}

/// Outline of a tooth with the tip upwards, in modules from the middle of its root: the flank on
/// the right, from the root to the tip.
fn tooth_outline(internal: bool) -> Vec<[f64; 2]> {
    let (alpha, teeth) = (20.0_f64.to_radians(), 25.0);
    let pitch_radius = 0.5 * teeth;
    let base = pitch_radius * alpha.cos();
    let involute = |roll: f64| roll - roll.atan();
    let reference = involute(alpha.tan());
    // The tooth of an internal gear is the space of an external one.
    let half = std::f64::consts::PI / (2.0 * teeth);
    let sign = if internal { -1.0 } else { 1.0 };
    (0..=12)
        .map(|step| {
            let along = f64::from(step) / 12.0;
            let radius = pitch_radius + sign * (-0.95 + 1.9 * along);
            let roll = ((radius / base).powi(2) - 1.0).max(0.0).sqrt();
            let angle = half - sign * (involute(roll) - reference);
            [radius * angle.sin(), sign * (radius * angle.cos() - pitch_radius) + 1.0]
        })
        .collect()
}

#[test]
fn the_picture_of_left_and_right_flanks_is_drawn() {
    let mut content = String::new();
    for (middle, internal, name) in [(130.0, false, "external tooth"), (370.0, true, "internal tooth")] {
        let outline = tooth_outline(internal);
        let place = |side: f64, [x, y]: [f64; 2]| [middle + side * 45.0 * x, 150.0 - 45.0 * y];
        let right: Vec<[f64; 2]> = outline.iter().map(|point| place(1.0, *point)).collect();
        let left: Vec<[f64; 2]> = outline.iter().map(|point| place(-1.0, *point)).collect();
        content += &polyline(&[left[12], right[12]], "#555555", 1.5);
        for (flank, away) in [(&left, -1.0), (&right, 1.0)] {
            content += &polyline(&[flank[0], [flank[0][0] + away * 25.0, flank[0][1]]], "#555555", 1.5);
        }
        content += &polyline(&left, "#0b5fa5", 3.0);
        content += &polyline(&right, "#b03a2e", 3.0);
        content += &text(left[6][0] - 12.0, left[6][1], "end", "#0b5fa5", "left");
        content += &text(right[6][0] + 12.0, right[6][1], "start", "#b03a2e", "right");
        content += &text(middle, 190.0, "middle", "#333333", name);
        // The counter-clockwise side of an external tooth is the left one.
        let turn =
            if internal { ["clockwise", "counter-clockwise"] } else { ["counter-clockwise", "clockwise"] };
        content += &text(middle - 108.0, 48.0, "start", "#777777", turn[0]);
        content += &text(middle + 108.0, 48.0, "end", "#777777", turn[1]);
    }
    content +=
        &text(250.0, 22.0, "middle", "#777777", "side of the tooth, in the sense of rotation about e3");
    content +=
        &text(250.0, 214.0, "middle", "#333333", "seen against e3, from the end of the face towards +e3");
    compare("left_right_flanks.svg", &picture([500.0, 225.0], &content));
}

#[test]
fn the_picture_of_slopes_shows_the_amounts() {
    const STEPS: usize = 8;
    let columns = [
        ("helical_right", "left", "right hand, left"),
        ("helical_right", "right", "right hand, right"),
        ("helical_left", "left", "left hand, left"),
        ("helical_left", "right", "left hand, right"),
    ];
    let kinds = ["gears.profile_slope(4 um)", "gears.helix_slope(4 um)", "gears.twist(8 um)"];
    // Roll angles of the root form circle and the tip circle of these gears.
    let (form, tip) = (0.187_929_7, 0.537_340_9);
    let parts: Vec<f64> = (0..STEPS).map(|step| (step as f64 + 0.5) / STEPS as f64).collect();
    let grid: Vec<[String; 2]> = parts
        .iter()
        .flat_map(|t| {
            parts
                .iter()
                .map(move |z| [format!("{}", form + t * (tip - form)), format!("{}", 30.0 * z - 15.0)])
        })
        .collect();
    let points = kinds.iter().flat_map(|kind| columns.iter().map(move |column| (kind, column)));
    let points = points.flat_map(|(kind, (gear, flank, _))| {
        grid.iter().map(move |[roll, z]| [*gear, *kind, roll.as_str(), z.as_str(), *flank])
    });
    let found = amounts(points);
    let mut content = String::new();
    for (row, kind) in kinds.iter().enumerate() {
        for (column, (_, _, title)) in columns.iter().enumerate() {
            let [left, top] = [100.0 + 150.0 * column as f64, 60.0 + 130.0 * row as f64];
            let cells = &found[(row * columns.len() + column) * grid.len()..][..grid.len()];
            for (index, amount) in cells.iter().enumerate() {
                let (t, z) = (index / STEPS, index % STEPS);
                let [width, height] = [120.0 / STEPS as f64, 80.0 / STEPS as f64];
                let shade = (255.0 - 45.0 * amount.abs()).max(60.0).round();
                // Removed material is blue, added material red.
                let color = if *amount > 0.0 {
                    format!("rgb({shade},{shade},255)")
                } else {
                    format!("rgb(255,{shade},{shade})")
                };
                content += &format!(
                    "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" fill=\"{color}\"/>\n",
                    left + width * z as f64,
                    top + 80.0 - height * (t + 1) as f64,
                );
            }
            let added = |t: usize, z: usize| {
                let amount = -cells[t * STEPS + z];
                if amount.abs() < 0.5 {
                    "0"
                } else if amount > 0.0 {
                    "+"
                } else {
                    "\u{2212}"
                }
            };
            let end = STEPS - 1;
            for (t, z, [x, y]) in [
                (0, 0, [8.0, 76.0]),
                (0, end, [112.0, 76.0]),
                (end, 0, [8.0, 13.0]),
                (end, end, [112.0, 13.0]),
            ] {
                content += &text(left + x, top + y, "middle", "#000000", added(t, z));
            }
            if row == 0 {
                content += &text(left + 60.0, 45.0, "middle", "#333333", title);
            }
        }
        let (top, name) = (60.0 + 130.0 * row as f64, kind.replace("gears.", ""));
        content += &text(100.0, top + 98.0, "start", "#333333", &name);
        content += &text(92.0, top + 12.0, "end", "#777777", "tip");
        content += &text(92.0, top + 78.0, "end", "#777777", "root");
    }
    content +=
        &text(350.0, 20.0, "middle", "#333333", "red, +: material added;  blue, \u{2212}: material removed");
    content += &text(92.0, 45.0, "end", "#777777", "hand, flank:");
    content += &text(
        670.0,
        60.0 + 130.0 * (kinds.len() - 1) as f64 + 98.0,
        "end",
        "#777777",
        "each from \u{2212}e3 on the left to +e3 on the right",
    );
    compare("slope_signs.svg", &picture([700.0, 455.0], &content));
}
