//! Asks for a thread's right to run at once, and says what it got.

use thread_priority::{
    RealtimeThreadSchedulePolicy, ThreadPriority, ThreadSchedulePolicy, set_thread_priority_and_policy,
    thread_native_id, thread_schedule_policy_param,
};

/// Priority that is asked for, of 1 to 99 (chosen: above the system's ordinary threads, below its interrupts).
const PRIORITY: u8 = 60;

/// Asks for first-in first-out scheduling of the calling thread.
pub fn ask_for_fifo() {
    if let Ok(priority) = PRIORITY.try_into() {
        let fifo = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo);
        // A refusal is no failure: what was got is reported.
        let _ = set_thread_priority_and_policy(thread_native_id(), ThreadPriority::Crossplatform(priority), fifo);
    }
}

/// What the calling thread has, such as "SCHED_FIFO 60" or "SCHED_OTHER".
pub fn granted() -> String {
    match thread_schedule_policy_param(thread_native_id()) {
        Ok((ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo), params)) => {
            format!("SCHED_FIFO {}", params.sched_priority)
        }
        Ok((ThreadSchedulePolicy::Realtime(_), params)) => format!("real time {}", params.sched_priority),
        Ok(_) => "SCHED_OTHER".to_owned(),
        Err(_) => "unknown".to_owned(),
    }
}
