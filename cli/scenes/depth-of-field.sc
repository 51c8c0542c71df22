% A row of balls recedes past the plane of focus, which goes through the third one. The lens is a hexagon: so are the blurred
% lamps behind. Report: cameras (2.1), the thin lens with fdist, lensr, sides and rotation.

image {
  resolution 640 480
  aa 0 2
  samples 3
}

camera {
  type thinlens
  eye    -1.7 -6.2 1.75
  target 0.35 0 0.78
  up     0 0 1
  fov    38
  aspect 1.333333
  fdist  6.2
  lensr  0.17
  sides  6
  rotation 15
}

background { color { "sRGB nonlinear" 0.03 0.035 0.05 } }

light {
  type point
  color { "sRGB nonlinear" 0.95 0.9 0.8 }
  power 60
  p -5 -7 8
}

light {
  type point
  color { "sRGB nonlinear" 0.4 0.45 0.6 }
  power 60
  p 7 -6 5
}

shader {
  name c1
  type phong
  diff { "sRGB nonlinear" 0.82 0.22 0.2 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 50
  samples 0
}

shader {
  name c2
  type phong
  diff { "sRGB nonlinear" 0.93 0.58 0.18 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 50
  samples 0
}

shader {
  name c3
  type phong
  diff { "sRGB nonlinear" 0.93 0.83 0.3 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 50
  samples 0
}

shader {
  name c4
  type phong
  diff { "sRGB nonlinear" 0.3 0.64 0.34 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 50
  samples 0
}

shader {
  name c5
  type phong
  diff { "sRGB nonlinear" 0.2 0.5 0.72 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 50
  samples 0
}

shader {
  name c6
  type phong
  diff { "sRGB nonlinear" 0.42 0.3 0.66 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 50
  samples 0
}

shader {
  name floor
  type phong
  texture "wood.png"
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

% Lamps: colours far above 1, since a lamp out of focus spreads its light over a hexagon several times its size.

shader {
  name warm
  type constant
  color 34 18 2.5
}

shader {
  name cool
  type constant
  color 2.5 17 34
}

object {
  shader floor
  type plane
  p -3 -8 0
  p 5 -8 0
  p -3 0 0
}

object {
  shader c1
  type sphere
  name ball1
  c -1.55 -2.70 0.55
  r 0.55
}

object {
  shader c2
  type sphere
  name ball2
  c -0.79 -1.35 0.55
  r 0.55
}

object {
  shader c3
  type sphere
  name ball3
  c -0.04 0.00 0.55
  r 0.55
}

object {
  shader c4
  type sphere
  name ball4
  c 0.72 1.35 0.55
  r 0.55
}

object {
  shader c5
  type sphere
  name ball5
  c 1.47 2.70 0.55
  r 0.55
}

object {
  shader c6
  type sphere
  name ball6
  c 2.23 4.05 0.55
  r 0.55
}

object {
  shader cool
  type sphere
  name lamp1
  c -2.4 18 2.6
  r 0.16
}

object {
  shader warm
  type sphere
  name lamp2
  c -0.6 20 3.5
  r 0.16
}

object {
  shader warm
  type sphere
  name lamp3
  c 1.3 17 2.2
  r 0.16
}

object {
  shader cool
  type sphere
  name lamp4
  c 3.1 21 3.1
  r 0.16
}

object {
  shader warm
  type sphere
  name lamp5
  c 4.6 18 1.9
  r 0.16
}

object {
  shader warm
  type sphere
  name lamp6
  c 6.2 20 3.6
  r 0.16
}

object {
  shader cool
  type sphere
  name lamp7
  c 7.6 17 2.5
  r 0.16
}

object {
  shader warm
  type sphere
  name lamp8
  c 9.2 19 3.3
  r 0.16
}

object {
  shader warm
  type sphere
  name lamp9
  c 10.8 17 2.0
  r 0.16
}

object {
  shader cool
  type sphere
  name lamp10
  c 12.4 18 2.9
  r 0.16
}

object {
  shader warm
  type sphere
  name lamp11
  c 2.3 15 3.3
  r 0.16
}

object {
  shader warm
  type sphere
  name lamp12
  c 8.4 15 1.5
  r 0.16
}
