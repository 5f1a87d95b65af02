#!/usr/bin/env bash
# The packages as users get them: packs them to artifacts/packages, looks into them, packs them once more in another folder
# to show that the build is deterministic, and builds and runs small programs (eng/pack-check) against them under .NET and
# Mono; installs the tool and runs it. eng/packages.txt lists the packages. With --quick the second build is left out.
set -euo pipefail
cd "$(dirname "$0")/.."

mapfile -t ids < <(sed -nE 's/^([A-Za-z][^ ]*).*/\1/p' eng/packages.txt)
mapfile -t libraries < <(sed -nE '/ (none|tool) +none$/d; s/^([A-Za-z][^ ]*).*/\1/p' eng/packages.txt)
version=$(dotnet msbuild src/Rabit.Core -getProperty:Version)
packages=$PWD/artifacts/packages
work=$PWD/artifacts/pack-check
copy=
trap '[ -z "$copy" ] || rm -rf "$copy"' EXIT

# All at once: one by one, each looks at all that it refers to again. The analyzers have judged the sources already,
# in the build of Rabit.sln.
pack() {
    dotnet pack "$1/Rabit.sln" -c Release -v quiet -o "$2" -p:RunAnalyzers=false
}

echo "--- the list of packages"
diff -u <(printf '%s\n' "${ids[@]}" | LC_ALL=C sort) \
    <(grep -l '<IsPackable>true' src/*/*.csproj | sed -E 's|.*/(.*)\.csproj|\1|' | LC_ALL=C sort)

echo "--- pack"
rm -rf "$packages"
pack . "$packages"

echo "--- look inside"
if [ "${1:-}" = --quick ]; then
    dotnet run eng/inspect-packages.cs -- "$packages"
else
    # The same sources, changes that are not committed included, in another place.
    copy=$(mktemp -d)
    git ls-files --cached --others --exclude-standard -z | xargs -0 ls -d 2> /dev/null | tar -cf - -T - .git | tar -xf - -C "$copy"
    pack "$copy" "$copy/packages"
    dotnet run eng/inspect-packages.cs -- "$packages" "$copy/packages"
fi

echo "--- use them"
mkdir -p "$work/packages"
rm -rf "$work"/packages/rabit.*   # a package of the same version, packed before, must not be taken for this one
export RabitVersion=$version          # read by the projects in eng/pack-check
# What has no build for netstandard2.0 is used by the program for .NET only.
RabitPackages=$(sed -nE '/ none$/d; s/^([A-Za-z][^ ]*).*/\1/p' eng/packages.txt | paste -sd';')
RabitNetPackages=$(sed -nE '/ (none|tool) +none$/d; / none$/!d; s/^([A-Za-z][^ ]*).*/\1/p' eng/packages.txt | paste -sd';')
export RabitPackages RabitNetPackages
dotnet build eng/pack-check -v quiet
dotnet run --project eng/pack-check -f net10.0 --no-build > "$work/net.txt"
cat "$work/net.txt"
for id in "${libraries[@]}"; do
    file=${id,,}/$version/${id,,}.$version.nupkg
    if ! cmp "$work/packages/$file" "$packages/$id.$version.nupkg"; then
        echo "$id was restored from somewhere else." >&2
        exit 1
    fi
done

mono "$work/bin/PackCheck/debug_net472/PackCheck.exe" > "$work/mono.txt"
diff -u "$work/net.txt" "$work/mono.txt"

echo "--- install the tool and run it"
rm -rf "$work/tool"
dotnet tool install Rabit.Tool --tool-path "$work/tool" --version "$version" --configfile eng/pack-check/nuget.config --no-cache
rabit=$work/tool/rabit
[ "$("$rabit" --version)" = "$version" ]
"$rabit" --help | tee "$work/tool-help.txt"
for command in mavlink geolocate simulate train completion; do
    grep -q "^  $command " "$work/tool-help.txt"
    "$rabit" "$command" --help > /dev/null
done
"$rabit" mavlink tests/data/mavlink/ardupilot-flight.tlog > "$work/tool-table.txt"
grep -q "^HEARTBEAT " "$work/tool-table.txt"
"$rabit" mavlink tests/data/mavlink/ardupilot-flight.tlog --print | head -n 1
"$rabit" geolocate docs/examples/geolocate/{camera,request}.json
completions=$(bash -c 'PATH=$1:$PATH; eval "$(rabit completion bash)"; COMP_LINE="rabit geo" COMP_POINT=9 COMP_WORDS=(rabit geo); _rabit; echo "${COMPREPLY[@]}"' - "$work/tool")
[ "$completions" = geolocate ]
status=0
"$rabit" mavlnk 2> "$work/tool-error.txt" || status=$?
[ $status -eq 2 ]
grep -q "did you mean 'mavlink'" "$work/tool-error.txt"

echo "--- Rabit.Uav alone, central package versions, two namespaces"
dotnet build eng/pack-check/central -v quiet
dotnet run --project eng/pack-check/central --no-build

echo "--- definitions without the generator"
dotnet build eng/pack-check/no-generator -v quiet > "$work/no-generator.log" 2>&1 && { echo "It compiles." >&2; exit 1; }
grep -q 'error RABMAV101' "$work/no-generator.log"

echo "--- wrong definitions are compiler errors"
dotnet build eng/pack-check/faults -v quiet > "$work/faults.log" 2>&1 && { echo "Wrong definitions compile." >&2; exit 1; }
sed -nE 's#^.*/eng/pack-check/faults/([^/]*: (error|warning) .*) \[.*\]$#\1#p' "$work/faults.log" | LC_ALL=C sort -u -V > "$work/faults.txt"
diff -u eng/pack-check/faults/expected.txt "$work/faults.txt"
if grep 'error CS\|error MSB\|error NU' "$work/faults.log"; then
    echo "Wrong definitions give errors of another kind." >&2
    exit 1
fi

echo "--- misuse of managers is found by the compiler"
dotnet build eng/pack-check/analyzers -v quiet > "$work/analyzers.log" 2>&1 && { echo "An async manager compiles." >&2; exit 1; }
sed -nE 's#^.*/eng/pack-check/analyzers/([^/]*: (error|warning) RABIT[0-9]*).*$#\1#p' "$work/analyzers.log" | LC_ALL=C sort -u -V > "$work/analyzers.txt"
diff -u eng/pack-check/analyzers/expected.txt "$work/analyzers.txt"

echo "--- compile the programs of their readmes"
rm -rf "$work/readme"
mkdir -p "$work/readme"
rules=$PWD/eng/pack-check
echo "<Project><Import Project='$rules/Directory.Build.props' /></Project>" > "$work/readme/Directory.Build.props"
cp "$rules"/{Directory.Build.targets,Directory.Packages.props} "$work/readme"
sed "s#\.\./\.\./artifacts/packages#$packages#" "$rules/nuget.config" > "$work/readme/nuget.config"
for id in "${libraries[@]}"; do
    awk '/^```/ { if (inside) exit } inside { print } /^```csharp$/ { inside = 1 }' "src/$id/README.md" > "$work/readme/$id.cs"
    echo "<Project><PropertyGroup><RabitPackage>$id</RabitPackage></PropertyGroup><Import Project='$rules/readme/Readme.csproj' /></Project>" \
        > "$work/readme/Readme.$id.csproj"
    echo "<Project Path='Readme.$id.csproj' />"
done | sed '1i <Solution>
$a </Solution>' > "$work/readme/all.slnx"
dotnet build "$work/readme/all.slnx" -v quiet
for id in "${libraries[@]}"; do
    ls "$work/bin/Readme.$id/debug/Readme.$id.dll"
done

echo "The packages work on .NET and Mono."
