//! Tables of the flanks of meshes on general axes for the run directory.

use calyx_gears::general_mesh::tooth_chart::{ChartPoint, Lengthwise, ToothChart};
use calyx_gears::general_mesh::topography::{FlankPair, Topography, flank_pairs};
use calyx_gears::host::ModelHost;
use calyx_report::field_tables::{COAST, DRIVE};
use calyx_report::flank_tables::{
    EaseOffRow, FlankRow, FlankTables, ON_EDGE, ON_FLANK, ON_ROOT, UnloadedRow,
};
use calyx_runtime::scene::Prototype;
use std::sync::Arc;

/// Flank pairs of a model with the prototypes of both bodies. Their tables are computed on request.
pub(crate) struct MeshedFlanks(Vec<(FlankPair, [Arc<dyn Prototype>; 2])>);

impl MeshedFlanks {
    /// Collects the flank pairs of a model.
    pub fn of(host: &ModelHost) -> MeshedFlanks {
        let prototype = |name: &String| {
            let body = host.scene.bodies.iter().find(|body| body.name == *name)?;
            Some(body.prototype.clone())
        };
        let with_prototypes = |pair: FlankPair| {
            let prototypes = [prototype(&pair.names[0])?, prototype(&pair.names[1])?];
            Some((pair, prototypes))
        };
        MeshedFlanks(flank_pairs(host).into_iter().filter_map(with_prototypes).collect())
    }

    /// Computes the tables.
    pub fn tables(&self) -> FlankTables {
        let mut tables = FlankTables::default();
        for (pair, prototypes) in &self.0 {
            for (side, prototype) in prototypes.iter().enumerate() {
                if let Some(chart) = pair.chart(side, prototype.as_ref()) {
                    tables.flanks.extend(flank_rows(pair, side, &chart));
                }
            }
            if let Some(topography) = pair.topography() {
                tables.unloaded.extend(unloaded_rows(pair, &topography));
                tables.ease_off.extend(ease_off_rows(pair, &topography));
            }
        }
        tables
    }
}

fn flank_name(pair: &FlankPair) -> String {
    if pair.coast { COAST.into() } else { DRIVE.into() }
}

fn flank_rows(pair: &FlankPair, side: usize, chart: &ToothChart) -> Vec<FlankRow> {
    let shape = match chart.shape {
        Lengthwise::Straight => "straight",
        Lengthwise::Concave => "concave",
        Lengthwise::Convex => "convex",
    };
    let row = |part: &str, [column, row]: [usize; 2], point: &ChartPoint| FlankRow {
        body: pair.names[side].clone(),
        mate: pair.names[1 - side].clone(),
        flank: flank_name(pair),
        surface: pair.surfaces[side] as u32,
        shape: shape.into(),
        conical: chart.conical,
        part: part.into(),
        column,
        row,
        along_face: point.place[0],
        along_profile: point.place[1],
        axial: point.meridian[0],
        radius: point.meridian[1],
        distance: point.projected[0],
        height: point.projected[1],
    };
    let part = |point: &ChartPoint| if point.place[1] > chart.edge_from { ON_EDGE } else { ON_FLANK };
    let flank = chart.points.iter().map(|(index, point)| row(part(point), *index, point));
    let root = chart.root.iter().enumerate().map(|(column, point)| row(ON_ROOT, [column, 0], point));
    flank.chain(root).collect()
}

fn unloaded_rows(pair: &FlankPair, topography: &Topography) -> Vec<UnloadedRow> {
    let row = |contact: &calyx_gears::general_mesh::topography::UnloadedContact| {
        let [first, second] = contact.places;
        UnloadedRow {
            first_body: pair.names[0].clone(),
            second_body: pair.names[1].clone(),
            flank: flank_name(pair),
            pitch: topography.pitch,
            rotation: contact.rotation,
            transmission_error: contact.transmission_error,
            touches: contact.touches,
            edge: contact.edge,
            first_along_face: first[0],
            first_along_profile: first[1],
            second_along_face: second[0],
            second_along_profile: second[1],
        }
    };
    topography.path.iter().map(row).collect()
}

fn ease_off_rows(pair: &FlankPair, topography: &Topography) -> Vec<EaseOffRow> {
    let row = |([column, row], point): &([usize; 2], calyx_gears::general_mesh::topography::EaseOffPoint)| {
        let [first, second] = point.places;
        EaseOffRow {
            first_body: pair.names[0].clone(),
            second_body: pair.names[1].clone(),
            flank: flank_name(pair),
            column: *column,
            row: *row,
            first_along_face: first[0],
            first_along_profile: first[1],
            second_along_face: second[0],
            second_along_profile: second[1],
            ease_off: point.ease_off,
            gap: point.gap,
        }
    };
    topography.ease_off.iter().map(row).collect()
}
