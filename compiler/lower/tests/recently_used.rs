//! Tests of stores of limited size.

use calyx_lower::recently_used::RecentlyUsed;

#[test]
fn the_least_recently_used_values_are_dropped_beyond_the_limit() {
    let mut store = RecentlyUsed::new(10);
    store.store(1, "one", 4);
    store.store(2, "two", 4);
    assert_eq!(store.find(1), Some("one"));
    store.store(3, "three", 5);
    assert_eq!([1, 2, 3].map(|key| store.find(key)), [Some("one"), None, Some("three")]);
    store.store(4, "larger than the limit", 11);
    assert_eq!([1, 3, 4].map(|key| store.find(key)), [Some("one"), Some("three"), None]);
    // The third value has been used since.
    store.store(5, "five", 5);
    assert_eq!([1, 3, 5].map(|key| store.find(key)), [None, Some("three"), Some("five")]);
}
