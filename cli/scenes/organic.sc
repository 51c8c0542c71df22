% A rabbit of some 70,000 triangles with normals at their vertices, found as the surface of smoothly joined blobs.
% Report: meshes (2.3.5), what the octree is for (4.1, 5).

image {
  resolution 640 480
  aa 0 2
  samples 1
}

camera {
  type pinhole
  eye    4.6 -9 3.6
  target 0.05 0 2.02
  up     0 0 1
  fov    37
  aspect 1.333333
}

background { color { "sRGB nonlinear" 0.75 0.84 0.8 } }

light {
  type point
  color { "sRGB nonlinear" 0.92 0.88 0.8 }
  power 100000000
  p 480000 -600000 650000
}

light {
  type point
  color { "sRGB nonlinear" 0.48 0.52 0.6 }
  power 100000000
  p -600000 200000 800000
}

light {
  type point
  color { "sRGB nonlinear" 0.42 0.44 0.5 }
  power 100000000
  p 3.6 -9 1
}

shader {
  name fur
  type phong
  diff { "sRGB nonlinear" 0.8 0.62 0.46 }
  spec { "sRGB nonlinear" 0.15 0.15 0.15 } 12
  samples 0
}

shader {
  name eye
  type phong
  diff { "sRGB nonlinear" 0.06 0.05 0.06 }
  spec { "sRGB nonlinear" 1 1 1 } 80
  samples 0
}

shader {
  name nose
  type phong
  diff { "sRGB nonlinear" 0.8 0.42 0.42 }
  spec { "sRGB nonlinear" 0.4 0.4 0.4 } 30
  samples 0
}

shader {
  name ground
  type phong
  diff { "sRGB nonlinear" 0.62 0.72 0.5 }
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

object {
  shader ground
  type plane
  p 0 0 -0.03
  n 0 0 1
}

object {
  shader eye
  type sphere
  name left
  c 0.44 -0.99 2.56
  r 0.13
}

object {
  shader eye
  type sphere
  name right
  c -0.44 -0.99 2.56
  r 0.13
}

object {
  shader nose
  transform {
    scale 0.11 0.08 0.08
    translate 0 -1.37 2.31
  }
  type sphere
  name snout
}
