#!/usr/bin/env bash
# Changes the code in small ways and reports which changes the tests notice: see scripts/mutation/mutate.py --help.
set -euo pipefail
exec python3 "$(dirname "${BASH_SOURCE[0]}")/mutation/mutate.py" "$@"
