# shellcheck shell=bash
# Completion of the command line of argos3 in bash: source this file, or link it from /etc/bash_completion.d/.
# Options and names come from the program.
_argos3() {
  local current="${COMP_WORDS[COMP_CWORD]}"
  local previous="${COMP_WORDS[COMP_CWORD - 1]}"
  COMPREPLY=()
  case "$previous" in
    -c | --config-file)
      local file
      while IFS= read -r file; do
        if [[ -d "$file" || "$file" == *.argos || "$file" == *.xml ]]; then
          COMPREPLY+=("$file")
        fi
      done < <(compgen -f -- "$current")
      compopt -o filenames 2>/dev/null
      ;;
    -q | --query)
      mapfile -t COMPREPLY < <(compgen -W "$(argos3 -q names 2>/dev/null)" -- "$current")
      ;;
    --schema)
      mapfile -t COMPREPLY < <(compgen -W "rng rnc" -- "$current")
      ;;
    --csv)
      mapfile -t COMPREPLY < <(compgen -d -- "$current")
      compopt -o filenames 2>/dev/null
      ;;
    -l | --log-file | -e | --logerr-file | --record | --video | --replay)
      mapfile -t COMPREPLY < <(compgen -f -- "$current")
      compopt -o filenames 2>/dev/null
      ;;
    *)
      mapfile -t COMPREPLY < <(compgen -W "$(argos3 --help 2>/dev/null | grep -oE -- '(^|[ ,])--[a-z-]+' | tr -d ' ,' | sort -u)" -- "$current")
      ;;
  esac
}
complete -F _argos3 argos3
