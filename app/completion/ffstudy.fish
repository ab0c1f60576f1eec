# Completion of ffstudy for fish: the program itself says what may come next.

function __ffstudy_complete
    set -l words (commandline -opc)
    set -l last (commandline -ct)
    set -l option (string match -r '^--[^=]*=' -- $last; or echo '')
    set -l path (string replace -r '^--[^=]*=' '' -- $last)
    for answer in ($words[1] complete $words "$last" 2>/dev/null)
        switch $answer
            case :files
                # Behind a colon, where a scene has its size, fish 4 would complete any file.
                string match -q '*:*' -- $path
                or printf '%s\n' $option(__fish_complete_path "$path")
            case :folders
                printf '%s\n' $option(__fish_complete_directories "$path")
            case '*'
                printf '%s\n' $answer
        end
    end
end
complete -c ffstudy -f -a '(__ffstudy_complete)'
