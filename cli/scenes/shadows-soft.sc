% Figure 9: render with soft shadows: the lamp's light becomes a cluster of lights, 0.1 apart, and each shadow a gradient, the
% wider the farther the object is from the ground. "shadows-hard" is the same scene with hard ones. Report: shadows (3.2).

