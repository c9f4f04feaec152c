//! Settings overrides: fidelity, mesh, contact grids and positions from outside a model.
//!
//! They serve to measure speed and accuracy by changing one setting at a time, on unmodified
//! models.
//!
//! See `docs/theory/fidelity.md`.

use crate::estimate::Estimates;
use crate::scene::Scene;
use calyx_model::fidelity::{Fidelity, StructureOptions};
use calyx_model::position::Position;
use calyx_numerics::error::EngineError;

/// Settings that replace those of the model; `None` keeps the model's own.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Override {
    /// Fidelity level.
    pub fidelity: Option<Fidelity>,
    /// Factor on the number of elements along every direction of the mesh.
    pub refinement: Option<f64>,
    /// Order of the displacement interpolation in the section, 1 to 3.
    pub order: Option<usize>,
    /// Number of elements along the face, 1 to 64.
    pub face_elements: Option<usize>,
    /// Order of the displacement interpolation along the face, 1 to 8.
    pub displacement_order: Option<usize>,
    /// M: contact grids have 2M + 1 cells across; 1 to 400.
    pub cells: Option<usize>,
    /// N: three-dimensional contact grids have 2N + 1 slices along the face; 1 to 200.
    pub cells_along: Option<usize>,
    /// Sampling of positions: every so many unnamed positions are analysed, starting with the
    /// first; named ones always.
    pub every: Option<usize>,
    /// Selection of error estimates.
    pub error_estimates: Option<Estimates>,
}

/// Contact grid of a scene at a fidelity level: M across, and N along the face for
/// three-dimensional models.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid {
    /// M: 2M + 1 cells across.
    pub half_cells: usize,
    /// N: 2N + 1 slices along the face.
    pub half_slices: Option<usize>,
}

impl Grid {
    /// Returns the number of cells of a tooth pair; zero if M is 0, as for rigid bodies.
    pub fn cells(&self) -> usize {
        match self.half_cells {
            0 => 0,
            half => (2 * half + 1) * self.half_slices.map_or(1, |half| 2 * half + 1),
        }
    }
}

/// Ranges of the settings.
const RANGES: [(&str, [usize; 2]); 6] = [
    ("element_order", [1, 3]),
    ("face_elements", [1, 64]),
    ("displacement_order", [1, 8]),
    ("contact_cells", [1, 400]),
    ("contact_slices", [1, 200]),
    ("position_stride", [1, 10_000]),
];

/// Names of settings and their former names. The former names work until version 0.2.
pub const FORMER_NAMES: [(&str, &str); 4] = [
    ("element_order", "order"),
    ("contact_cells", "cells"),
    ("contact_slices", "cells_along"),
    ("position_stride", "every"),
];

/// Returns the name of the setting that was called `former`; any other name is returned unchanged.
pub fn current_name(former: &str) -> &str {
    FORMER_NAMES.iter().find(|(_, known)| *known == former).map_or(former, |(name, _)| name)
}

/// Range of refinements, which catches a typing error before it exhausts the memory.
const REFINEMENTS: [f64; 2] = [0.1, 10.0];

impl Override {
    /// Sets a setting by its name or former name, from the text of an option.
    ///
    /// # Errors
    /// E0795: there is no such setting, or the value is out of range.
    pub fn set(&mut self, name: &str, text: &str) -> Result<(), EngineError> {
        let name = current_name(name);
        let refuse = |help: String| {
            Err(EngineError::new("E0795", format!("`{name}` of an analysis cannot be `{text}`"), help))
        };
        match name {
            "fidelity" => match Fidelity::named(text) {
                Some(fidelity) => self.fidelity = Some(fidelity),
                None => {
                    return refuse(format!("choose one of {}", Fidelity::ALL.map(Fidelity::name).join(", ")));
                }
            },
            "error_estimates" => match Estimates::named(text) {
                Some(estimates) => self.error_estimates = Some(estimates),
                None => {
                    let known = Estimates::ALL.map(|(name, _)| name);
                    return refuse(format!("choose one of {}", known.join(", ")));
                }
            },
            "refinement" => {
                let [low, high] = REFINEMENTS;
                match text.parse::<f64>() {
                    Ok(number) if (low..=high).contains(&number) => self.refinement = Some(number),
                    _ => {
                        return refuse(format!(
                            "give a number from {low} to {high}; 1 is the mesh of the fidelity"
                        ));
                    }
                }
            }
            _ => {
                let Some((_, [low, high])) = RANGES.iter().find(|(known, _)| *known == name) else {
                    let known: Vec<&str> = ["fidelity", "refinement", "error_estimates"]
                        .into_iter()
                        .chain(RANGES.map(|(name, _)| name))
                        .collect();
                    return Err(EngineError::new(
                        "E0795",
                        format!("an analysis has no setting called `{name}`"),
                        format!("choose one of {}", known.join(", ")),
                    ));
                };
                match text.parse::<usize>() {
                    Ok(number) if (*low..=*high).contains(&number) => {
                        *self.count(name) = Some(number);
                    }
                    _ => return refuse(format!("give a whole number from {low} to {high}")),
                }
            }
        }
        Ok(())
    }

    fn count(&mut self, name: &str) -> &mut Option<usize> {
        match name {
            "element_order" => &mut self.order,
            "face_elements" => &mut self.face_elements,
            "displacement_order" => &mut self.displacement_order,
            "contact_cells" => &mut self.cells,
            "contact_slices" => &mut self.cells_along,
            _ => &mut self.every,
        }
    }

    /// Returns the names and values of the overridden settings, in a fixed order.
    pub fn overridden(&self) -> Vec<(&'static str, String)> {
        let count = |number: Option<usize>| number.map(|number| number.to_string());
        let all = [
            ("fidelity", self.fidelity.map(|fidelity| fidelity.name().to_owned())),
            ("refinement", self.refinement.map(|number| number.to_string())),
            ("element_order", count(self.order)),
            ("face_elements", count(self.face_elements)),
            ("displacement_order", count(self.displacement_order)),
            ("contact_cells", count(self.cells)),
            ("contact_slices", count(self.cells_along)),
            ("position_stride", count(self.every)),
            ("error_estimates", self.error_estimates.map(|estimates| estimates.name().to_owned())),
        ];
        all.into_iter().filter_map(|(name, value)| Some((name, value?))).collect()
    }

    /// Returns whether nothing is overridden.
    pub fn is_none(&self) -> bool {
        *self == Override::default()
    }

    /// Returns whether the analysis itself is unchanged, regardless of error estimates.
    pub fn keeps_setting(&self) -> bool {
        Override { error_estimates: None, ..*self }.is_none()
    }

    /// Applies the mesh overrides to the model's `own` options.
    pub fn structure(&self, own: StructureOptions) -> StructureOptions {
        StructureOptions {
            refinement: self.refinement.unwrap_or(own.refinement),
            order: self.order.unwrap_or(own.order),
            face_elements: self.face_elements.or(own.face_elements),
            axial_order: self.displacement_order.or(own.axial_order),
            ..own
        }
    }

    /// Applies the contact grid overrides to a scene.
    pub fn override_grids(&self, scene: &mut Scene) {
        for pair in &mut scene.pairs {
            pair.grid.half_cells = self.cells.or(pair.grid.half_cells);
            pair.grid.half_slices = self.cells_along.unwrap_or(pair.grid.half_slices);
        }
    }

    /// Selects the positions that are analysed.
    pub fn sample(&self, positions: Vec<Position>) -> Vec<Position> {
        let Some(every) = self.every else { return positions };
        let mut unnamed = 0;
        let mut kept = |position: &Position| {
            let uniform = position.name.is_empty();
            unnamed += usize::from(uniform);
            !uniform || (unnamed - 1) % every == 0
        };
        positions.into_iter().filter(|position| kept(position)).collect()
    }

    /// Adds to an error of the analysis that settings were overridden, because the author of the
    /// model did not choose them.
    pub fn list(&self, error: EngineError) -> EngineError {
        // An interruption from outside has no remedy.
        if self.is_none() || error.help.is_empty() {
            return error;
        }
        let given: Vec<String> =
            self.overridden().iter().map(|(name, value)| format!("{name} = {value}")).collect();
        let help = format!("{}; the run overrides settings of the model: {}", error.help, given.join(", "));
        EngineError { help, ..error }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_model::fidelity::Template;
    use calyx_model::ids::BodyId;
    use calyx_model::pairs::SurfacePair;
    use std::borrow::Cow;

    #[test]
    fn settings_are_set_and_listed_by_name() {
        let mut overrides = Override::default();
        assert!(overrides.is_none() && overrides.overridden().is_empty());
        let all = [
            ("fidelity", "fineroot"),
            ("refinement", "0.5"),
            ("element_order", "2"),
            ("face_elements", "4"),
            ("displacement_order", "5"),
            ("contact_cells", "6"),
            ("contact_slices", "7"),
            ("position_stride", "3"),
            ("error_estimates", "full"),
        ];
        all.iter().for_each(|(name, text)| overrides.set(name, text).unwrap());
        assert_eq!(overrides.overridden(), all.map(|(name, text)| (name, text.to_owned())));
        assert_eq!(overrides.fidelity, Some(Fidelity::Solid(Template::FineRoot)));
        let own = StructureOptions { matching_depth: 2.0, ..StructureOptions::default() };
        let overridden = overrides.structure(own);
        assert_eq!((overridden.refinement, overridden.order, overridden.matching_depth), (0.5, 2, 2.0));
        assert_eq!((overridden.face_elements, overridden.axial_order), (Some(4), Some(5)));
        assert_eq!(Override::default().structure(overridden), overridden);
        let mut scene = Scene::default();
        scene.add_pair(SurfacePair::new([BodyId(0), BodyId(1)], [0, 0]));
        overrides.override_grids(&mut scene);
        assert_eq!((scene.pairs[0].grid.half_cells, scene.pairs[0].grid.half_slices), (Some(6), 7));
        Override::default().override_grids(&mut scene);
        assert_eq!((scene.pairs[0].grid.half_cells, scene.pairs[0].grid.half_slices), (Some(6), 7));
    }

    #[test]
    fn former_names_set_the_same_settings() {
        for (name, former) in FORMER_NAMES {
            let [mut one, mut other] = [Override::default(); 2];
            one.set(name, "2").unwrap();
            other.set(former, "2").unwrap();
            assert_eq!((one, one.overridden()), (other, vec![(name, "2".to_owned())]));
            let error = other.set(former, "0").expect_err(former);
            assert!(error.message.contains(&format!("`{name}`")), "{error:?}");
        }
    }

    #[test]
    fn invalid_values_are_rejected() {
        let mut overrides = Override::default();
        for (name, text) in [
            ("fidelity", "exact"),
            ("refinement", "0"),
            ("refinement", "NaN"),
            ("element_order", "4"),
            ("contact_cells", "0"),
            ("contact_cells", "2.5"),
            ("contact_slices", "-1"),
            ("position_stride", "x"),
            ("error_estimates", "some"),
            ("torque", "1"),
        ] {
            let error = overrides.set(name, text).expect_err(name);
            assert!(
                error.code == "E0795" && error.message.contains(name) && !error.help.is_empty(),
                "{error:?}"
            );
        }
        assert!(overrides.is_none());
    }

    #[test]
    fn sampling_keeps_named_positions() {
        let position =
            |time: f64, name: &'static str| Position { name: Cow::Borrowed(name), ..Position::at(time) };
        let all = vec![
            position(0.0, ""),
            position(0.1, "SAP"),
            position(1.0, ""),
            position(2.0, ""),
            position(2.1, "HPSTC"),
            position(3.0, ""),
        ];
        let times = |every| {
            let overrides = Override { every, ..Override::default() };
            overrides.sample(all.clone()).iter().map(|position| position.time).collect::<Vec<_>>()
        };
        assert_eq!(times(None).len(), 6);
        assert_eq!(times(Some(1)).len(), 6);
        assert_eq!(times(Some(2)), [0.0, 0.1, 2.0, 2.1]);
        assert_eq!(times(Some(100)), [0.0, 0.1, 2.1]);
    }

    #[test]
    fn errors_list_the_overridden_settings() {
        let error = EngineError::new("E0623", "no model in section", "choose another");
        assert_eq!(Override::default().list(error.clone()), error);
        let overrides = Override { fidelity: Some(Fidelity::Plane), cells: Some(6), ..Override::default() };
        let help = overrides.list(error).help;
        assert_eq!(
            help,
            "choose another; the run overrides settings of the model: fidelity = plane, contact_cells = 6"
        );
        let ended = EngineError::new("E0704", "the run was cancelled", "");
        assert_eq!(overrides.list(ended.clone()), ended);
    }
}
