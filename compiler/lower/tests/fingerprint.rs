//! Tests of fingerprints.

use calyx_lower::fingerprint::Fingerprint;
use std::collections::HashSet;

#[test]
fn different_content_has_different_fingerprints() {
    let mut seen = HashSet::new();
    let mut add = |found: Fingerprint| assert!(seen.insert(found));
    for number in 0..20_000_u64 {
        add(Fingerprint::of((1, f64::from_bits(0x3ff0_0000_0000_0000 + number).to_bits())));
        add(Fingerprint::of((2, number << 44)));
        add(Fingerprint::of([number, 0]));
        add(Fingerprint::of([0, number + 1]));
    }
    for text in ["", "\0", "\0\0\0\0\0\0\0\0", "a", "ab", "ba", "abcdefgh", "abcdefghi"] {
        add(Fingerprint::of(text));
    }
    add(Fingerprint::of(("a", "bc")));
    add(Fingerprint::of(("ab", "c")));
    assert_eq!(Fingerprint::of([1, 2]), Fingerprint::of([1, 2]));
}
