% Textures on all that takes them. On the left a cube, whose faces show the whole picture; in front a triangle without UV, on
% which the picture's corner lies at its first point; behind a wall of a mesh with UV; on the right a lampshade of eight
% facets that normals make round. The floor is a plane by three points: they span one tile. The back wall is a plane by point
% and normal: its picture repeats each 10 units. Report: 2.3.2 to 2.3.5.

image {
  resolution 640 480
  aa 0 2
  samples 1
}

camera {
  type pinhole
  eye    0.6 -9.8 4.4
  target 0.15 0 1.0
  up     0 0 1
  fov    48
  aspect 1.333333
}

background { color { "sRGB nonlinear" 0.1 0.1 0.12 } }

light {
  type point
  color { "sRGB nonlinear" 0.95 0.93 0.9 }
  power 70
  p 3 -9 9
}

light {
  type point
  color { "sRGB nonlinear" 0.5 0.52 0.6 }
  power 60
  p -9 -7 5
}

shader {
  name picture
  type phong
  texture "orientation.png"
  spec { "sRGB nonlinear" 0.25 0.25 0.25 } 30
  samples 0
}

shader {
  name floor
  type phong
  texture "tiles.png"
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

shader {
  name wall
  type phong
  texture "checker.png"
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

shader {
  name stripes
  type phong
  texture "swirl.png"
  spec { "sRGB nonlinear" 0.5 0.5 0.5 } 30
  samples 0
}

object {
  shader floor
  type plane
  p 0 0 0
  p 4 0 0
  p 0 4 0
}

object {
  shader wall
  type plane
  p 0 9 0
  n 0 -1 0
}

object {
  shader picture
  transform {
    scaleu 2
    rotatez 35
    translate -2.6 0.2 1
  }
  type box
  name cube
}

object {
  shader picture
  type generic-mesh
  name triangle
  points 3
    -0.7 -2.6 0.02
    1.3 -2.6 0.02
    -0.7 -0.9 0.85
  triangles 1
    0 1 2
  normals none
  uvs none
}

object {
  shader picture
  type generic-mesh
  name banner
  points 4
    -0.4 2.4 0.02
    2 2.4 0.02
    2 2.4 2.42
    -0.4 2.4 2.42
  triangles 2
    0 1 2
    0 2 3
  normals none
  uvs vertex
    0 0
    1 0
    1 1
    0 1
}

object {
  shader stripes
  transform {
    rotatez 20
    translate 3.2 0 0
  }
  type generic-mesh
  name shade
  points 18
    0.95 0 0
    0.67175 0.67175 0
    5.8171e-17 0.95 0
    -0.67175 0.67175 0
    -0.95 1.1634e-16 0
    -0.67175 -0.67175 0
    -1.7451e-16 -0.95 0
    0.67175 -0.67175 0
    0.95 -2.3268e-16 0
    0.6 0 1.9
    0.42426 0.42426 1.9
    3.6739e-17 0.6 1.9
    -0.42426 0.42426 1.9
    -0.6 7.3479e-17 1.9
    -0.42426 -0.42426 1.9
    -1.1022e-16 -0.6 1.9
    0.42426 -0.42426 1.9
    0.6 -1.4696e-16 1.9
  triangles 16
    0 1 10
    1 2 11
    2 3 12
    3 4 13
    4 5 14
    5 6 15
    6 7 16
    7 8 17
    0 10 9
    1 11 10
    2 12 11
    3 13 12
    4 14 13
    5 15 14
    6 16 15
    7 17 16
  normals vertex
    1 0 0.18
    0.70711 0.70711 0.18
    6.1232e-17 1 0.18
    -0.70711 0.70711 0.18
    -1 1.2246e-16 0.18
    -0.70711 -0.70711 0.18
    -1.837e-16 -1 0.18
    0.70711 -0.70711 0.18
    1 -2.4493e-16 0.18
    1 0 0.18
    0.70711 0.70711 0.18
    6.1232e-17 1 0.18
    -0.70711 0.70711 0.18
    -1 1.2246e-16 0.18
    -0.70711 -0.70711 0.18
    -1.837e-16 -1 0.18
    0.70711 -0.70711 0.18
    1 -2.4493e-16 0.18
  uvs vertex
    0 0
    0.125 0
    0.25 0
    0.375 0
    0.5 0
    0.625 0
    0.75 0
    0.875 0
    1 0
    0 1
    0.125 1
    0.25 1
    0.375 1
    0.5 1
    0.625 1
    0.75 1
    0.875 1
    1 1
}
