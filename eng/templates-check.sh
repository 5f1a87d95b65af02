#!/usr/bin/env bash
# The templates as users get them: with an empty home folder (eng/empty-home.sh) installs Rabit.Templates, makes a project of
# each template in an empty folder, builds it and runs its tests, and prints how many seconds that took. Then the programs
# themselves, and the unit file. --pack makes the packages first. Ends with one line, "N passed, N failed".
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
logs=$PWD/artifacts/templates-check
rm -rf "$logs"
mkdir -p "$logs"
source eng/empty-home.sh
need_packages "${1:-}"
passed=0
failed=0
cd "$work"

# One check: a name, then the command that must succeed, with -e inside. What it printed is shown where it fails.
check() {
    local name=$1 log="$logs/${1// /-}.txt" started=$SECONDS status
    shift
    set +e   # in a condition, -e would have no effect inside
    (set -e; "$@") > "$log" 2>&1
    status=$?
    set -e
    if [ $status -eq 0 ]; then
        echo "$name: ok, $((SECONDS - started)) s"
        passed=$((passed + 1))
    else
        cat "$log"
        echo "$name: FAILED"
        failed=$((failed + 1))
    fi
}

# That no line of files matches.
absent() {
    if grep -E "$@"; then
        echo "should not be there" >&2
        return 1
    fi
}

install() {
    dotnet nuget add source "$packages" --name rabit-local
    dotnet new install Rabit.Templates
}

# From an empty folder to a passing test. The name has what a namespace cannot have.
make_and_test() {
    local template=$1 name=$2
    dotnet new "$template" -n "$name"
    absent '(Greenhouse|Observer|Companion)(\.|_*)1' -r "$name"
    dotnet test "$name" | tee test.txt
    grep -q '^Passed!' test.txt
}

run_rabit() {
    dotnet run --project my-house/my-house -- --virtual > printed.txt
    cat printed.txt
    grep -q 'degrees, window closes$' printed.txt
}

run_rabit_uav() {
    dotnet run --project my-watch/my-watch -- "tlog:$root/tests/data/mavlink/ardupilot-flight.tlog?speed=max" > printed.txt
    cat printed.txt
    grep -q 'Ardupilotmega RTL armed' printed.txt
}

# Starts up and stops in order; wrong settings are a line each.
run_rabit_service() {
    local program=$PWD/my-service/my-service/bin/Debug/net10.0 status=0 socket
    cd "$program"
    dotnet my-service.dll --Uav:Links:0 udpout:127.0.0.1:9 > "$work/printed.txt" 2>&1 &
    socket=$XDG_RUNTIME_DIR/rabit/my-service-$!.sock   # of its diagnostics, the last thing that is opened
    for _ in $(seq 600); do
        if [ -S "$socket" ]; then break; fi
        sleep 0.1
    done
    [ -S "$socket" ]
    kill -TERM $!
    wait $! || status=$?
    cat "$work/printed.txt"
    grep -q 'starts communications, .*battery alarm' "$work/printed.txt"
    [ $status -eq 0 ]

    status=0
    dotnet my-service.dll --Uav:Helth 1 > "$work/printed.txt" 2>&1 || status=$?
    cat "$work/printed.txt"
    [ $status -eq 2 ]
    grep -q '^- Uav:Helth is not known' "$work/printed.txt"
    absent '^   at ' "$work/printed.txt"
}

# On a copy with a program that is there; a key that is not known is a warning for systemd, and a fault here.
verify_unit() {
    local unit=$work/my-service.service
    sed -E 's#^(Exec[A-Za-z]*=)[^ ]+#\1/bin/true#' my-service/my-service/my-service.service > "$unit"
    systemd-analyze verify --man=no --recursive-errors=no "$unit" 2>&1 | tee verified.txt
    absent 'my-service\.service' verified.txt
}

check "install" install
check "rabit" make_and_test rabit my-house
check "rabit-uav" make_and_test rabit-uav my-watch
check "rabit-service" make_and_test rabit-service my-service
check "run rabit" run_rabit
check "run rabit-uav" run_rabit_uav
check "run rabit-service" run_rabit_service
if command -v systemd-analyze > /dev/null; then
    check "unit of rabit-service" verify_unit
else
    echo "unit of rabit-service: skipped, systemd-analyze is not installed (eng/install-tools.sh installs it)"
fi
check "restored packages" compare_restored "$packages"

echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
