% The assignment's third scene: three cubes of side 2 and two spheres of radius 1 in turn along x, with gaps of 0.5.
% Report: cubes placed by transforms (2.3.3). "box" is the course's cube of side 1 around the origin; Sunflow has none.

image {
  resolution 640 480
  aa 0 2
  samples 1
}

camera {
  type pinhole
  eye    -4.2 -12.8 4.2
  target -0.45 0 0.15
  up     0 0 1
  fov    53
  aspect 1.333333
}

background { color { "sRGB nonlinear" 0.78 0.84 0.88 } }

light {
  type point
  color { "sRGB nonlinear" 0.9 0.87 0.81 }
  power 100000
  p 300 -900 1200
}

light {
  type point
  color { "sRGB nonlinear" 0.55 0.6 0.68 }
  power 100000
  p -1200 -500 600
}

shader {
  name blue
  type phong
  diff { "sRGB nonlinear" 0.2 0.46 0.74 }
  spec { "sRGB nonlinear" 0.2 0.2 0.2 } 20
  samples 0
}

shader {
  name coral
  type phong
  diff { "sRGB nonlinear" 0.92 0.42 0.32 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 50
  samples 0
}

shader {
  name ground
  type phong
  diff { "sRGB nonlinear" 0.83 0.82 0.78 }
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

object {
  shader ground
  type plane
  p 0 0 -1
  n 0 0 1
}

object {
  shader blue
  transform {
    scaleu 2
    translate -5 0 0
  }
  type box
}

object {
  shader coral
  type sphere
  c -2.5 0 0
  r 1
}

object {
  shader blue
  transform {
    scaleu 2
  }
  type box
}

object {
  shader coral
  type sphere
  c 2.5 0 0
  r 1
}

object {
  shader blue
  transform {
    scaleu 2
    translate 5 0 0
  }
  type box
}
