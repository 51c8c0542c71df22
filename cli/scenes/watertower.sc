% Figure 5: a water tower of four meshes, some 13,000 triangles with normals at their vertices.
% The camera looks level and its picture is shifted upwards, as architects do, so that the legs stay upright.
% Report: meshes (2.3.5), cameras (2.1).

image {
  resolution 600 800
  aa 0 2
  samples 1
}

camera {
  type pinhole
  eye    6.5 -15.5 1.9
  target 0 0 1.9
  up     0 0 1
  fov    33
  aspect 0.75
  shift  0 0.19
}

background { color { "sRGB nonlinear" 0.62 0.76 0.88 } }

light {
  type point
  color { "sRGB nonlinear" 0.95 0.9 0.8 }
  power 100000000
  p 480000 -550000 680000
}

light {
  type point
  color { "sRGB nonlinear" 0.45 0.5 0.58 }
  power 100000000
  p -750000 -500000 400000
}

light {
  type point
  color { "sRGB nonlinear" 0.5 0.52 0.56 }
  power 100000000
  p 4.5 -15 0.5
}

shader {
  name steel
  type phong
  diff { "sRGB nonlinear" 0.42 0.45 0.5 }
  spec { "sRGB nonlinear" 0.5 0.5 0.5 } 30
  samples 0
}

shader {
  name planks
  type phong
  diff { "sRGB nonlinear" 0.55 0.42 0.3 }
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

shader {
  name enamel
  type phong
  diff { "sRGB nonlinear" 0.9 0.88 0.82 }
  spec { "sRGB nonlinear" 0.4 0.4 0.4 } 40
  samples 0
}

shader {
  name tin
  type phong
  diff { "sRGB nonlinear" 0.72 0.24 0.18 }
  spec { "sRGB nonlinear" 0.5 0.5 0.5 } 25
  samples 0
}

shader {
  name grass
  type phong
  diff { "sRGB nonlinear" 0.42 0.52 0.3 }
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

object {
  shader grass
  type plane
  p 0 0 0
  n 0 0 1
}
