# shellcheck shell=bash
# A bare Debian in a temporary folder, for scripts that try something there; sourced behind lib.sh, not run. Needs root,
# debootstrap and a network. MIRROR is where debootstrap and apt fetch packages.
mirror="${MIRROR:-http://deb.debian.org/debian}"
((EUID == 0)) || die "chroot needs root"
command -v debootstrap >/dev/null || die "there is no debootstrap; run: scripts/setup.sh package"

system="$(mktemp -d)"
remove_debian() {
  # never delete below a mount
  umount -l "$system/proc" 2>/dev/null || true
  mountpoint -q "$system/proc" || rm -rf --one-file-system -- "$system"
}
trap remove_debian EXIT

inside() { # inside COMMAND...: in the new system, without this shell's environment
  chroot "$system" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"
}

apt_install() {
  inside apt-get -y -qq -o Dpkg::Use-Pty=0 install --no-install-recommends "$@" >"$system/tmp/apt.log" 2>&1 ||
    { tail -n 30 "$system/tmp/apt.log" >&2; die "apt-get install $* failed, see above"; }
}

install_debian() { # install_debian <suite>
  say "A bare Debian, $1 (after ${SECONDS} s)"
  debootstrap --variant=minbase "$1" "$system" "$mirror" >"$system.log" 2>&1 ||
    { tail -n 20 "$system.log" >&2; die "debootstrap failed, see above"; }
  rm -f "$system.log"
  mount -t proc proc "$system/proc"
  inside apt-get -qq update
}

copy_sources() { # copy_sources <folder in the new system>: what is committed
  mkdir -p "$system$1"
  # shellcheck disable=SC2154  # lib.sh sets repo
  git -C "$repo" archive HEAD | tar -x -C "$system$1"
}
