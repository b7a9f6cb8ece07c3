# bash completion for nipref
_nipref() {
  local word=${COMP_WORDS[COMP_CWORD]} words=
  case $([ "$COMP_CWORD" -gt 1 ] && echo "${COMP_WORDS[1]}") in
    "") words="{{#verbs}}{{name}} {{/verbs}}{{#quantities}}{{.}} {{/quantities}}help" ;;
{{#verbs}}
    {{name}}) words="{{words}}" ;;
{{/verbs}}
    help) words="{{#trimmed}}{{#verbs}}{{name}} {{/verbs}}{{/trimmed}}" ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -o default -F _nipref nipref
