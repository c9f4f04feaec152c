//! Image loads of cells in free side faces.
//!
//! If a side face is normal to the length of the patch, as on spur gears, an image lies in the
//! plane of the patch, and its influence has a closed form. Otherwise the image is inclined: its
//! potential is exact, and the average is computed by quadrature.

use super::grid::Cell;
use super::half_space::{mean_inverse_distance, rectangle_potential};
use super::placement::{PatchFrame, Pose};
use super::strips::{Strip, StripInfluence, StripPoints};
use calyx_numerics::vec3::{Vector, cross, dot, length, minus, plus, scaled};
use calyx_structure::solid::Mirror;

/// Mirror in ground coordinates, and the factor of its images for the surface displacement: `1 /
/// (pi E')`, summed over the bodies that have this side face.
#[derive(Clone, Copy, Debug)]
pub struct PlacedMirror {
    point: Vector,
    normal: Vector,
    pub softness: f64,
}

/// Tolerance for equal mirrors: difference of normals and of positions relative to the patch.
const SAME: f64 = 1e-12;

impl PlacedMirror {
    pub fn new(mirror: &Mirror, pose: &Pose, softness: f64) -> Self {
        Self { point: pose.point(mirror.point), normal: pose.direction(mirror.normal), softness }
    }

    /// Returns whether both are one plane, near the point `place`.
    pub fn is_same(&self, other: &PlacedMirror, place: Vector) -> bool {
        let sign = dot(self.normal, other.normal).signum();
        let turn = length(minus(self.normal, scaled(other.normal, sign)));
        let own = self.height(place);
        turn <= SAME && (own - other.height(place) * sign).abs() <= SAME * (own.abs() + length(place))
    }

    fn height(&self, point: Vector) -> f64 {
        dot(minus(point, self.point), self.normal)
    }

    fn turned(&self, direction: Vector) -> Vector {
        minus(direction, scaled(self.normal, 2.0 * dot(direction, self.normal)))
    }
}

/// Images of a patch's cells in one mirror.
pub struct Images<'a> {
    mirror: PlacedMirror,
    frame: &'a PatchFrame,
    /// Directions of the sides of images, unit vectors.
    axes: [Vector; 2],
    /// y of the mirror, if it is normal to the length of the patch.
    upright: Option<f64>,
    /// True if cells at the same y are equally far from the mirror.
    pub is_level: bool,
}

impl<'a> Images<'a> {
    pub fn new(mirror: PlacedMirror, frame: &'a PatchFrame) -> Self {
        let along = dot(mirror.normal, frame.along);
        let upright = (along.abs() >= 1.0 - SAME).then(|| -mirror.height(frame.point) / along);
        let is_level = dot(mirror.normal, frame.across).abs() <= SAME;
        let axes = [frame.across, frame.along].map(|axis| mirror.turned(axis));
        Self { mirror, frame, axes, upright, is_level }
    }

    /// Returns whether images lie in the plane of the patch: then the influence depends on the
    /// difference in x and the sum of the distances from the mirror.
    pub fn is_upright(&self) -> bool {
        self.upright.is_some()
    }

    /// Returns the displacement of a cell by the image of a force of 1 N on another, m/N.
    pub fn influence(&self, observe: &Cell, load: &Cell) -> f64 {
        self.mirror.softness * self.mean_inverse_distance(observe, load)
    }

    /// Returns the displacement of a point of the tangent plane at `at` by the image of a force of
    /// 1 N, distributed uniformly over a rectangle around `center`, m/N.
    pub fn influence_at(&self, at: [f64; 2], center: [f64; 2], size: [f64; 2]) -> f64 {
        let half = size.map(|size| 0.5 * size);
        let image = Panel::new(self.image_of(self.frame.at(center)), self.axes, half);
        let from = minus(self.frame.at(at), image.center);
        let potential = rectangle_potential(half, image.axes.map(|axis| dot(from, axis)));
        self.mirror.softness * potential / (size[0] * size[1])
    }

    fn image_of(&self, point: Vector) -> Vector {
        minus(point, scaled(self.mirror.normal, 2.0 * self.mirror.height(point)))
    }

    /// Returns the average of 1/r between the points of a cell and of another's image, 1/m. It is
    /// symmetric in the cells, in the closed form bit for bit.
    fn mean_inverse_distance(&self, observe: &Cell, load: &Cell) -> f64 {
        if let Some(y) = self.upright {
            let halves = [observe, load].map(|cell| cell.size.map(|size| 0.5 * size));
            let offset = [observe.center[0] - load.center[0], (observe.center[1] - y) + (load.center[1] - y)];
            return mean_inverse_distance(offset, halves[0], halves[1]);
        }
        self.panel(observe).mean_inverse_distance(&self.image(load))
    }

    fn panel(&self, cell: &Cell) -> Panel {
        let frame = self.frame;
        Panel::new(frame.at(cell.center), [frame.across, frame.along], cell.size.map(|size| 0.5 * size))
    }

    fn image(&self, cell: &Cell) -> Panel {
        let image = self.image_of(self.frame.at(cell.center));
        Panel::new(image, self.axes, cell.size.map(|size| 0.5 * size))
    }
}

impl StripInfluence for Images<'_> {
    type Close = ();

    fn distance(&self, observe: &Strip, load: &Strip) -> f64 {
        let radius = |strip: &Strip| strip.half[0].hypot(strip.half[1]);
        let [place, other] = [observe, load].map(|strip| self.frame.at(strip.center));
        let apart = length(minus(place, self.image_of(other))) - radius(observe) - radius(load);
        // The strip and the image of one on the same side are on opposite sides of the mirror.
        let slopes = [self.frame.across, self.frame.along].map(|axis| dot(axis, self.mirror.normal).abs());
        let reach = |strip: &Strip| strip.half[0] * slopes[0] + strip.half[1] * slopes[1];
        let heights = [place, other].map(|place| self.mirror.height(place));
        let between = (heights[0] + heights[1]).abs() - reach(observe) - reach(load);
        apart.max(between)
    }

    fn between_lines(&self, observe: &StripPoints, load: &StripPoints) -> Vec<f64> {
        let image = |at: [f64; 2]| self.image_of(self.frame.at(at));
        let mut means = observe.mean_inverse_distances(load, |at| self.frame.at(at), image);
        means.iter_mut().for_each(|mean| *mean *= self.mirror.softness);
        means
    }
}

/// Cell as a rectangle in three dimensions.
#[derive(Clone, Copy, Debug)]
struct Panel {
    center: Vector,
    /// Unit vectors along its sides, and their cross product.
    axes: [Vector; 3],
    /// Half-lengths of its sides, m.
    half: [f64; 2],
}

/// Gauss-Legendre rules on -1 .. 1 with weights of sum 1. Each has the largest ratio of half a side
/// to the distance at which an average of 1/r by `n` points is accurate to 1e-6, since the `2n`-th
/// derivative of 1/r is at most `(2n)! / r^(2n + 1)`.
const RULES: [(f64, &[(f64, f64)]); 4] = [
    (1.7e-3, &[(0.0, 1.0)]),
    (0.057, &[(-0.577_350_269_189_625_8, 0.5), (0.577_350_269_189_625_8, 0.5)]),
    (
        0.18,
        &[(-0.774_596_669_241_483_4, 5.0 / 18.0), (0.0, 4.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 18.0)],
    ),
    (
        1.0 / 3.0,
        &[
            (-0.861_136_311_594_052_6, 0.173_927_422_568_726_93),
            (-0.339_981_043_584_856_3, 0.326_072_577_431_273_07),
            (0.339_981_043_584_856_3, 0.326_072_577_431_273_07),
            (0.861_136_311_594_052_6, 0.173_927_422_568_726_93),
        ],
    ),
];
/// Distance, in sums of both halves of the long sides, from which quadrature points replace panels.
const FAR: f64 = 2.0;
/// Distance, in halves of the long side, from which points observe the potential of an image. Cells
/// of a lattice are at no such distance, so that rounding does not decide.
const NEAR: f64 = 3.07;
/// Maximum number of bisections of an observing panel. Where image and panel touch, the potential
/// is continuous and only its slope is singular, so each bisection leaves a quarter of the error,
/// down to 1e-6.
const HALVINGS: u32 = 9;

/// Points of a product rule with their weights, and their number.
struct Points([(Vector, f64); 16], usize);

impl Points {
    fn iter(&self) -> impl Iterator<Item = &(Vector, f64)> {
        self.0[..self.1].iter()
    }
}

impl Panel {
    fn new(center: Vector, [across, along]: [Vector; 2], half: [f64; 2]) -> Self {
        Self { center, axes: [across, along, cross(across, along)], half }
    }

    fn longer(&self) -> usize {
        usize::from(self.half[1] > self.half[0])
    }

    /// Returns the distance of a point from the rectangle.
    fn distance_from(&self, point: Vector) -> f64 {
        let from = minus(point, self.center);
        let [x, y, z] = self.axes.map(|axis| dot(from, axis).abs());
        length([(x - self.half[0]).max(0.0), (y - self.half[1]).max(0.0), z])
    }

    /// Returns the points that average 1/r accurately at a distance.
    fn points(&self, distance: f64) -> Points {
        let rule = |k: usize| -> &'static [(f64, f64)] {
            let part = self.half[k] / distance.max(0.0);
            let enough = RULES.iter().find(|&&(most, _)| part <= most);
            enough.map_or(RULES[RULES.len() - 1].1, |&(_, rule)| rule)
        };
        let (rules, sides) = ([rule(0), rule(1)], [0, 1].map(|k| scaled(self.axes[k], self.half[k])));
        let mut points = Points([([0.0; 3], 0.0); 16], 0);
        for &(u, weight_u) in rules[0] {
            let row = plus(self.center, scaled(sides[0], u));
            for &(v, weight_v) in rules[1] {
                points.0[points.1] = (plus(row, scaled(sides[1], v)), weight_u * weight_v);
                points.1 += 1;
            }
        }
        points
    }

    /// Returns the average of 1/r between the points of both, to about 1e-6. Distant panels are
    /// replaced by quadrature points. Otherwise the potential of the image is exact and is averaged
    /// over parts of the panel that are smaller near the image.
    fn mean_inverse_distance(&self, image: &Panel) -> f64 {
        let distance = length(minus(self.center, image.center));
        let [own, others] = [self, image].map(|panel| panel.half[panel.longer()]);
        if distance < FAR * (own + others) {
            return self.near(image, HALVINGS);
        }
        let others = image.points(distance - own);
        let seen = |&(point, weight): &(Vector, f64)| {
            let of = |&(other, weight): &(Vector, f64)| weight / length(minus(point, other));
            weight * others.iter().map(of).sum::<f64>()
        };
        self.points(distance - image.half[image.longer()]).iter().map(seen).sum()
    }

    fn near(&self, image: &Panel, halvings: u32) -> f64 {
        let longer = self.longer();
        let apart = image.distance_from(self.center);
        if halvings > 0 && apart < NEAR * self.half[longer] {
            let mut part = *self;
            part.half[longer] *= 0.5;
            let shift = scaled(self.axes[longer], part.half[longer]);
            let halves = [minus(self.center, shift), plus(self.center, shift)];
            return halves
                .map(|center| 0.5 * Panel { center, ..part }.near(image, halvings - 1))
                .iter()
                .sum();
        }
        let area = 4.0 * image.half[0] * image.half[1];
        self.points(apart)
            .iter()
            .map(|&(point, weight)| {
                let from = minus(point, image.center);
                weight * rectangle_potential(image.half, image.axes.map(|axis| dot(from, axis))) / area
            })
            .sum()
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    impl PlacedMirror {
        /// Returns the mirror in other ground coordinates.
        pub fn rotated(self, turned: impl Fn(Vector) -> Vector) -> Self {
            Self { point: turned(self.point), normal: turned(self.normal), ..self }
        }
    }

    pub fn cell(center: [f64; 2], size: [f64; 2]) -> Cell {
        let (places, slope) = ([[0.0; 2]; 2], [0.0; 2]);
        Cell {
            center,
            size,
            places,
            loaded_at: places,
            axial: [size[1]; 2],
            spans: [size[1]; 2],
            gap: 0.0,
            point: [0.0; 3],
            slope,
            edge: false,
        }
    }

    pub const FRAME: PatchFrame = PatchFrame {
        point: [0.1, 0.2, 0.3],
        normal: [0.0, 0.0, 1.0],
        across: [1.0, 0.0, 0.0],
        along: [0.0, 1.0, 0.0],
    };

    /// Side face at y = 2, inclined towards the normal of the patch.
    pub fn face(lean: f64) -> PlacedMirror {
        PlacedMirror { point: [0.0, 2.2, 0.3], normal: [0.0, lean.cos(), lean.sin()], softness: 1.0 }
    }

    #[test]
    fn images_are_seen_alike_from_either_side() {
        let images = Images::new(face(0.4), &FRAME);
        let cells = [
            cell([0.0, 1.5], [0.02, 1.0]),
            cell([0.03, 1.4], [0.01, 1.2]),
            cell([0.5, -7.0], [0.4, 0.5]),
            cell([0.0, 0.5], [0.02, 1.0]),
        ];
        for one in &cells {
            for other in &cells {
                let [there, back] =
                    [(one, other), (other, one)].map(|(a, b)| images.mean_inverse_distance(a, b));
                assert!((there / back - 1.0).abs() < 1e-6, "{one:?} {other:?}: {there} {back}");
            }
        }
    }

    /// Near and far, narrow and square panels, against the exact potential on many parts.
    #[test]
    fn few_points_are_enough() {
        let images = Images::new(face(0.4), &FRAME);
        let load = cell([0.0, 1.4], [0.02, 0.5]);
        let others = [1.3, 0.7, 0.1, -0.9, -3.5, -20.0];
        for (y, size) in others.into_iter().flat_map(|y| [[0.02, 0.5], [0.3, 0.4]].map(|size| (y, size))) {
            let pieces = 40;
            let piece = |k: usize| {
                let along = y + size[1] * ((k as f64 + 0.5) / pieces as f64 - 0.5);
                cell([0.3, along], [size[0], size[1] / pieces as f64])
            };
            let exact = |k: usize| images.panel(&piece(k)).near(&images.image(&load), 2) / pieces as f64;
            let exact: f64 = (0..pieces).map(exact).sum();
            let found = images.mean_inverse_distance(&cell([0.3, y], size), &load);
            assert!((found / exact - 1.0).abs() < 2e-6, "{y} {size:?}: {found:e} {exact:e}");
        }
    }

    #[test]
    fn nearly_upright_faces_are_like_upright_ones() {
        let (upright, leaning) = (Images::new(face(0.0), &FRAME), Images::new(face(1e-5), &FRAME));
        assert!(upright.upright.is_some() && leaning.upright.is_none() && leaning.is_level);
        for (one, other) in [
            (cell([0.0, 1.5], [0.02, 1.0]), cell([0.0, 1.5], [0.02, 1.0])),
            (cell([0.1, 1.5], [0.02, 1.0]), cell([0.0, 0.4], [0.03, 1.0])),
            (cell([0.1, -9.5], [0.02, 1.0]), cell([0.0, 0.4], [0.03, 1.0])),
        ] {
            let ratio =
                upright.mean_inverse_distance(&one, &other) / leaning.mean_inverse_distance(&one, &other);
            assert!((ratio - 1.0).abs() < 1e-5, "{ratio}");
        }
    }

    #[test]
    fn faces_of_both_bodies_in_one_plane_are_one() {
        let opposite = PlacedMirror { point: [5.0, 2.2, 0.3], normal: [0.0, -1.0, 0.0], softness: 2.0 };
        assert!(face(0.0).is_same(&opposite, FRAME.point));
        assert!(!face(1e-6).is_same(&opposite, FRAME.point));
        let shifted = PlacedMirror { point: [5.0, 2.2001, 0.3], ..opposite };
        assert!(!face(0.0).is_same(&shifted, FRAME.point));
    }
}
