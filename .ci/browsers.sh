#!/usr/bin/env bash
# browsers.sh [SECONDS [PACKAGE...]]: installs the browsers that the tests drive, where it is root and has apt-get; prints
# one line for each that cannot be driven here, and never fails: without them their tests are skipped. The network may be
# closed.
set -uo pipefail
limit="${1:-420}" # seconds for all
wanted=("${@:2}")
[ ${#wanted[@]} -gt 0 ] || wanted=(chromium firefox-esr xvfb)

have() {
  case "$1" in
    chromium) command -v chromium || command -v chromium-browser || command -v google-chrome ;;
    firefox-esr) command -v firefox-esr || command -v firefox ;;
    xvfb) command -v Xvfb ;;
  esac >/dev/null
}

log="$(mktemp)"
trap 'rm -f "$log"' EXIT
declare -A reason # why a package is not there
export DEBIAN_FRONTEND=noninteractive

# What is asked of apt-get, within what is left of the time; its answer is in the log.
apt() {
  local left=$((limit - SECONDS))
  [ "$left" -gt 0 ] || { echo "E: apt-get took longer than $limit s" >"$log"; return 1; }
  timeout -k 10 "$left" apt-get -qq -o Acquire::Retries=1 -o Acquire::http::Timeout=20 -o Acquire::https::Timeout=20 \
    -o DPkg::Lock::Timeout=60 "$@" >"$log" 2>&1 </dev/null && return 0
  [ "$SECONDS" -lt "$limit" ] || echo "E: apt-get took longer than $limit s" >>"$log"
  return 1
}

updated=""
for package in "${wanted[@]}"; do
  if have "$package"; then
    continue
  elif [ "$(id -u)" != 0 ]; then
    reason[$package]="only root can install packages"
  elif ! command -v apt-get >/dev/null; then
    reason[$package]="there is no apt-get"
  else
    [ -n "$updated" ] || { apt update; updated=yes; } # lists of an earlier day may do, too
    apt install -y --no-install-recommends "$package" ||
      reason[$package]="$(grep -E '^(E|Err):' "$log" | tail -n 1 | cut -c 1-200)"
    have "$package" && unset "reason[$package]"
  fi
done

for package in "${!reason[@]}"; do
  name=Firefox
  [ "$package" != chromium ] || name=Chromium
  echo "not run: the viewer in $name ($package could not be installed: ${reason[$package]:-apt-get does not say why})"
done
exit 0
