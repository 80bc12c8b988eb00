# Prints what zsh offers for a command line, one a line:  zsh -f complete.zsh FUNCTION-FOLDER LINE
# An interactive zsh runs under a pseudo-terminal; its compadd prints the matches.
zmodload zsh/zpty
export TERM=dumb
zpty shell zsh -f -i
{
  zpty -w shell 'PS1= PS2=; unsetopt zle_bracketed_paste; stty -echo'
  zpty -w shell "fpath=(${(q)1} \$fpath); autoload -Uz compinit; compinit -u -D"
  zpty -w shell 'zstyle ":completion:*" list-colors ""; setopt rc_expand_param'
  zpty -w shell 'compadd() {
    if [[ ${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]]; then builtin compadd "$@"; return $?; fi
    local -a found; builtin compadd -O found "$@"
    (( $#found )) && print -rl -- "match:"$found
    builtin compadd "$@"
  }'
  zpty -w shell 'finish() { compstate[insert]= ; compstate[list]= ; print "end:" }'
  zpty -w shell 'comppostfuncs=(finish); bindkey "^I" complete-word; print ready:'
  local line
  while zpty -r shell line; do [[ $line == ready:* ]] && break; done
  zpty -w -n shell "$2"$'\t'
  while zpty -r shell line; do
    line=${line//$'\r'/} line=${line%$'\n'}
    [[ $line == *match:* ]] && print -r -- ${line#*match:}
    [[ $line == *end:* ]] && break
  done
} always {
  zpty -d shell
}
