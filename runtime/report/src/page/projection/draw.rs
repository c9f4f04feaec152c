//! Drawing of a tooth on its projection plane, true to scale: a coloured field, contour lines, a
//! path, and the outline with its labels.

use super::contour::{Field, contour};
use super::tooth::Tooth;
use crate::page::chart::{Axis, Error, FONT, LEGEND, Plot, SHADES, TALL, drawn, shade};
use crate::page::units::Unit;
use crate::signals::{label, tick};
use plotters::prelude::*;

/// Width of the labels of the vertical axis, and height of those of the horizontal one.
const LABELS: [u32; 2] = [148, 88];
const MARGIN: u32 = 8;
/// Room for the names of the boundaries, as parts of the length of the tooth: at
/// its ends, below and above it.
const ROOM: [f64; 3] = [0.09, 0.045, 0.085];
/// Limits of the height of a picture.
const HEIGHTS: [u32; 2] = [380, 1100];
/// Colours of the path, of the marks on edges, and of the boundary of a contact pattern.
pub const PATH: usize = 0;
pub const EDGE: usize = 3;
pub const PATTERN: usize = 2;

/// Coloured quadrilateral.
#[derive(Clone, Debug, PartialEq)]
pub struct Patch {
    pub corners: [[f64; 2]; 4],
    pub value: f64,
}

/// Contents of a picture; positions in m.
pub struct Picture<'a> {
    pub tooth: &'a Tooth,
    pub patches: Vec<Patch>,
    /// Quadrilaterals in the colour of edge contact.
    pub on_edges: Vec<[[f64; 2]; 4]>,
    /// Largest value of the scale, and its label.
    pub scale: (f64, Axis<'a>),
    /// Labelled contour lines of a field.
    pub contours: Option<(&'a Field, Vec<f64>)>,
    /// Boundary of a contact pattern: field and level.
    pub boundary: Option<(&'a Field, f64)>,
    /// Lines of the path of contact with their colours, with a mark at each point if `marked`.
    pub paths: Vec<(usize, Vec<[f64; 2]>)>,
    pub marked: bool,
    pub length: Unit,
    /// Colours and names of the legend.
    pub legend: Vec<(usize, String)>,
}

/// Largest coordinates of the picture, in the unit of length.
struct Frame {
    x: [f64; 2],
    y: [f64; 2],
    height: u32,
}

impl Picture<'_> {
    fn at(&self, [x, y]: [f64; 2]) -> (f64, f64) {
        (self.length.of(x), self.length.of(y))
    }

    fn points(&self, line: &[[f64; 2]]) -> Vec<(f64, f64)> {
        line.iter().map(|point| self.at(*point)).collect()
    }

    fn frame(&self) -> Frame {
        let outline = self.points(&self.tooth.outline());
        let ends = |values: &mut dyn Iterator<Item = f64>| {
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
                [low.min(value), high.max(value)]
            })
        };
        let x = ends(&mut outline.iter().map(|point| point.0));
        let y = ends(&mut outline.iter().map(|point| point.1));
        let room = ROOM.map(|part| part * (x[1] - x[0]));
        let (x, y) = ([x[0] - room[0], x[1] + room[0]], [y[0] - room[1], y[1] + room[2]]);
        let width = (TALL.0 - LEGEND - LABELS[0] - 2 * MARGIN) as f64;
        let drawn = (y[1] - y[0]) / (x[1] - x[0]) * width;
        let height = (drawn as u32 + LABELS[1] + 2 * MARGIN).clamp(HEIGHTS[0], HEIGHTS[1]);
        // A picture with a limited height remains true to scale.
        let visible = f64::from(height - LABELS[1] - 2 * MARGIN) * (x[1] - x[0]) / width;
        let (middle, half) = (0.5 * (y[0] + y[1]), 0.5 * visible.max(y[1] - y[0]));
        Frame { x, y: [middle - half, middle + half], height }
    }

    /// Draws the picture.
    pub fn plot(&self) -> Plot {
        let frame = self.frame();
        let svg = drawn((TALL.0, frame.height), |area| {
            let (picture, legend) = area.split_horizontally(TALL.0 - LEGEND);
            let mut chart = ChartBuilder::on(&picture)
                .margin(MARGIN)
                .x_label_area_size(LABELS[1])
                .y_label_area_size(LABELS[0])
                .build_cartesian_2d(frame.x[0]..frame.x[1], frame.y[0]..frame.y[1])?;
            let from =
                if self.tooth.conical { "from the toe along the pitch cone" } else { "along the face" };
            let small = 1e-9 * (frame.x[1] - frame.x[0]);
            let at = |value: f64| tick(if value.abs() < small { 0.0 } else { value });
            chart
                .configure_mesh()
                .x_desc(label(from, self.length.name))
                .y_desc(label("height above the root", self.length.name))
                .axis_desc_style(("sans-serif", FONT))
                .label_style(("sans-serif", FONT - 3))
                .x_label_formatter(&|value| at(*value))
                .y_label_formatter(&|value| at(*value))
                .y_labels(7)
                .light_line_style(TRANSPARENT)
                .bold_line_style(BLACK.mix(0.12))
                .draw()?;
            let outline = self.points(&self.tooth.outline());
            chart.draw_series([Polygon::new(outline.clone(), BLACK.mix(0.05).filled())])?;
            chart.draw_series(self.patches.iter().map(|patch| {
                let corners: Vec<(f64, f64)> = patch.corners.iter().map(|at| self.at(*at)).collect();
                Polygon::new(corners, shade(patch.value / self.scale.0).filled())
            }))?;
            chart.draw_series(self.on_edges.iter().map(|corners| {
                let corners: Vec<(f64, f64)> = corners.iter().map(|at| self.at(*at)).collect();
                Polygon::new(corners, crate::page::chart::COLOURS[EDGE].filled())
            }))?;
            self.lines(&mut chart)?;
            chart.draw_series([PathElement::new(outline, BLACK.stroke_width(4))])?;
            self.names(&mut chart)?;
            self.key(&legend)
        });
        Plot { svg, legend: self.legend.clone(), band_is_cut: false }
    }

    fn lines(&self, chart: &mut crate::page::chart::Chart<'_, '_>) -> Result<(), Error> {
        for line in [self.tooth.flank_start(), self.tooth.edge_start()] {
            chart.draw_series([PathElement::new(self.points(&line), BLACK.mix(0.45).stroke_width(2))])?;
        }
        let pieces = |field: &Field, level: f64, style: ShapeStyle| {
            let pieces = contour(field, level).into_iter();
            pieces.map(move |piece| PathElement::new(self.points(&piece), style)).collect::<Vec<_>>()
        };
        if let Some((field, levels)) = &self.contours {
            for level in levels {
                chart.draw_series(pieces(field, *level, BLACK.mix(0.6).stroke_width(2)))?;
            }
            self.numbers(chart, field, levels)?;
        }
        if let Some((field, level)) = &self.boundary {
            let style = crate::page::chart::COLOURS[PATTERN].stroke_width(6);
            chart.draw_series(pieces(field, *level, style))?;
        }
        for (colour, path) in &self.paths {
            let colour = crate::page::chart::COLOURS[*colour];
            let points = self.points(path);
            chart.draw_series([PathElement::new(points.clone(), colour.stroke_width(5))])?;
            if self.marked {
                chart.draw_series(points.iter().map(|point| Circle::new(*point, 9, colour.filled())))?;
            }
        }
        Ok(())
    }

    /// Writes the values of contour lines next to them, at different distances from the toe so that
    /// they do not cover each other.
    fn numbers(
        &self,
        chart: &mut crate::page::chart::Chart<'_, '_>,
        field: &Field,
        levels: &[f64],
    ) -> Result<(), Error> {
        let mut taken: Vec<(i32, i32)> = Vec::new();
        for level in levels {
            let mut pieces = contour(field, *level);
            // The highest points first.
            pieces.sort_by(|a, b| b[0][1].total_cmp(&a[0][1]));
            // The ends of a line are at the boundary of the field.
            let places = pieces.iter().skip(pieces.len() / 8).map(|[a, b]| {
                let middle = [0, 1].map(|k: usize| 0.5 * (a[k] + b[k]));
                (self.at(middle), chart.backend_coord(&self.at(middle)))
            });
            let free = |at: &(i32, i32)| {
                taken.iter().all(|other| (other.0 - at.0).abs() > 90 || (other.1 - at.1).abs() > 40)
            };
            let right = (TALL.0 - LEGEND) as i32 - 160;
            let inside = |at: &(i32, i32)| (LABELS[0] as i32 + 160..right).contains(&at.0);
            let found = places.into_iter().find(|(_, pixel)| free(pixel) && inside(pixel));
            let Some((place, pixel)) = found else { continue };
            taken.push(pixel);
            let style = ("sans-serif", FONT - 6).into_font().color(&BLACK);
            let style = style.pos(plotters::style::text_anchor::Pos::new(
                plotters::style::text_anchor::HPos::Center,
                plotters::style::text_anchor::VPos::Center,
            ));
            chart.draw_series([Text::new(tick(*level), place, style)])?;
        }
        Ok(())
    }

    /// Writes the names of the boundaries.
    fn names(&self, chart: &mut crate::page::chart::Chart<'_, '_>) -> Result<(), Error> {
        use plotters::style::text_anchor::{HPos, Pos, VPos};
        let tooth = self.tooth;
        let middle = |line: &[[f64; 2]]| line[line.len() / 2];
        let top = |along: f64| tooth.position([along, 1.0]);
        let outline = tooth.outline();
        let lowest = |x: f64| {
            let near = outline.iter().min_by(|a, b| {
                let off = |at: &&[f64; 2]| (at[0] - x).abs() + 1e-3 * at[1];
                off(a).total_cmp(&off(b))
            });
            near.copied().unwrap_or([x, 0.0])
        };
        let [toe, heel] = [false, true].map(|heel| middle(tooth.end(heel)));
        let ends = if tooth.conical { ["toe", "heel"] } else { ["end", "end"] };
        let tip = top(0.5);
        let root = lowest(0.5 * (toe[0] + heel[0]));
        let names = [
            (ends[0], toe, (-14, 0), Pos::new(HPos::Right, VPos::Center)),
            (ends[1], heel, (14, 0), Pos::new(HPos::Left, VPos::Center)),
            ("tip", tip, (0, -12), Pos::new(HPos::Center, VPos::Bottom)),
            ("root", root, (0, 12), Pos::new(HPos::Center, VPos::Top)),
        ];
        let title = format!("{}: {}", tooth.body, tooth.describe());
        let corner = Pos::new(HPos::Left, VPos::Top);
        let style = ("sans-serif", FONT).into_font().color(&BLACK).pos(corner);
        let (x, y) = (chart.x_range().start, chart.y_range().end);
        chart.draw_series([EmptyElement::at((x, y)) + Text::new(title, (14, 6), style)])?;
        for (name, at, shift, pos) in names {
            let style = ("sans-serif", FONT).into_font().color(&BLACK).pos(pos);
            let text = EmptyElement::at(self.at(at)) + Text::new(name.to_owned(), shift, style);
            chart.draw_series([text])?;
        }
        Ok(())
    }

    /// Draws the scale of colours.
    fn key(&self, area: &DrawingArea<SVGBackend<'_>, plotters::coord::Shift>) -> Result<(), Error> {
        let (largest, axis) = &self.scale;
        if self.patches.is_empty() {
            return Ok(());
        }
        let mut key = ChartBuilder::on(area)
            .margin(MARGIN)
            .margin_top(16)
            .margin_right(60)
            .x_label_area_size(LABELS[1])
            .y_label_area_size(124)
            .build_cartesian_2d(0.0..1.0, 0.0..*largest)?;
        let step = |k: usize| largest * k as f64 / SHADES as f64;
        key.draw_series((0..SHADES).map(|k| {
            let colour = shade((k as f64 + 0.5) / SHADES as f64);
            Rectangle::new([(0.0, step(k)), (1.0, step(k + 1))], colour.filled())
        }))?;
        key.configure_mesh()
            .disable_mesh()
            .x_labels(0)
            .x_desc(label(axis.what, axis.unit))
            .axis_desc_style(("sans-serif", FONT))
            .label_style(("sans-serif", FONT - 3))
            .y_label_formatter(&|value| tick(*value))
            .draw()?;
        Ok(())
    }
}
