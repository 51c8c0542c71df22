% Figure 6: a chain-link fence. Each of its 16 wires is a tube, bent to a flat helix and hooked into its neighbour's bends.
% Report: meshes (2.3.5), benchmark (5).

image {
  resolution 640 480
  aa 0 2
  samples 1
}

camera {
  type pinhole
  eye    17 -28 20
  target -1.2 0 11.3
  up     0 0 1
  fov    52
  aspect 1.333333
}

background { color { "sRGB nonlinear" 0.66 0.78 0.9 } }

light {
  type point
  color { "sRGB nonlinear" 0.95 0.9 0.82 }
  power 100000000
  p -280000 -520000 800000
}

light {
  type point
  color { "sRGB nonlinear" 0.5 0.54 0.6 }
  power 100000000
  p 720000 -570000 390000
}

light {
  type point
  color { "sRGB nonlinear" 0.42 0.44 0.5 }
  power 100000000
  p 17 -28 17
}

shader {
  name zinc
  type phong
  diff { "sRGB nonlinear" 0.62 0.66 0.7 }
  spec { "sRGB nonlinear" 0.7 0.7 0.7 } 40
  samples 0
}

shader {
  name paint
  type phong
  diff { "sRGB nonlinear" 0.16 0.36 0.26 }
  spec { "sRGB nonlinear" 0.4 0.4 0.4 } 30
  samples 0
}

shader {
  name grass
  type phong
  diff { "sRGB nonlinear" 0.5 0.62 0.38 }
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

shader {
  name orange
  type phong
  diff { "sRGB nonlinear" 0.88 0.38 0.16 }
  spec { "sRGB nonlinear" 0.5 0.5 0.5 } 40
  samples 0
}

object {
  shader grass
  type plane
  p 0 0 -1
  n 0 0 1
}

object {
  shader orange
  type sphere
  name ball
  c 4 12 2.5
  r 3.5
}
