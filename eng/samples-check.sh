#!/usr/bin/env bash
# The small samples print what their expected.txt says. Each line of the table: a sample and its arguments.
# Needs a build of Rabit.sln; with --mono those for Mono run instead. Ends with one line, "N passed, N failed".
set -euo pipefail
cd "$(dirname "$0")/.."

runtime=${1:-net}
out=artifacts/samples-check/${runtime#--}
mkdir -p "$out"
passed=0
failed=0
export LC_ALL=C.UTF-8

run() {
    local name=$1
    shift
    if [ "$runtime" = --mono ]; then
        exec mono "artifacts-mono/bin/$name/debug/$name.exe" "$@"
    else
        exec dotnet "artifacts/bin/$name/debug/$name.dll" "$@"
    fi
}

check() {
    local name=$1
    shift
    (run "$name" "$@") > "$out/$name.txt" && diff -u "samples/$name/expected.txt" "$out/$name.txt" && ok=1 || ok=0
    if [ $ok -eq 1 ]; then
        echo "$name: ok"
        passed=$((passed + 1))
    else
        echo "$name: FAILED"
        failed=$((failed + 1))
    fi
}

# SerialSensor on a pair of pseudo terminals that goes and comes back, under a name that stays.
check_serial_sensor() {
    local folder ok=0
    if ! command -v socat > /dev/null; then
        echo "SerialSensor: skipped, socat is not installed (eng/install-tools.sh installs it)"
        return
    fi
    folder=$(mktemp -d)
    run SerialSensor "serial:$folder/sensor:115200" > "$out/SerialSensor.txt" &
    local sensor=$!
    plug "$folder/sensor" 1.25 noise 2.5
    plug "$folder/sensor" 3.75
    kill -TERM $sensor
    wait $sensor && diff -u samples/SerialSensor/expected.txt "$out/SerialSensor.txt" && ok=1
    rm -r "$folder"
    if [ $ok -eq 1 ]; then
        echo "SerialSensor: ok"
        passed=$((passed + 1))
    else
        echo "SerialSensor: FAILED"
        failed=$((failed + 1))
    fi
}

# Plugs a device in, sends lines, waits until the sample has printed the last one, and pulls it out.
plug() {
    local device=$1 last=unplugged count
    shift
    count=$(grep -c "$last" "$out/SerialSensor.txt" || true)
    (await "plugged in" $((count + 1)); printf '%s\n' "$@"; await "${!#} m" 1) | socat -u - "pty,raw,echo=0,link=$device"
    await "$last" $((count + 1))
}

# Waits until a line was printed so many times, at most 20 s.
await() {
    local text=$1 times=$2
    for _ in $(seq 200); do
        if [ "$(grep -cx "$text" "$out/SerialSensor.txt")" -ge "$times" ]; then return; fi
        sleep 0.1
    done
    echo "SerialSensor did not print '$text'" >&2
}

flight='tlog:tests/data/mavlink/ardupilot-flight.tlog?speed=max'
check HelloRabit
check WatchVehicle "$flight"
check BatteryAlarm "$flight" 99
check SimulatedSearch
check OwnMavlinkMessage
check OwnDetector
check_serial_sensor

echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
