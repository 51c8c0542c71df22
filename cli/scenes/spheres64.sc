% The assignment's second scene: 64 spheres of radius 0.5 in a 4 x 4 x 4 grid spaced 1.5. Red grows along x, green along y and
% blue along z. Report: spheres (2.3.1), and why an octree pays (4.1).

image {
  resolution 640 480
  aa 0 2
  samples 1
}

camera {
  type pinhole
  eye    6.2 -9.4 5.2
  target 0 0 -0.4
  up     0 0 1
  fov    49
  aspect 1.333333
}

background { color { "sRGB nonlinear" 0.13 0.14 0.17 } }

light {
  type point
  color { "sRGB nonlinear" 1 1 1 }
  power 60
  p 9 -8 12
}

light {
  type point
  color { "sRGB nonlinear" 0.6 0.6 0.65 }
  power 60
  p -8 -12 3
}

light {
  type point
  color { "sRGB nonlinear" 0.4 0.4 0.42 }
  power 60
  p 6 -9.4 4.6
}

light {
  type point
  color { "sRGB nonlinear" 0.6 0.6 0.65 }
  power 60
  p -8 -12 3
}
