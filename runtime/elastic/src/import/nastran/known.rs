//! Names of the cards that are read, and of those that do not change the body.

/// Cards that the reader converts.
pub(super) const READ: &[&str] = &[
    "CBAR", "CBEAM", "CELAS1", "CELAS2", "CHEXA", "CONM2", "CONROD", "CORD1C", "CORD1R", "CORD1S", "CORD2C",
    "CORD2R", "CORD2S", "CPENTA", "CQUAD4", "CQUAD8", "CROD", "CTETRA", "CTRIA3", "CTRIA6", "FORCE",
    "GRDSET", "GRID", "LOAD", "MAT1", "MOMENT", "MPC", "MPCADD", "PARAM", "PBAR", "PBARL", "PBEAM", "PBEAML",
    "PELAS", "PROD", "PSHELL", "PSOLID", "RBE2", "RBE3", "SET1", "SPC", "SPC1", "SPCADD",
];

/// Cards of analyses, of output and of optimization: they do not change the body.
pub(super) const HARMLESS: &[&str] = &[
    "ASET", "ASET1", "BNDFIX", "BNDFIX1", "BNDFREE", "BNDFREE1", "BSET", "BSET1", "CSET", "CSET1", "DAREA",
    "DCONADD", "DCONSTR", "DEQATN", "DESVAR", "DLOAD", "DMIG", "DOPTPRM", "DRESP1", "DRESP2", "DTI",
    "DVPREL1", "EIGB", "EIGC", "EIGR", "EIGRL", "FREQ", "FREQ1", "FREQ2", "FREQ3", "FREQ4", "FREQ5",
    "MDLPRM", "NLPARM", "NLPCI", "OMIT", "OMIT1", "PLOTEL", "PLOTEL3", "PLOTEL4", "QSET", "QSET1", "RLOAD1",
    "RLOAD2", "SET3", "SPOINT", "SUPORT", "SUPORT1", "TABDMP1", "TABLED1", "TABLED2", "TABLED3", "TLOAD1",
    "TLOAD2", "TSTEP", "TSTEPNL", "USET", "USET1",
];

/// Loads that the reader does not convert: rejected if case control selects their set. Field 1 is
/// the identification number of the set.
pub(super) const LOADS: &[&str] = &[
    "ACCEL", "ACCEL1", "DEFORM", "FORCE1", "FORCE2", "GRAV", "MOMENT1", "MOMENT2", "PLOAD", "PLOAD1",
    "PLOAD2", "PLOAD4", "RFORCE", "SLOAD", "SPCD", "TEMP", "TEMPD", "TEMPP1", "TEMPRB",
];

/// Parameters that scale the body.
pub(super) const SCALING_PARAMETERS: &[&str] =
    &["CB1", "CB2", "CK1", "CK2", "CK3", "CM1", "CM2", "CP1", "CP2"];

/// Nearest supported card for an unsupported one, as a remedy.
pub(super) fn remedy(name: &str) -> &'static str {
    match name {
        "PCOMP" | "PCOMPG" | "MAT2" | "MAT8" | "MAT9" => "describe the part by PSHELL or PSOLID with MAT1",
        "RBAR" | "RBE1" | "RROD" => "write the rigid element as RBE2",
        "CBUSH" | "CBUSH1D" | "CGAP" | "CELAS3" | "CELAS4" => {
            "write the spring as CELAS1 or CELAS2 between grids"
        }
        "CONM1" => "write the mass as CONM2",
        "CQUADR" => "write the element as CQUAD4",
        "CTRIAR" => "write the element as CTRIA3",
        "CTUBE" => "write the element as CROD",
        "CPYRAM" | "CPYRA" => "mesh the part with CHEXA, CPENTA and CTETRA",
        "BAROR" | "BEAMOR" => "write the defaults on each CBAR or CBEAM",
        _ => "remove the card if the body does not need it, or export the model without it",
    }
}
