//! Sectors against the whole ring in one mesh.

use super::sector_of;
use crate::BoreSupport;
use crate::bore::{BoreMeans, RequestedMeans};
use crate::condense::Assembled;
use crate::modes::body::{RingFields, ring_sector};
use crate::modes::cyclic::ring_modes;
use crate::modes::sector::Sector;
use crate::tests::bodies::{Divisions, STEEL, ring_source, toothed_ring, toothed_sector};
use calyx_fe::PlaneModel;
use calyx_fe::material::Plane;
use calyx_numerics::dense::{cholesky, product, solve_lower};
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, Side};
use std::f64::consts::TAU;

const SMALL: Divisions = Divisions { rim: 1, tooth_root: 1, flank: 2, thickness: 2, grading: 1.0 };
const TEETH: u32 = 6;

/// Returns the squares of all natural frequencies of a whole mesh with the support of a ring, by
/// dense matrices.
fn of_whole(support: Option<BoreSupport>) -> Vec<f64> {
    let model = PlaneModel::new(toothed_ring(TEETH, SMALL), STEEL, Plane::Strain);
    let assembled = Assembled::plane(&model);
    let bore = model.mesh.chain("bore").unwrap();
    let constrained = match support {
        Some(BoreSupport::Rigid) => assembled.dofs_of(&model.mesh.chain_nodes(bore)),
        _ => Vec::new(),
    };
    let free: Vec<usize> = (0..model.dof_count()).filter(|dof| !constrained.contains(dof)).collect();
    let dense = |sparse: &faer::sparse::SparseColMat<usize, f64>| {
        let full = sparse.to_dense();
        Mat::from_fn(free.len(), free.len(), |row, column| full[(free[row], free[column])])
    };
    let factor = cholesky(dense(&model.mass())).unwrap();
    let half = solve_lower(factor.as_ref(), dense(&assembled.stiffness));
    let mut matrix = solve_lower(factor.as_ref(), half.transpose().to_owned());
    if let Some(BoreSupport::Means { harmonics, degree }) = support {
        let wanted = RequestedMeans::of_means(harmonics, degree);
        let means = BoreMeans::plane(&model, bore, wanted, &Interrupt::never()).unwrap().unwrap();
        let forms: Vec<Vec<f64>> = means.forms.iter().map(|form| form.to_full(model.dof_count())).collect();
        let forms = Mat::from_fn(free.len(), forms.len(), |row, column| forms[column][free[row]]);
        // Projects the matrix on the complement of the forms; the forms get the eigenvalue zero.
        let forms = solve_lower(factor.as_ref(), forms).qr().compute_thin_Q();
        let mut beside = Mat::<f64>::identity(free.len(), free.len());
        beside -= product(forms.as_ref(), forms.transpose());
        matrix = product(product(beside.as_ref(), matrix.as_ref()).as_ref(), beside.as_ref());
    }
    let mut squares = matrix.self_adjoint_eigenvalues(Side::Lower).unwrap();
    if let Some(BoreSupport::Means { .. }) = support {
        let constrained =
            squares.iter().filter(|&&square| square.abs() < 1e-6 * squares[squares.len() / 2]).count();
        squares.drain(..constrained);
    }
    squares
}

fn fields(sector: &Sector, highest: f64) -> RingFields<'_> {
    RingFields::new(sector, ring_modes(sector, highest, &Interrupt::never()).unwrap())
}

/// Returns a ring of sectors, supported or free.
fn ring(support: Option<BoreSupport>) -> Sector {
    let (model, _) = toothed_sector(TEETH, 1.0, SMALL);
    match support {
        Some(support) => {
            let source = crate::RingSource { support, ..ring_source(TEETH) };
            ring_sector(&model, &source, &Interrupt::never()).unwrap()
        }
        None => sector_of(&model, TEETH, false),
    }
}

const SUPPORTS: [Option<BoreSupport>; 4] = [
    None,
    Some(BoreSupport::Rigid),
    Some(BoreSupport::Means { harmonics: None, degree: 0 }),
    Some(BoreSupport::Means { harmonics: Some(3), degree: 0 }),
];

#[test]
fn no_mode_of_the_whole_ring_is_missed() {
    for support in SUPPORTS {
        let whole = of_whole(support);
        // Cut-offs between two frequencies, also further up where the spectrum is dense.
        for number in [5, 20, 60] {
            let gap = (number..).find(|&k| whole[k + 1] > 1.001 * whole[k] && whole[k] > 1.0).unwrap();
            let highest = (0.5 * (whole[gap] + whole[gap + 1])).sqrt();
            let sector = ring(support);
            let found = fields(&sector, highest).squares;
            assert_eq!(found.len(), gap + 1, "{support:?} up to number {gap}");
            for (k, (a, b)) in found.iter().zip(&whole).enumerate() {
                assert!(
                    (a - b).abs() < 1e-9 * b + 1e-14 * whole[whole.len() - 1],
                    "{support:?}, mode {k}: {a} against {b}"
                );
            }
        }
    }
}

#[test]
fn modes_are_orthogonal_on_the_whole_ring() {
    for support in SUPPORTS {
        let sector = ring(support);
        let highest = of_whole(support)[40].sqrt();
        let fields = fields(&sector, highest);
        let count = fields.modes.len();
        assert!(count > 35);
        let [mut mass, mut stiffness] = [0, 1].map(|_| Mat::<f64>::zeros(count, count));
        for tooth in 0..TEETH {
            let around = Mat::from_fn(sector.dofs(), count, |dof, mode| {
                let field = fields.modes[mode].field;
                let (sin, cos) =
                    (TAU * f64::from(tooth * fields.harmonics[field]) / f64::from(TEETH)).sin_cos();
                let [re, im] = [0, 1].map(|part| fields.parts[part][(dof, field)]);
                if fields.modes[mode].sine { cos * im + sin * re } else { cos * re - sin * im }
            });
            for (sum, matrix) in [(&mut mass, &sector.mass), (&mut stiffness, &sector.stiffness)] {
                *sum += around.transpose() * (matrix * &around);
            }
        }
        for row in 0..count {
            for column in 0..count {
                let unit = if row == column { 1.0 } else { 0.0 };
                assert!((mass[(row, column)] - unit).abs() < 1e-9, "{support:?}: {row} {column}");
                let square = unit * fields.squares[row];
                let scale = fields.squares[row].max(fields.squares[column]).max(fields.squares[3]);
                let error = (stiffness[(row, column)] - square).abs() / scale;
                assert!(error < 1e-9, "{support:?}: {row} {column}: {error:.1e}");
            }
        }
    }
}
