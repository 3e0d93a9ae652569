//! Scheduling of threads: the control loop's in real time, others behind what is urgent.

use thread_priority::{
    RealtimeThreadSchedulePolicy, ThreadPriority, ThreadSchedulePolicy, set_current_thread_priority,
    set_thread_priority_and_policy, thread_native_id, thread_schedule_policy_param,
};

/// Requested real-time priority, 1 to 99 (chosen: above ordinary threads, below the kernel's threaded interrupts).
const PRIORITY: u8 = 60;

/// Requests first-in first-out scheduling (SCHED_FIFO) for the calling thread.
pub fn request_fifo() {
    if let Ok(priority) = PRIORITY.try_into() {
        let fifo = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo);
        // A refusal is no error: the report names the policy that was granted.
        let _ = set_thread_priority_and_policy(thread_native_id(), ThreadPriority::Crossplatform(priority), fifo);
    }
}

/// Priority of work that others go before, 0 to 99, of which 50 is the usual one (chosen: on Linux a niceness of 9. At the lowest one,
/// forecasts came every ten seconds on two cores that draw by software and build programs).
const BEHIND: u8 = 24;

/// Lets other threads go first: the calling one gets a lower ordinary priority.
pub fn yield_to_others() {
    if let Ok(priority) = BEHIND.try_into() {
        // A refusal is no error: the thread then competes like any other.
        let _ = set_current_thread_priority(ThreadPriority::Crossplatform(priority));
    }
}

/// Returns the calling thread's policy, such as "SCHED_FIFO 60" or "SCHED_OTHER".
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
