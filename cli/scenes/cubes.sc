% The assignment's third scene: three cubes of side 2 and two spheres of radius 1 in turn along x, with gaps of 0.5.
% Report: cubes placed by transforms (2.3.3). "box" is the course's cube of side 1 around the origin; Sunflow has none.
% The floor's tiles are 2.5 wide: each of the five stands in the middle of one.

image {
  resolution 640 480
  aa 0 2
  samples 1
}

camera {
  type pinhole
  eye    -5.2 -11.6 5.6
  target -0.5 0 -0.35
  up     0 0 1
  fov    51
  aspect 1.333333
}

background { color { "sRGB nonlinear" 0.78 0.84 0.88 } }

light {
  type point
  color { "sRGB nonlinear" 0.92 0.88 0.8 }
  power 100000000
  p 450000 -550000 700000
}

light {
  type point
  color { "sRGB nonlinear" 0.48 0.54 0.66 }
  power 100000000
  p -700000 -100000 700000
}

light {
  type point
  color { "sRGB nonlinear" 0.42 0.44 0.5 }
  power 100000000
  p -4.2 -13 2
}

shader {
  name teal
  type phong
  diff { "sRGB nonlinear" 0.16 0.5 0.56 }
  spec { "sRGB nonlinear" 0.2 0.2 0.2 } 20
  samples 0
}

shader {
  name orange
  type phong
  diff { "sRGB nonlinear" 0.95 0.5 0.2 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 50
  samples 0
}

shader {
  name ground
  type phong
  texture "tiles.png"
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

object {
  shader ground
  type plane
  p 1.25 1.25 -1
  p 11.25 1.25 -1
  p 1.25 11.25 -1
}

object {
  shader teal
  transform {
    scaleu 2
    translate -5 0 0
  }
  type box
}

object {
  shader orange
  type sphere
  c -2.5 0 0
  r 1
}

object {
  shader teal
  transform {
    scaleu 2
  }
  type box
}

object {
  shader orange
  type sphere
  c 2.5 0 0
  r 1
}

object {
  shader teal
  transform {
    scaleu 2
    translate 5 0 0
  }
  type box
}
