# fish completion for nipref
complete -c nipref -n __fish_use_subcommand -a "{{#verbs}}{{name}} {{/verbs}}{{#quantities}}{{name}} {{/quantities}}help"
{{#verbs}}
complete -c nipref -n "__fish_seen_subcommand_from {{name}}" -a "{{words}}"
{{/verbs}}
complete -c nipref -n "__fish_seen_subcommand_from help" -a "{{#trimmed}}{{#verbs}}{{name}} {{/verbs}}{{/trimmed}}"
{{#quantities}}
complete -c nipref -n "__fish_seen_subcommand_from {{name}}" -a "{{#trimmed}}{{words}}{{/trimmed}}"
{{/quantities}}
