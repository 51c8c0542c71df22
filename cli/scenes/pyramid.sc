% The assignment's first scene: a pyramid with base and height 5, a sphere of radius 1 balanced on its tip, and spheres of
% radius 0.5 three units from the corners of its base. Report: triangles and spheres (2.3.1, 2.3.2), phong (3.3.2).

image {
  resolution 640 480
  aa 0 2
  samples 1
}

camera {
  type pinhole
  eye    8.5 -17 7.5
  target 0.2 0 2.5
  up     0 0 1
  fov    43
  aspect 1.333333
}

background { color { "sRGB nonlinear" 0.62 0.72 0.82 } }

light {
  type point
  color { "sRGB nonlinear" 0.92 0.88 0.8 }
  power 100000000
  p 540000 -490000 700000
}

light {
  type point
  color { "sRGB nonlinear" 0.48 0.54 0.66 }
  power 100000000
  p -600000 -400000 700000
}

light {
  type point
  color { "sRGB nonlinear" 0.4 0.42 0.48 }
  power 100000000
  p 7.5 -17 1.5
}

shader {
  name sandstone
  type phong
  diff { "sRGB nonlinear" 0.89 0.73 0.47 }
  spec { "sRGB nonlinear" 0.1 0.1 0.1 } 10
  samples 0
}

shader {
  name red
  type phong
  diff { "sRGB nonlinear" 0.8 0.2 0.17 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 60
  samples 0
}

shader {
  name teal
  type phong
  diff { "sRGB nonlinear" 0.13 0.58 0.6 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 60
  samples 0
}

shader {
  name ground
  type phong
  diff { "sRGB nonlinear" 0.8 0.76 0.68 }
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

object {
  shader ground
  type plane
  p 0 0 0
  n 0 0 1
}

object {
  shader sandstone
  type generic-mesh
  name pyramid
  points 5
    -2.5 -2.5 0
     2.5 -2.5 0
     2.5  2.5 0
    -2.5  2.5 0
     0    0   5
  triangles 6
    0 1 4
    1 2 4
    2 3 4
    3 0 4
    0 2 1
    0 3 2
  normals none
  uvs none
}

object {
  shader red
  type sphere
  name balanced
  c 0 0 6
  r 1
}

% On the ground, along the diagonals: from (2.5, 2.5, 0) to (4.5917, 4.5917, 0.5) it is three units.

object {
  shader teal
  type sphere
  name corner1
  c -4.5917 -4.5917 0.5
  r 0.5
}

object {
  shader teal
  type sphere
  name corner2
  c 4.5917 -4.5917 0.5
  r 0.5
}

object {
  shader teal
  type sphere
  name corner3
  c 4.5917 4.5917 0.5
  r 0.5
}

object {
  shader teal
  type sphere
  name corner4
  c -4.5917 4.5917 0.5
  r 0.5
}
