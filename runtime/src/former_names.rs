//! Former names of modules and types, which work until version 0.2.

/// Former name of [`observables`](crate::observables).
#[deprecated(since = "0.1.0", note = "use `observables`")]
pub mod observe {
    pub use calyx_analysis::observables::*;

    /// Former name of [`BearingLoad`].
    #[deprecated(since = "0.1.0", note = "use `BearingLoad`")]
    pub type Borne = BearingLoad;
    /// Former name of [`SplineToothLoad`].
    #[deprecated(since = "0.1.0", note = "use `SplineToothLoad`")]
    pub type LugLoad = SplineToothLoad;
    /// Former name of [`MaximumLocation`].
    #[deprecated(since = "0.1.0", note = "use `MaximumLocation`")]
    pub type PlaceOf = MaximumLocation;
    /// Former name of [`ModeClassification`].
    #[deprecated(since = "0.1.0", note = "use `ModeClassification`")]
    pub type KindOfMode = ModeClassification;
    /// Former name of [`ModeEnergyShares`].
    #[deprecated(since = "0.1.0", note = "use `ModeEnergyShares`")]
    pub type KindShares = ModeEnergyShares;
}

/// Former name of [`settings_override`](crate::settings_override).
#[deprecated(since = "0.1.0", note = "use `settings_override`")]
pub mod overriding {
    pub use calyx_analysis::settings_override::*;
}

/// Former name of [`dof`](crate::dof).
#[deprecated(since = "0.1.0", note = "use `dof`")]
pub mod freedom {
    pub use calyx_model::dof::*;

    /// Former name of [`Dof`].
    #[deprecated(since = "0.1.0", note = "use `Dof`")]
    pub type Freedom = Dof;
    /// Former name of [`DOF_NAMES`].
    #[deprecated(since = "0.1.0", note = "use `DOF_NAMES`")]
    pub const FREEDOMS: [&str; 6] = DOF_NAMES;
}

/// Former name of [`spline_contact`](crate::spline_contact).
#[deprecated(since = "0.1.0", note = "use `spline_contact`")]
pub mod lug_contact {
    pub use calyx_model::spline_contact::*;

    /// Former name of [`SplineContact`].
    #[deprecated(since = "0.1.0", note = "use `SplineContact`")]
    pub type LugContact = SplineContact;
}

/// Former name of [`restraint_check`](crate::restraint_check).
#[deprecated(since = "0.1.0", note = "use `restraint_check`")]
pub mod holding {
    pub use calyx_solve::restraint_check::*;
}
