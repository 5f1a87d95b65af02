"""The speed of Rabit's detectors beside OpenCV's in the same pictures: for eng/vision-speed.sh.

In each round every side searches all pictures of a set, one side after the other and another one first each time: the
mean over the pictures of the shortest of a few times. The table has medians of the rounds, and of their ratios.
Pictures: those of tests/data/detection, or the whole sets where RABIT_VECTORS names their folder.
"""
import argparse
import json
import os
import statistics
import subprocess
import time

try:
    import cv2
    cv2.setNumThreads(1)
except ImportError:
    cv2 = None

# From one HSV to another one, inclusive; hue 0 to 179. Red goes through 0.
COLOURS = {
    "red": [((178, 162, 170), (179, 255, 255)), ((0, 162, 170), (2, 255, 255))],
    "magenta": [((154, 151, 158), (166, 255, 255))],
    "orange": [((10, 160, 201), (20, 255, 255))],
    "white": [((0, 0, 174), (179, 18, 255))],
    "yellow": [((25, 156, 177), (30, 255, 255))],
    "blue": [((110, 164, 185), (117, 255, 255))],
}

# What Rabit does, what OpenCV does for it, and how much of OpenCV's time the limit is.
ROWS = [
    ("shapes", "chain", 0.5),
    ("markers", "aruco 4x4_50", 0.6),
    ("markers", "aruco 36h11", 0.6),
    ("read-colour", None, None),
    ("read-grey", None, None),
]


class OpenCv:
    """OpenCV in this process."""

    def __init__(self):
        self.sets = {}
        self.parameters = cv2.aruco.DetectorParameters_create()
        self.operations = {
            "chain": lambda colour, grey: self.chain(colour),
            "aruco 4x4_50": self.marker_finder(cv2.aruco.DICT_4X4_50),
            "aruco 36h11": self.marker_finder(cv2.aruco.DICT_APRILTAG_36h11),
        }

    def marker_finder(self, family):
        dictionary = cv2.aruco.Dictionary_get(family)
        return lambda colour, grey: cv2.aruco.detectMarkers(grey, dictionary, parameters=self.parameters)

    def chain(self, colour):
        """HSV, a mask for each colour, its contours and their moments."""
        hsv = cv2.cvtColor(colour, cv2.COLOR_BGR2HSV)
        centres = []
        for ranges in COLOURS.values():
            mask = cv2.inRange(hsv, *ranges[0])
            for more in ranges[1:]:
                mask = cv2.bitwise_or(mask, cv2.inRange(hsv, *more), dst=mask)
            contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
            for contour in contours:
                if len(contour) >= 4:
                    moments = cv2.moments(contour)
                    if moments["m00"] >= 5:
                        centres.append((moments["m10"] / moments["m00"], moments["m01"] / moments["m00"]))
        return centres

    def ask(self, operation, folder, repeats):
        """Milliseconds a picture."""
        if folder not in self.sets:
            files = [os.path.join(folder, name) for name in names_of(folder)]
            self.sets[folder] = [(cv2.imread(f), cv2.imread(f, cv2.IMREAD_GRAYSCALE)) for f in files]
        work = self.operations[operation]
        total = 0
        for colour, grey in self.sets[folder]:
            shortest = float("inf")
            for _ in range(repeats):
                begin = time.perf_counter()
                work(colour, grey)
                shortest = min(shortest, time.perf_counter() - begin)
            total += shortest
        return 1000 * total / len(self.sets[folder]), 0


class Program:
    """Rabit.Vision.Speed in a process of its own."""

    def __init__(self, command):
        self.process = subprocess.Popen(
            command.split(), stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)

    def ask(self, operation, folder, repeats):
        """Milliseconds and bytes allocated a picture."""
        self.process.stdin.write(f"{operation} {folder} {repeats}\n")
        answer = self.process.stdout.readline().split()
        if len(answer) != 3:
            raise SystemExit(f"Rabit.Vision.Speed did not answer to {operation} {folder}")
        return float(answer[0]), float(answer[1])


def names_of(folder):
    with open(os.path.join(folder, "truth.json"), encoding="utf-8") as file:
        return [frame["file"] for frame in json.load(file)["frames"]]


def folders():
    root = os.environ.get("RABIT_VECTORS")
    if root:
        return [os.path.join(root, "imagery", name) for name in ("stills_640", "stills_1640")]
    data = os.path.join(os.path.dirname(__file__), "..", "tests", "data", "detection")
    return [os.path.relpath(os.path.join(data, name)) for name in ("stills", "stills_1640")]


def tasks_of(sides):
    """Who does what: each operation of each side once."""
    for operation, other, _ in ROWS:
        for side in sides:
            name = other if side == "OpenCV" else operation
            if name:
                yield side, name


def measure(sides, folder, rounds, repeats):
    """For each side and operation the times of the rounds, and the bytes of the last one."""
    tasks = list(dict.fromkeys(tasks_of(sides)))
    for _ in range(4):    # until the runtimes have made their best code
        for side, name in tasks:
            sides[side].ask(name, folder, repeats)
    times = {task: [] for task in tasks}
    allocated = {}
    for number in range(rounds):
        shift = number % len(tasks)
        for side, name in tasks[shift:] + tasks[:shift]:
            spent, allocated[side, name] = sides[side].ask(name, folder, repeats)
            times[side, name].append(spent)
    return times, allocated


def report(sides, folder, times, allocated):
    """Prints the table of a set; true where all is within its limits."""
    good = True
    print(f"\n{folder}, {len(names_of(folder))} pictures")
    for operation, other, limit in ROWS:
        theirs = times.get(("OpenCV", other))
        text = f"  {operation:<12}"
        if theirs:
            text += f" {other} {statistics.median(theirs):.2f} ms;"
        for side in sides:
            if side == "OpenCV":
                continue
            own = times[side, operation]
            text += f" {side} {statistics.median(own):.3f} ms"
            if theirs:
                ratio = statistics.median(a / b for a, b in zip(own, theirs))
                text += f", ratio {ratio:.2f}"
                good = good and (ratio <= limit or side != ".NET")
            text += f", {allocated[side, operation]:g} B;"
            good = good and allocated[side, operation] == 0
        print(text + (f" limit {limit}" if theirs else ""))
    return good


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--command", action="append", required=True, help="NAME=COMMAND of a runtime")
    parser.add_argument("--rounds", type=int, default=11)
    parser.add_argument("--repeats", type=int, default=3)
    options = parser.parse_args()
    sides = {}
    if cv2 is None:
        print("OpenCV is not measured: apt-get install python3-opencv")
    else:
        sides["OpenCV"] = OpenCv()
        print(f"OpenCV {cv2.__version__}")
    for command in options.command:
        name, _, words = command.partition("=")
        sides[name] = Program(words)
    print(f"{options.rounds} rounds, medians; load average before: {os.getloadavg()[0]:.1f}")
    good = True
    for folder in folders():
        times, allocated = measure(sides, folder, options.rounds, options.repeats)
        good = report(sides, folder, times, allocated) and good
    raise SystemExit(0 if good else 1)


main()
