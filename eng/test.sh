#!/usr/bin/env bash
# The README's test command, and its totals read from the result files. A test project that ran no test has failed.
set -euo pipefail
cd "$(dirname "$0")/.."

results=$PWD/artifacts/test-results
rm -rf "$results"
status=0
dotnet test --logger trx --results-directory "$results" || status=$?

# A number from the Counters element of a result file.
counter() {
    sed -n "s/.*<Counters.* $2=\"\([0-9]*\)\".*/\1/p" "$1"
}

passed=0
failed=0
for project in tests/*/*.csproj; do
    name=$(basename "$project" .csproj)
    file=$(grep -rlis "storage=\"[^\"]*/$name\.dll\"" "$results" | head -n 1 || true)
    executed=0
    [ -z "$file" ] || executed=$(counter "$file" executed)
    executed=${executed:-0}
    if [ "$executed" -eq 0 ]; then
        echo "$name: no test was run"
        failed=$((failed + 1))
        continue
    fi

    ok=$(counter "$file" passed)
    echo "$name: $ok of $executed passed, $(($(counter "$file" total) - executed)) skipped"
    passed=$((passed + ok))
    failed=$((failed + executed - ok))
done

echo "$passed passed, $failed failed"
[ $status -eq 0 ] && [ $failed -eq 0 ]
