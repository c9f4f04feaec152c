//! Velocities of a surface at the speed of the model, for other acoustic programs: vectors at the
//! nodes of the skin of the mesh, before it is coarsened.

use super::motion::{SurfaceMotion, Vibrating};
use super::shapes::BodyShapes;
use calyx_numerics::vec3::Vector;
use faer::c64;
use std::sync::Arc;

/// Vibration of a closed surface at the speed of the model, from which the velocities of a line are
/// computed when they are needed.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceVibration {
    /// Vertices in ground coordinates, m.
    pub vertices: Vec<Vector>,
    /// Triangles, counter-clockwise seen from the fluid.
    pub triangles: Vec<[usize; 3]>,
    /// Index of each line with sound, and the velocities of the unknowns of the body.
    lines: Vec<(usize, Vec<c64>)>,
    /// Nodes of each vertex, whose mean motion it has.
    nodes: Vec<Vec<usize>>,
    /// Axes of the body in ground coordinates.
    axes: [Vector; 3],
    shapes: Arc<BodyShapes>,
}

impl SurfaceVibration {
    /// Returns the vibration of a surface at some lines.
    pub(super) fn new(
        model: &Vibrating,
        shapes: &Arc<BodyShapes>,
        motion: &SurfaceMotion,
        lines: &[usize],
    ) -> SurfaceVibration {
        let skin = &model.surface.original;
        let unknowns = |line: usize| {
            let mut unknowns = vec![c64::new(0.0, 0.0); shapes.shapes.displacements.len()];
            for (parts, amplitude) in model.moved.iter().zip(&motion.velocities[0][line]) {
                for (unknown, part) in parts {
                    if let Some(sum) = unknowns.get_mut(*unknown) {
                        *sum += amplitude * *part;
                    }
                }
            }
            unknowns
        };
        SurfaceVibration {
            vertices: model.surface.original_vertices(),
            triangles: skin.mesh.triangles().to_vec(),
            lines: lines.iter().map(|&line| (line, unknowns(line))).collect(),
            nodes: skin.nodes.clone(),
            axes: model.surface.axes(),
            shapes: shapes.clone(),
        }
    }

    /// Returns the indices of the lines with sound.
    pub fn lines(&self) -> impl Iterator<Item = usize> {
        self.lines.iter().map(|(line, _)| *line)
    }

    /// Returns the complex amplitudes of the velocities of the vertices at a line in ground
    /// coordinates, m/s, with the time factor exp(iωt); none at lines without sound.
    pub fn velocities(&self, line: usize) -> Vec<[c64; 3]> {
        let Some((_, unknowns)) = self.lines.iter().find(|(own, _)| *own == line) else { return Vec::new() };
        let BodyShapes { shapes, places, .. } = &*self.shapes;
        let zero = [c64::new(0.0, 0.0); 3];
        let mut at_nodes = vec![zero; places.len()];
        for (own, amplitude) in shapes.displacements.iter().zip(unknowns) {
            for (sum, displacement) in at_nodes.iter_mut().zip(own) {
                (0..3).for_each(|k| sum[k] += amplitude * displacement[k]);
            }
        }
        let mean = |nodes: &Vec<usize>| {
            let own = nodes.iter().filter_map(|node| places.get(node)).map(|&place| at_nodes[place]);
            let sum = own.fold(zero, |sum, own| [0, 1, 2].map(|k: usize| sum[k] + own[k]));
            let mean = sum.map(|sum| sum / nodes.len() as f64);
            [0, 1, 2].map(|k: usize| self.axes.iter().zip(&mean).map(|(axis, part)| part * axis[k]).sum())
        };
        self.nodes.iter().map(mean).collect()
    }
}
