//! Velocities of a surface at the speed of the model, for other acoustic programs: vectors at the
//! nodes of the skin of the mesh, before it is coarsened.

use super::motion::{SurfaceMotion, Vibrating};
use super::shapes::BodyShapes;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::Vector;
use faer::c64;

/// Vibration of a closed surface at the speed of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceVibration {
    /// Vertices in ground coordinates, m.
    pub vertices: Vec<Vector>,
    /// Triangles, counter-clockwise seen from the fluid.
    pub triangles: Vec<[usize; 3]>,
    /// Index of each line with sound, and the complex amplitudes of the velocities of the vertices
    /// in ground coordinates, m/s, with the time factor exp(iωt).
    pub lines: Vec<(usize, Vec<[c64; 3]>)>,
}

impl SurfaceVibration {
    /// Returns the velocities of a surface at some lines.
    ///
    /// # Errors
    /// Those of the interrupt.
    pub(super) fn new(
        model: &Vibrating,
        BodyShapes { shapes, places, .. }: &BodyShapes,
        motion: &SurfaceMotion,
        lines: &[usize],
        interrupt: &Interrupt,
    ) -> Result<SurfaceVibration, EngineError> {
        let skin = &model.surface.original;
        let bytes = 48 * skin.nodes.len() * lines.len();
        let _room = interrupt.reserve_memory(bytes as u64)?;
        let zero = c64::new(0.0, 0.0);
        let of_line = |&line: &usize| {
            interrupt.check()?;
            let mut unknowns = vec![zero; shapes.displacements.len()];
            for (parts, amplitude) in model.moved.iter().zip(&motion.velocities[0][line]) {
                for (unknown, part) in parts {
                    if let Some(sum) = unknowns.get_mut(*unknown) {
                        *sum += amplitude * *part;
                    }
                }
            }
            let mut at_nodes = vec![[zero; 3]; places.len()];
            for (own, amplitude) in shapes.displacements.iter().zip(&unknowns) {
                for (sum, displacement) in at_nodes.iter_mut().zip(own) {
                    (0..3).for_each(|k| sum[k] += amplitude * displacement[k]);
                }
            }
            let mean = |nodes: &Vec<usize>| {
                let own = nodes.iter().filter_map(|node| places.get(node)).map(|&place| at_nodes[place]);
                let sum = own.fold([zero; 3], |sum, own| [0, 1, 2].map(|k: usize| sum[k] + own[k]));
                model.surface.ground_vector(sum.map(|sum| sum / nodes.len() as f64))
            };
            Ok((line, skin.nodes.iter().map(mean).collect()))
        };
        Ok(SurfaceVibration {
            vertices: model.surface.original_vertices(),
            triangles: skin.mesh.triangles().to_vec(),
            lines: lines.iter().map(of_line).collect::<Result<_, EngineError>>()?,
        })
    }
}
