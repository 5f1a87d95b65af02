#!/usr/bin/env bash
# Installs what the checks need beside the .NET SDK, where it is missing: Mono (the second runtime), socat (serial
# links are tested over its pairs of pseudo-terminals), libturbojpeg (the benchmark of JPEG decoding compares with it),
# Chromium (the live page is tested in it) and systemd (its systemd-analyze checks the unit files).
set -euo pipefail

# A Mono without this facade runs, but no library for netstandard2.0: Debian has it in mono-devel, not in mono-runtime.
has_mono() {
    local mono
    mono=$(command -v mono) && [ -e "$(dirname "$mono")/../lib/mono/4.5/Facades/netstandard.dll" ]
}

has_turbojpeg() {
    /sbin/ldconfig -p | grep 'libturbojpeg\.so\.0' > /dev/null
}

has_chromium() {
    command -v chromium > /dev/null || command -v chromium-browser > /dev/null || command -v google-chrome > /dev/null
}

missing=()
has_mono || missing+=(mono-devel)
command -v socat > /dev/null || missing+=(socat)
has_turbojpeg || missing+=(libturbojpeg0)
has_chromium || missing+=(chromium)
command -v systemd-analyze > /dev/null || missing+=(systemd)
if [ ${#missing[@]} -eq 0 ]; then
    echo "Mono, socat, libturbojpeg, Chromium and systemd-analyze are there."
    exit 0
fi

if ! command -v apt-get > /dev/null; then
    echo "Missing: ${missing[*]} (Debian's names), and there is no apt-get here. Please install them another way." >&2
    exit 1
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo > /dev/null; then
        echo "Missing: ${missing[*]}. Please run as root: apt-get install ${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo -n)
fi

echo "Installing ${missing[*]}."
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
