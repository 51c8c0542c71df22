% The same still life at four sizes: 1/1000, 1, 1000 and 1,000,000, each as far away as it is large, so that all look alike. Glass,
% a matt sphere, a turned cube and a table of thin triangles. Renderers with constant epsilons show how large they thought
% the world was: try `girasol render scales --naive all`.

image {
  resolution 800 240
  aa 0 2
  samples 1
}

trace-depths {
  diff 1
  refl 4
  refr 6
}

camera {
  type pinhole
  eye    0 0 0
  target 0 10 -2.75
  up     0 0 1
  fov    48
  aspect 3.333333
}

background { color { "sRGB nonlinear" 0.66 0.76 0.86 } }

light {
  type point
  color { "sRGB nonlinear" 1 0.97 0.9 }
  power 1e12
  p -7e9 -4e9 8e9
}

light {
  type point
  color { "sRGB nonlinear" 0.35 0.4 0.5 }
  power 1e12
  p 5e9 -9e9 3e9
}

shader {
  name table
  type phong
  diff { "sRGB nonlinear" 0.83 0.8 0.74 }
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

shader {
  name cube
  type phong
  diff { "sRGB nonlinear" 0.13 0.53 0.56 }
  spec { "sRGB nonlinear" 0.2 0.2 0.2 } 20
  samples 0
}

shader {
  name ball
  type phong
  diff { "sRGB nonlinear" 0.83 0.27 0.2 }
  spec { "sRGB nonlinear" 0.7 0.7 0.7 } 60
  samples 0
}

shader {
  name glass
  type glass
  eta 1.5
  color { "sRGB nonlinear" 1 1 1 }
}
