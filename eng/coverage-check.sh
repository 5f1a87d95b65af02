#!/usr/bin/env bash
# How much of Rabit.Core its own tests reach: lines and branches, against the least that is allowed. The files that have
# lines left are listed. Needs a build of tests/Rabit.Core.Tests.
set -euo pipefail
cd "$(dirname "$0")/.."

least_lines=97
least_branches=92
results=$PWD/artifacts/coverage
rm -rf "$results"

dotnet test tests/Rabit.Core.Tests --no-build -s tests/coverage.runsettings --collect "XPlat Code Coverage" --results-directory "$results"
report=$(find "$results" -name coverage.cobertura.xml)

sed -n 's/.*<class name="\([^"]*\)".*line-rate="\([0-9.]*\)" branch-rate="\([0-9.]*\)".*/\2 \3 \1/p' "$report" |
    awk '$1 < 1 || $2 < 1 { printf "%5.1f %% of lines, %5.1f %% of branches: %s\n", $1 * 100, $2 * 100, $3 }' | sort -n

percent() {
    sed -n "1,3s/.*<coverage.* $1=\"\([0-9.]*\)\".*/\1/p" "$report" | awk '{ printf "%.2f", $1 * 100 }'
}

lines=$(percent line-rate)
branches=$(percent branch-rate)
echo "Rabit.Core: $lines % of lines (at least $least_lines), $branches % of branches (at least $least_branches)"
awk -v l="$lines" -v b="$branches" -v ll=$least_lines -v lb=$least_branches 'BEGIN { exit !(l >= ll && b >= lb) }'
