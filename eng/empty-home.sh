# Sourced by checks that do what a new user does: an empty home folder, and Rabit only from the packages made here. Packages
# of others may come from the folder that NuGet has filled before. Sets 'packages', 'version' and 'work', an empty folder
# that goes with the home folder when the script ends. The root of the repository must be the current folder.

version=$(dotnet msbuild src/Rabit.Core -getProperty:Version)
packages=$PWD/artifacts/packages   # of eng/pack-check.sh
filled=$(dotnet nuget locals global-packages --list | sed 's/^[^:]*: *//')

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export HOME=$work/home DOTNET_CLI_HOME=$work/home NUGET_PACKAGES=$work/home/.nuget/packages NUGET_FALLBACK_PACKAGES=$filled
export DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_NOLOGO=1 DOTNET_CLI_UI_LANGUAGE=en
# A user does not build with CI=true, nor with the settings of this repository's builds.
unset CI RabitQuick RabitMono
export XDG_RUNTIME_DIR=$work/home/run   # for the sockets of Rabit.Diagnostics
mkdir -p "$NUGET_PACKAGES" "$XDG_RUNTIME_DIR"
chmod 700 "$XDG_RUNTIME_DIR"

# Makes the packages where eng/pack-check.sh has not, or where --pack asks for new ones.
need_packages() {
    if [ "${1:-}" = --pack ] || ! [ -e "$packages/Rabit.Templates.$version.nupkg" ]; then
        rm -rf "$packages"
        dotnet pack Rabit.sln -c Release -v quiet -o "$packages" -p:RunAnalyzers=false
    fi
}

# What was restored is what was packed: a package of the same version from elsewhere would not be in this home folder, or
# would differ.
compare_restored() {
    local folder=$1 id file restored=0
    if ! ls "$NUGET_PACKAGES"/rabit.*/"$version"/*.nupkg > /dev/null 2>&1; then
        echo "No package of Rabit $version was restored." >&2
        return 1
    fi
    for file in "$NUGET_PACKAGES"/rabit.*/"$version"/*.nupkg; do
        id=$(basename "$file" ".$version.nupkg")
        if ! cmp "$file" "$(find "$folder" -iname "$id.$version.nupkg")"; then
            echo "$id was restored from somewhere else." >&2
            return 1
        fi
        restored=$((restored + 1))
    done
    echo "$restored packages of Rabit restored from $folder"
    if ls -d "$filled"/rabit.*/"$version" > /dev/null 2>&1; then
        echo "There are packages of Rabit $version in $filled: they may have been taken instead. Delete them." >&2
        return 1
    fi
}
