#!/usr/bin/env bash
# The packages as users get them: packs them to artifacts/packages, looks into them, packs them once more in another folder
# to show that the build is deterministic, and builds and runs a small program (eng/pack-check) against them under .NET and
# Mono. With --quick the second build is left out.
set -euo pipefail
cd "$(dirname "$0")/.."

ids=(Rabit.Core Rabit.Mavlink Rabit.Uav Rabit.Uav.Simulation)
version=$(dotnet msbuild src/Rabit.Core -getProperty:Version)
packages=$PWD/artifacts/packages
work=$PWD/artifacts/pack-check
copy=
trap '[ -z "$copy" ] || rm -rf "$copy"' EXIT

pack() {
    for id in "${ids[@]}"; do
        dotnet pack "$1/src/$id" -c Release -v quiet -o "$2" -p:ContinuousIntegrationBuild=true "${@:3}"
    done
}

echo "--- pack"
rm -rf "$packages"
pack . "$packages"

echo "--- look inside"
if [ "${1:-}" = --quick ]; then
    dotnet run eng/inspect-packages.cs -- "$packages"
else
    # The same sources, changes that are not committed included, in another place. The analyzers have judged them already.
    copy=$(mktemp -d)
    git ls-files --cached --others --exclude-standard -z | xargs -0 ls -d 2> /dev/null | tar -cf - -T - .git | tar -xf - -C "$copy"
    pack "$copy" "$copy/packages" -p:RunAnalyzers=false
    dotnet run eng/inspect-packages.cs -- "$packages" "$copy/packages"
fi

echo "--- use them"
mkdir -p "$work/packages"
rm -rf "$work"/packages/rabit.*   # a package of the same version, packed before, must not be taken for this one
export RabitVersion=$version          # read by the projects in eng/pack-check
dotnet build eng/pack-check -v quiet
dotnet run --project eng/pack-check -f net10.0 --no-build > "$work/net.txt"
cat "$work/net.txt"
for id in "${ids[@]}"; do
    file=${id,,}/$version/${id,,}.$version.nupkg
    if ! cmp "$work/packages/$file" "$packages/$id.$version.nupkg"; then
        echo "$id was restored from somewhere else." >&2
        exit 1
    fi
done

mono "$work/bin/PackCheck/debug_net472/PackCheck.exe" > "$work/mono.txt"
diff -u "$work/net.txt" "$work/mono.txt"

echo "--- wrong definitions are compiler errors"
dotnet build eng/pack-check/faults -v quiet > "$work/faults.log" 2>&1 && { echo "Wrong definitions compile." >&2; exit 1; }
sed -n 's|^.*/eng/pack-check/faults/\([^/]*: error .*\) \[.*\]$|\1|p' "$work/faults.log" | LC_ALL=C sort -u -V > "$work/faults.txt"
diff -u eng/pack-check/faults/expected.txt "$work/faults.txt"
if grep 'error CS\|error MSB\|error NU' "$work/faults.log"; then
    echo "Wrong definitions give errors of another kind." >&2
    exit 1
fi

echo "--- compile the programs of their readmes"
mkdir -p "$work/readme"
for id in "${ids[@]}"; do
    awk '/^```/ { if (inside) exit } inside { print } /^```csharp$/ { inside = 1 }' "src/$id/README.md" > "$work/readme/$id.cs"
    RabitPackage=$id dotnet build eng/pack-check/readme -v quiet
done

echo "The packages work on .NET and Mono."
