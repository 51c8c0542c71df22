% Figure 7, with anti-aliasing: the larger number of aa is 2, so a pixel has 4 x 4 zones, and 4 rays go to random places in
% each. "aliasing-off" is the same scene with one ray a pixel. Report: anti-aliasing (3.1).

image {
  resolution 320 240
  aa 0 2
  samples 4
}

