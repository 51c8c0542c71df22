% Figure 12: spheres of glass and mirror in a corner of three planes of different colours. The green ball swallows red and
% blue light on the way through it, the bubble is a glass shell with air inside. Report: glass (3.3.3), mirror (3.3.4).

image {
  resolution 640 480
  aa 0 2
  samples 1
}

trace-depths {
  diff 1
  refl 2
  refr 6
}

camera {
  type pinhole
  eye    6.2 -7.6 4.6
  target -0.3 0.2 1.1
  up     0 0 1
  fov    42
  aspect 1.333333
}

background { color { "sRGB nonlinear" 0.75 0.82 0.9 } }

light {
  type point
  color { "sRGB nonlinear" 0.95 0.93 0.88 }
  power 50
  p 5 -6 9
}

light {
  type point
  color { "sRGB nonlinear" 0.5 0.52 0.56 }
  power 40
  p 1 -8 4
}

light {
  type point
  color { "sRGB nonlinear" 0.42 0.42 0.46 }
  power 40
  p 8 2 6
}

shader {
  name cream
  type phong
  diff { "sRGB nonlinear" 0.88 0.85 0.77 }
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

shader {
  name blue
  type phong
  diff { "sRGB nonlinear" 0.24 0.46 0.66 }
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

shader {
  name coral
  type phong
  diff { "sRGB nonlinear" 0.84 0.42 0.3 }
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

shader {
  name ivory
  type phong
  diff { "sRGB nonlinear" 0.92 0.9 0.84 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 50
  samples 0
}

shader {
  name silver
  type mirror
  refl { "sRGB nonlinear" 0.92 0.92 0.92 }
}

shader {
  name gold
  type mirror
  refl { "sRGB nonlinear" 0.9 0.72 0.4 }
}

shader {
  name clear
  type glass
  eta 1.5
  color { "sRGB nonlinear" 1 1 1 }
}

shader {
  name green
  type glass
  eta 1.5
  color { "sRGB nonlinear" 1 1 1 }
  absorption.distance 1.6
  absorption.color { "sRGB nonlinear" 0.25 0.85 0.4 }
}

shader {
  name air
  type glass
  eta 0.6667
  color { "sRGB nonlinear" 1 1 1 }
}

object {
  shader cream
  type plane
  p 0 0 0
  n 0 0 1
}

object {
  shader blue
  type plane
  p 0 4 0
  n 0 -1 0
}

object {
  shader coral
  type plane
  p -4 0 0
  n 1 0 0
}

object {
  shader silver
  type sphere
  name mirror
  c -1.5 1.5 1.6
  r 1.6
}

object {
  shader gold
  type sphere
  name little
  c 2.4 1.6 0.7
  r 0.7
}

object {
  shader clear
  type sphere
  name glass
  c 0.9 -1.1 1
  r 1
}

object {
  shader green
  type sphere
  name bottle
  c -1.7 -1.6 0.75
  r 0.75
}

object {
  shader clear
  type sphere
  name shell
  c 3 -1.6 0.6
  r 0.6
}

object {
  shader air
  type sphere
  name hollow
  c 3 -1.6 0.6
  r 0.52
}

object {
  shader ivory
  type sphere
  name pearl
  c -0.35 -2.9 0.4
  r 0.4
}
