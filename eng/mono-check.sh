#!/usr/bin/env bash
# Rabit under Mono: builds tests, samples and the tool for net472 (into artifacts-mono/), runs every test project but the longer
# tests, several projects at a time, and compares what the samples and the tool print with what they print under .NET.
# Needs a build of Rabit.sln for .NET, which it leaves alone: other checks may run at the same time.
# Ends with one line, "N passed, N failed": each test and each comparison counts as one.
set -euo pipefail
cd "$(dirname "$0")/.."

# Recorded flights (tests/data/mavlink/NAME.tlog) that UavConsole replays on both runtimes, to the same summary.
flights=(ardupilot-flight px4-flight)

# The test projects that run longest.
longest=(Rabit.Uav.Tests Rabit.Uav.Simulation.Tests UavConsole.Tests Rabit.Core.Tests)

results=artifacts-mono/results
passed=0
failed=0
rm -rf "$results"
mkdir -p "$results"
export LC_ALL=C.UTF-8   # Mono formats numbers by the locale; the samples are compared with the invariant one

if ! command -v mono > /dev/null; then
    echo "Mono is not installed: eng/install-tools.sh installs it." >&2
    exit 1
fi

# One check: a name, then the command that must succeed.
check() {
    local name=$1
    shift
    if "$@"; then
        echo "$name: ok"
        passed=$((passed + 1))
    else
        echo "$name: FAILED"
        failed=$((failed + 1))
    fi
}

# Those of the given projects that run on Mono: all but those whose file says no (the tests of the documents need a
# compiler, which does not). To ask MSBuild for each takes a second.
that_run_on_mono() {
    grep -L '<RabitRunsOnMono>false</RabitRunsOnMono>' "$@"
}

# All at once: one by one, each build looks at all that it refers to again.
build_for_mono() {
    local filter=artifacts-mono/mono.slnf
    printf '"%s",' "$@" | sed 's/.*/{ "solution": { "path": "..\/Rabit.sln", "projects": [&] } }/; s/,\]/]/' > $filter
    dotnet build $filter -p:RabitMono=true -v quiet
}

# Runs a test project with xunit's console runner and adds up its result file. The runner is put beside the tests, so that
# the base directory is theirs, and needs no second application domain, whose end would wait for every thread.
run_tests() {
    local name=$1 assembly=artifacts-mono/bin/$1/debug/$1.dll
    cp "$xunit_folder"/xunit.* "$(dirname "$assembly")"
    mono "$(dirname "$assembly")/xunit.console.exe" "$assembly" \
        -noappdomain -nologo -notrait Category=Long -xml "$results/$name.xml" > "$results/$name.txt" 2>&1 || true
}

# Adds up the result file of a test project. One that ran no test has failed.
count_tests() {
    local name=$1 file=$results/$1.xml total ok
    cat "$results/$name.txt"
    total=$(attribute "$file" total)
    ok=$(attribute "$file" passed)
    if [ $((total - $(attribute "$file" skipped))) -le 0 ]; then
        echo "$name: no test was run"
        failed=$((failed + 1))
        return
    fi
    passed=$((passed + ok))
    failed=$((failed + $(attribute "$file" failed) + $(attribute "$file" errors)))
}

# A number of the assembly element of an xunit result file; 0 when the run did not get that far.
attribute() {
    local number
    number=$(grep -s -m 1 '<assembly ' "$1" | sed -n "s/.* $2=\"\([0-9]*\)\".*/\1/p") || true
    echo "${number:-0}"
}

# The steps of a comparison are joined by &&: what an "if" calls does not stop at an error by itself.
prints_the_same() {
    local name=$1
    shift
    dotnet "artifacts/bin/$name/debug/$name.dll" "$@" > "$results/$name.net.txt" &&
    mono "artifacts-mono/bin/$name/debug/$name.exe" "$@" > "$results/$name.mono.txt" &&
    diff -u "$results/$name.net.txt" "$results/$name.mono.txt"
}

# A search over seeds that finds its planted bug, and the event log of the seed that it names: exit code 1 is its success.
order_bug_is_the_same() {
    local option runtime status
    for option in "--seeds 1000" "--seed 24"; do
        for runtime in net mono; do
            status=0
            # shellcheck disable=SC2086 # an option and its value
            if [ $runtime = net ]; then
                dotnet artifacts/bin/OrderBugSearch/debug/OrderBugSearch.dll $option
            else
                mono artifacts-mono/bin/OrderBugSearch/debug/OrderBugSearch.exe $option
            fi > "$results/order-bug.$runtime.txt" || status=$?
            if [ $status -ne 1 ] || ! grep -q '^seed 24 fails' "$results/order-bug.$runtime.txt"; then
                echo "OrderBugSearch $option under $runtime does not name seed 24 (exit code $status)"
                return 1
            fi
        done
        diff -u "$results/order-bug.net.txt" "$results/order-bug.mono.txt" || return 1
    done
}

flight_is_the_same() {
    local link="tlog:tests/data/mavlink/$1.tlog?speed=max"
    dotnet artifacts/bin/UavConsole/debug/UavConsole.dll --link "$link" --headless --summary "$results/$1.net.json" > "$results/$1.net.txt" &&
    mono artifacts-mono/bin/UavConsole/debug/UavConsole.exe \
        --link "$link" --headless --summary "$results/$1.mono.json" > "$results/$1.mono.txt" &&
    diff -u "$results/$1.net.json" "$results/$1.mono.json"
}

# The simulated search: the same log to the byte; by the summary the same steps and targets.
search_is_the_same() {
    dotnet artifacts/bin/UavConsole/debug/UavConsole.dll --seed 3 --headless --log "$results/search.net.log" \
        --summary "$results/search.net.json" --report "$results/search.net.html" > "$results/search.net.txt" &&
    mono artifacts-mono/bin/UavConsole/debug/UavConsole.exe --seed 3 --headless --log "$results/search.mono.log" \
        --summary "$results/search.mono.json" --report "$results/search.mono.html" > "$results/search.mono.txt" &&
    diff -u "$results"/search.{net,mono}.log &&
    dotnet run eng/compare-searches.cs -- "$results"/search.net.{log,json} "$results"/search.mono.{log,json}
}

# Two vehicles that divide lanes and validate each other's targets: the same log to the byte, with each decision, its
# numbers and how often each manager ran.
group_search_is_the_same() {
    local seed=$1 into=$results/group-$1
    local options=(--vehicles 2 --seed "$seed" --targets 3 --mission tests/data/missions/group.json --headless)
    dotnet artifacts/bin/UavConsole/debug/UavConsole.dll "${options[@]}" --log "$into.net.log" \
        --report "$into.net.html" > "$into.net.txt" &&
    mono artifacts-mono/bin/UavConsole/debug/UavConsole.exe "${options[@]}" --log "$into.mono.log" \
        --report "$into.mono.html" > "$into.mono.txt" &&
    diff -u "$into.net.log" "$into.mono.log"
}

# The figures of a quick run say nothing; that every mode works does, of the build that is there.
latencies_work() {
    mono artifacts-mono/bin/Rabit.Latency/debug/Rabit.Latency.exe --quick > "$results/latency.txt"
}

mapfile -t tests < <(that_run_on_mono tests/*/*.csproj)
mapfile -t programs < <(that_run_on_mono samples/*/*.csproj src/Rabit.Tool/Rabit.Tool.csproj benchmarks/Rabit.Latency/Rabit.Latency.csproj)
check "build for Mono" build_for_mono "${tests[@]}" "${programs[@]}"
if [ $failed -ne 0 ]; then
    echo "0 passed, 1 failed"
    exit 1
fi
xunit_folder=$(dirname "$(dotnet msbuild "${tests[0]}" -p:RabitMono=true -getProperty:XunitConsole472Path)")
names=()
for project in "${tests[@]}"; do
    names+=("$(basename "$project" .csproj)")
done

# As many at a time as there are processors, the longest first: by itself one leaves a processor idle much of the time.
for name in $(printf '%s\n' "${longest[@]}" "${names[@]}" | awk '!seen[$0]++'); do
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do
        wait -n || true
    done
    run_tests "$name" &
done
wait
for name in "${names[@]}"; do
    count_tests "$name"
done

check "Rabit.Latency works" latencies_work
check "the small samples print what they should" eng/samples-check.sh --mono
check "CustomDialect prints the same" prints_the_same CustomDialect
check "Wheelchair prints the same" prints_the_same Wheelchair --virtual
check "OrderBugSearch finds the same" order_bug_is_the_same
check "rabit mavlink prints the same" prints_the_same Rabit.Tool mavlink tests/data/mavlink/px4-flight.tlog
check "rabit mavlink prints the same values" prints_the_same Rabit.Tool mavlink tests/data/mavlink/px4-flight.tlog --print
check "rabit mavlink prints the same JSON" prints_the_same Rabit.Tool mavlink tests/data/mavlink/ardupilot-flight.tlog --json
for flight in "${flights[@]}"; do
    check "the summary of $flight is the same" flight_is_the_same "$flight"
done
check "the simulated search is the same" search_is_the_same
check "the simulated search of a group is the same" group_search_is_the_same 4
check "the simulated search of another group is the same" group_search_is_the_same 2

echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
