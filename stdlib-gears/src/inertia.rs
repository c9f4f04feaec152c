//! Mass and moments of inertia of gears: the section times the face width, plus web and hub as
//! bodies of revolution.
//!
//! The section is the meshed one, with teeth and rim. A plane model contains nothing else, but web
//! and hub have mass too; they are a rigid part of the body.

use crate::prototype::GearPrototype;
use calyx_runtime::fe::Section;
use calyx_runtime::inertia::Inertia;
use calyx_runtime::material::Material;
use calyx_runtime::scene::StructureOptions;
use std::f64::consts::PI;

impl GearPrototype {
    /// Inertia of the whole gear; `None` if it cannot be meshed, which the construction of its
    /// structure reports.
    pub(crate) fn whole_inertia(&self) -> Option<Inertia> {
        let mesh = self.plane_mesh(&StructureOptions::default()).ok()?;
        let sectors = f64::from(self.gear.teeth());
        let [area, polar] = mesh.area_and_polar_moment().map(|moment| sectors * moment);
        let (density, width) = (self.material.density, self.face_width);
        let mass = density * area * width;
        let polar = density * polar * width;
        let toothed = Inertia::axial(mass, polar, 0.5 * polar + mass * width * width / 12.0);
        let toothed = if self.solid { toothed + self.core_inertia() } else { toothed };
        let carried = self.carrying().map(|(section, material)| material.density * section.inertia());
        Some(toothed + carried.unwrap_or_default())
    }

    /// Inertia of the cylinder inside the supported surface of the rim.
    fn core_inertia(&self) -> Inertia {
        let (radius, width) = (self.rim.fixed_radius, self.face_width);
        let mass = self.material.density * PI * radius * radius * width;
        let polar = 0.5 * mass * radius * radius;
        Inertia::axial(mass, polar, 0.5 * polar + mass * width * width / 12.0)
    }

    /// Section and material of the body between rim and bore.
    fn carrying(&self) -> Option<(Section, Material)> {
        let web = self.rim.web.as_ref()?;
        Some((web.section().clone(), web.material().unwrap_or(self.material)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blank::{GearBlank, Rim};
    use crate::fillet::Side;
    use crate::rack::Rack;
    use crate::web::{DiscWeb, Hub};
    use calyx_runtime::fe::Station;
    use calyx_runtime::profile::Profile;
    use calyx_runtime::scene::Prototype;
    use std::sync::Arc;

    const MODULE: f64 = 4e-3;
    const TEETH: u32 = 24;
    const DENSITY: f64 = 7850.0;

    fn blank() -> GearBlank {
        let rack = Rack::new(MODULE, 20_f64.to_radians(), 0.3 * MODULE).expect("a rack");
        GearBlank::standard(TEETH, rack).face_width(5.0 * MODULE)
    }

    /// Annulus: mass, polar moment, and transverse moment about its own middle.
    fn ring([inner, outer]: [f64; 2], width: f64) -> [f64; 3] {
        let mass = DENSITY * PI * (outer * outer - inner * inner) * width;
        let squares = inner * inner + outer * outer;
        [mass, 0.5 * mass * squares, mass * (3.0 * squares + width * width) / 12.0]
    }

    fn is_near(value: f64, expected: f64) -> bool {
        (value / expected - 1.0).abs() < 1e-12
    }

    #[test]
    fn an_annulus_has_its_closed_form_inertia() {
        let station = |radius: f64| Station { radius, ends: [0.01, 0.04] };
        let section = Section::new(vec![station(0.05), station(0.12)]).expect("a section");
        let found = DENSITY * section.inertia();
        let [mass, polar, transverse] = ring([0.05, 0.12], 0.03);
        assert!(is_near(found.mass, mass) && is_near(found.polar(), polar));
        assert!(is_near(found.moment[2], 0.025 * mass));
        assert!(is_near(found.about[0][0], transverse + mass * 0.025 * 0.025));
    }

    #[test]
    fn a_double_cone_has_its_closed_form_inertia() {
        // A disc that tapers from a small bore to zero thickness is nearly a double cone of height
        // h on either side, with mass 2/3 pi rho R² h and polar moment 3/10 m R².
        let (radius, height) = (0.1, 0.02);
        let station = |radius: f64, height: f64| Station { radius, ends: [-height, height] };
        let section = Section::new(vec![station(1e-9, height), station(radius, 1e-12)]).expect("a section");
        let found = DENSITY * section.inertia();
        let mass = 2.0 / 3.0 * PI * DENSITY * radius * radius * height;
        assert!((found.mass / mass - 1.0).abs() < 1e-6);
        assert!((found.polar() / (0.3 * mass * radius * radius) - 1.0).abs() < 1e-6);
        // Transverse moment: 3/20 m R² + m h²/10.
        let transverse = mass * (0.15 * radius * radius + 0.1 * height * height);
        assert!((found.about[0][0] / transverse - 1.0).abs() < 1e-6);
    }

    /// Area and polar moment of the outline of a gear minus its bore, from a polygon on the true
    /// curves.
    fn outline(blank: &GearBlank) -> [f64; 2] {
        let gear = blank.clone().cut().expect("a gear");
        let fillet = gear.gear.root_fillet(Side::CounterClockwise);
        let flank = &gear.flanks()[Side::CounterClockwise.surface() as usize];
        let mut half: Vec<[f64; 2]> = Vec::new();
        let points = 4000;
        let curves: [&dyn Profile; 2] = [&fillet, flank.as_ref()];
        for curve in curves {
            half.extend(
                (0..=points).map(|k| curve.at(curve.length() * f64::from(k) / f64::from(points)).position),
            );
        }
        // Ordered by polar angle from the middle of the space to that of the tooth; circles
        // continue the outline on both sides.
        half.sort_by(|a, b| a[1].atan2(a[0]).abs().total_cmp(&b[1].atan2(b[0]).abs()));
        let angle = |p: &[f64; 2]| p[1].atan2(p[0]).abs();
        let radius = |p: &[f64; 2]| p[0].hypot(p[1]);
        let (tip, root) = (half[0], half[half.len() - 1]);
        let pitch = PI / f64::from(TEETH);
        let mut sums = [0.0; 2];
        let mut add = |from: f64, to: f64, r: [f64; 2]| {
            // Integrals over a narrow sector of varying radius.
            let [square, fourth] = [2, 4].map(|power| 0.5 * (r[0].powi(power) + r[1].powi(power)));
            sums[0] += 0.5 * square * (to - from);
            sums[1] += 0.25 * fourth * (to - from);
        };
        add(0.0, angle(&tip), [radius(&tip); 2]);
        for pair in half.windows(2) {
            add(angle(&pair[0]), angle(&pair[1]), [radius(&pair[0]), radius(&pair[1])]);
        }
        add(angle(&root), pitch, [radius(&root); 2]);
        let bore = gear.rim.fixed_radius;
        let both = 2.0 * f64::from(TEETH);
        [both * sums[0] - PI * bore.powi(2), both * sums[1] - 0.5 * PI * bore.powi(4)]
    }

    #[test]
    fn teeth_weigh_what_their_outline_holds() {
        let blank = blank();
        let [area, polar] = outline(&blank);
        let found = blank.clone().cut().expect("a gear").inertia();
        let width = blank.face_width;
        let mass = blank.material.density * area * width;
        assert!((found.mass / mass - 1.0).abs() < 2e-5, "{} {mass}", found.mass);
        let polar = blank.material.density * polar * width;
        assert!((found.polar() / polar - 1.0).abs() < 2e-5, "{} {polar}", found.polar());
        let transverse = 0.5 * polar + mass * width * width / 12.0;
        assert!((found.about[0][0] / transverse - 1.0).abs() < 2e-5);
        assert!(found.moment[2] == 0.0);
    }

    #[test]
    fn a_solid_gear_includes_the_material_inside_its_support() {
        let plain = blank();
        let [without, solid] =
            [false, true].map(|solid| GearBlank { solid, ..plain.clone() }.cut().expect("a gear").inertia());
        let [mass, polar, transverse] = ring([0.0, plain.rim.fixed_radius], plain.face_width);
        assert!(is_near(solid.mass - without.mass, mass));
        assert!(is_near(solid.polar() - without.polar(), polar));
        assert!(is_near(solid.about[0][0] - without.about[0][0], transverse));
    }

    #[test]
    fn webs_and_hubs_have_mass() {
        let plain = blank();
        let (diameter, width) = (plain.root_diameter, plain.face_width);
        let rim = Rim::new(diameter - MODULE, diameter - 6.0 * MODULE).expect("a rim");
        let weigh = |rim: Rim| {
            let gear: Arc<GearPrototype> = plain.clone().rim(rim).cut().expect("a gear");
            gear.inertia()
        };
        let without = weigh(rim.clone());
        let (bore, offset) = (10e-3, 1e-3);
        let rim_radius = rim.fixed_radius;
        let radii = [0.5 * bore, rim_radius];
        let [mass, polar, transverse] = ring(radii, 0.25 * width);
        let webbed = weigh(rim.clone().on_web(0.25 * width, offset, bore).expect("a web"));
        assert!(is_near(webbed.mass - without.mass, mass));
        assert!(is_near(webbed.polar() - without.polar(), polar));
        assert!(is_near(webbed.moment[2], offset * mass));
        assert!(is_near(webbed.about[0][0] - without.about[0][0], transverse + mass * offset * offset));
        // A hub of the full face width, and a web of another density.
        let light = Material { density: 0.5 * DENSITY, ..Material::STEEL };
        let hub = Hub { radius: 8e-3, width, offset: 0.0 };
        let disc = DiscWeb { hub: Some(hub), material: Some(light), ..DiscWeb::plain(0.25 * width, 0.0) };
        let on_hub = weigh(rim.on_disc(0.25 * width, 0.0, bore, disc).expect("a disc web"));
        let (of_hub, of_web) =
            (ring([0.5 * bore, hub.radius], width), ring([hub.radius, rim_radius], 0.25 * width));
        assert!(is_near(on_hub.mass - without.mass, 0.5 * (of_hub[0] + of_web[0])));
        assert!(is_near(on_hub.polar() - without.polar(), 0.5 * (of_hub[1] + of_web[1])));
        assert!(is_near(on_hub.about[0][0] - without.about[0][0], 0.5 * (of_hub[2] + of_web[2])));
    }
}
