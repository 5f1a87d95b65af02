#!/usr/bin/env python3
"""Writes lenses.json: pixels of random directions by OpenCV (Debian: python3-opencv 4.6), for ten cameras of each lens."""
import json
import os
import cv2
import numpy

SEED = 20261123
random = numpy.random.default_rng(SEED)


def pinhole():
    width, height = int(random.integers(320, 4000)), int(random.integers(240, 3000))
    focal = width * random.uniform(0.5, 1.2)
    return {
        "width": width, "height": height, "fx": focal, "fy": focal * random.uniform(0.98, 1.02),
        "cx": width * random.uniform(0.45, 0.55), "cy": height * random.uniform(0.45, 0.55),
    }


def matrix(c):
    return numpy.array([[c["fx"], 0, c["cx"]], [0, c["fy"], c["cy"]], [0, 0, 1]])


def directions(max_degrees):
    out = []
    for _ in range(10):
        theta, phi = numpy.radians(random.uniform(0, max_degrees)), random.uniform(0, 2 * numpy.pi)
        distance = random.uniform(1, 200)
        out.append([distance * numpy.sin(theta) * numpy.cos(phi), distance * numpy.sin(theta) * numpy.sin(phi),
                    distance * numpy.cos(theta)])
    return out


def rational():
    c = pinhole()
    # A moderate lens, and as calibrations give it, two parts that nearly cancel.
    k4, k5, k6 = random.uniform(0, 0.6), random.uniform(0, 0.2), random.uniform(0, 0.02)
    c["k"] = [k4 + random.uniform(-0.3, 0.02), k5 + random.uniform(-0.02, 0.05), random.uniform(-1e-3, 1e-3),
              random.uniform(-1e-3, 1e-3), k6 + random.uniform(0, 0.01), k4, k5, k6]
    points = directions(40)
    pixels, _ = cv2.projectPoints(
        numpy.array(points), numpy.zeros(3), numpy.zeros(3), matrix(c), numpy.array(c["k"]))
    return {**c, "points": [[*p, *q] for p, q in zip(points, pixels.reshape(-1, 2).tolist())]}


def fisheye():
    c = pinhole()
    c["fx"] = c["width"] / numpy.radians(random.uniform(120, 175))
    c["fy"] = c["fx"] * random.uniform(0.98, 1.02)
    c["k"] = [random.uniform(-0.05, 0.05), random.uniform(-0.01, 0.01), random.uniform(-0.003, 0.003),
              random.uniform(-0.0005, 0.0005)]
    points = directions(85)
    pixels, _ = cv2.fisheye.projectPoints(
        numpy.array([points]), numpy.zeros(3), numpy.zeros(3), matrix(c), numpy.array(c["k"]))
    return {**c, "points": [[*p, *q] for p, q in zip(points, pixels.reshape(-1, 2).tolist())]}


lenses = {
    "what": "points: x, y, z in the axes of the camera, then column, row; k in OpenCV's order",
    "opencv": cv2.__version__, "seed": SEED,
    "rational": [rational() for _ in range(10)], "fisheye": [fisheye() for _ in range(10)],
}
with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "lenses.json"), "w") as file:
    json.dump(lenses, file, indent=None)
    file.write("\n")
