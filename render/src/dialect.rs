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
    /// * a plane's normal is as long as it is written and as its transform leaves it: see [`shading::sunflow::LongNormal`];
    /// * `shiny` surfaces reflect, and what has no shader is black.
    ///
    /// One fault is not copied: in Sunflow a sphere around a ray's start hides what is nearer than its own far side, in an order that hangs on the
    /// accelerator, and keeps all light from what is inside it, even that of lights inside.
    Sunflow,
}
