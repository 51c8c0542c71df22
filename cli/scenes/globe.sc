% Figure 11: a planet with a texture and a highlight, its axis slanted by a transform, and its moon.
% Report: the sphere's axis (2.3.1), phong with a texture (3.3.2).

image {
  resolution 640 480
  aa 0 2
  samples 1
}

camera {
  type pinhole
  eye    0 -8 1.2
  target 0.25 0 0
  up     0 0 1
  fov    43
  aspect 1.333333
}

background { color { "sRGB nonlinear" 0.02 0.025 0.05 } }

light {
  type point
  color { "sRGB nonlinear" 1 0.98 0.94 }
  power 60
  p -7 -9 6
}

light {
  type point
  color { "sRGB nonlinear" 0.22 0.26 0.38 }
  power 60
  p 9 -4 -2
}

shader {
  name planet
  type phong
  texture "globe.png"
  spec { "sRGB nonlinear" 0.65 0.65 0.6 } 35
  samples 0
}

shader {
  name moon
  type constant
  color { "sRGB nonlinear" 0.72 0.7 0.66 }
}

% Scaled by a negative number in z: a texture's lower edge lies at a sphere's +Z, and so comes down, unmirrored.

object {
  shader planet
  transform {
    scale 2 2 -2
    rotatez 40
    rotatey 23.4
  }
  type sphere
  name globe
}

object {
  shader moon
  type sphere
  name satellite
  c 2.9 0.6 1.5
  r 0.32
}
