# Sourced by eng/docs-check.sh: how it runs a command of a document, and what it replaces of it. Each replacement is said in
# a line that begins with "replaced: ". What is neither replaced nor works fails.

programs=()      # process ids of programs that run until they are stopped
said=$work/said.txt   # what they print
in_background=   # whether a command is such a program: it takes the place of its shell, so that signals reach it

# "sudo cp", "systemctl" and "journalctl" work on a folder instead of this machine.
etc=$work/machine/etc
mkdir -p "$etc/systemd/system"

# Runs a command in this shell, so that cd and variables stay; what it prints is in $printed too.
run_command() {
    local address
    case $1 in
        *--web*)
            # UavConsole with its page: runs until it is stopped.
            address=127.0.0.1:8080
            end_programs
            start_program "$1"
            await_page "http://$address/"
            ;;
        *'samples/UavConsole -- --realtime'*)
            # UavConsole with its diagnostics: runs until it is stopped.
            end_programs
            rm -f "$XDG_RUNTIME_DIR"/rabit/*.sock   # of a program that was killed
            start_program "$1"
            await_socket
            ;;
        *)
            set -o pipefail
            eval "$1" > "$printed" 2>&1 || { cat "$printed"; return 1; }
            cat "$printed"
            ;;
    esac
}

start_program() {
    echo "replaced: runs in the background until it is stopped by SIGTERM"
    in_background=1
    eval "$1 > '$said' 2>&1 &"
    in_background=
    programs+=($!)
}

await_socket() {
    local _
    for _ in $(seq 600); do
        if ls "$XDG_RUNTIME_DIR"/rabit/*.sock > /dev/null 2>&1; then
            echo "socket: $(basename "$(ls "$XDG_RUNTIME_DIR"/rabit/*.sock)")"
            return
        fi
        if ! kill -0 "${programs[-1]}" 2> /dev/null; then
            echo "It has ended:"
            cat "$said"
            return 1
        fi
        sleep 0.1
    done
    cat "$said"
    echo "No socket in $XDG_RUNTIME_DIR/rabit."
    return 1
}

await_page() {
    local _
    for _ in $(seq 600); do
        # The page is there before the flight is, and a program that is stopped before it flies has no stop in order.
        if grep -q '^live page: ' "$said" && curl -fsS --max-time 5 -o "$work/page.html" "$1" 2> /dev/null &&
            grep -q '<html' "$work/page.html"; then
            echo "page at $1: $(wc -c < "$work/page.html") bytes"
            return
        fi
        if ! kill -0 "${programs[-1]}" 2> /dev/null; then
            echo "It has ended:"
            cat "$said"
            return 1
        fi
        sleep 0.1
    done
    cat "$said"
    echo "No page at $1."
    return 1
}

# Stops what still runs, in order, and says how it ended. 1 is "the mission is not accomplished".
end_programs() {
    local process status
    for process in "${programs[@]}"; do
        kill -TERM "$process" 2> /dev/null || true
        status=0
        wait "$process" || status=$?
        echo "stopped: exit code $status"
        if [ $status -gt 1 ]; then
            cat "$said"
            return 1
        fi
    done
    programs=()
}

# "dotnet run --project samples/X" runs the sample of the clone as it is built, in the current folder; in the clone NuGet
# finds what it found when it was built.
dotnet() {
    local arguments=("$@") i
    if [ "$PWD" = "$root" ]; then
        run_here env NUGET_PACKAGES="$filled" dotnet "$@"
        return
    fi
    for i in "${!arguments[@]}"; do
        if [ "$1" = run ] && [ "${arguments[$i]}" = --project ] && [[ ${arguments[$((i + 1))]} == samples/* ]]; then
            arguments[$((i + 1))]=$root/${arguments[$((i + 1))]}
            arguments=(run --no-build "${arguments[@]:1}")
            run_here env NUGET_PACKAGES="$filled" dotnet "${arguments[@]}"
            return
        fi
    done
    run_here env dotnet "$@"
}

run_here() {
    if [ -n "$in_background" ]; then
        exec "$@"
    fi
    "$@"
}

# The tool, from the packages that the first command has made.
rabit() {
    if ! [ -x "$work/tools/rabit" ]; then
        echo "replaced: rabit is installed in a folder (dotnet tool install --tool-path)"
        command dotnet tool install Rabit.Tool --tool-path "$work/tools" --add-source "$root/packages" --version "$version" ||
            return 1
    fi
    DOTNET_ROLL_FORWARD=Major "$work/tools/rabit" "$@"
}

sudo() {
    case $1 in
        cp)
            echo "replaced: sudo $*, into a folder instead of /etc"
            cp "${@:2:$#-2}" "$etc${!##/etc}" && verify_units
            ;;
        systemctl) "$@" ;;
        *) echo "sudo $1 is not replaced."; return 1 ;;
    esac
}

systemctl() {
    local unit=${!#}
    echo "replaced: systemctl $*"
    case "$*" in
        daemon-reload) ;;
        'enable --now '* | start* | status* | stop*) [ -e "$etc/systemd/system/${unit%.service}.service" ] ;;
        *) echo "systemctl $1 is not replaced."; return 1 ;;
    esac
}

journalctl() {
    echo "replaced: journalctl $*"
    [ "$1" = -u ] && [ -e "$etc/systemd/system/$2.service" ]
}

# On copies with a program that is there; a key that is not known is a warning for systemd, and a fault here.
verify_units() {
    local unit name
    for unit in "$etc"/systemd/system/*.service; do
        name=$(basename "$unit")
        mkdir -p "$work/verified"
        sed -E 's#^(Exec[A-Za-z]*=)[^ ]+#\1/bin/true#' "$unit" > "$work/verified/$name"
        systemd-analyze verify --man=no --recursive-errors=no "$work/verified/$name" > "$work/verified.txt" 2>&1 || true
        if grep -F "$name" "$work/verified.txt" || ! [ -e "$unit" ]; then
            return 1
        fi
        echo "systemd-analyze verify $name: ok"
    done
}

# What a document shows of a unit stands in that of a sample, line by line.
is_of_a_unit() {
    local unit
    for unit in samples/*/*.service; do
        if ! grep -vxFf "$unit" "$1"; then
            echo "of $unit"
            return
        fi
    done
    echo "No unit of the samples has all lines of this block."
    return 1
}
