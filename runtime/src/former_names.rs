//! Former names of modules and types, which work until version 0.2.

/// Former name of [`observables`](crate::observables).
#[deprecated(since = "0.1.0", note = "use `observables`")]
pub mod observe {
    use calyx_analysis::observables;
    pub use calyx_analysis::observables::*;

    /// Former name of [`BearingLoad`](observables::BearingLoad).
    #[deprecated(since = "0.1.0", note = "use `BearingLoad`")]
    pub type Borne = observables::BearingLoad;
    /// Former name of [`SplineToothLoad`](observables::SplineToothLoad).
    #[deprecated(since = "0.1.0", note = "use `SplineToothLoad`")]
    pub type LugLoad = observables::SplineToothLoad;
    /// Former name of [`MaximumLocation`](observables::MaximumLocation).
    #[deprecated(since = "0.1.0", note = "use `MaximumLocation`")]
    pub type PlaceOf = observables::MaximumLocation;
    /// Former name of [`ModeClassification`](observables::ModeClassification).
    #[deprecated(since = "0.1.0", note = "use `ModeClassification`")]
    pub type KindOfMode = observables::ModeClassification;
    /// Former name of [`ModeEnergyShares`](observables::ModeEnergyShares).
    #[deprecated(since = "0.1.0", note = "use `ModeEnergyShares`")]
    pub type KindShares = observables::ModeEnergyShares;
}

/// Former name of [`settings_override`](crate::settings_override).
#[deprecated(since = "0.1.0", note = "use `settings_override`")]
pub mod overriding {
    pub use calyx_analysis::settings_override::*;
}

/// Former name of [`dof`](crate::dof).
#[deprecated(since = "0.1.0", note = "use `dof`")]
pub mod freedom {
    use calyx_model::dof;
    pub use calyx_model::dof::*;

    /// Former name of [`Dof`](dof::Dof).
    #[deprecated(since = "0.1.0", note = "use `Dof`")]
    pub type Freedom = dof::Dof;
    /// Former name of [`DOF_NAMES`](dof::DOF_NAMES).
    #[deprecated(since = "0.1.0", note = "use `DOF_NAMES`")]
    pub const FREEDOMS: [&str; 6] = dof::DOF_NAMES;
}

/// Former name of [`spline_contact`](crate::spline_contact).
#[deprecated(since = "0.1.0", note = "use `spline_contact`")]
pub mod lug_contact {
    use calyx_model::spline_contact;
    pub use calyx_model::spline_contact::*;

    /// Former name of [`SplineContact`](spline_contact::SplineContact).
    #[deprecated(since = "0.1.0", note = "use `SplineContact`")]
    pub type LugContact = spline_contact::SplineContact;
}

/// Former name of [`restraint_check`](crate::restraint_check).
#[deprecated(since = "0.1.0", note = "use `restraint_check`")]
pub mod holding {
    pub use calyx_solve::restraint_check::*;
}
