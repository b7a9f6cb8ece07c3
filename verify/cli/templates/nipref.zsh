#compdef nipref
# zsh completion for nipref
local offered one
case $((CURRENT > 2)):${words[2]} in
  0:*) offered="{{#verbs}}{{name}} {{/verbs}}{{#quantities}}{{name}} {{/quantities}}help" ;;
{{#verbs}}
  1:{{name}}) offered="{{words}}" ;;
{{/verbs}}
  1:help) offered="{{#trimmed}}{{#verbs}}{{name}} {{/verbs}}{{/trimmed}}" ;;
esac
for one in ${words[2,CURRENT-1]}; do
  case $one in
{{#quantities}}
    {{name}}) offered+="{{words}}" ;;
{{/quantities}}
  esac
done
compadd -- ${${=offered}:#*=}
compadd -S '' -- ${(M)${=offered}:#*=}
_files
