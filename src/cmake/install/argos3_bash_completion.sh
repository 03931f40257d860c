# shellcheck shell=bash
# Completion of argos3's command line in bash: source this file, or link it from /etc/bash_completion.d/.
_argos3() {
  local current="${COMP_WORDS[COMP_CWORD]}"
  local previous="${COMP_WORDS[COMP_CWORD - 1]}"
  local options="--config-file --query --help --version --no-color --no-visualization --log-file --logerr-file
    --seed --threads --length --set --csv --record --video --speed --replay --from --to --every --digest"
  local queries="actuators sensors physics_engines media visualizations outputs fields entities controllers
    loop_functions all"
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
      mapfile -t COMPREPLY < <(compgen -W "$queries" -- "$current")
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
      mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
      ;;
  esac
}
complete -F _argos3 argos3
