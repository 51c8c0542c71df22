% Marbles on a wooden tray: clear and tinted glass, silver and gold mirrors, paint with highlights, and painted swirls, each
% turned to another side. Three lights; glass casts no shadow. A white ball behind the first light, where it casts none
% either, is what glass and metal reflect as a lamp. All of the report at once.

image {
  resolution 800 600
  aa 0 1
  samples 3
}

trace-depths {
  diff 1
  refl 2
  refr 4
}

camera {
  type pinhole
  eye    3.6 -9.4 6.1
  target -0.2 -0.6 -0.1
  up     0 0 1
  fov    48
  aspect 1.333333
}

background { color { "sRGB nonlinear" 0.78 0.85 0.94 } }

light {
  type point
  color { "sRGB nonlinear" 1 0.96 0.88 }
  power 90
  p 6 -8 9.5
}

light {
  type point
  color { "sRGB nonlinear" 0.7 0.72 0.78 }
  power 70
  p -8 3 9
}

light {
  type point
  color { "sRGB nonlinear" 0.42 0.42 0.44 }
  power 60
  p 1.5 -10.5 4.5
}

shader {
  name clear
  type glass
  eta 1.6
  color { "sRGB nonlinear" 1 1 1 }
}

shader {
  name amber
  type glass
  eta 1.5
  color { "sRGB nonlinear" 0.98 0.98 0.98 }
  absorption.distance 0.4
  absorption.color { "sRGB nonlinear" 1 0.8 0.1 }
}

shader {
  name sea
  type glass
  eta 1.5
  color { "sRGB nonlinear" 0.98 0.98 0.98 }
  absorption.distance 0.7
  absorption.color { "sRGB nonlinear" 0.3 0.95 0.72 }
}

shader {
  name rose
  type glass
  eta 1.5
  color { "sRGB nonlinear" 0.98 0.98 0.98 }
  absorption.distance 0.5
  absorption.color { "sRGB nonlinear" 1 0.55 0.78 }
}

shader {
  name silver
  type mirror
  refl { "sRGB nonlinear" 0.9 0.91 0.93 }
}

shader {
  name gold
  type mirror
  refl { "sRGB nonlinear" 0.92 0.74 0.38 }
}

shader {
  name swirl
  type phong
  texture "swirl.png"
  spec { "sRGB nonlinear" 0.9 0.9 0.9 } 90
  samples 0
}

shader {
  name red
  type phong
  diff { "sRGB nonlinear" 0.78 0.12 0.13 }
  spec { "sRGB nonlinear" 0.9 0.9 0.9 } 90
  samples 0
}

shader {
  name blue
  type phong
  diff { "sRGB nonlinear" 0.1 0.26 0.62 }
  spec { "sRGB nonlinear" 0.9 0.9 0.9 } 90
  samples 0
}

shader {
  name cream
  type phong
  diff { "sRGB nonlinear" 0.93 0.89 0.78 }
  spec { "sRGB nonlinear" 0.7 0.7 0.7 } 90
  samples 0
}

shader {
  name violet
  type phong
  diff { "sRGB nonlinear" 0.42 0.2 0.55 }
  spec { "sRGB nonlinear" 0.9 0.9 0.9 } 90
  samples 0
}

shader {
  name board
  type phong
  texture "wood.png"
  spec { "sRGB nonlinear" 0.1 0.1 0.1 } 15
  samples 0
}

shader {
  name rail
  type phong
  diff { "sRGB nonlinear" 0.36 0.2 0.11 }
  spec { "sRGB nonlinear" 0.25 0.25 0.25 } 25
  samples 0
}

shader {
  name cloth
  type phong
  diff { "sRGB nonlinear" 0.26 0.45 0.44 }
  spec { "sRGB nonlinear" 0 0 0 } 1
  samples 0
}

shader {
  name lamp
  type constant
  color 5 4.9 4.6
}

object {
  shader lamp
  type sphere
  name bulb
  c 8.6 -11.5 13.6
  r 3
}

object {
  shader cloth
  type plane
  p 0 0 -0.3
  n 0 0 1
}

object {
  shader board
  transform {
    scale 6.8 6.8 0.3
    translate 0 0 -0.15
  }
  type box
  name tray
}

object {
  shader rail
  transform {
    scale 7.36 0.28 0.72
    translate 0 -3.54 0.06
  }
  type box
  name rail1
}

object {
  shader rail
  transform {
    scale 7.36 0.28 0.72
    translate 0 3.54 0.06
  }
  type box
  name rail2
}

object {
  shader rail
  transform {
    scale 6.8 0.28 0.72
    rotatez 90
    translate -3.54 0 0.06
  }
  type box
  name rail3
}

object {
  shader rail
  transform {
    scale 6.8 0.28 0.72
    rotatez 90
    translate 3.54 0 0.06
  }
  type box
  name rail4
}

object {
  shader blue
  type sphere
  name marble1
  c 0.323 0.795 0.620
  r 0.62
}

object {
  shader red
  type sphere
  name marble2
  c -0.899 1.010 0.620
  r 0.62
}

object {
  shader cream
  type sphere
  name marble3
  c -0.474 -0.155 0.620
  r 0.62
}

object {
  shader swirl
  transform {
    scale 0.85 0.85 -0.85
    rotatez 212
    rotatex 104
    translate 1.550 -1.350 0.850
  }
  type sphere
  name marble4
}

object {
  shader sea
  type sphere
  name marble5
  c -1.550 -1.750 0.750
  r 0.75
}

object {
  shader silver
  type sphere
  name marble6
  c 2.300 0.750 0.800
  r 0.8
}

object {
  shader gold
  type sphere
  name marble7
  c -2.350 1.900 0.800
  r 0.8
}

object {
  shader amber
  type sphere
  name marble8
  c 0.150 -2.550 0.500
  r 0.5
}

object {
  shader swirl
  transform {
    scale 0.6 0.6 -0.6
    rotatez 117
    rotatex 99
    translate -2.600 -0.350 0.600
  }
  type sphere
  name marble9
}

object {
  shader rose
  type sphere
  name marble10
  c 0.250 -1.000 0.450
  r 0.45
}

object {
  shader cream
  type sphere
  name marble11
  c 0.477 2.360 0.500
  r 0.5
}

object {
  shader violet
  type sphere
  name marble12
  c 2.791 -2.551 0.360
  r 0.36
}

object {
  shader amber
  type sphere
  name marble13
  c -0.604 2.468 0.420
  r 0.42
}

object {
  shader blue
  type sphere
  name marble14
  c 1.128 0.092 0.420
  r 0.42
}

object {
  shader swirl
  transform {
    scale 0.36 0.36 -0.36
    rotatez 75
    rotatex 165
    translate 2.927 -0.359 0.360
  }
  type sphere
  name marble15
}

object {
  shader clear
  type sphere
  name marble16
  c -0.966 -2.702 0.360
  r 0.36
}

object {
  shader red
  type sphere
  name marble17
  c 1.812 1.885 0.420
  r 0.42
}

object {
  shader silver
  type sphere
  name marble18
  c 2.957 1.752 0.360
  r 0.36
}

object {
  shader sea
  type sphere
  name marble19
  c -2.794 -1.700 0.420
  r 0.42
}

object {
  shader swirl
  transform {
    scale 0.36 0.36 -0.36
    rotatez 340
    rotatex 160
    translate 1.822 -2.514 0.360
  }
  type sphere
  name marble20
}

object {
  shader gold
  type sphere
  name marble21
  c 2.834 -1.438 0.360
  r 0.36
}

object {
  shader cream
  type sphere
  name marble22
  c 1.749 2.848 0.500
  r 0.5
}

object {
  shader rose
  type sphere
  name marble23
  c -2.456 -2.712 0.420
  r 0.42
}

object {
  shader violet
  type sphere
  name marble24
  c 1.183 1.319 0.360
  r 0.36
}

object {
  shader swirl
  transform {
    scale 0.36 0.36 -0.36
    rotatez 245
    rotatex 155
    translate -1.850 2.910 0.360
  }
  type sphere
  name marble25
}

object {
  shader blue
  type sphere
  name marble26
  c -1.498 0.216 0.360
  r 0.36
}

object {
  shader clear
  type sphere
  name marble27
  c -0.350 0.550 1.632
  r 0.62
}
