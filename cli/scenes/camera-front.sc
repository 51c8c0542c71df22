% Figure 1: three axes of spheres (red x, green y, blue z) from (0, 0, 20). The same scene from aside is "camera-side".
% Report: cameras (2.1).

camera {
  type pinhole
  eye    0 0 20
  target 0 0 0
  up     0 1 0
  fov    48
  aspect 1.333333
}

