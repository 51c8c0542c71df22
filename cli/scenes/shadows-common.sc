image {
  resolution 640 480
  aa 0 1
  samples 1
}

camera {
  type pinhole
  eye    0.3 -4.4 2.2
  target 0.05 0 0.88
  up     0 0 1
  fov    41
  aspect 1.333333
}

background { color { "sRGB nonlinear" 0.05 0.055 0.07 } }

light {
  type point
  color 1.5 1.38 1.14
  power 5
  p -0.55 -0.1 1.4
}

light {
  type point
  color { "sRGB nonlinear" 0.57 0.6 0.66 }
  power 30
  p 0.5 -5 2.5
}

shader {
  name wall
  type constant
  color { "sRGB nonlinear" 0.62 0.7 0.72 }
}

shader {
  name ground
  type constant
  color { "sRGB nonlinear" 0.86 0.82 0.74 }
}

shader {
  name red
  type constant
  color { "sRGB nonlinear" 0.85 0.2 0.18 }
}

shader {
  name blue
  type constant
  color { "sRGB nonlinear" 0.2 0.42 0.75 }
}

shader {
  name yellow
  type constant
  color { "sRGB nonlinear" 0.95 0.76 0.25 }
}

shader {
  name wood
  type constant
  color { "sRGB nonlinear" 0.6 0.42 0.28 }
}

shader {
  name glow
  type constant
  color 2 1.85 1.5
}

shader {
  name tin
  type constant
  color { "sRGB nonlinear" 0.93 0.9 0.82 }
}

shader {
  name clear
  type glass
  eta 1.4
  color { "sRGB nonlinear" 1 1 1 }
}

object {
  shader ground
  type plane
  p 0 0 0
  n 0 0 1
}

object {
  shader wall
  type plane
  p 0 2 0
  n 0 -1 0
}

% The bulb and the lampshade: wholly above the light and its cluster.

object {
  shader glow
  type sphere
  name bulb
  c -0.55 -0.1 1.64
  r 0.12
}

object {
  shader tin
  transform {
    translate -0.55 -0.1 -0.07
  }
  type generic-mesh
  name shade
  points 49
    0.4600 0.0000 1.7
    0.1600 0.0000 2.0
    0.4443 0.1191 1.7
    0.1545 0.0414 2.0
    0.3984 0.2300 1.7
    0.1386 0.0800 2.0
    0.3253 0.3253 1.7
    0.1131 0.1131 2.0
    0.2300 0.3984 1.7
    0.0800 0.1386 2.0
    0.1191 0.4443 1.7
    0.0414 0.1545 2.0
    0.0000 0.4600 1.7
    0.0000 0.1600 2.0
    -0.1191 0.4443 1.7
    -0.0414 0.1545 2.0
    -0.2300 0.3984 1.7
    -0.0800 0.1386 2.0
    -0.3253 0.3253 1.7
    -0.1131 0.1131 2.0
    -0.3984 0.2300 1.7
    -0.1386 0.0800 2.0
    -0.4443 0.1191 1.7
    -0.1545 0.0414 2.0
    -0.4600 0.0000 1.7
    -0.1600 0.0000 2.0
    -0.4443 -0.1191 1.7
    -0.1545 -0.0414 2.0
    -0.3984 -0.2300 1.7
    -0.1386 -0.0800 2.0
    -0.3253 -0.3253 1.7
    -0.1131 -0.1131 2.0
    -0.2300 -0.3984 1.7
    -0.0800 -0.1386 2.0
    -0.1191 -0.4443 1.7
    -0.0414 -0.1545 2.0
    -0.0000 -0.4600 1.7
    -0.0000 -0.1600 2.0
    0.1191 -0.4443 1.7
    0.0414 -0.1545 2.0
    0.2300 -0.3984 1.7
    0.0800 -0.1386 2.0
    0.3253 -0.3253 1.7
    0.1131 -0.1131 2.0
    0.3984 -0.2300 1.7
    0.1386 -0.0800 2.0
    0.4443 -0.1191 1.7
    0.1545 -0.0414 2.0
    0 0 2.0
  triangles 72
    0 2 3
    0 3 1
    2 4 5
    2 5 3
    4 6 7
    4 7 5
    6 8 9
    6 9 7
    8 10 11
    8 11 9
    10 12 13
    10 13 11
    12 14 15
    12 15 13
    14 16 17
    14 17 15
    16 18 19
    16 19 17
    18 20 21
    18 21 19
    20 22 23
    20 23 21
    22 24 25
    22 25 23
    24 26 27
    24 27 25
    26 28 29
    26 29 27
    28 30 31
    28 31 29
    30 32 33
    30 33 31
    32 34 35
    32 35 33
    34 36 37
    34 37 35
    36 38 39
    36 39 37
    38 40 41
    38 41 39
    40 42 43
    40 43 41
    42 44 45
    42 45 43
    44 46 47
    44 47 45
    46 0 1
    46 1 47
    1 3 48
    3 5 48
    5 7 48
    7 9 48
    9 11 48
    11 13 48
    13 15 48
    15 17 48
    17 19 48
    19 21 48
    21 23 48
    23 25 48
    25 27 48
    27 29 48
    29 31 48
    31 33 48
    33 35 48
    35 37 48
    37 39 48
    39 41 48
    41 43 48
    43 45 48
    45 47 48
    47 1 48
  normals none
  uvs none
}

% A ball on a stick, far above its shadow; a cube and a ball that touch theirs.

object {
  shader wood
  transform {
    scale 0.035 0.035 0.65
    translate 0.12 0.4 0.325
  }
  type box
  name stick
}

object {
  shader red
  type sphere
  name lollipop
  c 0.12 0.4 0.8
  r 0.2
}

object {
  shader blue
  transform {
    scaleu 0.42
    rotatez 25
    translate -0.85 0.55 0.21
  }
  type box
  name cube
}

object {
  shader yellow
  type sphere
  name ball
  c 0.8 -0.35 0.2
  r 0.2
}

object {
  shader clear
  type sphere
  name bubble
  c -0.1 -0.75 0.2
  r 0.2
}
