//! Serialization of the tables of structures for the structure cache. The prototype rebuilds the
//! contact surfaces; the condensed tables are read from the bytes.

use super::bore_coupling::BoreCoupling;
use super::bore_interface::BoreInterface;
use super::bspline::BSpline;
use super::elastic::{ElasticStructure, OffsetTables, Surface};
use super::far_coupling::FarCoupling;
use super::raceway::Raceway;
use super::ring::SharedUnknowns;
use super::sampling::EdgeCoordinate;
use super::spline_teeth::{SplineTeeth, SplineToothSet};
use crate::profile::Profile;
use faer::Mat;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use serde::{Deserialize, Serialize, Serializer};
use std::borrow::Cow;
use std::sync::Arc;

/// Matrix, column by column. The entries are borrowed from the bytes until the matrix is built,
/// because tables take hundreds of megabytes.
#[derive(Serialize, Deserialize)]
pub(super) struct Table<'a> {
    rows: usize,
    columns: usize,
    #[serde(borrow, serialize_with = "as_bytes")]
    values: Cow<'a, [u8]>,
}

/// Serializes bytes in one call; a list would be serialized byte by byte.
fn as_bytes<S: Serializer>(values: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_bytes(values)
}

/// Tables of a structure, by observed and loaded surface.
type Tables<'a> = Vec<Vec<Table<'a>>>;

impl From<&Mat<f64>> for Table<'_> {
    fn from(matrix: &Mat<f64>) -> Self {
        let mut values = Vec::with_capacity(matrix.nrows() * matrix.ncols() * size_of::<f64>());
        for column in matrix.col_iter() {
            column.iter().for_each(|value| values.extend_from_slice(&value.to_le_bytes()));
        }
        Self { rows: matrix.nrows(), columns: matrix.ncols(), values: values.into() }
    }
}

impl Table<'_> {
    pub fn matrix(&self) -> Option<Mat<f64>> {
        let (values, rest) = self.values.as_chunks();
        let fits = rest.is_empty() && self.rows.checked_mul(self.columns) == Some(values.len());
        let entry = |row, column| f64::from_le_bytes(values[column * self.rows + row]);
        fits.then(|| Mat::from_fn(self.rows, self.columns, entry))
    }
}

fn tables(matrices: &[Vec<Mat<f64>>]) -> Tables<'static> {
    matrices.iter().map(|row| row.iter().map(Table::from).collect()).collect()
}

fn matrices(tables: &[Vec<Table>]) -> Option<Vec<Vec<Mat<f64>>>> {
    tables.iter().map(|row| row.iter().map(Table::matrix).collect()).collect()
}

/// Serialized [`OffsetTables`]: compliance, stress ahead, stress behind.
#[derive(Serialize, Deserialize)]
pub(super) struct StoredOffset<'a>(#[serde(borrow)] [Tables<'a>; 3]);

impl StoredOffset<'_> {
    pub fn of(offset: &OffsetTables) -> Self {
        Self([tables(&offset.compliance), tables(&offset.stress_ahead), tables(&offset.stress_behind)])
    }

    /// Returns the tables of all offsets, which threads copy in parallel: they are most of a
    /// structure.
    pub fn all_tables(offsets: &[Self]) -> Option<Vec<OffsetTables>> {
        offsets.par_iter().map(Self::tables).collect()
    }

    fn tables(&self) -> Option<OffsetTables> {
        let [compliance, ahead, behind] = &self.0;
        Some(OffsetTables {
            compliance: matrices(compliance)?,
            stress_ahead: matrices(ahead)?,
            stress_behind: matrices(behind)?,
        })
    }
}

/// Serialized [`BoreCoupling`].
#[derive(Serialize, Deserialize)]
pub(super) struct StoredBore<'a> {
    sectors: u32,
    pitch: f64,
    count: usize,
    pairs: Vec<([usize; 2], f64)>,
    #[serde(borrow)]
    release: Table<'a>,
    /// Spline teeth with their forces.
    #[serde(borrow)]
    spline_teeth: Option<(SplineTeeth, Table<'a>)>,
    /// Displacements of the interface by amplitudes, and compliance.
    #[serde(borrow)]
    interface: Option<([Table<'a>; 2], Option<Raceway>)>,
    #[serde(borrow)]
    loads: Vec<Table<'a>>,
    #[serde(borrow)]
    stress: Vec<Table<'a>>,
}

impl StoredBore<'_> {
    pub fn of(bore: &BoreCoupling) -> Self {
        let tables = |matrices: &[Mat<f64>]| matrices.iter().map(Table::from).collect();
        Self {
            sectors: bore.sectors,
            pitch: bore.pitch,
            count: bore.shared.count,
            pairs: bore.shared.pairs.clone(),
            release: Table::from(&bore.release),
            spline_teeth: bore
                .spline_teeth
                .as_ref()
                .map(|set| (set.spline_teeth, Table::from(&set.reactions))),
            interface: bore.interface.as_ref().map(|interface| {
                let tables = [&interface.by_amplitudes, &interface.compliance].map(Table::from);
                (tables, interface.raceway)
            }),
            loads: tables(&bore.loads),
            stress: tables(&bore.stress),
        }
    }

    pub fn coupling(self) -> Option<BoreCoupling> {
        let count = self.count;
        let sound = self.pairs.iter().all(|(places, _)| places.iter().all(|&place| place < count));
        let matrices = |tables: &[Table]| tables.iter().map(Table::matrix).collect::<Option<Vec<_>>>();
        (sound && self.sectors > 0).then_some(())?;
        // A stored set of spline teeth must be valid.
        let spline_teeth = match self.spline_teeth {
            Some((spline_teeth, reactions)) => {
                Some(SplineToothSet { spline_teeth, reactions: reactions.matrix()? })
            }
            None => None,
        };
        let interface = match &self.interface {
            Some(([by_amplitudes, compliance], raceway)) => Some(BoreInterface {
                by_amplitudes: by_amplitudes.matrix()?,
                compliance: compliance.matrix()?,
                raceway: *raceway,
            }),
            None => None,
        };
        Some(BoreCoupling {
            sectors: self.sectors,
            spline_teeth,
            interface,
            pitch: self.pitch,
            shared: SharedUnknowns { count, pairs: self.pairs },
            release: self.release.matrix()?,
            loads: matrices(&self.loads)?,
            stress: matrices(&self.stress)?,
        })
    }
}

/// Serialized [`FarCoupling`].
#[derive(Serialize, Deserialize)]
pub(super) struct StoredFar<'a> {
    sectors: u32,
    first: u32,
    /// Compliances by offset, modes ahead and behind, loads, stress.
    #[serde(borrow)]
    matrices: [Vec<Table<'a>>; 5],
}

impl StoredFar<'_> {
    pub fn of(far: &FarCoupling) -> Self {
        let tables = |matrices: &Vec<Mat<f64>>| matrices.iter().map(Table::from).collect();
        let [ahead, behind] = &far.modes;
        let matrices = [&far.by_offset, ahead, behind, &far.loads, &far.stress].map(tables);
        Self { sectors: far.sectors, first: far.first, matrices }
    }

    pub fn coupling(&self) -> Option<FarCoupling> {
        let [by_offset, ahead, behind, loads, stress] = self
            .matrices
            .each_ref()
            .map(|tables| tables.iter().map(Table::matrix).collect::<Option<Vec<_>>>());
        let (by_offset, modes, loads, stress) = (by_offset?, [ahead?, behind?], loads?, stress?);
        let (count, shapes) = (by_offset.first()?.nrows(), modes[0].first()?.nrows());
        let sized = |matrices: &[Mat<f64>], [rows, columns]: [usize; 2]| {
            matrices.iter().all(|matrix| matrix.nrows() == rows && matrix.ncols() == columns)
        };
        let fits = sized(&by_offset, [count, count])
            && modes.iter().all(|modes| modes.len() == by_offset.len() && sized(modes, [shapes, count]))
            && loads.iter().all(|loads| loads.nrows() == count)
            && stress.iter().all(|stress| stress.ncols() == shapes);
        let (sectors, first) = (self.sectors, self.first);
        (sectors > 0 && fits).then_some(FarCoupling { sectors, first, by_offset, modes, loads, stress })
    }
}

/// Builds a spline on nodes from untrusted bytes; `None` if they are not valid.
pub(super) fn spline(nodes: Vec<f64>) -> Option<BSpline> {
    let sound = nodes.len() >= 4 && nodes.windows(2).all(|pair| pair[0] < pair[1]);
    sound.then(|| BSpline::new(nodes))
}

pub(super) fn to_bytes(content: &impl Serialize) -> Option<Vec<u8>> {
    postcard::to_stdvec(content).ok()
}

/// Deserializes bytes; `None` if they contain something else.
pub(super) fn from_bytes<'a, T: Deserialize<'a>>(bytes: &'a [u8]) -> Option<T> {
    postcard::from_bytes(bytes).ok()
}

/// Serialized [`ElasticStructure`] without its contact curves.
#[derive(Serialize, Deserialize)]
struct StoredElastic<'a> {
    teeth: u32,
    surface_modulus: f64,
    reference_length: f64,
    kink: f64,
    directions: usize,
    surfaces: Vec<StoredSurface>,
    #[serde(borrow)]
    offsets: Vec<StoredOffset<'a>>,
    twists: Vec<[f64; 2]>,
    #[serde(borrow)]
    far: Option<StoredFar<'a>>,
    #[serde(borrow)]
    bore: Option<StoredBore<'a>>,
}

/// Serialized [`Surface`] without its curve.
#[derive(Serialize, Deserialize)]
pub(super) struct StoredSurface {
    nodes: Vec<f64>,
    stretch: EdgeCoordinate,
    stretched: Vec<f64>,
    range: [f64; 2],
    turned: Vec<f64>,
    stress_points: Vec<(f64, [f64; 2])>,
}

impl StoredSurface {
    pub fn of(surface: &Surface) -> Self {
        Self {
            nodes: surface.spline.nodes().to_vec(),
            stretch: surface.stretch.clone(),
            stretched: surface.stretched.nodes().to_vec(),
            range: surface.range,
            turned: surface.turned.clone(),
            stress_points: surface.stress_points.clone(),
        }
    }

    pub fn on(self, profile: &Arc<dyn Profile>) -> Option<Surface> {
        Some(Surface {
            profile: profile.clone(),
            spline: spline(self.nodes)?,
            stretch: self.stretch,
            stretched: spline(self.stretched)?,
            range: self.range,
            turned: self.turned,
            stress_points: self.stress_points,
        })
    }
}

impl ElasticStructure {
    pub(super) fn to_bytes(&self) -> Option<Vec<u8>> {
        to_bytes(&StoredElastic {
            teeth: self.teeth,
            surface_modulus: self.surface_modulus,
            reference_length: self.reference_length,
            kink: self.kink,
            directions: self.directions,
            surfaces: self.surfaces.iter().map(StoredSurface::of).collect(),
            offsets: self.offsets.iter().map(StoredOffset::of).collect(),
            twists: self.twists.clone(),
            far: self.far.as_ref().map(StoredFar::of),
            bore: self.bore.as_ref().map(StoredBore::of),
        })
    }

    /// Restores a structure from the bytes of [`stored`](super::Structure::stored), with the curves
    /// that it was built with. `None` if the bytes contain something else.
    pub fn restored(bytes: &[u8], profiles: &[Arc<dyn Profile>]) -> Option<Self> {
        let stored: StoredElastic = from_bytes(bytes)?;
        if stored.surfaces.len() != profiles.len() {
            return None;
        }
        // A stored bore coupling must be valid.
        let bore = match stored.bore {
            Some(bore) => Some(bore.coupling()?),
            None => None,
        };
        let far = match &stored.far {
            Some(far) => Some(far.coupling()?),
            None => None,
        };
        Some(Self {
            teeth: stored.teeth,
            surface_modulus: stored.surface_modulus,
            reference_length: stored.reference_length,
            kink: stored.kink,
            surfaces: stored
                .surfaces
                .into_iter()
                .zip(profiles)
                .map(|(stored, on)| stored.on(on))
                .collect::<Option<_>>()?,
            directions: stored.directions,
            offsets: StoredOffset::all_tables(&stored.offsets)?,
            twists: stored.twists,
            far,
            bore,
        })
    }
}
