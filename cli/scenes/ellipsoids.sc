% Spheres under every transform: scaled unevenly, turned about any axis, sheared by a matrix; and one geometry shown again by
% an instance. Highlights and textures follow. Report: transforms, normals by the inverse transpose (2.3).

image {
  resolution 640 480
  aa 0 2
  samples 1
}

camera {
  type pinhole
  eye    1 -11.2 4.1
  target 0.05 0 0.85
  up     0 0 1
  fov    45
  aspect 1.333333
}

background { color { "sRGB nonlinear" 0.86 0.87 0.84 } }

light {
  type point
  color { "sRGB nonlinear" 0.9 0.88 0.83 }
  power 100000000
  p 420000 -540000 720000
}

light {
  type point
  color { "sRGB nonlinear" 0.48 0.52 0.6 }
  power 100000000
  p -600000 -300000 740000
}

light {
  type point
  color { "sRGB nonlinear" 0.42 0.44 0.5 }
  power 100000000
  p 1 -11 1.5
}

shader {
  name globe
  type phong
  texture "globe.png"
  spec { "sRGB nonlinear" 0.5 0.5 0.5 } 30
  samples 0
}

shader {
  name swirl
  type phong
  texture "swirl.png"
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 60
  samples 0
}

shader {
  name plum
  type phong
  diff { "sRGB nonlinear" 0.5 0.2 0.45 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 50
  samples 0
}

shader {
  name olive
  type phong
  diff { "sRGB nonlinear" 0.55 0.6 0.2 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 50
  samples 0
}

shader {
  name ocher
  type phong
  diff { "sRGB nonlinear" 0.9 0.6 0.2 }
  spec { "sRGB nonlinear" 0.8 0.8 0.8 } 50
  samples 0
}

shader {
  name ground
  type phong
  diff { "sRGB nonlinear" 0.84 0.77 0.65 }
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

object {
  shader ground
  type plane
  p 0 0 0
  n 0 0 1
}

% A flat planet: the pole stays up, since the texture turns with the sphere.

object {
  shader globe
  transform {
    scale 1.5 1.5 -0.55
    rotatez 200
    rotatey 15
    translate -2.9 0.3 0.95
  }
  type sphere
  name lens
}

% An egg on its end.

object {
  shader swirl
  transform {
    scale 0.75 0.75 -1.2
    rotatez 40
    translate 0 0.6 1.2
  }
  type sphere
  name egg
}

% A cigar, turned about a slanting axis.

object {
  shader ocher
  transform {
    scale 1.7 0.35 0.35
    rotate 0 1 1 -35
    translate 2.7 0.8 1.35
  }
  type sphere
  name cigar
}

% A sheared sphere: the third column leans the upper half to the side. Rows of a 4 x 4 matrix.

object {
  shader plum
  transform row
    0.6 0   0.45 -1.5
    0   0.6 0    -2
    0   0   0.6   0.6
    0   0   0     1
  type sphere
  name sheared
}

% A pill, by columns of a matrix; and the same geometry once more.

object {
  shader olive
  transform col
    0.7 0   0    0
    0   0.7 0    0
    0   0   0.25 0
    0.6 -2.3 0.25 1
  type sphere
  name pill
}

instance {
  name again
  geometry pill
  transform {
    scale 0.7 0.7 0.25
    rotatex -62
    translate 1.55 -1.35 0.66
  }
  shader olive
}
