# bash completion for nipref
_nipref() {
  local word=${COMP_WORDS[COMP_CWORD]} words=
  case $([ "$COMP_CWORD" -gt 1 ] && echo "${COMP_WORDS[1]}") in
    "") words="{{#verbs}}{{name}} {{/verbs}}{{#quantities}}{{name}} {{/quantities}}help" ;;
{{#verbs}}
    {{name}}) words="{{words}}" ;;
{{/verbs}}
    help) words="{{#trimmed}}{{#verbs}}{{name}} {{/verbs}}{{/trimmed}}" ;;
  esac
  local one
  for one in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case $one in
{{#quantities}}
      {{name}}) words+="{{words}}" ;;
{{/quantities}}
    esac
  done
  COMPREPLY=($(compgen -W "$words" -- "$word"))
  [[ ${COMPREPLY[0]} != *= ]] || compopt -o nospace 2>/dev/null || true
}
complete -o default -F _nipref nipref
