//! Settings that are measured: every fidelity level, with the settings of the level varied one at a
//! time, and all coarse together.

use calyx_runtime::estimate::Estimates;
use calyx_runtime::scene::Fidelity;
use calyx_runtime::settings_override::{Grid, Override, current_name};

/// A setting of an analysis.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// Name: the fidelity level and the changed settings, like `medium`, `medium contact_cells=5`.
    pub name: String,
    /// Overrides that define it, including the fidelity level.
    pub overrides: Override,
}

/// Refinement factors of the measured solid meshes, other than 1: number of elements along every
/// direction relative to the level's mesh.
const REFINEMENTS: [f64; 2] = [0.5, 0.7];
/// Refinement factors of plane meshes, which are cheap.
const REFINEMENTS_IN_SECTION: [f64; 3] = [0.5, 0.7, 1.4];
/// Refinement factor of the reference of solid levels, finer than any above.
const REFERENCE_IN_SPACE: f64 = 1.4;
/// Refinement factor of the reference of plane levels, finer than any above.
const REFERENCE_IN_SECTION: f64 = 2.0;
/// Intervals of the analysed positions.
const EVERY: [usize; 2] = [2, 4];

impl Setting {
    pub fn new(overrides: Override) -> Setting {
        // Errors are measured here, so their estimates are disabled.
        let overrides = Override { error_estimates: Some(Estimates::None), ..overrides };
        let names = overrides.overridden().into_iter().filter(|(name, _)| *name != "error_estimates");
        let name = names.map(|(name, value)| match name {
            "fidelity" => value,
            _ => format!("{name}={value}"),
        });
        Setting { name: name.collect::<Vec<_>>().join(" "), overrides }
    }

    /// Returns the name of the fidelity level.
    pub fn level(&self) -> &'static str {
        self.overrides.fidelity.map_or("", Fidelity::name)
    }

    /// Returns the name of the run directory.
    pub fn folder(&self) -> String {
        self.name.replace(' ', ",")
    }

    /// Returns the settings that its structures depend on: settings for which these are equal share
    /// them.
    pub fn mesh(&self) -> Override {
        Override { cells: None, cells_along: None, every: None, ..self.overrides }
    }

    /// Returns true if its mesh is finer than that of the other setting: a comparison then includes
    /// the discretization error of the other. A level without a mesh has no finer mesh.
    pub fn is_finer_than(&self, other: &Setting) -> bool {
        let rank = |setting: &Setting| {
            let level = setting.overrides.fidelity?;
            Fidelity::ALL.iter().position(|known| *known == level)
        };
        match (rank(self), rank(other)) {
            (Some(own), Some(others)) if own == others => {
                let refinement = |setting: &Setting| setting.overrides.refinement.unwrap_or(1.0);
                refinement(self) > refinement(other)
            }
            (own, others) => own > others,
        }
    }

    /// Returns the overridden settings other than the fidelity level.
    pub fn overridden(&self) -> Vec<(&'static str, String)> {
        let below = |name: &str| !["fidelity", "error_estimates"].contains(&name);
        self.overrides.overridden().into_iter().filter(|(name, _)| below(name)).collect()
    }
}

/// Returns the name of a setting in which settings of the analysis may have former names.
pub fn current_setting_name(name: &str) -> String {
    let part = |part: &str| match part.split_once('=') {
        Some((name, value)) => format!("{}={value}", current_name(name)),
        None => part.to_owned(),
    };
    name.split(' ').map(part).collect::<Vec<_>>().join(" ")
}

/// Returns the settings of a fidelity level, its default first. Settings that share structures are
/// adjacent. The setting with the doubled contact grid is last, because the reference has the same
/// grid.
pub fn settings(level: Fidelity, grid: Grid, sampled: bool) -> Vec<Setting> {
    let own = Override { fidelity: Some(level), ..Override::default() };
    let half = |count: usize| (count / 2).max(1);
    let coarse_grid =
        Override { cells: Some(half(grid.half_cells)), cells_along: grid.half_slices.map(half), ..own };
    let mut all = vec![own];
    // A level without meshes or contact grids, such as the rigid one, has no other settings.
    if grid.half_cells > 0 {
        all.push(Override { cells: coarse_grid.cells, ..own });
        all.push(Override { cells: Some(2 * grid.half_cells), ..own });
        if let Some(slices) = grid.half_slices {
            all.push(Override { cells_along: coarse_grid.cells_along, ..own });
            all.push(Override { cells_along: Some(2 * slices), ..own });
            all.push(coarse_grid);
        }
    }
    if sampled {
        all.extend(EVERY.map(|every| Override { every: Some(every), ..own }));
    }
    // Levels without a mesh have no refinements.
    let refinements: &[f64] = if let Fidelity::Solid(_) = level {
        &REFINEMENTS
    } else if level == Fidelity::Plane {
        &REFINEMENTS_IN_SECTION
    } else {
        &[]
    };
    for &refinement in refinements {
        all.push(Override { refinement: Some(refinement), ..own });
        if refinement < 0.6 {
            all.push(Override { refinement: Some(refinement), ..coarse_grid });
        }
    }
    let mut settings: Vec<Setting> = Vec::new();
    for setting in all.into_iter().map(Setting::new) {
        if !settings.contains(&setting) {
            settings.push(setting);
        }
    }
    settings
}

/// Returns the references of a level, the better one first: one with a finer mesh than all
/// settings, and one with the level's own mesh (in plane models the finest of them). Both have
/// contact grids twice as fine. A level without meshes has one reference.
pub fn references(level: Fidelity, grid: Grid) -> Vec<Setting> {
    let [.., finest] = REFINEMENTS_IN_SECTION;
    let refinements = match level {
        Fidelity::Rigid | Fidelity::Analytic => vec![None],
        Fidelity::Plane => vec![Some(REFERENCE_IN_SECTION), Some(finest)],
        Fidelity::Solid(_) => vec![Some(REFERENCE_IN_SPACE), None],
    };
    let of = |refinement: Option<f64>| {
        Setting::new(Override {
            fidelity: Some(level),
            refinement,
            cells: (grid.half_cells > 0).then_some(2 * grid.half_cells),
            cells_along: grid.half_slices.map(|slices| 2 * slices),
            ..Override::default()
        })
    };
    refinements.into_iter().map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_runtime::scene::Template;

    const GRID: Grid = Grid { half_cells: 10, half_slices: Some(8) };

    #[test]
    fn settings_are_told_apart_by_name_and_share_meshes_side_by_side() {
        for level in Fidelity::ALL {
            let all = settings(level, GRID, true);
            assert_eq!(all[0].name, level.name());
            for (index, setting) in all.iter().enumerate() {
                assert_eq!(setting.level(), level.name());
                assert!(
                    all[..index].iter().all(|other| other.folder() != setting.folder()),
                    "{}",
                    setting.name
                );
                // Settings of one mesh are contiguous.
                let first = all.iter().position(|other| other.mesh() == setting.mesh()).unwrap();
                assert!(all[first..=index].iter().all(|other| other.mesh() == setting.mesh()));
            }
        }
        let named =
            |name: &str| settings(Fidelity::Plane, GRID, true).iter().any(|setting| setting.name == name);
        assert!(
            named("plane refinement=0.5 contact_cells=5 contact_slices=4")
                && named("plane position_stride=2")
        );
        assert!(
            !settings(Fidelity::Plane, GRID, false).iter().any(|setting| setting.overrides.every.is_some())
        );
    }

    #[test]
    fn the_reference_has_a_finer_mesh_than_any_setting() {
        for level in Fidelity::ALL {
            let all = settings(level, GRID, true);
            let references = references(level, GRID);
            let meshless = references.len() == 1;
            assert_eq!(meshless, matches!(level, Fidelity::Rigid | Fidelity::Analytic));
            for setting in &all {
                assert_eq!(references[0].is_finer_than(setting), !meshless, "{}", setting.name);
            }
        }
        let level = Fidelity::Solid(Template::Finest);
        let names: Vec<String> = references(level, GRID).into_iter().map(|setting| setting.name).collect();
        assert_eq!(
            names,
            [
                "finest refinement=1.4 contact_cells=20 contact_slices=16",
                "finest contact_cells=20 contact_slices=16"
            ]
        );
        assert_eq!(current_setting_name("finest cells=20 cells_along=16"), names[1]);
        assert_eq!(current_setting_name(&names[0]), names[0]);
        let own = &settings(level, GRID, true)[0];
        let [finer, same] = &references(level, GRID)[..] else { panic!("two references") };
        assert!(finer.is_finer_than(own) && !same.is_finer_than(own) && same.mesh() == own.mesh());
        // Levels are compared by their order of cost.
        let plane = &references(Fidelity::Plane, GRID)[0];
        assert!(same.is_finer_than(plane) && !plane.is_finer_than(own));
    }
}
