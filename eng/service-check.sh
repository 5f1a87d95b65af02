#!/usr/bin/env bash
# The unit files of the samples are what systemd understands. (That the service of one of them notifies it is a test, in
# tests/UavService.Tests.) Ends with one line, "N passed, N failed".
set -euo pipefail
cd "$(dirname "$0")/.."

out=artifacts/service-check
rm -rf "$out"
mkdir -p "$out"
passed=0
failed=0

if ! command -v systemd-analyze > /dev/null; then
    echo "systemd-analyze is not installed: eng/install-tools.sh installs it." >&2
    echo "0 passed, 1 failed"
    exit 1
fi

# On a copy with a program that is there: the one that is meant is where the user puts it. A key that is not known is
# a warning for systemd, and a fault here; what it says of other units of this machine is not asked for.
for unit in samples/*/*.service; do
    name=$(basename "$unit")
    sed -E 's#^(Exec[A-Za-z]*=)[^ ]+#\1/bin/true#' "$unit" > "$out/$name"
    systemd-analyze verify --man=no --recursive-errors=no "$out/$name" > "$out/$name.txt" 2>&1 && status=0 || status=$?
    if [ $status -eq 0 ] && ! grep -qF "$name" "$out/$name.txt"; then
        echo "$unit: ok"
        passed=$((passed + 1))
    else
        cat "$out/$name.txt"
        echo "$unit: FAILED"
        failed=$((failed + 1))
    fi
done

echo "$passed passed, $failed failed"
[ $failed -eq 0 ] && [ $passed -gt 0 ]
