#!/usr/bin/env bash
# Measures finding markers, in one run: OpenCV's detector (python3-opencv, Debian) for one family, Rabit's for both, .NET
# and Mono, on the still pictures of tests/data/markers, one thread each.
set -euo pipefail
cd "$(dirname "$0")/.."

dotnet build tests/Rabit.Vision.Tests -c Release -v quiet
/usr/bin/python3 eng/marker-speed.py || echo "OpenCV was not measured: apt-get install python3-opencv"
dotnet test tests/Rabit.Vision.Tests -c Release --no-build --filter "FullyQualifiedName~MarkerSpeed" \
    --logger "console;verbosity=detailed" -e RABIT_MARKER_SPEED=1 | grep "Rabit, "
