//! Tests of limits of time and memory as text.

use calyx_rt::budget::{memory, time};
use std::time::Duration;

#[test]
fn limits_are_read_as_they_are_written() {
    assert_eq!(time("10s").unwrap(), Duration::from_secs(10));
    assert_eq!(time("500 ms").unwrap(), Duration::from_millis(500));
    assert_eq!(time("1.5 min").unwrap(), Duration::from_secs(90));
    assert_eq!(time("3").unwrap(), Duration::from_secs(3));
    assert_eq!(memory("2GB").unwrap(), 2_000_000_000);
    assert_eq!(memory("64 kB").unwrap(), 64_000);
    for wrong in ["ten", "10 weeks", "-1s", "", "nan s"] {
        assert!(time(wrong).is_err(), "{wrong}");
    }
    assert!(memory("2 s").unwrap_err().contains("`GB`"));
}
