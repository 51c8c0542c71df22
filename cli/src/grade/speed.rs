use serde_json::Value;

/// What a scene took with a program's own parts and with the reference's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Speed {
    /// Seconds, greater than 0.
    pub(crate) own: f64,
    /// Seconds, greater than 0.
    pub(crate) reference: f64,
    /// Rays of all kinds with the program's own parts.
    pub(crate) rays: f64,
}

impl Speed {
    /// Reads what the process that measures wrote; `None` if it is something else.
    pub(crate) fn read(value: &Value) -> Option<Self> {
        let number = |name: &str| value.get(name)?.as_f64();
        let speed = Self { own: number("own")?, reference: number("reference")?, rays: number("rays")? };
        (speed.own > 0.0 && speed.reference > 0.0).then_some(speed)
    }

    /// So many times the reference's time.
    pub(crate) fn ratio(&self) -> f64 {
        self.own / self.reference
    }

    /// A million rays a second.
    pub(crate) fn mega_rays(&self) -> f64 {
        self.rays / self.own / 1e6
    }

    /// In a line.
    pub(crate) fn sentence(&self) -> String {
        format!("{:.2} times the reference's time, {:.2} million rays a second", self.ratio(), self.mega_rays())
    }
}
