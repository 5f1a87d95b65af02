# Completion of rabit in bash. In ~/.bashrc:
#     eval "$(rabit completion bash)"
_rabit() {
    local line=${COMP_LINE:0:COMP_POINT} word candidate
    word=${line##*[[:space:]]}
    COMPREPLY=()
    while IFS= read -r candidate; do
        # Options only where one was begun: all else may be a file, which bash completes by itself.
        if [[ $candidate == "$word"* && ( $candidate != -* || $word == -* ) ]]; then
            COMPREPLY+=("$candidate")
        fi
    done < <("${COMP_WORDS[0]}" "[suggest:${#line}]" "$line" 2> /dev/null)
    # A link goes on behind its colon, at which bash begins a new word.
    if [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *: ]]; then
        compopt -o nospace 2> /dev/null
    fi
    if [[ $word == *:* && $COMP_WORDBREAKS == *:* ]]; then
        COMPREPLY=("${COMPREPLY[@]#"${word%"${word##*:}"}"}")
    fi
}
complete -o bashdefault -o default -F _rabit rabit
