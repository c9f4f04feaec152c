//! Solid mesh of a tooth with its sector of the rim: the meshes of developed sections, rolled up
//! and joined along the face.

use super::layout::Layout;
use super::tooth::Tooth;
use crate::sector_mesh::Refinement;
use calyx_runtime::error::EngineError;
use calyx_runtime::fe::MeshError;
use calyx_runtime::fe::solid::{SolidMesh, SweepError, coordinate_stations};
use calyx_runtime::interrupt::Interrupt;
use std::sync::Arc;

/// Bore of a rim: a cone, which is a straight line in the meridian plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bore {
    /// Height of the bore in the middle section, see [`super::section::Meridian::height`], m.
    pub height: f64,
    /// Increase of the height per length along the face.
    pub slope: f64,
}

impl Bore {
    /// Height in the section at `v`, m.
    pub fn at(&self, v: f64) -> f64 {
        self.height + self.slope * v
    }
}

/// Reasons why a tooth cannot be meshed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs, reason = "the messages describe the variants")]
pub enum LoftError {
    #[error("in the section {} m from the middle of the face, {error}", at)]
    Section { at: f64, error: MeshError },
    #[error("the section {} m from the middle of the face needs other elements than the middle one", at)]
    Differs { at: f64 },
    #[error("{0}")]
    Solid(#[from] SweepError),
}

/// Checks that the sections at the middle and at both ends of the face can be meshed.
///
/// # Errors
/// One of them cannot.
pub fn check_sections(tooth: &Arc<Tooth>, bore: &Bore, refinement: &Refinement) -> Result<(), LoftError> {
    let layout = Layout::new(tooth, refinement, bore.height);
    let mesh = |v: f64| layout.mesh(v, bore.at(v)).map_err(|error| LoftError::Section { at: v, error });
    let middle = mesh(0.0)?;
    for v in tooth.face {
        if mesh(v)?.elements != middle.elements {
            return Err(LoftError::Differs { at: v });
        }
    }
    Ok(())
}

/// Mesh of tooth 0 with its sector, with a number of equal elements of an order along the face. Its
/// sets of faces are the chains of [`Layout::mesh`]; their second coordinate is `v`.
///
/// # Errors
/// A section cannot be meshed, or an element between sections is folded.
pub fn solid_mesh(
    tooth: &Arc<Tooth>,
    bore: &Bore,
    refinement: &Refinement,
    [elements, order]: [usize; 2],
    interrupt: &Interrupt,
) -> Result<Result<SolidMesh, LoftError>, EngineError> {
    let layout = Layout::new(tooth, refinement, bore.height);
    let [start, end] = tooth.face;
    let station = |k: usize| {
        let part = k as f64 / elements as f64;
        (1.0 - part) * start + part * end
    };
    let stations: Vec<f64> = (0..=elements).map(station).collect();
    let mesh = |v: f64| layout.mesh(v, bore.at(v)).map_err(|error| LoftError::Section { at: v, error });
    let middle = match mesh(0.0) {
        Ok(middle) => middle,
        Err(error) => return Ok(Err(error)),
    };
    let mut sections = Vec::new();
    for v in coordinate_stations(&stations, order.min(255) as u8) {
        interrupt.check()?;
        let section = match mesh(v) {
            Ok(section) if section.elements == middle.elements => section,
            Ok(_) => return Ok(Err(LoftError::Differs { at: v })),
            Err(error) => return Ok(Err(error)),
        };
        let placed = |&point: &[f64; 2]| tooth.placed(v, point).position;
        sections.push(section.coordinate_nodes.iter().map(placed).collect());
    }
    Ok(SolidMesh::lofted(&middle, &stations, order, &sections).map_err(LoftError::Solid))
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::tabulated::test_teeth::{Conical, cylindrical, sampled};
    use crate::template::section;
    use calyx_runtime::fe::solid::SolidElementPoint;
    use calyx_runtime::scene::Template;
    use std::f64::consts::TAU;

    fn determinant(m: [[f64; 3]; 3]) -> f64 {
        m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
    }

    /// Volume, and the smallest ratio of the Jacobian determinant to the largest one of its
    /// element.
    pub fn volume_and_quality(mesh: &SolidMesh) -> [f64; 2] {
        let (mut volume, mut worst) = (0.0, f64::INFINITY);
        for (element, data) in mesh.elements.iter().enumerate() {
            let points = data.coordinate_interpolation.cell().quadrature([5, 5]);
            let values: Vec<f64> = points
                .iter()
                .map(|&(local, _)| determinant(mesh.jacobian(SolidElementPoint { element, local })))
                .collect();
            volume += points.iter().zip(&values).map(|((_, weight), value)| weight * value).sum::<f64>();
            let largest = values.iter().copied().fold(0.0, f64::max);
            worst = values.iter().map(|value| value / largest).fold(worst, f64::min);
        }
        [volume, worst]
    }

    /// Cuts of the mesh coincide under rotation by the pitch.
    pub fn assert_congruent(mesh: &SolidMesh, teeth: u32) {
        let nodes = |name: &str| mesh.nodes_on(mesh.face_set(name).expect("a cut"));
        let (first, last) = (nodes("cut_right"), nodes("cut_left"));
        assert_eq!(first.len(), last.len());
        let (sine, cosine) = (TAU / f64::from(teeth)).sin_cos();
        for node in first {
            let [x, y, z] = mesh.nodes[node];
            let target = [cosine * x - sine * y, sine * x + cosine * y, z];
            let near =
                |&other: &usize| (0..3).all(|axis| (mesh.nodes[other][axis] - target[axis]).abs() < 1e-12);
            assert!(last.iter().any(near), "no node at {target:?}");
        }
    }

    fn meshed(tooth: &Arc<Tooth>, template: Template, thickness: f64) -> Result<SolidMesh, LoftError> {
        let height = crate::tabulated::boundary::root_end(tooth, 0, 0.0)[0] - thickness;
        let [start, end] = tooth.face.map(|v| crate::tabulated::boundary::root_end(tooth, 0, v)[0]);
        let slope = (end - start) / (tooth.face[1] - tooth.face[0]);
        let bore = Bore { height, slope };
        solid_mesh(tooth, &bore, &section(template), [2, 3], &Interrupt::never()).expect("not interrupted")
    }

    #[test]
    fn a_sampled_cylindrical_gear_has_its_volume() {
        for helix in [0.0, 20.0] {
            let gear = cylindrical(helix);
            let stations = sampled(&gear, 7, 24).stations().expect("a table");
            let tooth = Tooth::new(&stations, Some(gear.form().tip_edge_radius)).expect("a tooth");
            let tooth = Arc::new(tooth);
            let thickness = gear.form().root_radius - gear.rim.fixed_radius;
            let own = gear.solid_mesh(&Default::default()).expect("a mesh");
            let found = meshed(&tooth, Template::Medium, thickness).expect("a mesh");
            let ([own, _], [found, quality]) = (volume_and_quality(&own), volume_and_quality(&found));
            assert!((found / own - 1.0).abs() < 1e-4, "{helix}: {found} {own}");
            assert!(quality > 0.02, "{quality}");
        }
    }

    #[test]
    fn conical_teeth_are_meshed_without_folds() {
        let (pinion, gear) = (Conical::PINION, Conical::GEAR);
        let family = [
            pinion,
            gear,
            Conical { lean: 0.08, ..pinion },
            Conical { lean: -0.15, spiral: 50.0, ..pinion },
            Conical { lean: 0.15, ..gear },
            Conical { tip_radius: 0.1, ..pinion },
            Conical { tip_radius: 0.45, ..gear },
            Conical { spiral: 0.0, upwards: true, ..pinion },
            Conical { teeth: 6, virtual_teeth: 8, tip_radius: 0.2, ..pinion },
            Conical { teeth: 41, virtual_teeth: 160, ..gear },
            Conical { teeth: 20, virtual_teeth: 28, face: 0.45, ..pinion },
        ];
        for conical in family {
            let stations = conical.table(9, 17).stations().expect("a table");
            let tooth = Arc::new(Tooth::new(&stations, None).expect("a tooth"));
            let templates = [
                (Template::Medium, 0.3),
                (Template::Medium, 1.5),
                (Template::ThinRim, 0.5),
                (Template::Finest, 1.0),
            ];
            for (template, thickness) in templates {
                let mesh = meshed(&tooth, template, thickness * tooth.module);
                let mesh = mesh.unwrap_or_else(|error| panic!("{conical:?} {template:?}: {error}"));
                let [_, quality] = volume_and_quality(&mesh);
                assert!(quality > 0.01, "{conical:?} {template:?} {thickness}: {quality}");
                if template == Template::Medium {
                    assert_congruent(&mesh, conical.teeth);
                }
            }
        }
    }
}
