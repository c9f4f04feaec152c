//! Tests of the remaining time.

use calyx_rt::progress::{line, seconds_left};
use std::time::Duration;

#[test]
fn what_is_left_follows_what_was_predicted_and_what_it_took() {
    assert_eq!(seconds_left(&[1.0, 2.0, 3.0], 0, 0.0), 6.0);
    assert_eq!(seconds_left(&[1.0, 2.0, 3.0], 2, 6.0), 6.0);
    assert_eq!(seconds_left(&[1.0, 2.0, 3.0], 3, 6.0), 0.0);
}

#[test]
fn lines_say_what_is_left() {
    assert_eq!(
        line("structures", 0, None, None).to_string(),
        r#"{"stage":"structures","done":0,"total":null,"seconds_left":null}"#
    );
    assert_eq!(
        line("positions", 3, Some(9), Some(Duration::from_secs(6))).to_string(),
        r#"{"stage":"positions","done":3,"total":9,"seconds_left":12.0}"#
    );
}
