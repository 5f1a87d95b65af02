#!/usr/bin/env bash
# The plain tests beside a load generator: as many busy processes as the load average is to be (20); they end with the
# script. eng/load-check.sh [--load N] [--at-once] [PROJECT and other arguments of dotnet test]; --at-once does not wait
# until the load is there.
# Prints the load average that was seen while the tests ran, and the result.
set -euo pipefail
cd "$(dirname "$0")/.."

load=20
waits=yes
while [ $# -gt 0 ]; do
    case $1 in
        --load) load=$2; shift 2 ;;
        --at-once) waits=no; shift ;;
        *) break ;;
    esac
done

# Built before, not beside the load: what is asked is whether the tests pass.
dotnet build -v quiet -nologo ${1:+"$1"}

seen=$(mktemp)
children=()
end_all() {
    [ ${#children[@]} -eq 0 ] || kill "${children[@]}" 2>/dev/null || true
    rm -f "$seen"
}
trap end_all EXIT

for _ in $(seq "$load"); do
    (trap - EXIT; while :; do :; done) &
    children+=($!)
done

# The average of a minute: it takes some three to rise.
average() { cut -d ' ' -f 1 /proc/loadavg; }
reaches() { awk -v seen="$(average)" -v load="$load" 'BEGIN { exit !(seen >= 0.95 * load) }'; }
if [ $waits = yes ]; then
    for _ in $(seq 60); do
        ! reaches || break
        sleep 5
    done
    reaches || { echo "the load average is $(average) after five minutes, not $load"; exit 1; }
fi

(trap - EXIT; while :; do average >> "$seen"; sleep 5; done) &
children+=($!)

status=0
if [ $# -eq 0 ]; then
    eng/test.sh || status=$?
else
    dotnet test --no-build "$@" || status=$?
fi

average >> "$seen"
sort -n "$seen" | awk '{ v[NR] = $1; sum += $1 }
    END { printf "load average beside the tests: %s to %s, %.1f in the mean\n", v[1], v[NR], sum / NR }'
[ $status -eq 0 ] && echo "the tests passed" || echo "the tests FAILED"
exit $status
