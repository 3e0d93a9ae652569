//! Promise: how fast a sweep is, and how long it still takes, counts the rows that came since its folder was opened.

use std::time::Duration;

use saute_sweep_folder::Tally;

#[test]
fn rate_and_time_left_are_those_of_the_rows_that_came_since_the_folder_was_opened() {
    let tally = Tally { rows: 100, done: 80, failed: 3, fresh: 10 };
    let since = Duration::from_secs(5);
    assert_eq!((tally.rate(since), tally.left_s(since)), (2.0, Some(10.0)));
    assert_eq!(Tally { fresh: 0, ..tally }.left_s(since), None);
    assert!(!tally.is_complete());
}
