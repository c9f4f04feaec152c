//! A bearing between the bore of a gear and the seat of an elastic body, eliminated from a contact
//! problem, against the equations of all unknowns.

use super::{SeatTerms, SeatedBodies};
use crate::step::nonlinear_bearings::Member;
use calyx_contact::problem::ContactProblem;
use calyx_model::bearing::{ElasticRaceways, NonlinearLoad, PlacedRaceway, RollingElements, by_element};
use calyx_rolling::{Material, Motion, Profile, RollerGeometry, RollerKind, RollerRow, RollingBearing};
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;
use std::sync::Arc;

const ROLLERS: usize = 7;
const CELLS: usize = 4;
const DOFS: usize = 3;
/// Terms of the series of the bore and of the seat.
const TERMS: [usize; 2] = [5, 4];
/// Width of a plane model, m.
const WIDTH: f64 = 0.02;
/// Terms of other seats of the elastic body, before those of the bearing.
const OTHERS: usize = 3;
const DEFLECTION: [f64; 5] = [12e-6, -4e-6, 0.0, 1e-4, -5e-5];

/// Numbers between -1 and 1 that look random, of the same size in each run.
fn numbers(rows: usize, columns: usize, seed: f64) -> DMatrix<f64> {
    DMatrix::from_fn(rows, columns, |row, column| {
        (97.3 * seed + 12.9898 * row as f64 + 78.233 * column as f64 + 1.0).sin()
    })
}

/// A positive definite matrix of this size.
fn definite(size: usize, scale: f64, seed: f64) -> DMatrix<f64> {
    let root = numbers(size, size, seed);
    scale * (&root * root.transpose() + DMatrix::identity(size, size))
}

fn rollers() -> NonlinearLoad {
    let row = RollerRow::new(RollerGeometry {
        kind: RollerKind::Cylindrical { clearance: 0.0 },
        count: ROLLERS,
        roller_diameter: 6e-3,
        length: 10e-3,
        pitch_diameter: 40e-3,
        profile: Profile::Logarithmic,
        laminae: 21,
        rings: Material::STEEL,
        rollers: Material::STEEL,
        raceway_widths: [None; 2],
    });
    let bearing = RollingBearing::single(row.expect("sound rollers"));
    NonlinearLoad::Rolling(Arc::new(RollingElements::new(bearing, Motion::REST).expect("sound rollers")))
}

/// Rows by rows or columns of the equations of all unknowns.
struct Equations {
    matrix: DMatrix<f64>,
    right: DVector<f64>,
}

impl Equations {
    fn add(&mut self, (row, column): (usize, usize), block: &DMatrix<f64>) {
        let mut view = self.matrix.view_mut((row, column), block.shape());
        view += block;
    }
}

#[test]
fn elimination_solves_the_equations_of_all_unknowns() {
    let nonlinear = rollers();
    let size = 3 * ROLLERS;
    let displaced = 2e-6 * numbers(size, 1, 0.1);
    let scales = [1.0, 1.0, 50.0];
    let by_terms = |terms: usize, seed: f64| {
        let all = numbers(size, terms, seed);
        DMatrix::from_fn(size, terms, |row, column| scales[row % 3] * all[(row, column)])
    };
    let [bore, own_seat] = [by_terms(TERMS[0], 0.2), by_terms(TERMS[1], 0.3)];
    let terms_of_body = OTHERS + TERMS[1];
    let mut seat = DMatrix::zeros(size, terms_of_body);
    seat.columns_mut(OTHERS, TERMS[1]).copy_from(&own_seat);
    let of_bore = definite(TERMS[0], 1e-9, 0.4);
    // The connection has one coefficient of another one before its own.
    let terms = SeatTerms { connection: 5, first: OTHERS - 1 };
    let compliance = &bore * &of_bore * bore.transpose();
    let placed = |by_terms: &DMatrix<f64>, seat| PlacedRaceway { body: 0, seat, by_terms: by_terms.clone() };
    let raceways = ElasticRaceways::new(
        vec![placed(&bore, None), placed(&own_seat, Some(terms))],
        compliance.clone(),
        WIDTH,
    );

    let at_rest = nonlinear.state(None, DEFLECTION).expect("finite");
    let state = nonlinear.state_on(&at_rest, DEFLECTION, &by_element(displaced.as_slice())).expect("finite");
    let tangent = nonlinear.tangent_with(&state, 0.0, Some(&raceways));
    let rigid = nonlinear.tangent(&state, 0.0);

    let arms: Vec<[f64; 6]> = numbers(DOFS, 6, 0.5)
        .row_iter()
        .map(|row| std::array::from_fn(|k| if k < 3 { row[k] } else { 20.0 * row[k] }))
        .collect();
    let motions = numbers(terms_of_body, DOFS, 0.6);
    let of_seat = definite(terms_of_body, 2e-9, 0.7);
    let factor = of_seat.clone().cholesky().expect("definite").l();
    let by_cells = 1e-9 * numbers(CELLS, TERMS[0], 0.8);
    let growth = raceways.growth(&by_cells).expect("a bore");

    // Without the bearing.
    let own = definite(CELLS, 1e-8, 0.9);
    let lever = numbers(CELLS, DOFS, 1.0);
    let gaps = DVector::from_fn(CELLS, |row, _| -1e-5 * (2.0 + row as f64));
    let springs = definite(DOFS, 1e8, 1.1);
    let load = 1e3 * DVector::from_fn(DOFS, |row, _| numbers(DOFS, 1, 1.2)[row]);

    // Unknowns: forces of cells, motions, displacements of the raceways, loads on them, and the
    // elastic part of the terms of the seat.
    let [p, u, v, f, s] = [0, CELLS, CELLS + DOFS, CELLS + DOFS + size, CELLS + DOFS + 2 * size];
    let all = s + terms_of_body;
    let mut equations = Equations { matrix: DMatrix::zeros(all, all), right: DVector::zeros(all) };
    let mut stiffness = DMatrix::zeros(size, size);
    let mut coupling = DMatrix::zeros(size, 5);
    let mut loads = DVector::zeros(size);
    for (element, load) in state.raceway_loads.iter().enumerate() {
        for i in 0..3 {
            loads[3 * element + i] = load.force[i];
            for j in 0..3 {
                let entry = 0.5 * (load.stiffness[i][j] + load.stiffness[j][i]);
                stiffness[(3 * element + i, 3 * element + j)] = entry;
            }
            for j in 0..5 {
                coupling[(3 * element + i, j)] = load.coupling[i][j];
            }
        }
    }
    let at = DVector::from_column_slice(displaced.as_slice());
    let deflections = DMatrix::from_fn(5, DOFS, |k, dof| arms[dof][k]);
    let bearing = DMatrix::from_fn(5, 5, |row, column| rigid.stiffness[row][column]);
    let identity = |size: usize| DMatrix::identity(size, size);
    // Gaps: g + A p + C u + H f = 0, and the growth of gaps by the bore.
    equations.add((p, p), &own);
    equations.add((p, u), &lever);
    equations.add((p, f), &(&growth / WIDTH));
    equations.right.rows_mut(p, CELLS).copy_from(&-&gaps);
    // Motions: K u + D' (k D u - l - B' (v - v0)) - A' E' f - C' p = load.
    equations.add((u, u), &(&springs + deflections.transpose() * &bearing * &deflections / WIDTH));
    equations.add((u, v), &-(deflections.transpose() * coupling.transpose() / WIDTH));
    equations.add((u, f), &-(motions.transpose() * seat.transpose() / WIDTH));
    equations.add((u, p), &-lever.transpose());
    let rest = DVector::from_fn(5, |k, _| rigid.load[k]) - coupling.transpose() * &at;
    equations.right.rows_mut(u, DOFS).copy_from(&(&load + deflections.transpose() * rest / WIDTH));
    // Displacements: v = H' p + C f + E (A u + s).
    equations.add((v, v), &identity(size));
    equations.add((v, p), &-growth.transpose());
    equations.add((v, f), &-&compliance);
    equations.add((v, u), &-(&seat * &motions));
    equations.add((v, s), &-&seat);
    // Loads: f = f0 + B (D u - q0) - K (v - v0).
    equations.add((f, f), &identity(size));
    equations.add((f, u), &-(&coupling * &deflections));
    equations.add((f, v), &stiffness);
    let start = loads - &coupling * DVector::from_row_slice(&DEFLECTION) + &stiffness * at;
    equations.right.rows_mut(f, size).copy_from(&start);
    // Seat: s = C E' f.
    equations.add((s, s), &identity(terms_of_body));
    equations.add((s, f), &-(&of_seat * seat.transpose()));
    let expected = equations.matrix.lu().solve(&equations.right).expect("regular");

    let member = Member {
        bearing: 0,
        nonlinear,
        raceways: Some(raceways.clone()),
        arms: arms.clone(),
        radius: 20e-3,
        width: WIDTH,
    };
    let first = BTreeMap::from([(2, 0), (5, 1)]);
    let bodies = SeatedBodies { motions, factor, first, members: vec![0], width: WIDTH };
    let (members, tangents, growths) = ([member], [tangent.clone()], [Some(growth.clone())]);
    let response = bodies.response(&members, &tangents);
    let rows = |matrix: &DMatrix<f64>| matrix.transpose().as_slice().to_vec();
    let deflected = DMatrix::from_fn(5, 5, |row, column| tangent.stiffness[row][column]);
    let of_bearing = deflections.transpose() * deflected * &deflections / WIDTH;
    let pushed = deflections.transpose() * DVector::from_fn(5, |k, _| tangent.load[k]) / WIDTH;
    // Motions of the problem are relative to these.
    let began = 1e-6 * DVector::from_fn(DOFS, |row, _| 1.0 + row as f64);
    let mut problem = ContactProblem {
        compliance: rows(&own),
        arms: rows(&lever),
        gaps: (&gaps + &lever * &began).as_slice().to_vec(),
        stiffness: rows(&(&springs + of_bearing)),
        load: (&load + pushed).as_slice().to_vec(),
    };
    response.add_to(&mut problem.stiffness, &mut problem.load);
    let elastic = tangent.raceway.as_ref().expect("a raceway");
    raceways.put(&mut problem, (elastic, &growth), &arms, began.as_slice());
    bodies.put(&mut problem, (&members, &tangents, &response), &growths, began.as_slice());

    let stiffness = DMatrix::from_row_slice(DOFS, DOFS, &problem.stiffness);
    let strained = &stiffness * &began;
    problem.load.iter_mut().zip(strained.iter()).for_each(|(load, part)| *load -= part);

    // All cells in contact: A p + C u = -g, K u - C' p = load.
    let mut reduced =
        Equations { matrix: DMatrix::zeros(CELLS + DOFS, CELLS + DOFS), right: DVector::zeros(CELLS + DOFS) };
    reduced.add((0, 0), &DMatrix::from_row_slice(CELLS, CELLS, &problem.compliance));
    let lever = DMatrix::from_row_slice(CELLS, DOFS, &problem.arms);
    reduced.add((0, CELLS), &lever);
    reduced.add((CELLS, 0), &-lever.transpose());
    reduced.add((CELLS, CELLS), &stiffness);
    reduced.right.rows_mut(0, CELLS).copy_from(&-DVector::from_row_slice(&problem.gaps));
    reduced.right.rows_mut(CELLS, DOFS).copy_from(&DVector::from_row_slice(&problem.load));
    let found = reduced.matrix.lu().solve(&reduced.right).expect("regular");

    let close = |what: &str, found: &[f64], expected: &[f64]| {
        let scale = expected.iter().fold(0.0f64, |most, entry| most.max(entry.abs()));
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-9 * scale, "{what}: {found:e} {expected:e}");
        }
    };
    close("forces", &found.as_slice()[..CELLS], &expected.as_slice()[p..u]);
    close("motions", (found.rows(CELLS, DOFS) + &began).as_slice(), &expected.as_slice()[u..v]);
    let motion = &expected.as_slice()[u..v];
    let on_cells = DVector::from_row_slice(&expected.as_slice()[p..u]);
    let mut moved = vec![growth.tr_mul(&on_cells).as_slice().to_vec()];
    bodies.displace(&mut moved, (&members, &tangents, &response), motion);
    let deflection: [f64; 5] = std::array::from_fn(|k| (0..DOFS).map(|dof| arms[dof][k] * motion[dof]).sum());
    let displaced = raceways.displaced(elastic, &deflection, &moved[0]);
    close("displacements", &displaced, &expected.as_slice()[v..f]);
    close("loads", &elastic.load_at(&deflection, &moved[0]), &expected.as_slice()[f..s]);
}
