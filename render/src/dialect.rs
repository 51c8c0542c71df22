/// Whose meaning a scene's statements have, where the report and Sunflow read the same words differently.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dialect {
    /// The report's.
    #[default]
    Report,
    /// Sunflow's, so that pictures can be compared:
    ///
    /// * only camera rays see the background: those that were reflected or refracted see black past the last surface;
    /// * pixels lie as in [`crate::Raster::Sunflow`];
    /// * a plane given by its normal, and a mesh without texture coordinates, have (0, 0) everywhere;
    /// * the length of a plane's normal multiplies the light that falls on it.
    Sunflow,
}
