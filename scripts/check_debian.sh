#!/usr/bin/env bash
# Builds what is committed in a bare Debian, and runs the tests and the pinned digests there:
#   scripts/check_debian.sh [SUITE] [TEST...]    a release, by default trixie, which is Debian 13; bookworm is 12
# Tests are expressions of ctest -R; by default all run that have not the label soak. Needs root, debootstrap and a network;
# takes as long as scripts/test.sh without its stamps, so continuous integration runs the same in containers instead
# (.github/workflows/checks.yml). MIRROR is where debootstrap and apt fetch packages.
set -euo pipefail
if [[ "${1:-}" == -h || "${1:-}" == --help ]]; then
  sed -n '2,6s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
source "$(dirname "${BASH_SOURCE[0]}")/bare_debian.sh"
suite="${1:-trixie}"
tests="${*:2}"
install_debian "$suite"

say "Packages (after ${SECONDS} s)"
copy_sources /root/argos3
inside /root/argos3/scripts/setup.sh run test

say "Build (after ${SECONDS} s)"
# shellcheck disable=SC2016  # that shell expands it
inside bash -euo pipefail -c '
  source /root/argos3/scripts/lib.sh
  configure_release "$release_build" -DARGOS_BUILD_TESTING=ON -DARGOS_WERROR=ON
  build "$release_build"' || die "the build failed in $suite, see above"

say "Tests (after ${SECONDS} s)"
inside ctest --test-dir /root/argos3/build -LE soak --output-on-failure --parallel "$jobs" -R "${tests// /|}" ||
  die "a test failed in $suite, see above"

say "Digests (after ${SECONDS} s)"
inside /root/argos3/scripts/digests.sh /root/argos3/build --any-build || die "the digests differ in $suite, see above"
say "All is fine in $suite; after ${SECONDS} s"
