#!/usr/bin/env bash
# How much faster than real time a simulated group of three is on one processor: with cameras, radio and ten targets.
# Runs UavConsole (Release) once for each seed, 1 to 5 unless they are named, on one processor; start and compilation
# included. The limit is ten times real time. Usage: eng/group-speed.sh [SEED...]
set -euo pipefail
cd "$(dirname "$0")/.."

limit=10
seeds=("$@")
[ ${#seeds[@]} -gt 0 ] || seeds=(1 2 3 4 5)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

dotnet build -c Release samples/UavConsole -v quiet -nologo -p:RunAnalyzers=false
program=$PWD/artifacts/bin/UavConsole/release/UavConsole.dll
slowest=
for seed in "${seeds[@]}"; do
    begin=$(date +%s.%N)
    (cd "$folder" && taskset -c 0 dotnet "$program" --vehicles 3 --targets 10 --seed "$seed" --headless --log "$seed.log" > "$seed.txt") ||
        { tail -n 3 "$folder/$seed.txt"; exit 1; }
    end=$(date +%s.%N)
    # The last line of the log: when the group ended, by its clock.
    flown=$(sed -n 's/^vehicle [0-9]*: *\([0-9.]*\) reactor: stops.*/\1/p' "$folder/$seed.log" | tail -n 1)
    ratio=$(awk -v flown="$flown" -v begin="$begin" -v end="$end" 'BEGIN { printf "%.1f", flown / (end - begin) }')
    printf 'seed %s: %s s flown, %s times real time; %s\n' "$seed" "$flown" "$ratio" "$(grep 'targets found' "$folder/$seed.txt")"
    slowest=$(printf '%s\n%s\n' "$ratio" "${slowest:-$ratio}" | sort -g | head -n 1)
done
echo "the slowest: $slowest times real time on one processor, at least $limit are wanted"
awk -v slowest="$slowest" -v limit="$limit" 'BEGIN { exit !(slowest >= limit) }'
