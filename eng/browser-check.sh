#!/usr/bin/env bash
# The live page in a headless Chromium: the tests that follow simulated flights in a browser. They are longer tests;
# here they are executed for themselves, since nothing else looks at the page as a user does.
# Ends with "N passed, N failed".
set -euo pipefail
cd "$(dirname "$0")/.."

results=$PWD/artifacts/browser-results
rm -rf "$results"
status=0
dotnet test tests/Rabit.Uav.Web.Tests -s tests/long.runsettings --no-build --logger trx \
    --results-directory "$results" || status=$?

counter() {
    sed -n "s/.*<Counters.* $1=\"\([0-9]*\)\".*/\1/p" "$results"/*.trx
}

executed=$(counter executed)
passed=$(counter passed)
if [ "${executed:-0}" -eq 0 ]; then
    echo "no test was executed: is Chromium installed?"
    echo "0 passed, 1 failed"
    exit 1
fi

echo "$passed passed, $((executed - passed)) failed"
[ $status -eq 0 ]
