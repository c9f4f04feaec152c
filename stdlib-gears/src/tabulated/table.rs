//! Tables of boundary points of a tooth, and their checks.

use super::section::{Meridian, SectionCones};
use crate::error::{GeometryError, Sentence, sentence};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Points by station along the face, then along the profile, m.
pub type PointGrid = Vec<Vec<[f64; 3]>>;

/// Smallest number of stations along the face, and of points of a profile.
pub const FEWEST_STATIONS: usize = 3;
/// Smallest number of points of a flank or a fillet at a station.
pub const FEWEST_POINTS: usize = 4;
/// Largest distance of a point from its section cone, of the common point of a flank and its
/// fillet, and between both fillets' ends, relative to the height of the tooth.
const CLOSE: f64 = 1e-4;
/// Largest difference of the heights at which both fillets end, relative to the height of the
/// tooth. The root between them is interpolated.
const LEVEL: f64 = 0.12;
/// Largest coordinate, m.
const LARGEST: f64 = 100.0;
/// Names of the two tables of an argument in messages.
const SIDES: [&str; 2] = ["counter-clockwise", "clockwise"];

/// Boundary of tooth 0 by points on section cones along the face.
#[derive(Clone, Debug, PartialEq)]
pub struct ToothTable {
    /// Number of teeth.
    pub teeth: u32,
    /// Pitch angle of the section cones: angle between pitch cone and axis, 0 to 90 degrees, rad.
    pub pitch_angle: f64,
    /// Counter-clockwise and clockwise flank, from the fillet to the tip.
    pub flanks: [PointGrid; 2],
    /// Fillet next to either flank, from the flank to the root.
    pub fillets: [PointGrid; 2],
}

/// Checked table in developed sections.
#[derive(Clone, Debug)]
pub struct Stations {
    /// Number of teeth.
    pub teeth: u32,
    /// Sections.
    pub cones: SectionCones,
    /// Coordinate along the pitch cone at the middle of the face, see [`Meridian::along`], m.
    pub middle: f64,
    /// Distances of the stations from the middle, ascending, m.
    pub along: Vec<f64>,
    /// Azimuth of the middle of the tooth by station, rad: the mean of the ends of both flanks.
    pub rotation: Vec<f64>,
    /// Points of the development relative to that azimuth, by side, station and profile.
    pub flanks: [Vec<Vec<[f64; 2]>>; 2],
    /// Points of the fillets, likewise.
    pub fillets: [Vec<Vec<[f64; 2]>>; 2],
    /// Height of the tooth at the middle station, from the end of the fillet to the tip, m.
    pub tooth_height: f64,
}

/// Point grids of both sides in the order flank 0, flank 1, fillet 0, fillet 1.
type Meridians = [Vec<Vec<Meridian>>; 4];

fn error(code: &'static str, argument: &'static str, message: Sentence, help: Sentence) -> GeometryError {
    GeometryError::error(code, argument, message, help)
}

/// Argument of a table of [`Meridians`].
fn argument(table: usize) -> &'static str {
    if table < 2 { "flanks" } else { "fillets" }
}

impl ToothTable {
    fn grids(&self) -> [&PointGrid; 4] {
        [&self.flanks[0], &self.flanks[1], &self.fillets[0], &self.fillets[1]]
    }

    /// Checks the table and develops its sections.
    ///
    /// # Errors
    /// E0970: numbers of stations or points, or coordinates. E0971: points are not on a common
    /// section cone. E0972: the curves do not bound a tooth.
    pub fn stations(&self) -> Result<Stations, GeometryError> {
        self.check_counts()?;
        let (cones, mut meridians) = self.on_cones()?;
        if meridians[0][0][0].along > meridians[0][meridians[0].len() - 1][0].along {
            meridians.iter_mut().for_each(|table| table.reverse());
        }
        unwrap_azimuths(&mut meridians);
        let height = height_of(&meridians);
        self.check_joints(&cones, &meridians, height)?;
        let along: Vec<f64> = meridians[0].iter().map(|station| station[0].along).collect();
        let middle = 0.5 * (along[0] + along[along.len() - 1]);
        // The mean azimuth of the ends of both flanks, which varies smoothly along the face.
        let middle_of = |station: usize| {
            let ends = [0, 1].map(|table: usize| {
                let points = &meridians[table][station];
                points[0].azimuth + points[points.len() - 1].azimuth
            });
            0.25 * (ends[0] + ends[1])
        };
        let rotation: Vec<f64> = (0..along.len()).map(middle_of).collect();
        let developed = |table: usize| -> Vec<Vec<[f64; 2]>> {
            let station = |(index, points): (usize, &Vec<Meridian>)| {
                let point =
                    |at: &Meridian| cones.developed(along[index], at.height, at.azimuth - rotation[index]);
                points.iter().map(point).collect()
            };
            meridians[table].iter().enumerate().map(station).collect()
        };
        let stations = Stations {
            teeth: self.teeth,
            cones,
            middle,
            rotation: rotation.clone(),
            flanks: [developed(0), developed(1)],
            fillets: [developed(2), developed(3)],
            tooth_height: height,
            along: along.iter().map(|along| along - middle).collect(),
        };
        stations.check_sides()?;
        Ok(stations)
    }

    fn check_counts(&self) -> Result<(), GeometryError> {
        let stations = self.flanks[0].len();
        if stations < FEWEST_STATIONS {
            return Err(error(
                "E0970",
                "flanks",
                sentence!["a flank has ", number stations as f64, " stations along the face, which must be ", number FEWEST_STATIONS as f64, " at least"],
                sentence!["give the points of more sections; 9 suffice for most flanks"],
            ));
        }
        for (table, grid) in self.grids().into_iter().enumerate() {
            let name = SIDES[table % 2];
            let what = if table < 2 { " flank" } else { " fillet" };
            if grid.len() != stations {
                return Err(error(
                    "E0970",
                    argument(table),
                    sentence!["the ", text name, text what, " has ", number grid.len() as f64, " stations and the counter-clockwise flank ", number stations as f64],
                    sentence!["give the points of flanks and fillets in the same sections"],
                ));
            }
            let points = grid[0].len();
            for (station, profile) in grid.iter().enumerate() {
                if profile.len() != points || points < FEWEST_POINTS {
                    return Err(error(
                        "E0970",
                        argument(table),
                        sentence!["station ", number station as f64, " of the ", text name, text what, " has ", number profile.len() as f64, " points; all stations must have the same number, ", number FEWEST_POINTS as f64, " at least"],
                        sentence!["divide the profile at each station alike"],
                    ));
                }
                for (index, point) in profile.iter().enumerate() {
                    let known = point.iter().all(|part| part.abs() <= LARGEST);
                    if !known || point[0].hypot(point[1]) == 0.0 {
                        return Err(error(
                            "E0970",
                            argument(table),
                            sentence!["point ", number index as f64, " of station ", number station as f64, " of the ", text name, text what, text if known { " lies on the axis" } else { " is not finite, or farther than 100 m from the origin" }],
                            sentence!["check the calculation of the points: it has no solution there"],
                        ));
                    }
                }
            }
        }
        Ok(())
    }

    /// Chooses the direction in which the pitch cone opens, and returns all points in the
    /// coordinates of the sections.
    fn on_cones(&self) -> Result<(SectionCones, Meridians), GeometryError> {
        if !(0.0..=FRAC_PI_2).contains(&self.pitch_angle) {
            return Err(error(
                "E0971",
                "pitch_angle",
                sentence!["a pitch angle of ", angle self.pitch_angle, " is not between 0 and 90 deg"],
                sentence!["give the angle between the pitch cone and the axis, whichever way the cone opens"],
            ));
        }
        let candidates = [1.0, -1.0].map(|sense| {
            let cones = SectionCones::new(self.pitch_angle, sense);
            let table = |grid: &PointGrid| -> Vec<Vec<Meridian>> {
                grid.iter()
                    .map(|profile| profile.iter().map(|&point| cones.meridian(point)).collect())
                    .collect()
            };
            let meridians = self.grids().map(table);
            let worst = worst_off(&meridians);
            let height = height_of(&meridians);
            let extent = extent_of(&meridians);
            (cones, meridians, worst, worst.0 <= CLOSE * extent, height > CLOSE * extent)
        });
        let [first, second] = candidates;
        let better = match (first.3, second.3) {
            (true, false) => first,
            (false, true) => second,
            // At 0 and 90 degrees both senses have the same sections; teeth point outwards.
            (true, true) if first.4 || !second.4 => first,
            (true, true) => second,
            _ if first.2.0 <= second.2.0 => first,
            _ => second,
        };
        let (cones, meridians, (off, table, station, point), _, upright) = better;
        if !upright {
            return Err(error(
                "E0972",
                "flanks",
                sentence!["the tips of the flanks are not above the ends of the fillets"],
                sentence![
                    "order the points of a flank from the fillet to the tip, and those of a fillet from the flank to the root"
                ],
            ));
        }
        if off > CLOSE * extent_of(&meridians) {
            return Err(error(
                "E0971",
                argument(table),
                sentence![
                    "point ", number point as f64, " of station ", number station as f64, " of the ", text SIDES[table % 2], text if table < 2 { " flank" } else { " fillet" }, " is ", length off, " away from the section cone of the station's first point"
                ],
                sentence![
                    "compute all points of a station on one cone normal to the pitch cone; `pitch_angle` is the pitch angle of these cones"
                ],
            ));
        }
        let along: Vec<f64> = meridians[0].iter().map(|station| station[0].along).collect();
        let width = (along[along.len() - 1] - along[0]).abs();
        let steps: Vec<f64> = along.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let ordered = steps.iter().all(|step| step * steps[0] > 0.0 && step.abs() > 1e-6 * width);
        if !ordered {
            return Err(error(
                "E0971",
                "flanks",
                sentence!["the stations do not follow each other along the face"],
                sentence!["order the sections from one end of the face to the other, all apart"],
            ));
        }
        Ok((cones, meridians))
    }

    /// Checks the common points of flanks and fillets, and the root.
    fn check_joints(
        &self,
        cones: &SectionCones,
        meridians: &Meridians,
        height: f64,
    ) -> Result<(), GeometryError> {
        let pitch = TAU / f64::from(self.teeth);
        for station in 0..meridians[0].len() {
            for side in 0..2 {
                let (flank, fillet) = (meridians[side][station][0], meridians[2 + side][station][0]);
                let radius = cones.radius(flank.along, flank.height);
                let apart = (flank.height - fillet.height).hypot(radius * (flank.azimuth - fillet.azimuth));
                if apart > CLOSE * height {
                    return Err(error(
                        "E0972",
                        "fillets",
                        sentence!["the ", text SIDES[side], " fillet begins ", length apart, " away from its flank at station ", number station as f64],
                        sentence!["begin each fillet at the first point of its flank"],
                    ));
                }
            }
            let [left, right] = [2, 3].map(|table: usize| {
                let points = &meridians[table][station];
                points[points.len() - 1]
            });
            let radius = cones.radius(left.along, left.height);
            let beyond = radius * (left.azimuth - right.azimuth - pitch);
            if beyond > CLOSE * height {
                return Err(error(
                    "E0972",
                    "fillets",
                    sentence!["at station ", number station as f64, " the tooth is ", length beyond, " wider at its root than the pitch"],
                    sentence![
                        "end the fillets at the middle of the tooth space at the latest, and check the tooth thickness and the number of teeth"
                    ],
                ));
            }
            let step = (left.height - right.height).abs();
            if step > LEVEL * height {
                return Err(error(
                    "E0972",
                    "fillets",
                    sentence!["at station ", number station as f64, " one fillet ends ", length step, " lower than the other"],
                    sentence!["end both fillets on the root cone"],
                ));
            }
        }
        Ok(())
    }
}

/// Largest distance of a point from the section cone of its station, with its table, station and
/// index.
fn worst_off(meridians: &Meridians) -> (f64, usize, usize, usize) {
    let mut worst = (0.0, 0, 0, 0);
    for (table, grid) in meridians.iter().enumerate() {
        for (station, points) in grid.iter().enumerate() {
            for (index, point) in points.iter().enumerate() {
                let off = (point.along - meridians[0][station][0].along).abs();
                if off > worst.0 {
                    worst = (off, table, station, index);
                }
            }
        }
    }
    worst
}

/// Mean height of the tips above the ends of the fillets at the middle station, m.
fn height_of(meridians: &Meridians) -> f64 {
    let station = meridians[0].len() / 2;
    let last = |table: usize| meridians[table][station].last().map_or(0.0, |point| point.height);
    0.5 * (last(0) + last(1) - last(2) - last(3))
}

/// Difference of the greatest and the least height at the middle station, m.
fn extent_of(meridians: &Meridians) -> f64 {
    let station = meridians[0].len() / 2;
    let heights = || meridians.iter().flat_map(|grid| grid[station].iter().map(|point| point.height));
    heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min)
}

/// Adds whole turns to the azimuths so that they are continuous along profiles and along the face.
fn unwrap_azimuths(meridians: &mut Meridians) {
    let mut reference = meridians[0][0][0].azimuth;
    for station in 0..meridians[0].len() {
        for (table, grid) in meridians.iter_mut().enumerate() {
            for point in &mut grid[station] {
                point.azimuth -= TAU * ((point.azimuth - reference) / TAU).round();
            }
            if table == 0 {
                reference = grid[station][0].azimuth;
            }
        }
    }
}

impl Stations {
    /// Checks that the flanks are in the right order and do not cross.
    fn check_sides(&self) -> Result<(), GeometryError> {
        let half = PI / f64::from(self.teeth);
        for station in 0..self.along.len() {
            let [left, right] = [0, 1].map(|side: usize| &self.flanks[side][station]);
            let tops = [left, right].map(|points| points[points.len() - 1]);
            let feet = [left[0], right[0]];
            let width = |pair: [[f64; 2]; 2]| pair[0][1] - pair[1][1];
            if width(feet) <= 0.0 {
                return Err(error(
                    "E0972",
                    "flanks",
                    sentence!["at station ", number station as f64, " the counter-clockwise flank lies clockwise of the other one"],
                    sentence![
                        "give the counter-clockwise flank of the tooth first, then its clockwise one; the tooth is between them"
                    ],
                ));
            }
            if width(tops) <= 0.0 {
                return Err(error(
                    "E0972",
                    "flanks",
                    sentence!["at station ", number station as f64, " the flanks cross ", length -width(tops), " before the tip"],
                    sentence!["reduce the tip height, or check the tooth thickness"],
                ));
            }
            // Points of the fillets must not leave the sector of the tooth, whose middle is that of
            // the root ends of both fillets.
            let along = self.middle + self.along[station];
            let ends = [0, 1].map(|side: usize| {
                let points = &self.fillets[side][station];
                self.cones.rolled(along, points[points.len() - 1])[1]
            });
            let middle = 0.5 * (ends[0] + ends[1]);
            for side in 0..2 {
                let sign = 1.0 - 2.0 * side as f64;
                for (index, &point) in self.fillets[side][station].iter().enumerate() {
                    let [height, azimuth] = self.cones.rolled(along, point);
                    let beyond = sign * (azimuth - middle) - half;
                    let radius = self.cones.radius(along, height);
                    if beyond * radius > CLOSE * self.tooth_height {
                        return Err(error(
                            "E0972",
                            "fillets",
                            sentence!["point ", number index as f64, " of station ", number station as f64, " of the ", text SIDES[side], " fillet lies ", length beyond * radius, " beyond the middle of the tooth space"],
                            sentence![
                                "end the fillet where it meets the root or the fillet of the next tooth"
                            ],
                        ));
                    }
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tabulated::test_teeth::Conical;

    fn refused(change: impl Fn(&mut ToothTable)) -> (&'static str, &'static str, String) {
        let mut table = Conical::PINION.table(5, 8);
        change(&mut table);
        let error = table.stations().map(|_| ()).expect_err("refused");
        (error.code, error.argument, error.message.to_string())
    }

    #[test]
    fn malformed_tables_are_refused() {
        let (code, argument, message) = refused(|table| table.flanks[0].truncate(2));
        assert_eq!((code, argument), ("E0970", "flanks"));
        assert!(message.contains("2 stations"), "{message}");
        let (code, argument, message) = refused(|table| table.fillets[1].truncate(4));
        assert_eq!((code, argument), ("E0970", "fillets"));
        assert!(message.contains("clockwise fillet has 4 stations"), "{message}");
        let (code, _, message) = refused(|table| table.flanks[1][3].truncate(7));
        assert_eq!(code, "E0970");
        assert!(message.contains("station 3 of the clockwise flank has 7 points"), "{message}");
        let (code, _, message) = refused(|table| table.flanks[1][3][2][1] = f64::INFINITY);
        assert_eq!(code, "E0970");
        assert!(message.contains("point 2 of station 3 of the clockwise flank is not finite"), "{message}");
        let (code, _, message) = refused(|table| table.flanks[0][0][1] = [0.0, 0.0, 1.0]);
        assert_eq!(code, "E0970");
        assert!(message.contains("on the axis"), "{message}");
    }

    #[test]
    fn points_off_their_section_are_refused() {
        let (code, argument, message) = refused(|table| table.fillets[0][2][5][2] += 1e-4);
        assert_eq!((code, argument), ("E0971", "fillets"));
        assert!(message.contains("point 5 of station 2 of the counter-clockwise fillet"), "{message}");
        let (code, _, _) = refused(|table| table.pitch_angle += 0.02);
        assert_eq!(code, "E0971");
        let (code, argument, _) = refused(|table| table.pitch_angle = 2.0);
        assert_eq!((code, argument), ("E0971", "pitch_angle"));
        let exchange = |grid: &mut PointGrid| grid.swap(1, 2);
        let (code, _, message) = refused(|table| {
            table.flanks.iter_mut().chain(&mut table.fillets).for_each(exchange);
        });
        assert_eq!(code, "E0971");
        assert!(message.contains("do not follow each other"), "{message}");
    }

    #[test]
    fn curves_that_bound_no_tooth_are_refused() {
        let (code, _, message) = refused(|table| {
            table.flanks.swap(0, 1);
            table.fillets.swap(0, 1);
        });
        assert_eq!(code, "E0972");
        assert!(message.contains("lies clockwise of the other"), "{message}");
        let (code, argument, message) = refused(|table| table.teeth = 14);
        assert_eq!((code, argument), ("E0972", "fillets"));
        assert!(message.contains("wider at its root than the pitch"), "{message}");
        let (code, argument, message) = refused(|table| {
            table.fillets[1].iter_mut().for_each(|profile| {
                profile.remove(0);
            });
        });
        assert_eq!((code, argument), ("E0972", "fillets"));
        assert!(message.contains("away from its flank"), "{message}");
        let reverse = |grid: &mut PointGrid| grid.iter_mut().for_each(|profile| profile.reverse());
        let (code, _, message) = refused(|table| {
            table.flanks.iter_mut().chain(&mut table.fillets).for_each(reverse);
        });
        assert_eq!(code, "E0972");
        assert!(message.contains("not above"), "{message}");
        // Flanks that cross: the tip of each is rotated past the other.
        let (code, _, message) = refused(|table| {
            for (side, grid) in table.flanks.iter_mut().enumerate() {
                let turn = if side == 0 { -0.2_f64 } else { 0.2 };
                for profile in grid {
                    let last = profile.len() - 1;
                    for (index, point) in profile.iter_mut().enumerate() {
                        let (sine, cosine) = (turn * index as f64 / last as f64).sin_cos();
                        let [x, y, z] = *point;
                        *point = [cosine * x - sine * y, sine * x + cosine * y, z];
                    }
                }
            }
        });
        assert_eq!(code, "E0972");
        assert!(message.contains("cross"), "{message}");
    }

    #[test]
    fn stations_may_run_either_way_and_the_tooth_may_lie_anywhere() {
        let table = Conical::PINION.table(5, 8);
        let stations = table.stations().expect("a table");
        let mut turned = table.clone();
        for grid in turned.flanks.iter_mut().chain(&mut turned.fillets) {
            grid.reverse();
            // Tooth 0 at three radians, across the jump of the azimuth.
            let (sine, cosine) = 3.0_f64.sin_cos();
            for point in grid.iter_mut().flatten() {
                let [x, y, z] = *point;
                *point = [cosine * x - sine * y, sine * x + cosine * y, z];
            }
        }
        let other = turned.stations().expect("a table");
        for (a, b) in stations.along.iter().zip(&other.along) {
            assert!((a - b).abs() < 1e-15);
        }
        for (a, b) in stations.flanks[1].iter().flatten().zip(other.flanks[1].iter().flatten()) {
            assert!((a[0] - b[0]).abs() < 1e-15 && (a[1] - b[1]).abs() < 1e-14);
        }
    }
}
