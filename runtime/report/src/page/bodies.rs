//! Section "Deformed bodies": pictures of the meshed bodies with stress and exaggerated
//! displacements.

use super::number;
use super::read::Run;
use super::units::{Unit, Units};
use crate::body_pictures::{BodyPicture, colour_scale};
use maud::{Markup, PreEscaped, html};

/// Returns the section; empty without pictures.
pub fn section(run: &Run, units: Units) -> Markup {
    if run.bodies.is_empty() {
        return PreEscaped(String::new());
    }
    html! {
        p.note {
            "Meshed bodies at the position with their largest stress: undeformed edges in blue, displacements exaggerated. "
            "Displacements of gears are relative to their frames. Stresses of shafts are nominal. "
            code { "calyx run --vtu" } " draws gears, housings and carriers as well, and writes files of all positions for ParaView."
        }
        @for (picture, content) in &run.bodies { (body(picture, content, units)) }
    }
}

fn body(picture: &BodyPicture, content: &str, units: Units) -> Markup {
    let [width, height] = picture.size;
    let shown = |unit: Unit, value: f64| format!("{} {}", number(unit.of(value)), unit.name);
    let displacement = shown(units.film, picture.largest_displacement);
    let caption = format!(
        "{}: displacements × {}, largest {displacement}; position {} at {} s",
        picture.body,
        number(picture.exaggeration),
        picture.position + 1,
        number(picture.time)
    );
    html! {
        figure {
            img.body src={ "data:image/png;base64," (content) } width=(width) height=(height) alt=(caption);
            @if picture.largest_stress > 0.0 {
                p.legend {
                    "von Mises stress: 0 "
                    i.scale style={ "background:linear-gradient(90deg," (colour_scale().join(",")) ")" } {}
                    " " (shown(units.stress, picture.largest_stress))
                }
            }
            figcaption { (caption) }
        }
    }
}
