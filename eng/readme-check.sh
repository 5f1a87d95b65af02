#!/usr/bin/env bash
# The README's first program is samples/HelloRabit, to the letter, and prints what the README says.
# After the marker "<!-- HelloRabit -->" README.md has the program in a ```csharp block and its output in a ```text block.
set -euo pipefail
cd "$(dirname "$0")/.."

readonly longest_program=45
work=artifacts/readme-check
mkdir -p "$work"

# The first block of a language after the marker.
block() {
    awk -v fence="\`\`\`$1" '
        /^<!-- HelloRabit -->/ { marked = 1 }
        inside && /^```/       { exit }
        inside                 { print }
        marked && $0 == fence  { inside = 1 }' README.md
}

block csharp > "$work/Program.cs"
block text > "$work/output.txt"
if ! [ -s "$work/Program.cs" ] || ! [ -s "$work/output.txt" ]; then
    echo "README.md has no csharp block and text block after <!-- HelloRabit -->." >&2
    exit 1
fi

lines=$(wc -l < "$work/Program.cs")
if [ "$lines" -gt "$longest_program" ]; then
    echo "The README's first program has $lines lines; it may have $longest_program." >&2
    exit 1
fi

diff -u --label README.md --label samples/HelloRabit/Program.cs "$work/Program.cs" samples/HelloRabit/Program.cs
dotnet run --project samples/HelloRabit > "$work/printed.txt"
diff -u --label README.md --label printed "$work/output.txt" "$work/printed.txt"
echo "README.md shows samples/HelloRabit ($lines lines) and what it prints."
