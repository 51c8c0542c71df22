image {
  resolution 640 480
  aa 0 2
  samples 1
}

background { color { "sRGB nonlinear" 0.72 0.8 0.88 } }

light {
  type point
  color { "sRGB nonlinear" 0.9 0.88 0.83 }
  power 100000000
  p 450000 680000 600000
}

light {
  type point
  color { "sRGB nonlinear" 0.45 0.5 0.58 }
  power 100000000
  p -760000 430000 500000
}

light {
  type point
  color { "sRGB nonlinear" 0.4 0.42 0.46 }
  power 100000000
  p 4 0 22
}

shader {
  name red
  type phong
  diff { "sRGB nonlinear" 0.84 0.2 0.18 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 50
  samples 0
}

shader {
  name green
  type phong
  diff { "sRGB nonlinear" 0.2 0.62 0.26 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 50
  samples 0
}

shader {
  name blue
  type phong
  diff { "sRGB nonlinear" 0.18 0.36 0.8 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 50
  samples 0
}

shader {
  name ivory
  type phong
  diff { "sRGB nonlinear" 0.93 0.9 0.82 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 50
  samples 0
}

shader {
  name floor
  type phong
  texture "tiles.png"
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

object {
  shader floor
  type plane
  p 0 -3 0
  n 0 1 0
}

object {
  shader ivory
  type sphere
  name origin
  c 0 0 0
  r 1.8
}

object {
  shader red
  type sphere
  name red1
  c 2.9 0 0
  r 1.1
}

object {
  shader red
  type sphere
  name red2
  c 4.6 0 0
  r 0.75
}

object {
  shader red
  type sphere
  name red3
  c 5.85 0 0
  r 0.5
}

object {
  shader green
  type sphere
  name green1
  c 0 2.9 0
  r 1.1
}

object {
  shader green
  type sphere
  name green2
  c 0 4.6 0
  r 0.75
}

object {
  shader green
  type sphere
  name green3
  c 0 5.85 0
  r 0.5
}

object {
  shader blue
  type sphere
  name blue1
  c 0 0 2.9
  r 1.1
}

object {
  shader blue
  type sphere
  name blue2
  c 0 0 4.6
  r 0.75
}

object {
  shader blue
  type sphere
  name blue3
  c 0 0 5.85
  r 0.5
}
