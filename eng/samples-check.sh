#!/usr/bin/env bash
# The small samples print what their expected.txt says. Each line of the table: a sample and its arguments.
# With --mono the builds for Mono run instead (they must be there). Ends with one line, "N passed, N failed".
set -euo pipefail
cd "$(dirname "$0")/.."

runtime=${1:-net}
out=artifacts/samples-check
mkdir -p "$out"
passed=0
failed=0
export LC_ALL=C.UTF-8

check() {
    local name=$1
    shift
    if [ "$runtime" = --mono ]; then
        mono "artifacts-mono/bin/$name/debug/$name.exe" "$@" > "$out/$name.txt"
    else
        dotnet run --project "samples/$name" -- "$@" > "$out/$name.txt"
    fi && diff -u "samples/$name/expected.txt" "$out/$name.txt" && ok=1 || ok=0
    if [ $ok -eq 1 ]; then
        echo "$name: ok"
        passed=$((passed + 1))
    else
        echo "$name: FAILED"
        failed=$((failed + 1))
    fi
}

flight='tlog:tests/data/mavlink/ardupilot-flight.tlog?speed=max'
check HelloRabit
check WatchVehicle "$flight"
check BatteryAlarm "$flight" 99
check SimulatedSearch
check OwnMavlinkMessage
check OwnDetector

echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
