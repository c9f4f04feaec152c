//! Parallel projection of a surface with hidden parts removed by a depth buffer.

use super::surface::Surface;
use std::collections::BTreeMap;
use std::io;

/// Width or height of the body in a picture, whichever is larger, pixels.
const LARGEST: f64 = 760.0;
/// Margin, pixels.
const MARGIN: f64 = 12.0;
/// Samples per pixel in each direction.
const SAMPLES: usize = 2;
/// Direction of the viewer from the front, which faces +z: to the right and above, rad.
const AZIMUTH: f64 = 0.55;
const ELEVATION: f64 = 0.4;
/// Difference of the directions of two faces, as the cosine, beyond which their edge is drawn.
const CREASE: f64 = 0.9;
/// Length of the median edge from which all edges of elements are drawn, pixels.
const DENSE: f64 = 7.0;
/// Distance of lines in front of their surface, relative to the size of the body.
const LIFTED: f64 = 2e-3;
const GREY: [f64; 3] = [0.6, 0.6, 0.62];
const INK: [f64; 3] = [0.12, 0.13, 0.15];
/// Colour of undeformed creases, which are seen through the surface.
const GHOST: [f64; 3] = [0.2, 0.4, 0.75];

/// Picture with a transparent background.
pub struct Image {
    width: usize,
    height: usize,
    /// Red, green, blue and opacity of each sample.
    samples: Vec<[f64; 4]>,
    depths: Vec<f64>,
}

/// Direction of the viewer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// From the front, which faces +z, to the right and above.
    Front,
    /// The opposite direction.
    Back,
}

impl View {
    /// All directions: each side of a box is seen from one of them.
    pub const ALL: [View; 2] = [View::Front, View::Back];

    /// Returns the name in files.
    pub fn name(self) -> &'static str {
        match self {
            View::Front => "front",
            View::Back => "back",
        }
    }
}

/// Draws a surface with exaggerated displacements. Colours go from zero to a largest stress; parts
/// without stress are grey. Creases of the undeformed surface are seen through it.
pub fn draw(surface: &Surface, exaggeration: f64, largest_stress: f64) -> Image {
    let colour = |face: usize, corner: usize| match surface.stresses[surface.faces[face][corner]] {
        stress if stress.is_finite() && largest_stress > 0.0 => colour_of(stress / largest_stress),
        stress if stress.is_finite() => colour_of(0.0),
        _ => GREY,
    };
    draw_coloured(surface, exaggeration, View::Front, &colour)
}

/// Draws a surface like [`draw`] with a colour for each corner of each face.
pub fn draw_coloured(
    surface: &Surface,
    exaggeration: f64,
    view: View,
    colour: &dyn Fn(usize, usize) -> [f64; 3],
) -> Image {
    let moved: Vec<[f64; 3]> = surface
        .points
        .iter()
        .zip(&surface.displacements)
        .map(|(point, by)| std::array::from_fn(|k| point[k] + exaggeration * by[k]))
        .collect();
    let frame = Frame::around(view, moved.iter().chain(&surface.points));
    let mut image = Image::empty(&frame);
    let [deformed, undeformed] = [&moved, &surface.points]
        .map(|points| points.iter().map(|&point| frame.projected(point)).collect::<Vec<[f64; 3]>>());
    for (index, face) in surface.faces.iter().enumerate() {
        let light = light(&frame.axes, &moved, face);
        for k in 1..face.len() - 1 {
            let corners = [0, k, k + 1];
            image.triangle(
                corners.map(|corner| deformed[face[corner]]),
                corners.map(|corner| colour(index, corner).map(|part| light * part)),
            );
        }
    }
    let edges = Edges::of(surface, &moved);
    let lifted = LIFTED * frame.size * frame.scale;
    if edges.median(&deformed) >= DENSE * SAMPLES as f64 {
        for &[from, to] in edges.all.keys() {
            image.line([deformed[from], deformed[to]], (INK, 0.35, 1), lifted);
        }
    }
    for [from, to] in edges.creases() {
        image.line([deformed[from], deformed[to]], (INK, 0.9, 2), lifted);
    }
    for &[from, to] in &surface.lines {
        image.line([deformed[from], deformed[to]], (INK, 1.0, 3 * SAMPLES), lifted);
    }
    if exaggeration != 0.0 {
        for [from, to] in Edges::of(surface, &surface.points).creases() {
            image.line([undeformed[from], undeformed[to]], (GHOST, 0.5, 2), f64::INFINITY);
        }
    }
    image
}

/// Axes of the picture in ground coordinates, of which y is upwards.
struct Axes {
    right: [f64; 3],
    up: [f64; 3],
    /// Direction towards the viewer.
    towards: [f64; 3],
}

impl Axes {
    fn of_view(view: View) -> Axes {
        let ([sine, cosine], [rise, level]) =
            ([AZIMUTH.sin(), AZIMUTH.cos()], [ELEVATION.sin(), ELEVATION.cos()]);
        // Seen from the opposite direction, up is the same.
        let sense = if view == View::Back { -1.0 } else { 1.0 };
        Axes {
            right: [sense * cosine, 0.0, -sense * sine],
            up: [-sine * rise, level, -cosine * rise],
            towards: [sense * sine * level, sense * rise, sense * cosine * level],
        }
    }
}

/// Projection of ground coordinates to samples: right, down, and towards the viewer.
struct Frame {
    axes: Axes,
    /// Coordinates of the left upper corner.
    corner: [f64; 2],
    /// Samples per metre.
    scale: f64,
    /// Largest side, m.
    size: f64,
    width: usize,
    height: usize,
}

impl Frame {
    fn around<'p>(view: View, points: impl Iterator<Item = &'p [f64; 3]>) -> Frame {
        let axes = Axes::of_view(view);
        let (mut least, mut most) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in points {
            for (k, axis) in [axes.right, axes.up].iter().enumerate() {
                let at = dot(point, axis);
                (least[k], most[k]) = (least[k].min(at), most[k].max(at));
            }
        }
        let sides = [most[0] - least[0], most[1] - least[1]];
        let size = sides[0].max(sides[1]);
        let size = if size.is_finite() && size > 0.0 { size } else { 1.0 };
        let samples = SAMPLES as f64;
        let scale = samples * LARGEST / size;
        let margin = MARGIN * samples / scale;
        let count = |side: f64| {
            let pixels = LARGEST * side.max(0.0) / size + 2.0 * MARGIN;
            (if pixels.is_finite() { pixels.ceil() as usize } else { 1 }) * SAMPLES
        };
        let corner = [least[0] - margin, most[1] + margin];
        Frame { axes, corner, scale, size, width: count(sides[0]), height: count(sides[1]) }
    }

    fn projected(&self, point: [f64; 3]) -> [f64; 3] {
        let [x, y] = [dot(&point, &self.axes.right), dot(&point, &self.axes.up)];
        let right = (x - self.corner[0]) * self.scale;
        let down = (self.corner[1] - y) * self.scale;
        [right, down, dot(&point, &self.axes.towards) * self.scale]
    }
}

/// Edges of faces with the normals of the faces at them.
struct Edges {
    all: BTreeMap<[usize; 2], Vec<[f64; 3]>>,
}

impl Edges {
    fn of(surface: &Surface, points: &[[f64; 3]]) -> Edges {
        let mut all: BTreeMap<[usize; 2], Vec<[f64; 3]>> = BTreeMap::new();
        for face in &surface.faces {
            let normal = normal(points, face);
            for k in 0..face.len() {
                let [from, to] = [face[k], face[(k + 1) % face.len()]];
                all.entry([from.min(to), from.max(to)]).or_default().push(normal);
            }
        }
        Edges { all }
    }

    /// Returns the edges of one face, and those between faces of different directions. Shells have
    /// two sides, so the sense of a normal does not count.
    fn creases(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        let is_crease = |normals: &[[f64; 3]]| match normals {
            [one, other] => dot(one, other).abs() < CREASE,
            _ => true,
        };
        self.all.iter().filter(move |(_, normals)| is_crease(normals)).map(|(edge, _)| *edge)
    }

    /// Returns the median length in a projection.
    fn median(&self, points: &[[f64; 3]]) -> f64 {
        let length = |&[from, to]: &[usize; 2]| {
            (points[from][0] - points[to][0]).hypot(points[from][1] - points[to][1])
        };
        let mut lengths: Vec<f64> = self.all.keys().map(length).collect();
        lengths.sort_by(f64::total_cmp);
        lengths.get(lengths.len() / 2).copied().unwrap_or(0.0)
    }
}

impl Image {
    fn empty(frame: &Frame) -> Image {
        let count = frame.width * frame.height;
        Image {
            width: frame.width,
            height: frame.height,
            samples: vec![[0.0; 4]; count],
            depths: vec![f64::NEG_INFINITY; count],
        }
    }

    /// Returns width and height, pixels.
    pub fn size(&self) -> [u32; 2] {
        [self.width, self.height].map(|count| u32::try_from(count / SAMPLES).unwrap_or(u32::MAX))
    }

    /// Draws a triangle with colours at its corners where nothing is in front of it.
    fn triangle(&mut self, corners: [[f64; 3]; 3], colours: [[f64; 3]; 3]) {
        let [a, b, c] = corners;
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        if !area.is_finite() || area == 0.0 {
            return;
        }
        let range = |k: usize, count: usize| {
            let least = a[k].min(b[k]).min(c[k]).floor().max(0.0) as usize;
            let most = (a[k].max(b[k]).max(c[k]).ceil().max(0.0) as usize).min(count);
            least..most
        };
        for row in range(1, self.height) {
            for column in range(0, self.width) {
                let [x, y] = [column as f64 + 0.5, row as f64 + 0.5];
                let part = |from: [f64; 3], to: [f64; 3]| {
                    ((to[0] - from[0]) * (y - from[1]) - (x - from[0]) * (to[1] - from[1])) / area
                };
                let weights = [part(b, c), part(c, a), part(a, b)];
                if weights.iter().any(|weight| *weight < 0.0) {
                    continue;
                }
                let depth: f64 = (0..3).map(|k| weights[k] * corners[k][2]).sum();
                let place = row * self.width + column;
                if depth > self.depths[place] {
                    self.depths[place] = depth;
                    let [red, green, blue] =
                        std::array::from_fn(|part| (0..3).map(|k| weights[k] * colours[k][part]).sum());
                    self.samples[place] = [red, green, blue, 1.0];
                }
            }
        }
    }

    /// Draws a line of a colour, opacity and width where nothing is more than a distance in front
    /// of it.
    fn line(
        &mut self,
        [from, to]: [[f64; 3]; 2],
        (colour, opacity, width): ([f64; 3], f64, usize),
        lifted: f64,
    ) {
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        if !length.is_finite() {
            return;
        }
        let steps = length.ceil().max(1.0) as usize;
        let mut before = None;
        for step in 0..=steps {
            let part = step as f64 / steps as f64;
            let at = |k: usize| from[k] + part * (to[k] - from[k]);
            let (column, row) = ((at(0) - 0.5 * width as f64).round(), (at(1) - 0.5 * width as f64).round());
            if before.replace((column, row)) == Some((column, row)) {
                continue;
            }
            for (i, j) in (0..width).flat_map(|i| (0..width).map(move |j| (i, j))) {
                let (column, row) = (column + i as f64, row + j as f64);
                if column < 0.0 || row < 0.0 || column >= self.width as f64 || row >= self.height as f64 {
                    continue;
                }
                let place = row as usize * self.width + column as usize;
                if at(2) + lifted >= self.depths[place] {
                    let under = self.samples[place];
                    let sum = opacity + under[3] * (1.0 - opacity);
                    let mixed =
                        |k: usize| (opacity * colour[k] + under[3] * (1.0 - opacity) * under[k]) / sum;
                    self.samples[place] = [mixed(0), mixed(1), mixed(2), sum];
                }
            }
        }
    }

    /// Encodes the picture.
    ///
    /// # Errors
    /// It has no pixels.
    pub fn png(&self) -> io::Result<Vec<u8>> {
        let [width, height] = self.size();
        let mut bytes = Vec::with_capacity(4 * (width * height) as usize);
        for row in 0..height as usize {
            for column in 0..width as usize {
                let mut sum = [0.0; 4];
                for place in 0..SAMPLES * SAMPLES {
                    let (i, j) = (SAMPLES * row + place / SAMPLES, SAMPLES * column + place % SAMPLES);
                    let [red, green, blue, opacity] = self.samples[i * self.width + j];
                    let weighted = [red * opacity, green * opacity, blue * opacity, opacity];
                    sum.iter_mut().zip(weighted).for_each(|(sum, part)| *sum += part);
                }
                let opacity = sum[3];
                let byte = |value: f64| (255.0 * value.clamp(0.0, 1.0)).round() as u8;
                bytes.extend((0..3).map(|k| if opacity > 0.0 { byte(sum[k] / opacity) } else { 0 }));
                bytes.push(byte(opacity / (SAMPLES * SAMPLES) as f64));
            }
        }
        let mut content = Vec::new();
        let mut encoder = png::Encoder::new(&mut content, width, height);
        encoder.set_color(png::ColorType::Rgba);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.write_header()?.write_image_data(&bytes)?;
        Ok(content)
    }
}

fn dot(one: &[f64; 3], other: &[f64; 3]) -> f64 {
    one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
}

/// Returns the unit normal of a face, from its diagonals; zero for a degenerate one.
fn normal(points: &[[f64; 3]], face: &[usize]) -> [f64; 3] {
    let between = |from: usize, to: usize| -> [f64; 3] {
        std::array::from_fn(|k| points[face[to]][k] - points[face[from]][k])
    };
    let [a, b] = match face.len() {
        4 => [between(0, 2), between(1, 3)],
        _ => [between(0, 1), between(0, 2)],
    };
    let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let length = dot(&cross, &cross).sqrt();
    if length > 0.0 { cross.map(|part| part / length) } else { [0.0; 3] }
}

/// Returns the brightness of a face, which light from the viewer and from above reaches.
fn light(axes: &Axes, points: &[[f64; 3]], face: &[usize]) -> f64 {
    let normal = normal(points, face);
    let sense = if dot(&normal, &axes.towards) < 0.0 { -1.0 } else { 1.0 };
    0.8 + 0.14 * sense * dot(&normal, &axes.towards) + 0.06 * sense * dot(&normal, &axes.up)
}

/// Points of the colour scale, equally spaced: from a light grey, so that parts without load do not
/// hide the shading, by yellow and red to a dark red.
const SCALE: [[f64; 3]; 8] = [
    [0.90, 0.91, 0.92],
    [0.98, 0.93, 0.66],
    [0.99, 0.82, 0.42],
    [0.99, 0.66, 0.28],
    [0.97, 0.46, 0.19],
    [0.87, 0.24, 0.14],
    [0.69, 0.07, 0.14],
    [0.42, 0.00, 0.15],
];

/// Returns the colour of a fraction of the largest stress.
fn colour_of(fraction: f64) -> [f64; 3] {
    let at = fraction.clamp(0.0, 1.0) * (SCALE.len() - 1) as f64;
    let first = (at as usize).min(SCALE.len() - 2);
    let part = at - first as f64;
    std::array::from_fn(|k| SCALE[first][k] + part * (SCALE[first + 1][k] - SCALE[first][k]))
}

/// Points of the colour scale of negative values, from zero.
const NEGATIVE: [[f64; 3]; 4] =
    [[0.90, 0.91, 0.92], [0.60, 0.76, 0.90], [0.27, 0.51, 0.78], [0.08, 0.22, 0.50]];

/// Returns the colour of a fraction of the largest magnitude, from -1 to 1: shades of blue for
/// negative values.
pub fn signed_colour(fraction: f64) -> [f64; 3] {
    if !fraction.is_finite() {
        return GREY;
    }
    if fraction >= 0.0 {
        return colour_of(fraction);
    }
    let at = -fraction.max(-1.0) * (NEGATIVE.len() - 1) as f64;
    let first = (at as usize).min(NEGATIVE.len() - 2);
    let part = at - first as f64;
    std::array::from_fn(|k| NEGATIVE[first][k] + part * (NEGATIVE[first + 1][k] - NEGATIVE[first][k]))
}

/// Returns the colours of the scale as hexadecimal codes from the negative largest magnitude to the
/// positive one.
pub fn signed_colour_scale() -> Vec<String> {
    let negative = NEGATIVE.into_iter().rev().map(code);
    negative.chain(SCALE.into_iter().skip(1).map(code)).collect()
}

/// Returns the hexadecimal code of a colour.
fn code([red, green, blue]: [f64; 3]) -> String {
    let byte = |part: f64| (255.0 * part).round() as u8;
    format!("#{:02x}{:02x}{:02x}", byte(red), byte(green), byte(blue))
}

/// Returns the colours of the scale as hexadecimal codes, from zero to the largest stress.
pub fn colour_scale() -> Vec<String> {
    SCALE.into_iter().map(code).collect()
}

#[cfg(test)]
mod tests {
    use super::super::surface::all;
    use super::super::tests::cube;
    use super::*;
    use calyx_runtime::observables::Fields;

    #[test]
    fn the_axes_of_the_picture_are_orthonormal() {
        for view in View::ALL {
            let Axes { right, up, towards } = Axes::of_view(view);
            let axes = [right, up, towards];
            for (i, one) in axes.iter().enumerate() {
                for (j, other) in axes.iter().enumerate() {
                    assert!((dot(one, other) - f64::from(i == j)).abs() < 1e-15, "{i} {j}");
                }
            }
            let cross = [
                right[1] * up[2] - right[2] * up[1],
                right[2] * up[0] - right[0] * up[2],
                right[0] * up[1] - right[1] * up[0],
            ];
            assert!(dot(&cross, &towards) > 0.0, "{view:?}");
        }
    }

    /// The projection of a unit cube has the area of its three visible faces, and hidden faces do
    /// not show: nothing has the colour of their stress.
    #[test]
    fn visible_faces_cover_their_projection() {
        let fields = Fields { elastic_bodies: vec![cube(0, 1e6)], ..Fields::default() };
        let surface = all(&fields).next().expect("a cube").surface();
        let frame = Frame::around(View::Front, surface.points.iter());
        let image = draw(&surface, 0.0, 1e6);
        let covered = image.samples.iter().filter(|sample| sample[3] == 1.0).count() as f64;
        let expected = frame.axes.towards.iter().sum::<f64>() * frame.scale * frame.scale;
        assert!((covered / expected - 1.0).abs() < 5e-3, "{covered} {expected}");
        // The left face, where x and so the stress is zero, is hidden: its colour is on edges only.
        let grey = |sample: &&[f64; 4]| sample[3] == 1.0 && sample[2] > sample[0];
        let grey = image.samples.iter().filter(grey).count() as f64;
        assert!(grey > 0.0 && grey < 0.1 * covered, "{grey} of {covered}");
    }

    #[test]
    fn exaggerated_displacements_move_the_surface() {
        let fields = Fields { elastic_bodies: vec![cube(0, 1e6)], ..Fields::default() };
        let surface = all(&fields).next().expect("a cube").surface();
        let covered = |exaggeration: f64| {
            let image = draw(&surface, exaggeration, 1e6);
            let [width, height] = image.size();
            f64::from(width) / f64::from(height)
        };
        assert!(covered(5e4) > 1.1 * covered(0.0));
    }

    #[test]
    fn degenerate_surfaces_have_a_picture() {
        let mut flat = cube(0, 0.0);
        flat.points = vec![[1.0, 2.0, 3.0]; 8];
        let mut invalid = cube(0, f64::NAN);
        invalid.displacements[3] = [f64::NAN; 3];
        let mut empty = cube(0, 1.0);
        empty.cells.clear();
        for field in [flat, invalid, empty] {
            let fields = Fields { elastic_bodies: vec![field], ..Fields::default() };
            let body = all(&fields).next().expect("a body");
            let image = draw(&body.surface(), 1.0, body.largest_stress());
            assert!(!image.png().expect("a picture").is_empty());
        }
    }
}
