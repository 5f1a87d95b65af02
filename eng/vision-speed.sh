#!/usr/bin/env bash
# Measures the detectors of colour and shape and of markers, .NET and Mono, beside those of OpenCV (python3-opencv,
# Debian), in one run, in turn, one thread each. Options: --rounds N. Exit code 1 where a ratio of .NET is above its
# limit, or memory is allocated.
set -euo pipefail
cd "$(dirname "$0")/.."

name=Rabit.Vision.Speed
commands=(--command ".NET=artifacts/bin/$name/release/$name")
dotnet build benchmarks/$name -c Release -v quiet
if command -v mono > /dev/null; then
    dotnet build benchmarks/$name -c Release -p:RabitMono=true -v quiet
    commands+=(--command "Mono=mono artifacts-mono/bin/$name/release/$name.exe")
fi
/usr/bin/python3 eng/vision-speed.py "${commands[@]}" "$@"
