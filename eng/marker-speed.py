"""OpenCV's marker detector on the still pictures of tests/data/markers, one thread: the median of a pass, ms a picture.

For eng/marker-speed.sh; needs python3-opencv (Debian).
"""
import glob
import os
import time

import cv2

cv2.setNumThreads(1)
FOLDER = os.path.join(os.path.dirname(__file__), "..", "tests", "data", "markers")
FAMILIES = (("4x4_50", cv2.aruco.DICT_4X4_50), ("36h11", cv2.aruco.DICT_APRILTAG_36h11))

for pictures in ("stills_640", "stills_1640"):
    grey = [cv2.imread(path, cv2.IMREAD_GRAYSCALE) for path in sorted(glob.glob(f"{FOLDER}/{pictures}_*.jpg"))]
    for name, family in FAMILIES:
        dictionary = cv2.aruco.Dictionary_get(family)
        parameters = cv2.aruco.DetectorParameters_create()
        times = []
        for _ in range(15):
            begin = time.perf_counter()
            for picture in grey:
                cv2.aruco.detectMarkers(picture, dictionary, parameters=parameters)
            times.append((time.perf_counter() - begin) * 1000 / len(grey))
        print(f"OpenCV {cv2.__version__} {name}, {pictures}: {sorted(times)[len(times) // 2]:.2f} ms")
