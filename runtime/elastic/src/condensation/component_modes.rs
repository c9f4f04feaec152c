//! Component mode synthesis: Craig-Bampton with fixed interfaces, and free interfaces with residual
//! flexibility.

use super::interface::Interface;
use super::{Attached, CondensedBody, prescribed_forces};
use crate::assembly::{System, multiply};
use crate::check::mechanism_within;
use crate::error::ElasticError;
use crate::factor::{Factor, Pencil};
use crate::model::NodalLoad;
use crate::modes::{self, Modes, Operator, Problem, Request, apply};
use crate::resources::Resources;
use calyx_fe::sparse::SparseVector;
use calyx_numerics::dense::{Interruptible, symmetric_eigen};
use faer::linalg::solvers::Solve;
use faer::sparse::SparseColMat;
use faer::{Mat, MatRef};

/// Kind of component modes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Synthesis {
    /// Modes with fixed attachments (Craig and Bampton 1968), and pseudo-modes above the highest
    /// frequency for the inertia of the omitted ones.
    FixedInterface,
    /// Modes with free attachments, and the residual flexibility of all others (MacNeal 1971, Rubin
    /// 1975, Craig and Chang 1977).
    FreeInterface,
}

/// Condenses stiffness, mass and load cases onto attachment nodes and the component modes up to a
/// highest frequency, Hz.
///
/// # Errors
/// As for [`super::static_condensation`], or the modes do not converge.
pub fn component_modes(
    system: &System<'_>,
    attachments: &[usize],
    cases: &[Vec<NodalLoad>],
    synthesis: Synthesis,
    highest_frequency: f64,
    resources: &Resources,
) -> Result<CondensedBody, ElasticError> {
    let attached = Attached::new(system, attachments)?;
    let mass = system.mass(resources)?;
    // Static shapes, their inertia and the pseudo-modes.
    let columns = 6 * (attached.components.len() + attached.helpers.len()) as u64;
    let bytes = 8 * columns * system.dof_count() as u64;
    let _room = resources.reserve("the shapes of the attachments", bytes, system.dof_count(), 1.0)?;
    let request = Request::Below(highest_frequency);
    let (shapes, modes, stiffness) = match synthesis {
        Synthesis::FixedInterface => fixed_interface(system, &mass, &attached, request, resources)?,
        Synthesis::FreeInterface => free_interface(system, &mass, &attached, request, resources)?,
    };
    let count = shapes.ncols();
    let stiffness = match stiffness {
        Some(static_stiffness) => Mat::from_fn(count, count, |row, column| {
            let attached = static_stiffness.nrows();
            if row < attached && column < attached {
                static_stiffness[(row, column)]
            } else if row == column {
                modes.eigenvalues[row - attached]
            } else {
                0.0
            }
        }),
        None => projected(&system.stiffness, shapes.as_ref(), resources)?,
    };
    let mass = projected(&mass, shapes.as_ref(), resources)?;
    let mut loads = Mat::zeros(count, cases.len());
    let by_prescribed = prescribed_forces(system);
    for (case, nodal) in cases.iter().enumerate() {
        let full = system.loads(nodal)?;
        for row in 0..count {
            let terms = shapes
                .col(row)
                .iter()
                .enumerate()
                .map(|(dof, shape)| shape * (full[dof] - by_prescribed[dof]));
            loads[(row, case)] = terms.sum::<f64>();
        }
    }
    Ok(CondensedBody {
        components: attached.components,
        eigenvalues: modes.eigenvalues,
        stiffness,
        mass: Some(mass),
        loads,
        between_loads: Mat::zeros(0, 0),
        shapes: Some(shapes),
    })
}

/// Condenses stiffness and mass onto attachment nodes by their static shapes (Guyan 1965).
///
/// # Errors
/// As for [`super::static_condensation`].
pub fn guyan(
    system: &System<'_>,
    attachments: &[usize],
    resources: &Resources,
) -> Result<CondensedBody, ElasticError> {
    let attached = Attached::new(system, attachments)?;
    let mass = system.mass(resources)?;
    let columns = 4 * (attached.components.len() + attached.helpers.len()) as u64;
    let bytes = 8 * columns * system.dof_count() as u64;
    let _room = resources.reserve("the shapes of the attachments", bytes, system.dof_count(), 1.0)?;
    let fixed = [&system.constrained()[..], &attached.direct, &attached.helpers].concat();
    let factor = Factor::new(Pencil::stiffness(&system.stiffness), &system.positions, &fixed, resources)?;
    if !factor.singular.is_empty() {
        return Err(mechanism_within(system, &factor.singular));
    }
    let (shapes, stiffness) = static_shapes(system, &attached, &factor, resources)?;
    let mass = projected(&mass, shapes.as_ref(), resources)?;
    Ok(CondensedBody {
        loads: Mat::zeros(attached.components.len(), 0),
        between_loads: Mat::zeros(0, 0),
        components: attached.components,
        eigenvalues: Vec::new(),
        stiffness,
        mass: Some(mass),
        shapes: Some(shapes),
    })
}

/// Returns `X^T A X`.
fn projected(
    matrix: &SparseColMat<usize, f64>,
    shapes: MatRef<'_, f64>,
    resources: &Resources,
) -> Result<Mat<f64>, ElasticError> {
    let images = images(matrix, shapes);
    let check = || resources.check();
    let product = Interruptible(&check).product(shapes.transpose(), images.as_ref())?;
    Ok(Mat::from_fn(product.nrows(), product.ncols(), |i, j| 0.5 * (product[(i, j)] + product[(j, i)])))
}

/// Returns `A X`.
fn images(matrix: &SparseColMat<usize, f64>, columns: MatRef<'_, f64>) -> Mat<f64> {
    let mut images = Mat::zeros(columns.nrows(), columns.ncols());
    for column in 0..columns.ncols() {
        let vector: Vec<f64> = columns.col(column).iter().copied().collect();
        for (row, value) in multiply(matrix, &vector).into_iter().enumerate() {
            images[(row, column)] = value;
        }
    }
    images
}

/// Shapes over all unknowns, component modes, and the stiffness of the attachments where it
/// decouples from the modes.
type Basis = (Mat<f64>, Modes, Option<Mat<f64>>);

fn fixed_interface(
    system: &System<'_>,
    mass: &SparseColMat<usize, f64>,
    attached: &Attached,
    request: Request,
    resources: &Resources,
) -> Result<Basis, ElasticError> {
    let mut fixed = system.constrained();
    fixed.extend(&attached.direct);
    let problem = Problem {
        stiffness: &system.stiffness,
        mass,
        positions: &system.positions,
        constrained: &fixed,
        forms: &attached.forms,
        is_free: !attached.helpers.is_empty(),
    };
    let wanted = modes::wanted(&problem, request, resources)?;
    let operator = Operator::new(&problem, modes::shift(&problem, request), resources)?;
    let constrained = [fixed.as_slice(), &attached.helpers].concat();
    let own_factor;
    let factor = if attached.helpers.is_empty() {
        &operator.factor
    } else {
        let pencil = Pencil::stiffness(&system.stiffness);
        own_factor = Factor::new(pencil, &system.positions, &constrained, resources)?;
        &own_factor
    };
    if !factor.singular.is_empty() {
        return Err(mechanism_within(system, &factor.singular));
    }
    let mut modes = match wanted {
        0 => Modes::none(&problem),
        _ => modes::iterate(&problem, &operator, request, wanted, resources)?,
    };
    let (shapes, stiffness) = static_shapes(system, attached, factor, resources)?;
    let components = attached.components.len();
    let inertia = images(mass, shapes.as_ref());
    augment(system, mass, &problem, &operator, inertia, &mut modes, resources)?;
    let count = components + modes.eigenvalues.len();
    let shapes = Mat::from_fn(system.dof_count(), count, |dof, column| {
        if column < components { shapes[(dof, column)] } else { modes.shapes[(dof, column - components)] }
    });
    Ok((shapes, modes, Some(stiffness)))
}

/// Returns the static shapes of the attachments over all unknowns, one per component, and the
/// condensed stiffness. The retained unknowns of `attached` are fixed in the factor.
fn static_shapes(
    system: &System<'_>,
    attached: &Attached,
    factor: &Factor,
    resources: &Resources,
) -> Result<(Mat<f64>, Mat<f64>), ElasticError> {
    // Static responses to unit displacements of the retained unknowns and unit multipliers.
    let retained: Vec<usize> = attached.direct.iter().chain(&attached.helpers).copied().collect();
    let (count, forms) = (retained.len(), attached.forms.len());
    let mut columns = Mat::zeros(system.dof_count(), count + forms);
    for (column, &dof) in retained.iter().enumerate() {
        for (row, value) in system.stiffness.row_idx_of_col(dof).zip(system.stiffness.val_of_col(dof)) {
            columns[(row, column)] = -value;
        }
    }
    for (column, form) in attached.forms.iter().enumerate() {
        form.entries.iter().for_each(|&(dof, value)| columns[(dof, count + column)] = value);
    }
    factor.solve_in_place(columns.as_mut(), resources)?;
    for (column, &dof) in retained.iter().enumerate() {
        columns[(dof, column)] = 1.0;
    }
    let responses = columns.as_ref();
    let forces = images(&system.stiffness, responses.subcols(0, count));
    let of_forms = apply(&attached.forms, responses);
    let interface = Interface {
        attached: attached.direct.len(),
        stiffness: Mat::from_fn(count, count, |row, column| forces[(retained[row], column)]),
        forms: of_forms.as_ref().subcols(0, count).to_owned(),
        compliance: of_forms.as_ref().subcols(count, forms).to_owned(),
        loads: Mat::zeros(count, 0),
        form_loads: Mat::zeros(forms, 0),
        between_loads: Mat::zeros(0, 0),
    };
    let relaxed = interface.relax()?;
    // Shapes: the attachments' own responses, then helpers and multipliers.
    let direct = attached.direct.len();
    let components = attached.components.len();
    let check = || resources.check();
    let others = responses.subcols(direct, count + forms - direct);
    let mut shapes = Mat::zeros(system.dof_count(), components);
    let by_others = Interruptible(&check).product(others, relaxed.response.as_ref())?;
    for (component, &place) in attached.places.iter().enumerate() {
        for dof in 0..system.dof_count() {
            let own = if place < direct { responses[(dof, place)] } else { 0.0 };
            shapes[(dof, component)] = own + by_others[(dof, place)];
        }
    }
    Ok((shapes, attached.ordered(&relaxed.stiffness)))
}

/// Adds pseudo-modes to the modes with fixed attachments: the response of the omitted modes to the
/// inertia of the static shapes (modal truncation augmentation, Dickens, Nakagawa and Wittbrodt
/// 1997).
fn augment(
    system: &System<'_>,
    mass: &SparseColMat<usize, f64>,
    problem: &Problem<'_>,
    operator: &Operator,
    mut loads: Mat<f64>,
    modes: &mut Modes,
    resources: &Resources,
) -> Result<(), ElasticError> {
    let check = || resources.check();
    let dense = Interruptible(&check);
    operator.solve_in_place(problem.forms, loads.as_mut(), resources)?;
    let of_modes = images(mass, modes.shapes.as_ref());
    for _ in 0..2 {
        let shares = dense.product(of_modes.transpose(), loads.as_ref())?;
        dense.add_product(loads.as_mut(), -1.0, modes.shapes.as_ref(), shares.as_ref())?;
    }
    // Mass-orthonormal combinations, without those that depend on others.
    let failed = || ElasticError::Convergence("the pseudo-modes of the truncated modes failed".into());
    let inertia = projected(mass, loads.as_ref(), resources)?;
    let scale: Vec<f64> = (0..inertia.nrows())
        .map(|k| if inertia[(k, k)] > 0.0 { inertia[(k, k)].sqrt().recip() } else { 0.0 })
        .collect();
    let size = scale.len();
    let scaled = Mat::from_fn(size, size, |i, j| inertia[(i, j)] * scale[i] * scale[j]);
    let (values, vectors) = symmetric_eigen(scaled.as_ref()).ok_or_else(failed)?;
    let kept: Vec<usize> = (0..size).filter(|&k| values[k] > 1e-8).collect();
    let combination =
        Mat::from_fn(size, kept.len(), |i, j| scale[i] * vectors[(i, kept[j])] / values[kept[j]].sqrt());
    let basis = dense.product(loads.as_ref(), combination.as_ref())?;
    let stiffness = projected(&system.stiffness, basis.as_ref(), resources)?;
    let (values, vectors) = symmetric_eigen(stiffness.as_ref()).ok_or_else(failed)?;
    let pseudo = dense.product(basis.as_ref(), vectors.as_ref())?;
    let old = modes.eigenvalues.len();
    modes.shapes = Mat::from_fn(system.dof_count(), old + values.len(), |dof, column| {
        if column < old { modes.shapes[(dof, column)] } else { pseudo[(dof, column - old)] }
    });
    modes.eigenvalues.extend(values);
    Ok(())
}

fn free_interface(
    system: &System<'_>,
    mass: &SparseColMat<usize, f64>,
    attached: &Attached,
    request: Request,
    resources: &Resources,
) -> Result<Basis, ElasticError> {
    let constrained = system.constrained();
    let motions: Vec<Vec<f64>> =
        crate::check::parts(system).into_iter().flat_map(|part| part.free_motions).collect();
    let problem = Problem {
        stiffness: &system.stiffness,
        mass,
        positions: &system.positions,
        constrained: &constrained,
        forms: &[],
        is_free: !motions.is_empty(),
    };
    let modes = modes::solve(&problem, request, |dofs| mechanism_within(system, dofs), resources)?;
    if modes.eigenvalues.len() < motions.len() {
        return Err(ElasticError::Convergence("a rigid-body motion of the free body is missing".into()));
    }
    let components = attached.components.len();
    let mut forms: Vec<SparseVector> = vec![SparseVector::default(); components];
    for (component, &place) in attached.places.iter().enumerate() {
        forms[component] = match attached.direct.get(place) {
            Some(&dof) => SparseVector { entries: vec![(dof, 1.0)] },
            None => attached.forms[place - attached.direct.len()].clone(),
        };
    }
    let check = || resources.check();
    let dense = Interruptible(&check);
    let inertia = images(mass, modes.shapes.as_ref());
    // Unit loads, balanced by the inertia of the rigid-body motions.
    let rigid = motions.len();
    let by_modes = apply(&forms, modes.shapes.as_ref());
    let mut residual = Mat::zeros(system.dof_count(), components);
    for (column, form) in forms.iter().enumerate() {
        form.entries.iter().for_each(|&(dof, value)| residual[(dof, column)] += value);
    }
    let shares = by_modes.as_ref().subcols(0, rigid);
    dense.add_product(residual.as_mut(), -1.0, inertia.as_ref().subcols(0, rigid), shares.transpose())?;
    let mut fixed = constrained.clone();
    fixed.extend(crate::check::determinate_support(system, &motions));
    let factor = Factor::new(Pencil::stiffness(&system.stiffness), &system.positions, &fixed, resources)?;
    if !factor.singular.is_empty() {
        return Err(mechanism_within(system, &factor.singular));
    }
    factor.solve_in_place(residual.as_mut(), resources)?;
    // The flexibility of the retained modes and their rigid-body motion are removed.
    let shares = dense.product(inertia.transpose(), residual.as_ref())?;
    dense.add_product(residual.as_mut(), -1.0, modes.shapes.as_ref(), shares.as_ref())?;
    let flexibility = apply(&forms, residual.as_ref());
    let scale: Vec<f64> = (0..components).map(|k| flexibility[(k, k)].abs().sqrt().recip()).collect();
    let scaled = Mat::from_fn(components, components, |i, j| {
        0.5 * (flexibility[(i, j)] + flexibility[(j, i)]) * scale[i] * scale[j]
    });
    let inverse = scaled.partial_piv_lu().solve(Mat::<f64>::identity(components, components));
    let inverse = Mat::from_fn(components, components, |i, j| inverse[(i, j)] * scale[i] * scale[j]);
    let of_attachments = dense.product(residual.as_ref(), inverse.as_ref())?;
    let mut of_modes = modes.shapes.clone();
    dense.add_product(of_modes.as_mut(), -1.0, of_attachments.as_ref(), by_modes.as_ref())?;
    let count = modes.eigenvalues.len();
    let shapes = Mat::from_fn(system.dof_count(), components + count, |dof, column| {
        if column < components { of_attachments[(dof, column)] } else { of_modes[(dof, column - components)] }
    });
    Ok((shapes, modes, None))
}
