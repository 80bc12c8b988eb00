# What app/start and tests/run share: install what is missing, configure, build.
# Sourced by bash in the project's top folder, under set -euo pipefail.

# Each line: the Debian package, and how other systems tell whether it is there.
build_packages='
g++                tool:c++
cmake              tool:cmake
ninja-build        tool:ninja
libncurses-dev     header:curses.h
libeigen3-dev      header:Eigen/Core
nlohmann-json3-dev header:nlohmann/json.hpp
libcli11-dev       header:CLI/CLI.hpp
libfmt-dev         header:fmt/format.h
libmpfr-dev        header:mpfr.h
'
test_packages='
libboost-dev       header:boost/multiprecision/cpp_bin_float.hpp
libgtest-dev       header:gtest/gtest.h
librapidcheck-dev  header:rapidcheck.h
libbenchmark-dev   header:benchmark/benchmark.h
libvterm-dev       header:vterm.h
mandoc             tool:mandoc
valgrind           tool:valgrind
clang-format-14    tool:clang-format-14
pkgconf            tool:pkg-config
zsh                tool:zsh
fish               tool:fish
tmux               tool:tmux
screen             tool:screen
'

build_folder=build/release
log=$(mktemp)
trap 'rm -f "$log"' EXIT

say() { printf 'carom: %s\n' "$*" >&2; }

# Shows the whole log of a stage that failed, and ends.
give_up() {
  cat "$log" >&2
  say "$1"
  exit 1
}

is_there() {
  case $1 in
    tool:*) command -v "${1#tool:}" >/dev/null ;;
    header:*) c++ -E -x c++ -I/usr/include/eigen3 -include "${1#header:}" /dev/null >/dev/null 2>&1 ;;
  esac
}

is_installed() {
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

as_root() {
  if [ "$(id -u)" = 0 ]; then
    "$@"
  elif [ -t 0 ]; then
    sudo "$@"
  else
    sudo -n "$@"
  fi
}

apt_get() {
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get -qq -o DPkg::Lock::Timeout=300 "$@" >>"$log" 2>&1 </dev/null
}

# install_missing LIST: installs the packages of a list that are not there; asks dpkg first.
install_missing() {
  local debian=no missing=() package probe
  if command -v apt-get >/dev/null && command -v dpkg-query >/dev/null; then debian=yes; fi
  while read -r package probe; do
    [ -n "$package" ] || continue
    if [ $debian = yes ] && is_installed "$package"; then continue; fi
    is_there "$probe" || missing+=("$package")
  done <<<"$1"
  [ ${#missing[@]} -gt 0 ] || return 0

  if [ $debian = no ]; then
    say "this system has no apt-get; what is missing, by the names of Debian's packages:"
    printf '  %s\n' "${missing[@]}" >&2
    exit 1
  fi
  if [ "$(id -u)" != 0 ] && ! command -v sudo >/dev/null; then
    say "packages are missing, and there is no sudo; run this as root, then try again:"
    printf '  apt-get install --no-install-recommends %s\n' "${missing[*]}" >&2
    exit 1
  fi
  say "installing ${missing[*]}"
  if ls /var/lib/apt/lists/*_Packages* >/dev/null 2>&1; then
    apt_get install --no-install-recommends -y "${missing[@]}" && return 0
    : >"$log" # the lists may be old: once more with new ones
  fi
  { apt_get update && apt_get install --no-install-recommends -y "${missing[@]}"; } ||
    give_up "installing failed; by hand, as root: apt-get install ${missing[*]}"
}

is_cached() { grep -qs -- "^$1\$" "$build_folder/CMakeCache.txt"; }

# configure [tests]: once; the tests join a build that is there, and stay.
configure() {
  local settings=()
  if [ "${1:-}" = tests ]; then
    settings=(-DCAROM_TESTS=ON)
  elif ! is_cached CAROM_TESTS:BOOL=ON; then
    settings=(-DCAROM_TESTS=OFF)
  fi
  if [ -n "${CI:-}" ]; then settings+=(-DCAROM_WERROR=ON); fi
  if is_cached "CMAKE_HOME_DIRECTORY:INTERNAL=$(pwd -P)"; then
    if [ -e $build_folder/build.ninja ] && { [ "${1:-}" != tests ] || is_cached CAROM_TESTS:BOOL=ON; }; then
      return 0
    fi
  else
    settings+=(--fresh) # nothing is built yet, or the folder was moved
  fi
  say "configuring"
  cmake --preset release "${settings[@]}" >"$log" 2>&1 || give_up "configuring failed"
}

# build TARGET: says nothing where there is nothing to do.
build() {
  cmake --build --preset release --target "$1" 2>&1 | tee "$log" | show_building ||
    give_up "building failed"
}

# One line: on a terminal it counts the steps of ninja's output.
show_building() {
  local line said=no
  while IFS= read -r line; do
    [[ $line == \[* && $line != *'Re-checking globbed'* ]] || continue
    if [ -t 2 ]; then
      printf '\rcarom: building %s]' "${line%%]*}" >&2
    elif [ $said = no ]; then
      say "building"
    fi
    said=yes
  done
  if [ $said = yes ] && [ -t 2 ]; then printf '\n' >&2; fi
}
