#!/usr/bin/env bash
# docs/ground-stations.md against node-mavlink, an independent library: UavConsole flies "rabit simulate", two processes with UDP between them,
# and a station of node-mavlink lists and sets the parameters of component 191, commands it and uploads a fence to it. Two more, at once, connect to
# UavConsole as to a vehicle and do with the autopilot what stock ground stations do. Needs a build of Rabit.sln, node and npm; where these two
# are missing, or npm cannot fetch the package, it says so and nothing is checked.
set -euo pipefail
cd "$(dirname "$0")/.."

if ! command -v node > /dev/null || ! command -v npm > /dev/null; then
    echo "skipped: node and npm are not installed, so that no ground station of node-mavlink was tried"
    exit 0
fi

packages=$PWD/artifacts/node-mavlink-check
mkdir -p "$packages"
cp eng/node-mavlink-check/package.json eng/node-mavlink-check/*.mjs "$packages"

# What was fetched before may be half of it: it is used only where it can be loaded.
loads() { (cd "$packages" && node --input-type=module -e 'const { default: m } = await import("node-mavlink"); new m.common.ParamSet()' > /dev/null 2>&1); }
if ! loads; then
    rm -rf "$packages/node_modules"
    if ! (cd "$packages" && npm install --no-audit --no-fund > npm.log 2>&1) || ! loads; then
        echo "skipped: npm could not fetch node-mavlink ($packages/npm.log says why), so that no ground station of it was tried"
        exit 0
    fi
fi

work=$(mktemp -d)
vehicle="" console=""
end() {
    [ -z "$console" ] || kill "$console" 2> /dev/null || true
    [ -z "$vehicle" ] || kill "$vehicle" 2> /dev/null || true
    wait 2> /dev/null || true
    rm -rf "$work"
}
trap end EXIT

# Three free ports.
read -r port station stations < <(node -e '
  const dgram = require("dgram"), sockets = [1, 2, 3].map(() => dgram.createSocket("udp4"))
  let left = 3
  sockets.forEach(s => s.bind(0, "127.0.0.1", () => { if (--left === 0) { console.log(sockets.map(s => s.address().port).join(" ")); sockets.forEach(s => s.close()) } }))')
mission=$PWD/samples/UavConsole/missions/search.json
root=$PWD
cd "$work"
dotnet "$root/artifacts/bin/Rabit.Tool/debug/Rabit.Tool.dll" simulate --link "udpout:127.0.0.1:$port" --mission "$mission" > vehicle.txt 2>&1 &
vehicle=$!
dotnet "$root/artifacts/bin/UavConsole/debug/UavConsole.dll" --link "udpin:127.0.0.1:$port" --link "udpout:127.0.0.1:$station" --link "udpin:127.0.0.1:$stations" --mission "$mission" \
    --fly --without-detection --headless > console.txt 2>&1 &
console=$!
try() {
    (cd "$packages" && timeout 150 node "$@") || {
        status=$?
        tail -n 30 console.txt
        exit $status
    }
}

# The last ends the mission.
try hub.mjs "$stations"
try station.mjs "$station" '[[47.3975,8.5447],[47.3985,8.5447],[47.3985,8.5468],[47.3975,8.5468]]'
