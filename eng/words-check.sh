#!/usr/bin/env bash
# Finds the words of eng/word-list.txt: "path:line:text   [word: what is written instead]", sorted by file. --count: how often each, most first.
# Exit code 1 if there are any. WordListTests does the same in dotnet test.
set -euo pipefail
cd "$(dirname "$0")/.."

list=eng/word-list.txt
allowed=$(sed -n 's/^allow \(.*\) => .*$/\1/p' "$list" | paste -sd'|')
code=('src/*.cs' 'samples/*.cs' 'tests/*.cs' 'benchmarks/*.cs')
texts=("${code[@]}" 'docs/*.md' 'src/*.md' 'benchmarks/*.md' README.md CONTRIBUTING.md)

find_all() {
    while IFS= read -r entry; do
        kind=${entry%% *}
        rest=${entry#* }
        pattern=${rest%% => *}
        instead=${rest##* => }
        case $kind in
            word) git grep --untracked -nPiI "\\b(?:$pattern)\\b" -- "${texts[@]}" || true ;;
            name) git grep --untracked -nPI "$pattern" -- "${code[@]}" || true ;;
        esac | while IFS= read -r line; do printf '%s   [%s => %s]\n' "$line" "$pattern" "$instead"; done
    done < <(grep -E '^(word|name) ' "$list") | grep -vP "$allowed" | sort -t: -k1,1 -k2,2n || true
}

found=$(find_all)
[[ -z $found ]] && exit 0
if [[ ${1:-} == --count ]]; then
    sed 's/.*   \[\(.*\) => .*/\1/' <<< "$found" | sort | uniq -c | sort -rn
else
    printf '%s\n' "$found"
fi
exit 1
