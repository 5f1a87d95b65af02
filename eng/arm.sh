#!/usr/bin/env bash
# Runs the tests of Rabit.Core under .NET or Mono for an Arm processor, emulated by qemu-user: a stand-in for a Raspberry Pi. By command only,
# since it takes its time. Usage: eng/arm.sh net|mono arm64|armhf [xunit options, for example -class Rabit.Core.Tests.Managers.WakeUpEventTests]
# (.NET for arm64 only). What it cannot show: the memory order of Arm (qemu runs on the order of the host), and how fast anything is.
# Needs Debian; for Mono, mono-devel of its own version: the assemblies are the host's, only the runtime is Arm's.
# Ends with one line, "N passed, N failed".
set -euo pipefail
cd "$(dirname "$0")/.."

runtime=${1:-}
architecture=${2:-}
case $runtime-$architecture in
    net-arm64 | mono-arm64) qemu=qemu-aarch64-static ;;
    mono-armhf) qemu=qemu-arm-static ;;
    *) echo "usage: eng/arm.sh net arm64 | mono arm64|armhf [xunit options]" >&2; exit 2 ;;
esac
shift 2
home=$PWD/artifacts-mono/$architecture
root=$home/root
project=tests/Rabit.Core.Tests
results=$home/$runtime.xml
export LC_ALL=C.UTF-8

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

# Files that are in the Arm root are taken from there, all others from the host.
run_on_arm() {
    "$qemu" -L "$root" -E LD_LIBRARY_PATH="$root/usr/lib" "$@"
}

run_mono() {
    local assembly runner
    dotnet build $project -p:RabitMono=true -v quiet
    assembly=$(dotnet msbuild $project -p:RabitMono=true -getProperty:TargetPath)
    runner=$(dotnet msbuild $project -p:RabitMono=true -getProperty:XunitConsole472Path)
    cp "$(dirname "$runner")"/xunit.* "$(dirname "$assembly")"
    run_on_arm -E MONO_CFG_DIR="$root/etc" "$root/usr/bin/mono-sgen" "$(dirname "$assembly")/xunit.console.exe" "$assembly" -noappdomain "$@"
}

# What .NET would map twice, to be either written or executed, qemu executes as it was before. Stop signals to this process are
# left out: Ctrl-C ends xunit's console.
run_net() {
    local folder=$home/bin runner
    dotnet publish $project -r linux-$architecture --self-contained -p:RabitQuick=true -p:ArtifactsPath="$home/artifacts" -v quiet -o "$folder"
    dotnet publish eng/run-tests.cs -r linux-$architecture --self-contained -v quiet -o "$home/run-tests"
    dotnet restore $project -p:RabitMono=true -v quiet   # xunit's console is a package of the build for Mono
    runner=$(dotnet msbuild $project -p:RabitMono=true -getProperty:XunitConsole472Path)
    cp "$home"/run-tests/run-tests* "$(dirname "$runner")"/../netcoreapp2.0/xunit.* "$folder"
    run_on_arm -E DOTNET_EnableWriteXorExecute=0 -E DOTNET_SYSTEM_GLOBALIZATION_INVARIANT=1 \
        "$folder/run-tests" "$folder/xunit.console.dll" "$folder/Rabit.Core.Tests.dll" \
        -noclass Rabit.Core.Tests.Reactors.StopSignalTests "$@"
}

attribute() {
    local number
    number=$(grep -s -m 1 '<assembly ' "$results" | sed -n "s/.* $1=\"\([0-9]*\)\".*/\1/p") || true
    echo "${number:-0}"
}

eng/install-tools.sh
if ! command -v $qemu > /dev/null; then
    apt-get update -q
    env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends qemu-user-static
fi

if [ ! -L "$root/usr/lib/mono" ]; then   # the last step below
    apt_for_arm update || echo "Some lists of packages could not be had; those that are there are used."
    apt_for_arm install --download-only mono-runtime-sgen libstdc++6 libssl3
    mkdir -p "$root"
    for package in "$home"/apt/cache/archives/*.deb; do
        dpkg-deb -x "$package" "$root"
    done
    # Assemblies are the same for every processor, and the host has all of them.
    rm -rf "$root/usr/lib/mono"
    ln -s "$(dirname "$(readlink -f "$(command -v mono)")")/../lib/mono" "$root/usr/lib/mono"
fi

rm -f "$results"
"run_$runtime" -nologo -nocolor -notrait Category=Long -parallel none -xml "$results" "$@" || true

passed=$(attribute passed)
failed=$(($(attribute failed) + $(attribute errors)))
if [ $((passed + failed)) -eq 0 ]; then
    echo "no test was run"
    failed=1
fi
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
