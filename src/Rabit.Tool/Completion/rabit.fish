# Completion of rabit in fish:
#     rabit completion fish > ~/.config/fish/completions/rabit.fish
function __rabit_complete
    set -l line (commandline -cp)
    set -l word (commandline -ct)
    set -l program (commandline -po)[1]
    $program "[suggest:"(string length -- $line)"]" $line 2>/dev/null | while read -l candidate
        # Options only where one was begun: all else may be a file, which fish completes by itself.
        if not string match -q -- '-*' $candidate; or string match -q -- '-*' $word
            echo $candidate
        end
    end
end
complete -c rabit -a '(__rabit_complete)'
