#!/usr/bin/env bash
# Runs the tests of Rabit.Core under Mono for an Arm processor, emulated by qemu-user: a stand-in for a Raspberry Pi. By command only, since
# it takes its time. Usage: eng/mono-arm.sh [arm64|armhf] [xunit options, for example -class Rabit.Core.Tests.Managers.WakeUpEventTests]
# What it cannot show: the memory order of Arm (qemu runs on the order of the host), and how fast anything is.
# Needs Debian, and mono-devel of its own version: the assemblies are the host's, only the runtime is Arm's.
# Ends with one line, "N passed, N failed".
set -euo pipefail
cd "$(dirname "$0")/.."

architecture=${1:-arm64}
shift || true
case $architecture in
    arm64) qemu=qemu-aarch64-static ;;
    armhf) qemu=qemu-arm-static ;;
    *) echo "usage: eng/mono-arm.sh [arm64|armhf] [xunit options]" >&2; exit 2 ;;
esac
home=$PWD/artifacts-mono/$architecture
root=$home/root
project=tests/Rabit.Core.Tests
results=$home/results.xml
export LC_ALL=C.UTF-8

eng/install-tools.sh
if ! command -v $qemu > /dev/null; then
    apt-get update -q
    env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends qemu-user-static
fi

# An apt of its own: the host's list of architectures and of installed packages stays as it is.
apt_for_arm() {
    local command=$1
    shift
    mkdir -p "$home"/apt/{state/lists/partial,cache/archives/partial}
    : > "$home/apt/status"
    apt-get -q -y --no-install-recommends -o APT::Architecture=$architecture -o APT::Architectures::=$architecture \
        -o Dir::State="$home/apt/state" -o Dir::State::status="$home/apt/status" -o Dir::Cache="$home/apt/cache" \
        -o Debug::NoLocking=1 -o APT::Sandbox::User=root "$command" "$@"
}

if [ ! -L "$root/usr/lib/mono" ]; then   # the last step below
    apt_for_arm update || echo "Some lists of packages could not be had; those that are there are used."
    apt_for_arm install --download-only mono-runtime-sgen
    mkdir -p "$root"
    for package in "$home"/apt/cache/archives/*.deb; do
        dpkg-deb -x "$package" "$root"
    done
    # Assemblies are the same for every processor, and the host has all of them.
    rm -rf "$root/usr/lib/mono"
    ln -s "$(dirname "$(readlink -f "$(command -v mono)")")/../lib/mono" "$root/usr/lib/mono"
fi

dotnet build $project -p:RabitMono=true -v quiet
assembly=$(dotnet msbuild $project -p:RabitMono=true -getProperty:TargetPath)
runner=$(dotnet msbuild $project -p:RabitMono=true -getProperty:XunitConsole472Path)
cp "$(dirname "$runner")"/xunit.* "$(dirname "$assembly")"
rm -f "$results"

# Files that are in the Arm root are taken from there, all others from the host.
"$qemu" -L "$root" -E LD_LIBRARY_PATH="$root/usr/lib" -E MONO_CFG_DIR="$root/etc" "$root/usr/bin/mono-sgen" "$(dirname "$assembly")/xunit.console.exe" "$assembly" \
    -noappdomain -nologo -notrait Category=Long -parallel none -xml "$results" "$@" || true

attribute() {
    local number
    number=$(grep -s -m 1 '<assembly ' "$results" | sed -n "s/.* $1=\"\([0-9]*\)\".*/\1/p") || true
    echo "${number:-0}"
}

passed=$(attribute passed)
failed=$(($(attribute failed) + $(attribute errors)))
if [ $((passed + failed)) -eq 0 ]; then
    echo "no test was run"
    failed=1
fi
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
