% Figure 10: hard shadows, from a point light under a lampshade. "shadows-soft" is the same scene with soft ones.
% Glass casts no shadow, nor do bulb and shade in the lamp's light, since they lie behind it; the faint shadows are those of
% a second, weak light. Report: point lights (2.2), shadows (3.2).

