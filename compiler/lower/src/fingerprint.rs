//! Fingerprints of content.

use std::hash::{Hash, Hasher};

/// Fingerprint of 128 bits. Different content has different fingerprints, except by a coincidence
/// of negligible probability. Content that is made to collide is not detected.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Fingerprint([u64; 2]);

impl Fingerprint {
    /// Computes the fingerprint of a content.
    pub fn of(content: impl Hash) -> Self {
        let mut hasher = FingerprintHasher::default();
        content.hash(&mut hasher);
        hasher.fingerprint()
    }
}

/// Odd numbers with irregular bits: the fractional parts of pi (Blowfish).
const FACTORS: [u64; 2] = [0x243f_6a88_85a3_08d3, 0x1319_8a2e_0370_7345];

/// Two hashes of the same words. Content has some hundred thousand words per check of a model, so a
/// word costs two multiplications only.
#[derive(Clone, Debug)]
pub(crate) struct FingerprintHasher([u64; 2]);

impl Default for FingerprintHasher {
    fn default() -> Self {
        FingerprintHasher([0xa409_3822_299f_31d0, 0x082e_fa98_ec4e_6c89])
    }
}

impl FingerprintHasher {
    pub(crate) fn fingerprint(&self) -> Fingerprint {
        let mut last = self.clone();
        last.word(0);
        Fingerprint(last.0)
    }

    #[inline]
    fn word(&mut self, word: u64) {
        for (state, factor) in self.0.iter_mut().zip(FACTORS) {
            let product = u128::from(*state ^ word) * u128::from(factor);
            // The sum keeps the state where the product is zero.
            *state = (product as u64 ^ (product >> 64) as u64).wrapping_add(state.rotate_left(23));
        }
    }
}

impl Hasher for FingerprintHasher {
    fn write(&mut self, bytes: &[u8]) {
        let (words, rest) = bytes.as_chunks::<8>();
        words.iter().for_each(|word| self.word(u64::from_le_bytes(*word)));
        let mut last = [0; 8];
        last[..rest.len()].copy_from_slice(rest);
        self.word(u64::from_le_bytes(last));
        self.word(bytes.len() as u64);
    }

    fn write_u8(&mut self, value: u8) {
        self.word(value.into());
    }

    fn write_u16(&mut self, value: u16) {
        self.word(value.into());
    }

    fn write_u32(&mut self, value: u32) {
        self.word(value.into());
    }

    fn write_u64(&mut self, value: u64) {
        self.word(value);
    }

    fn write_usize(&mut self, value: usize) {
        self.word(value as u64);
    }

    fn finish(&self) -> u64 {
        self.0[0]
    }
}
