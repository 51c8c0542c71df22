% Figure 2: three axes of spheres (red x, green y, blue z) from (10, 10, 20). The same scene from the front is "camera-front".
% Report: cameras (2.1).

camera {
  type pinhole
  eye    10 10 20
  target 0 0 0
  up     0 1 0
  fov    48
  aspect 1.333333
}

