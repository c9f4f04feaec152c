//! Writer of OP2 and punch files for tests of several crates.

/// Real and imaginary part.
pub type Complex = [f64; 2];

/// Quantity of vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    Displacement,
    Velocity,
    Acceleration,
}

/// Words of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    pub is_big_endian: bool,
    /// Eight bytes in place of four.
    pub is_wide: bool,
    /// Date and name of the program at the beginning.
    pub has_label: bool,
}

impl Layout {
    pub const LITTLE: Self = Self { is_big_endian: false, is_wide: false, has_label: true };
    /// Byte orders, sizes of words, and files without a label.
    pub const ALL: [Self; 5] = [
        Self::LITTLE,
        Self { is_big_endian: true, ..Self::LITTLE },
        Self { is_wide: true, ..Self::LITTLE },
        Self { is_big_endian: true, is_wide: true, has_label: true },
        Self { has_label: false, ..Self::LITTLE },
    ];
}

#[derive(Clone, Copy, Debug)]
pub enum Word {
    I(i64),
    R(f64),
}
use Word::{I, R};

/// OP2 file under construction.
pub struct Op2 {
    pub bytes: Vec<u8>,
    layout: Layout,
}

impl Op2 {
    pub fn new(layout: Layout) -> Self {
        let mut file = Self { bytes: Vec::new(), layout };
        if layout.has_label {
            file.data(&[I(11), I(28), I(26)]);
            file.data(&[I(0); 7]);
            file.data(&[I(0); 2]);
            file.key(-1);
            file.key(0);
        }
        file
    }

    fn marker(&mut self, size: usize) {
        let size = size as i32;
        self.bytes.extend(if self.layout.is_big_endian { size.to_be_bytes() } else { size.to_le_bytes() });
    }

    pub fn record(&mut self, bytes: &[u8]) {
        self.marker(bytes.len());
        self.bytes.extend(bytes);
        self.marker(bytes.len());
    }

    fn word(&self, word: Word) -> Vec<u8> {
        let mut bytes = match (word, self.layout.is_wide) {
            (I(value), false) => (value as i32).to_le_bytes().to_vec(),
            (I(value), true) => value.to_le_bytes().to_vec(),
            (R(value), false) => (value as f32).to_le_bytes().to_vec(),
            (R(value), true) => value.to_le_bytes().to_vec(),
        };
        if self.layout.is_big_endian {
            bytes.reverse();
        }
        bytes
    }

    pub fn key(&mut self, key: i64) {
        let bytes = self.word(I(key));
        self.record(&bytes);
    }

    pub fn data(&mut self, words: &[Word]) {
        self.key(words.len() as i64);
        let bytes: Vec<u8> = words.iter().flat_map(|word| self.word(*word)).collect();
        self.record(&bytes);
    }

    /// Writes a name of up to eight characters, four for each word.
    fn name(&mut self, name: &str) {
        let name = format!("{name:8}");
        let half = if self.layout.is_wide { "    " } else { "" };
        self.key(2);
        self.record(format!("{}{half}{}{half}", &name[..4], &name[4..]).as_bytes());
    }

    /// Writes a data block with logical records of a type, each in pieces of up to 1000 words.
    pub fn block(&mut self, name: &str, kind: i64, records: &[Vec<Word>]) {
        self.name(name);
        self.key(-1);
        self.data(&[I(101), I(0), I(0), I(0), I(0), I(0), I(0)]);
        self.key(-2);
        self.data(&[I(0)]);
        self.name(name);
        let mut number = -3;
        for record in records {
            self.key(number);
            self.data(&[I(kind)]);
            record.chunks(1000).for_each(|piece| self.data(piece));
            number -= 1;
        }
        self.key(number);
        self.data(&[I(0)]);
        self.key(0);
    }
}

/// Form of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    Real,
    Cartesian,
    Polar,
}

impl Form {
    /// Parts of a number: one if it is real.
    fn parts(self, value: Complex) -> [f64; 2] {
        match self {
            Self::Real => [value[0], 0.0],
            Self::Cartesian => value,
            Self::Polar => {
                let phase = value[1].atan2(value[0]).to_degrees();
                [value[0].hypot(value[1]), phase.rem_euclid(360.0)]
            }
        }
    }
}

/// Vectors at one frequency.
#[derive(Clone, Debug)]
pub struct Written {
    pub subcase: i64,
    /// Number and eigenvalue of a mode; `None` for responses.
    pub mode: Option<(i64, f64)>,
    pub frequency: f64,
    pub quantity: Quantity,
    pub form: Form,
    pub values: Vec<(i64, [Complex; 3])>,
}

/// Words of an entry: the first one, the type, the translations, and rotations, which readers
/// ignore.
fn entry(first: Word, kind: i64, value: &[Complex; 3], form: Form) -> Vec<Word> {
    let mut words = vec![first, I(kind)];
    for part in 0..if form == Form::Real { 1 } else { 2 } {
        words.extend(value.map(|component| R(form.parts(component)[part])));
        words.extend([R(1e9), R(-1e9), R(7.0)]);
    }
    words
}

/// Identification of vectors; those that are sorted by point have their point.
pub fn identification(vectors: &Written, point: Option<i64>) -> Vec<Word> {
    let code = match (vectors.quantity, vectors.mode) {
        (Quantity::Displacement, Some(_)) => 7,
        (Quantity::Displacement, None) => 1,
        (Quantity::Velocity, _) => 10,
        (Quantity::Acceleration, _) => 11,
    };
    let sort = i64::from(vectors.form != Form::Real) + if point.is_some() { 2 } else { 0 };
    let mut words = vec![I(0); 146];
    // The device code 2 is that of plot files.
    words[0] = I(if vectors.mode.is_some() { 22 } else { 52 });
    words[1] = I(1000 * sort + code);
    words[3] = I(vectors.subcase);
    match (point, vectors.mode) {
        (Some(point), _) => words[4] = I(10 * point + 2),
        (None, Some((number, eigenvalue))) => (words[4], words[5]) = (I(number), R(eigenvalue)),
        (None, None) => words[4] = R(vectors.frequency),
    }
    words[8] = I(match vectors.form {
        Form::Real => 1,
        Form::Cartesian => 2,
        Form::Polar => 3,
    });
    words[9] = I(if vectors.form == Form::Real { 8 } else { 14 });
    words
}

/// Logical records of vectors that are sorted by frequency. A scalar point follows the others.
pub fn by_frequency(all: &[Written]) -> Vec<Vec<Word>> {
    let records = all.iter().flat_map(|vectors| {
        let mut words: Vec<Word> = vectors
            .values
            .iter()
            .flat_map(|(label, value)| entry(I(10 * label + 2), 1, value, vectors.form))
            .collect();
        words.extend(entry(I(9_999_992), 2, &[[5.0, 0.0]; 3], vectors.form));
        [identification(vectors, None), words]
    });
    records.collect()
}

/// Logical records of the same vectors, sorted by point.
pub fn by_point(all: &[Written]) -> Vec<Vec<Word>> {
    let Some(first) = all.first() else { return Vec::new() };
    let records = first.values.iter().enumerate().flat_map(|(at, (label, _))| {
        let entries = all
            .iter()
            .flat_map(|vectors| entry(R(vectors.frequency), 1, &vectors.values[at].1, vectors.form))
            .collect();
        [identification(first, Some(*label)), entries]
    });
    records.collect()
}

/// Writes vectors to a punch file, sorted by frequency or by point.
pub fn punch(all: &[Written], is_by_point: bool) -> String {
    let mut lines: Vec<String> = Vec::new();
    let header = |lines: &mut Vec<String>, vectors: &Written| {
        let name = match (vectors.quantity, vectors.mode) {
            (Quantity::Displacement, Some(_)) => "$EIGENVECTOR",
            (Quantity::Displacement, None) => "$DISPLACEMENTS",
            (Quantity::Velocity, _) => "$VELOCITY",
            (Quantity::Acceleration, _) => "$ACCELERATION",
        };
        let form = match vectors.form {
            Form::Real => "$REAL OUTPUT",
            Form::Cartesian => "$REAL-IMAGINARY OUTPUT",
            Form::Polar => "$MAGNITUDE-PHASE OUTPUT",
        };
        lines.extend(["$TITLE   = HOUSING", "$SUBTITLE=", "$LABEL   =", name, form].map(String::from));
        lines.push(format!("$SUBCASE ID ={:>12}", vectors.subcase));
    };
    let point = |lines: &mut Vec<String>, first: String, value: &[Complex; 3], form: Form| {
        let fields = |values: [f64; 3]| values.map(|value| format!("{value:>18.6E}")).concat();
        let parts = |part: usize| fields(value.map(|component| form.parts(component)[part]));
        let continued = |fields: String| format!("-CONT-            {fields}");
        lines.push(format!("{first}{}", parts(0)));
        lines.push(continued(fields([1e9, -1e9, 7.0])));
        if form != Form::Real {
            lines.push(continued(parts(1)));
            lines.push(continued(fields([0.0; 3])));
        }
    };
    if is_by_point {
        let first = &all[0];
        for (at, (label, _)) in first.values.iter().enumerate() {
            header(&mut lines, first);
            lines.push(format!("$POINT ID ={label:>12}  IDENTIFIED BY FREQUENCY"));
            for vectors in all {
                let start = format!("{:>16.6E} G", vectors.frequency);
                point(&mut lines, start, &vectors.values[at].1, vectors.form);
            }
        }
    } else {
        for vectors in all {
            header(&mut lines, vectors);
            lines.push(match vectors.mode {
                Some((number, value)) => format!("$EIGENVALUE ={value:>15.7E}  MODE ={number:>6}"),
                None => format!("$FREQUENCY ={:>16.7E}", vectors.frequency),
            });
            for (label, value) in &vectors.values {
                point(&mut lines, format!("{label:>10}       G"), value, vectors.form);
            }
            point(&mut lines, format!("{:>10}       S", 999_999), &[[5.0, 0.0]; 3], vectors.form);
        }
    }
    // Columns 73 to 80 have the number of the line.
    lines.iter().enumerate().map(|(at, line)| format!("{line:<72.72}{:>8}\n", at + 1)).collect()
}
