% Figure 10: hard shadows, from a point light under a lampshade. "shadows-soft" is the same scene with soft ones.
% Glass casts no shadow, and the shade behind the light casts none down here. Report: point lights (2.2), shadows (3.2).

