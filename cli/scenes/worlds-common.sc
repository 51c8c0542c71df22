camera {
  type pinhole
  eye    6.4 -9.6 5.4
  target 0 0 -0.4
  up     0 0 1
  fov    50
  aspect 1.333333
}

background { color { "sRGB nonlinear" 0.17 0.18 0.24 } }

shader {
  name globe
  type phong
  texture "globe.png"
  spec { "sRGB nonlinear" 0.45 0.45 0.45 } 30
  samples 0
}

% Scaled by a negative number in z: a texture's lower edge lies at a sphere's +Z, and so comes down, unmirrored.
