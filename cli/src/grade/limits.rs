use std::time::Duration;

use crate::report::Failure;

/// How much a law may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Limits {
    /// From start to answer. Whoever started the process ends it then.
    pub(crate) time: Duration,
    /// Address space in MiB, where the system can limit it.
    pub(crate) memory: u64,
}

impl Limits {
    /// Whether this system holds a process to its memory.
    pub(crate) const LIMITS_MEMORY: bool = cfg!(any(target_os = "linux", target_os = "android", target_os = "freebsd"));

    /// Holds this process to them.
    ///
    /// The time of all its threads is limited, too, generously: it ends a loop without end when nobody is left to end it.
    #[cfg(unix)]
    pub(crate) fn keep(self) -> Result<(), Failure> {
        let limit = |resource, most: u64| {
            rlimit::setrlimit(resource, most, most).map_err(|error| {
                Failure::of(format!("the process cannot be limited to {most} of {}", resource.as_name()), error)
            })
        };
        if Self::LIMITS_MEMORY {
            limit(rlimit::Resource::AS, self.memory.saturating_mul(1 << 20))?;
        }
        let threads = std::thread::available_parallelism().map_or(1, |threads| threads.get() as u64);
        limit(rlimit::Resource::CPU, (self.time.as_secs() + 1).saturating_mul(threads).saturating_add(5))
    }

    /// This system has no limits.
    #[cfg(not(unix))]
    pub(crate) fn keep(self) -> Result<(), Failure> {
        Ok(())
    }
}
