% Figure 7, without anti-aliasing: one ray goes through the middle of each pixel. "aliasing-on" is the same scene, smoothed.
% The picture is small so that its pixels show. Report: anti-aliasing (3.1).

image {
  resolution 320 240
  aa 0 0
  samples 1
}

