#!/usr/bin/env bash
# Rabit.Mavlink against node-mavlink, an independent library: 1000 frames of ours are read by it and 1000 of its frames by us, half of them
# signed, and both are timed over one recorded flight. Needs node and npm; where they are missing, or npm cannot fetch the package, it says so
# and nothing is checked. Fails where the two disagree, or where we are not 20 times as fast.
set -euo pipefail
cd "$(dirname "$0")/.."

if ! command -v node > /dev/null || ! command -v npm > /dev/null; then
    echo "skipped: node and npm are not installed, so that nothing was compared with node-mavlink"
    exit 0
fi

work=$PWD/artifacts/node-mavlink-check
golden=$PWD/tests/data/mavlink/golden.jsonl
mkdir -p "$work"
cp eng/node-mavlink-check/package.json eng/node-mavlink-check/check.mjs "$work"
if ! [ -d "$work/node_modules/node-mavlink" ] && ! (cd "$work" && npm install --no-audit --no-fund > npm.log 2>&1); then
    echo "skipped: npm could not fetch node-mavlink ($work/npm.log says why), so that nothing was compared with it"
    exit 0
fi

dotnet build -c Release -v quiet eng/node-mavlink-check -p:RunAnalyzers=false
check() {
    dotnet artifacts/bin/NodeMavlinkCheck/release/NodeMavlinkCheck.dll "$@"
}
check write "$work" "$golden" tests/data/mavlink/px4-flight.tlog
(cd "$work" && node check.mjs "$work" "$golden")
check compare "$work" "$golden"
