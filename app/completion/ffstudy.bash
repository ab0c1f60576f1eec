# Completion of ffstudy for bash: the program itself says what may come next.

_ffstudy() {
    local line=${COMP_LINE:0:COMP_POINT} words answer last kept paths
    read -ra words <<<"$line"
    [[ $line != *[[:space:]] ]] || words+=('')
    last=${words[-1]}
    # bash takes what stands before = and : for words of their own, and must not be given it again.
    kept=${last%"${last##*[=:]}"}
    COMPREPLY=()
    while read -r answer; do
        paths=()
        case $answer in
            :files) compopt -o filenames && mapfile -t paths < <(compgen -f -- "${last#--*=}") ;;
            :folders) compopt -o filenames && mapfile -t paths < <(compgen -d -- "${last#--*=}") ;;
            *) answer=${answer%%$'\t'*} && COMPREPLY+=("${answer#"$kept"}") ;;
        esac
        COMPREPLY+=("${paths[@]#"${kept#--*=}"}")
    done < <("$1" complete "${words[@]}" 2>/dev/null)
}
complete -F _ffstudy ffstudy
