#!/usr/bin/env bash
# Does what documents say, as they say it: copies the commands and files out of docs/getting-started.md and of the recipes
# named below, and runs them with an empty home folder (eng/empty-home.sh) and the packages that the first command makes.
#
# A block of sh is run line by line. A csharp block below "`FILE`:" is that file, any other is built against the packages. A
# text block is what the last command printed; an ini block stands in a unit of the samples. A block marked "in the clone"
# runs in the root of the repository, all others in a folder of their own, in which samples/ is that of the clone.
# What cannot be done here is replaced, by the short list in eng/docs-replaced.sh, and said: sudo, systemctl, journalctl (the
# unit is verified), programs that run until they are stopped, and "dotnet run" of a sample, which takes the one built before.
# Ends with one line, "N passed, N failed"; a section is a check.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
logs=$PWD/artifacts/docs-check
rm -rf "$logs"
mkdir -p "$logs"
source eng/empty-home.sh
source eng/docs-replaced.sh
passed=0
failed=0

# extract DOCUMENT HEADING FOLDER: the blocks of a section (of the whole document for "-"), as NUMBER.LANGUAGE, and what is
# said of each of them as NUMBER.about: line, marker, file.
extract() {
    awk -v heading="$2" -v folder="$3" '
        BEGIN { inside = heading == "-" }
        !block && heading != "-" && /^## / { inside = $0 == "## " heading; found = found || inside }
        !block && /^```/ && inside {
            number++
            language = substr($0, 4) == "" ? "none" : substr($0, 4)
            file = sprintf("%s/%03d.", folder, number)
            marker = before ~ /^<!-- .* -->$/ ? substr(before, 6, length(before) - 9) : ""
            printf "%d\t%s\t%s\n", NR, marker, language == "csharp" ? name : "" > (file "about")
            printf "" > (file language)
            if (language == "csharp") name = ""
            block = 1
            before = ""
            next
        }
        block && /^```$/ { block = 0; close(file language); next }
        block            { if (inside) print > (file language); next }
        !block && /^```/ { block = 1; before = ""; next }
        /^`[^` ]+`:$/    { name = substr($0, 2, length($0) - 3) }
        NF               { before = $0 }
        END { exit heading != "-" && !found }' "$1"
}

# Runs the blocks of a section in order, in one shell, as a user does.
run_section() {
    local document=$1 heading=$2 steps about block line marker file language
    steps=$(mktemp -d -p "$work")
    if ! extract "$document" "$heading" "$steps"; then
        echo "$document has no section '$heading'."
        return 1
    fi
    if ! ls "$steps"/*.sh > /dev/null 2>&1; then
        echo "$document, '$heading': there are no commands."
        return 1
    fi

    cd "$(mktemp -d -p "$work")"
    ln -s "$root/samples" samples
    here=$PWD
    for about in "$steps"/*.about; do
        IFS=$'\t' read -r line marker file < <(tr '\t' '\001' < "$about" | sed 's/\x01/\t/g')
        block=$(ls "${about%about}"* | grep -v 'about$')
        language=${block##*.}
        echo "--- $document:$line, $language${marker:+, $marker}${file:+, $file}"
        case $language in
            sh) run_commands "$block" "$marker" ;;
            text) diff -u --label "$document:$line" --label printed "$block" "$printed" ;;
            csharp)
                if [ -n "$file" ]; then
                    mkdir -p "$(dirname "$file")"
                    cp "$block" "$file"
                else
                    build_with_packages "$block"
                fi
                ;;
            ini) is_of_a_unit "$block" ;;
            *) echo "(no commands)" ;;
        esac
    done
    end_programs
}

run_commands() {
    local block=$1 marker=$2 command before=$PWD
    printed=$work/printed.txt
    case $marker in
        '') ;;
        'in the clone') cd "$root" ;;
        *) echo "The marker '$marker' is not known."; return 1 ;;
    esac
    while IFS= read -r command; do
        command=$(sed -E 's/[[:space:]]+#.*$//' <<< "$command")
        [ -n "$command" ] || continue
        echo "\$ $command"
        run_command "$command"
    done < <(sed -e ':a' -e '/\\$/N; s/\\\n[[:space:]]*//; ta' "$block")
    [ -z "$marker" ] || cd "$before"
}

# A program without the name of a file is built against all libraries among the packages of the first command, and not run.
build_with_packages() {
    local project id
    project=$(mktemp -d -p "$work")/program
    dotnet new console -o "$project" > /dev/null
    cp "$1" "$project/Program.cs"
    {
        echo '<Project><ItemGroup>'
        sed -nE '/ (none|tool) +none/d; s/^([A-Za-z][^ ]*).*/\1/p' "$root/eng/packages.txt" | while read -r id; do
            echo "<PackageReference Include=\"$id\" Version=\"$version\" />"
        done
        echo '</ItemGroup></Project>'
    } > "$project/Directory.Build.targets"
    dotnet build "$project" -v quiet -warnaserror
    echo "(built against the packages)"
}

# One check: a section.
check() {
    local name="$1${2:+, $2}" log status started=$SECONDS
    log=$logs/$(tr -c 'A-Za-z0-9\n' '-' <<< "$name").txt
    set +e   # in a condition, -e would have no effect inside
    (set -e; trap end_programs EXIT; run_section "$1" "${2:--}") < /dev/null > "$log" 2>&1
    status=$?
    set -e
    if [ $status -eq 0 ]; then
        grep '^\$ \|^replaced: ' "$log" || true
        echo "$name: ok, $((SECONDS - started)) s"
        passed=$((passed + 1))
    else
        cat "$log"
        echo "$name: FAILED"
        failed=$((failed + 1))
    fi
}

check docs/getting-started.md
check docs/how-to.md "Run on boot"
check docs/how-to.md "Watch a flight in the browser"
check docs/how-to.md "See what the managers do"
if compare_restored "$root/packages"; then
    echo "restored packages: ok"
    passed=$((passed + 1))
else
    echo "restored packages: FAILED"
    failed=$((failed + 1))
fi

echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
