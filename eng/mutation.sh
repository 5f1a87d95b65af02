#!/usr/bin/env bash
# Mutation testing of the managers, messages and queues of Rabit.Core (docs/concepts/mutation-testing.md; the folders are
# in eng/stryker-config.json). Stryker makes the mutants and compiles them into one assembly, which is kept; eng/mutation-run.cs runs them. Usage: eng/mutation.sh [SEED [COUNT]]
set -euo pipefail
cd "$(dirname "$0")/.."
seed=${1:-1}
count=${2:-600}
out=$PWD/artifacts/mutation
bin=artifacts/bin/Rabit.Core.Tests/debug

rm -rf "$out" && mkdir -p "$out"
dotnet tool restore
dotnet build tests/Rabit.Core.Tests

# Stryker puts the assembly back when it ends, so it is taken while a few tests run that hardly reach these folders.
(cd tests/Rabit.Core.Tests && dotnet stryker -f ../../eng/stryker-config.json --skip-version-check -O "$out") > "$out/stryker.log" 2>&1 &
stryker=$!
until grep -q 'mutants will be tested' "$out/stryker.log"; do
    kill -0 "$stryker" || { tail -n 20 "$out/stryker.log" >&2; exit 1; }
    sleep 0.2
done
cp -r "$bin" "$out/bin"
wait "$stryker" || true   # its score is that of those few tests
grep -q MutantControl "$out/bin/Rabit.Core.dll"

dotnet run eng/mutation-run.cs -- "$out/reports/mutation-report.json" "$out/bin/Rabit.Core.Tests.dll" "$seed" "$count" | tee "$out/mutants.txt"
