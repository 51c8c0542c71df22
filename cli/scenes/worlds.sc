% Figure 4: 64 globes under three lights. Without them they are "worlds-dark".
% Report: lights (2.2), textures on spheres with an axis (2.3.1).

image {
  resolution 640 480
  aa 0 2
  samples 1
}

light {
  type point
  color { "sRGB nonlinear" 1 0.97 0.9 }
  power 70
  p 10 -10 12
}

light {
  type point
  color { "sRGB nonlinear" 0.5 0.58 0.7 }
  power 60
  p -10 -12 4
}

light {
  type point
  color { "sRGB nonlinear" 0.42 0.42 0.45 }
  power 60
  p 6.2 -9.6 4.8
}

