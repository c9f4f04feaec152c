//! Reservation of memory.

use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::*;

/// Two parallel computations cannot reserve the same memory, and a finished one releases it.
#[test]
fn what_is_promised_to_one_is_not_promised_to_another() {
    let full = || EngineError::new("E0707", "it is too much", "");
    let interrupt =
        Interrupt::counting(
            move |wanted| if wanted.bytes + wanted.promised <= 100 { Ok(()) } else { Err(full()) },
        );
    let first = interrupt.reserve_memory(60).expect("there is room");
    assert_eq!(interrupt.reserve_memory(60).map(drop).map_err(|error| error.code), Err("E0707"));
    // A refused request reserves nothing.
    let second = interrupt.clone().reserve_memory(40).expect("there is room");
    assert_eq!(interrupt.largest_request(), 120);
    interrupt.check().expect("it takes nothing");
    drop(first);
    let mut third = interrupt.reserve_memory(60).expect("there is room again");
    third.shrink_to(20);
    third.shrink_to(40);
    let fourth = interrupt.reserve_memory(40).expect("there is room for what is not taken after all");
    assert_eq!(interrupt.reserve_memory(1).map(drop).map_err(|error| error.code), Err("E0707"));
    drop((second, third, fourth));
    interrupt.reserve_memory(100).map(drop).expect("all is given back");
}
