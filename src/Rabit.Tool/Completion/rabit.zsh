#compdef rabit
# Completion of rabit in zsh. In ~/.zshrc, behind compinit:
#     eval "$(rabit completion zsh)"
_rabit() {
    local line="${(j: :)words[1,CURRENT]}" word="${words[CURRENT]}"
    local -a candidates links
    # Options only where one was begun: all else may be a file.
    candidates=("${(@f)$("${words[1]}" "[suggest:${#line}]" "$line" 2> /dev/null)}")
    candidates=(${(M)candidates:#${word}*})
    [[ $word == -* ]] || candidates=(${candidates:#-*})
    links=(${(M)candidates:#*:})
    candidates=(${candidates:#*:})
    compadd -- $candidates
    compadd -S '' -- $links
    (( ${#candidates} + ${#links} )) || _files
}
compdef _rabit rabit
