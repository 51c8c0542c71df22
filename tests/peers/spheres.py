"""One scene in two languages: spheres and mirrors on a plane, under lights that fall off with the square of the distance."""

from math import pi

SIZE = 640, 480
EYE, TARGET, ANGLE = (0, -16, 9), (0, 0, 0.5), 40
# Colour, power, place.
LIGHTS = [((1, 0.95, 0.9), 2500, (8, -8, 12)), ((0.7, 0.8, 1), 1500, (-10, -5, 9)), ((1, 0.7, 0.6), 800, (0, 10, 8))]
FLOOR = (0.5, 0.5, 0.5)
MIRROR = 0.85


def spheres():
    """Centre, radius, colour or None for a mirror: 8 x 8 on the plane, the sizes and colours by a rule of three primes."""
    for number in range(64):
        x, y = number % 8, number // 8
        radius = 0.35 + 0.3 * (number * 37 % 64) / 64
        colour = tuple(0.1 + 0.8 * (number * prime % 64) / 64 for prime in (11, 23, 41))
        yield (1.45 * x - 5.075, 1.45 * y - 5.075, radius), radius, None if number % 5 == 2 else colour


def words(values):
    return " ".join(f"{value:.6g}" for value in values)


def sc():
    """For girasol and Sunflow. All colours are linear."""
    text = [f"image {{ resolution {SIZE[0]} {SIZE[1]} aa 2 2 filter box }}", "trace-depths { diff 1 refl 4 refr 4 }"]
    text.append(f"camera {{ type pinhole eye {words(EYE)} target {words(TARGET)} up 0 0 1 fov {ANGLE} aspect {SIZE[0] / SIZE[1]} }}")
    for colour, power, place in LIGHTS:
        text.append(f'light {{ type point color {{ "sRGB linear" {words(colour)} }} power {power} p {words(place)} }}')
    text.append(f"shader {{ name floor type diffuse diff {words(FLOOR)} }}")
    text.append(f"shader {{ name mirror type mirror refl {words([MIRROR] * 3)} }}")
    text.append("object { shader floor type plane p 0 0 0 n 0 0 1 }")
    for number, (centre, radius, colour) in enumerate(spheres()):
        shader = "mirror"
        if colour:
            shader = f"paint{number}"
            text.append(f"shader {{ name {shader} type diffuse diff {words(colour)} }}")
        text.append(f"object {{ shader {shader} type sphere name ball{number} c {words(centre)} r {radius:.6g} }}")
    return "\n".join(text) + "\n"


# POV-Ray's falloff is 2 / (1 + (d / fade_distance)^2): nearly the inverse square, where fade_distance is small.
FADE = 0.01


def pov():
    """For POV-Ray. Its mirrors fade to white at grazing angles by Schlick's formula, as Sunflow's do."""

    def vector(values):
        return "<" + ", ".join(f"{value:.6g}" for value in values) + ">"

    text = ["#version 3.7;", "global_settings { assumed_gamma 1.0 max_trace_level 5 }"]
    text.append(
        f"camera {{ location {vector(EYE)} sky <0, 0, 1> up <0, 0, 1> right <{-SIZE[0] / SIZE[1]:.6g}, 0, 0> "
        f"angle {ANGLE} look_at {vector(TARGET)} }}"
    )
    for colour, power, place in LIGHTS:
        # Sunflow: colour * power * cos / (4 pi^2 d^2).
        scale = power / (4 * pi**2) / (2 * FADE**2)
        light = vector(value * scale for value in colour)
        text.append(f"light_source {{ {vector(place)} rgb {light} fade_distance {FADE} fade_power 2 }}")
    matt = "finish { ambient 0 diffuse 1 }"
    text.append(f"plane {{ <0, 0, 1>, 0 pigment {{ rgb {vector(FLOOR)} }} {matt} }}")
    mirror = f"pigment {{ rgb 0 }} finish {{ ambient 0 diffuse 0 reflection {{ rgb {MIRROR}, rgb 1 falloff 5 }} }}"
    for centre, radius, colour in spheres():
        surface = f"pigment {{ rgb {vector(colour)} }} {matt}" if colour else mirror
        text.append(f"sphere {{ {vector(centre)}, {radius:.6g} {surface} }}")
    return "\n".join(text) + "\n"
