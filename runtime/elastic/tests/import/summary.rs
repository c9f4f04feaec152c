//! Text of an imported body, to compare with the text of a case.

use calyx_elastic::import::{CondensedMatrices, Import};
use calyx_elastic::model::{Components, Constraint, Element, ElementKind};
use std::fmt::Write;

/// Number with six digits.
pub fn number(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().expect("a number");
    format!("{:?}", if rounded == 0.0 { 0.0 } else { rounded })
}

fn numbers(values: impl IntoIterator<Item = f64>) -> String {
    values.into_iter().map(number).collect::<Vec<_>>().join(" ")
}

fn digits(components: &Components) -> String {
    (0..6).filter(|c| components[*c]).map(|c| (c + 1).to_string()).collect()
}

/// Text with a line for each part of the model and each remark of the report.
pub fn summary(import: &Import) -> String {
    let model = &import.model;
    let label = |node: &usize| model.nodes[*node].label.to_string();
    let mut text = String::new();
    let mut line = |entry: String| writeln!(text, "{entry}").expect("text grows");
    if !import.report.title.is_empty() {
        line(format!("title {}", import.report.title));
    }
    for node in &model.nodes {
        let basic = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let axes = match node.axes == basic {
            true => String::new(),
            false => format!(" axes {}", node.axes.map(numbers).join(", ")),
        };
        line(format!("node {}: {}{axes}", node.label, numbers(node.position)));
    }
    for (at, material) in model.materials.iter().enumerate() {
        line(format!(
            "material {at}: {}",
            numbers([
                material.youngs_modulus,
                material.poissons_ratio,
                material.shear_modulus,
                material.density,
                material.structural_damping
            ])
        ));
    }
    for element in &model.elements {
        let nodes: Vec<String> = element.nodes.iter().map(label).collect();
        line(format!(
            "element {}: {} nodes {}{}",
            element.label,
            kind(element),
            nodes.join(" "),
            element.material.map_or_else(String::new, |at| format!(" material {at}"))
        ));
    }
    for constraint in &model.constraints {
        line(match constraint {
            Constraint::Rigid { label: own, reference, dependents } => {
                let all: Vec<String> =
                    dependents.iter().map(|(node, c)| format!("{}({})", label(node), digits(c))).collect();
                format!("rigid {own}: {} moves {}", label(reference), all.join(" "))
            }
            Constraint::WeightedAverage { label: own, reference, components, terms } => {
                let all: Vec<String> = terms
                    .iter()
                    .map(|(w, node, c)| format!("{}*{}({})", number(*w), label(node), digits(c)))
                    .collect();
                format!("average {own}: {}({}) of {}", label(reference), digits(components), all.join(" "))
            }
            Constraint::Equation { label: own, terms } => {
                let all: Vec<String> = terms
                    .iter()
                    .map(|(node, c, factor)| format!("{}*{}({})", number(*factor), label(node), c + 1))
                    .collect();
                format!("equation {own}: {}", all.join(" + "))
            }
        });
    }
    for fixed in &model.fixed {
        line(format!(
            "fixed {}({}) = {}",
            label(&fixed.node),
            digits(&fixed.components),
            number(fixed.value)
        ));
    }
    for load in &model.loads {
        line(format!("load {}: {}", label(&load.node), numbers(load.load)));
    }
    for (name, nodes) in &model.sets {
        line(format!("set {name}: {}", nodes.iter().map(label).collect::<Vec<_>>().join(" ")));
    }
    for skipped in &import.report.skipped {
        line(format!("skipped {} x{} {}:{}", skipped.name, skipped.count, skipped.file, skipped.line));
    }
    for note in &import.report.notes {
        line(format!("note {note}"));
    }
    let mass = &import.report.mass;
    if mass.mass != 0.0 {
        line(format!("mass {} at {}", number(mass.mass), numbers(mass.centre)));
    }
    text
}

fn kind(element: &Element) -> String {
    match &element.kind {
        ElementKind::Solid(shape) => format!("{shape:?}"),
        ElementKind::Shell { shape, thickness, offset, added_mass } => format!(
            "{shape:?} thickness {} offset {} added {}",
            numbers(thickness.iter().copied()),
            number(*offset),
            number(*added_mass)
        ),
        ElementKind::Beam(beam) => {
            let section = |end: usize| {
                let s = beam.sections[end];
                numbers([
                    s.area,
                    s.second_moment_z,
                    s.second_moment_y,
                    s.product_of_inertia,
                    s.torsion_constant,
                    s.shear_factors[0],
                    s.shear_factors[1],
                    s.added_mass,
                ])
            };
            let second = if beam.sections[0] == beam.sections[1] { "same".into() } else { section(1) };
            let mut text = format!("Beam [{}] [{second}] y {}", section(0), numbers(beam.orientation));
            if beam.offsets != [[0.0; 3]; 2] {
                write!(text, " offsets {}", beam.offsets.map(numbers).join(", ")).expect("text grows");
            }
            if beam.released != [[false; 6]; 2] {
                let released = [0, 1].map(|end| digits(&beam.released[end]));
                write!(text, " released {}", released.join(", ")).expect("text grows");
            }
            text
        }
        ElementKind::Rod { area, torsion_constant, added_mass } => {
            format!("Rod {}", numbers([*area, *torsion_constant, *added_mass]))
        }
        ElementKind::Spring { components, stiffness } => {
            format!("Spring {} {} {}", components[0] + 1, components[1] + 1, number(*stiffness))
        }
        ElementKind::Mass { mass, offset, inertia } => format!(
            "Mass {} offset {} inertia {}",
            number(*mass),
            numbers(*offset),
            numbers(inertia.iter().flatten().copied())
        ),
    }
}

/// Text with a line for each node and each row of the matrices of a condensed body.
pub fn condensed(body: &CondensedMatrices) -> String {
    let mut text = String::new();
    for node in &body.nodes {
        let position = node.position.map_or_else(|| "?".to_owned(), numbers);
        writeln!(text, "node {}: {position}", node.label).expect("text grows");
    }
    for (row, (node, component)) in body.components.iter().enumerate() {
        let entries = |matrix: &nalgebra::DMatrix<f64>| numbers(matrix.row(row).iter().copied());
        let mass = body.mass.as_ref().map_or_else(String::new, |mass| format!(" mass {}", entries(mass)));
        let label = &body.nodes[*node].label;
        let stiffness = entries(&body.stiffness);
        writeln!(text, "{label}({}): stiffness {stiffness}{mass}", component + 1).expect("text grows");
    }
    text
}
