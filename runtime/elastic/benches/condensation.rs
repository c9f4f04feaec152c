//! Time to condense a housing with eight bearing seats, as a ratio to a sparse Cholesky
//! factorization with minimum degree and one solution per attachment component, of the same matrix
//! in the same run.
//!
//! `cargo bench -p calyx-elastic --bench condensation` runs a small housing;
//! `-- full` one of 200,000 degrees of freedom, `-- 20` one of 20 cells along an edge,
//! `-- estimate 80` only states the memory of its factor, and `-- condense 86` condenses one of a
//! million degrees of freedom without the reference.

use calyx_elastic::assembly::System;
use calyx_elastic::attachment::{Attachment, Connection, Region, attach};
use calyx_elastic::condensation::{Synthesis, component_modes, static_condensation};
use calyx_elastic::factor::memory;
use calyx_elastic::model::SolidShape;
use calyx_elastic::{ElasticModel, Element, ElementKind, Material, Node, Resources};
use calyx_fe::dissection::Dissection;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::cholesky::{LltRef, SymmetricOrdering, factorize_symbolic_cholesky};
use faer::sparse::{SparseColMat, Triplet};
use faer::{Conj, Mat, Par, Side};
use std::collections::HashMap;
use std::time::Instant;

/// Edge of a cell, m.
const CELL: f64 = 0.012;
/// Thickness of the walls in cells.
const WALL: usize = 2;

fn main() {
    let edge = std::env::args().find_map(|argument| match argument.as_str() {
        "full" => Some(38),
        other => other.parse().ok(),
    });
    let (model, seats) = housing(edge.unwrap_or(14));
    let resources = Resources::default();
    let start = Instant::now();
    let system = System::new(&model, &resources).expect("valid");
    let assembly = start.elapsed().as_secs_f64();
    println!("{} degrees of freedom, {} seats", system.unknowns().len(), seats.len());

    let constrained = system.constrained();
    let kept: [usize; 0] = [];
    let dissection = Dissection::new(&system.stiffness, &system.positions, &constrained, &kept);
    let (bytes, entries) = memory(&dissection);
    println!("factor of {:.3e} entries, {:.2} GB with its work space", entries as f64, bytes as f64 / 1e9);
    if std::env::args().any(|argument| argument == "estimate") {
        return;
    }

    let start = Instant::now();
    let body = static_condensation(&system, &seats, &[], &resources).expect("condensed");
    let condensation = start.elapsed().as_secs_f64();
    if std::env::args().any(|argument| argument == "condense") {
        println!("assembly {assembly:.2} s, static condensation {condensation:.2} s");
        return;
    }
    let reference = cholesky(&system, &body.components);
    println!("assembly                  {assembly:8.2} s");
    println!(
        "static condensation       {condensation:8.2} s, {:.2} of the reference",
        condensation / reference
    );
    println!("Cholesky, minimum degree  {reference:8.2} s");

    let start = Instant::now();
    let highest = 2000.0;
    let modes = component_modes(&system, &seats, &[], Synthesis::FixedInterface, highest, &resources);
    let modes = modes.expect("condensed");
    let below = modes.eigenvalues.iter().filter(|value| value.sqrt() < highest * std::f64::consts::TAU);
    let time = start.elapsed().as_secs_f64();
    let count = below.count();
    println!("Craig-Bampton, {count:3} modes  {time:8.2} s, {:.2} of the reference", time / reference);
}

/// Returns the time of a factorization with the attachments fixed, and of their static responses.
fn cholesky(system: &System<'_>, components: &[(usize, usize)]) -> f64 {
    let mut unknown = vec![usize::MAX; system.dof_count()];
    let attached: Vec<usize> = components.iter().map(|(node, component)| 6 * node + component).collect();
    let mut count = 0;
    for dof in system.unknowns() {
        if !attached.contains(&dof) {
            unknown[dof] = count;
            count += 1;
        }
    }
    let mut entries = Vec::new();
    let mut loads = Mat::zeros(count, attached.len());
    for entry in system.stiffness.triplet_iter() {
        match (unknown[entry.row], unknown[entry.col]) {
            (usize::MAX, _) => {}
            (row, usize::MAX) => {
                if let Some(column) = attached.iter().position(|&dof| dof == entry.col) {
                    loads[(row, column)] = -entry.val;
                }
            }
            (row, column) if row >= column => entries.push(Triplet::new(row, column, *entry.val)),
            _ => {}
        }
    }
    let matrix = SparseColMat::try_new_from_triplets(count, count, &entries).expect("valid");
    drop(entries);
    let start = Instant::now();
    let par = Par::rayon(0);
    let order = SymmetricOrdering::Amd;
    let symbolic = factorize_symbolic_cholesky(matrix.symbolic(), Side::Lower, order, Default::default());
    let symbolic = symbolic.expect("enough memory");
    let mut factor = vec![0.0; symbolic.len_val()];
    let mut memory = MemBuffer::new(symbolic.factorize_numeric_llt_scratch::<f64>(par, Default::default()));
    let stack = MemStack::new(&mut memory);
    let (regularization, parameters) = (Default::default(), Default::default());
    symbolic
        .factorize_numeric_llt(
            &mut factor,
            matrix.as_ref(),
            Side::Lower,
            regularization,
            par,
            stack,
            parameters,
        )
        .expect("definite");
    let mut memory = MemBuffer::new(symbolic.solve_in_place_scratch::<f64>(loads.ncols(), par));
    LltRef::new(&symbolic, &factor).solve_in_place_with_conj(
        Conj::No,
        loads.as_mut(),
        par,
        MemStack::new(&mut memory),
    );
    start.elapsed().as_secs_f64()
}

/// Returns a box of walls with an open top, with four bores in each of two opposite walls.
fn housing(edge: usize) -> (ElasticModel, Vec<usize>) {
    let center = |k: usize| [0.3, 0.7][k] * edge as f64;
    let bores: Vec<[f64; 2]> = (0..4).map(|k| [center(k % 2), center(k / 2)]).collect();
    let radius = 0.13 * edge as f64;
    let is_solid = |[x, y, z]: [usize; 3]| {
        let wall = |k: usize| k < WALL || k >= edge - WALL;
        let at = [y as f64 + 0.5, z as f64 + 0.5];
        let bored = bores.iter().any(|bore| (at[0] - bore[0]).hypot(at[1] - bore[1]) < radius);
        (wall(x) && !bored) || wall(y) || z < WALL
    };
    let mut model = ElasticModel::default();
    model.materials.push(Material {
        youngs_modulus: 70e9,
        poissons_ratio: 0.33,
        shear_modulus: 70e9 / 2.66,
        density: 2700.0,
        structural_damping: 0.0,
    });
    // Nodes by twice their grid position.
    let mut numbers: HashMap<[usize; 3], usize> = HashMap::new();
    for x in 0..edge {
        for y in 0..edge {
            for z in (0..edge).filter(|&z| is_solid([x, y, z])) {
                let corner = |n: usize| {
                    let [i, j] = [[0, 0], [2, 0], [2, 2], [0, 2]][n % 4];
                    [2 * x + i, 2 * y + j, 2 * z + 2 * (n / 4)]
                };
                let midside = |&[from, to]: &[usize; 2]| {
                    let (a, b) = (corner(from), corner(to));
                    [0, 1, 2].map(|axis| (a[axis] + b[axis]) / 2)
                };
                let edges = SolidShape::Hexahedron20.midside_edges();
                let at: Vec<[usize; 3]> = (0..8).map(corner).chain(edges.iter().map(midside)).collect();
                let nodes = at
                    .into_iter()
                    .map(|at| {
                        *numbers.entry(at).or_insert_with(|| {
                            let label = model.nodes.len() as u64 + 1;
                            let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
                            let position = at.map(|k| 0.5 * CELL * k as f64);
                            model.nodes.push(Node { label, position, axes });
                            model.nodes.len() - 1
                        })
                    })
                    .collect();
                let label = model.elements.len() as u64 + 1;
                let kind = ElementKind::Solid(SolidShape::Hexahedron20);
                model.elements.push(Element { label, kind, nodes, material: Some(0) });
            }
        }
    }
    let mut seats = Vec::new();
    for wall in [0, edge - WALL] {
        for [y, z] in &bores {
            let from = CELL * wall as f64;
            let position = [from + 0.5 * CELL * WALL as f64, CELL * y, CELL * z];
            let region = Region::Cylinder {
                origin: [from, CELL * y, CELL * z],
                axis: [1.0, 0.0, 0.0],
                radius: CELL * radius,
                heights: [0.0, CELL * WALL as f64],
                tolerance: 0.6 * CELL,
            };
            let name = format!("seat {}", seats.len());
            let attachment =
                Attachment { name, position: Some(position), region, connection: Connection::Rigid };
            seats.push(attach(&mut model, &attachment).expect("attached")[0]);
        }
    }
    (model, seats)
}
