//! Meshes of gears in VTU files: their stresses in fillets are those that the run reports.

use crate::common::pair::{PairOptions, RELIEVED, pair};
use crate::common::resources;
use calyx_runtime::analysis::{AnalysisOptions, Event, Observer, mesh_cycle, quasi_static};
use calyx_runtime::error::EngineError;
use calyx_runtime::observables::{Fields, FilletField, SectorField};
use calyx_runtime::results::OutputRequest;
use calyx_runtime::scene::{ObservableId, Prototype, Scene};
use std::sync::Arc;

/// Fields of the last position.
#[derive(Default)]
struct RecordedFields(Option<Fields>);

impl Observer for RecordedFields {
    fn observe(&mut self, event: Event<'_>) -> Result<(), EngineError> {
        if let Event::Step { fields: Some(fields), .. } = event {
            self.0 = Some(fields.clone());
        }
        Ok(())
    }
}

/// Scene of a pair whose bodies are the gears alone.
fn scene(options: &PairOptions) -> (Scene, calyx_runtime::scene::GearMesh) {
    let (mut scene, mesh) = pair(options);
    for (body, member) in scene.bodies.iter_mut().zip(&options.gears) {
        body.prototype = member.prototype.clone() as Arc<dyn Prototype>;
    }
    (scene, mesh)
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| a[axis] - b[axis])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Stresses along the profile at the nodes of a VTU file that lie on a fillet: the value in the
/// file, and the value interpolated on the fillet. Pa.
fn on_fillet(sector: &SectorField, fillet: &FilletField) -> Vec<[f64; 2]> {
    let mut found = Vec::new();
    let [places] = &fillet.sections[..] else { return found };
    for pair in places.windows(2) {
        let along = minus(pair[1].point, pair[0].point);
        let length = dot(along, along).sqrt();
        let tangent = along.map(|part| part / length);
        for (&point, &[xx, yy, _, _, _, xy]) in sector.points.iter().zip(&sector.stresses) {
            let from = minus(point, pair[0].point);
            let share = dot(from, tangent) / length;
            let off = minus(from, tangent.map(|part| part * share * length));
            if (0.0..1.0).contains(&share) && dot(off, off).sqrt() < 0.02 * length {
                let [x, y, _] = tangent;
                let shown = x * x * xx + y * y * yy + 2.0 * x * y * xy;
                let [from, to] = [0, 1].map(|end: usize| pair[end].components[0]);
                found.push([shown, from + share * (to - from)]);
            }
        }
    }
    found
}

#[test]
fn stresses_in_the_fillets_of_pictures_are_root_stresses() {
    let (scene, mesh) = scene(&PairOptions::chapter_5(&RELIEVED));
    let positions = &mesh_cycle(&mesh, 1)[..1];
    let outputs: Vec<OutputRequest> = (0..scene.observables.len())
        .map(|at| OutputRequest::observing(at.to_string(), ObservableId(at)))
        .collect();
    let options =
        AnalysisOptions { fields: 1, bodies: true, resources: resources(), ..AnalysisOptions::default() };
    let mut recorded = RecordedFields::default();
    quasi_static(&scene, positions, &outputs, &options, &mut recorded).expect("it is solved");
    let fields = recorded.0.expect("fields");
    assert_eq!(fields.bodies.iter().map(|body| body.sectors.len()).collect::<Vec<_>>(), [20, 40]);
    assert!(fields.without_mesh.is_empty());
    let (mut loaded, mut compared) = (0, 0);
    for fillet in &fields.fillets {
        let body = fields.bodies.iter().find(|body| body.body == fillet.body).expect("a picture of it");
        let found = on_fillet(&body.sectors[fillet.tooth as usize], fillet);
        assert!(found.len() > 8, "{} nodes on a fillet", found.len());
        let most = found.iter().fold(0.0_f64, |most, [_, reported]| most.max(reported.abs()));
        // Lightly stressed teeth are not compared.
        if most < 3e7 {
            continue;
        }
        loaded += 1;
        compared += found.len();
        for [shown, reported] in found {
            let error = (shown - reported).abs() / most;
            assert!(error < 0.03, "{} {}: {shown:e} {reported:e} of {most:e}", fillet.body, fillet.tooth);
        }
    }
    assert!(loaded >= 4 && compared > 40, "{loaded} {compared}");
}
