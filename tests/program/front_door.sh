#!/usr/bin/env bash
# The script `course` on machines that lack something: what it asks for, what it runs, and how it ends.
# The machine is made of stand-ins for apt, dpkg, sudo and the build; nothing is installed.
# Run by `course test`, which sets COURSE_ROOT and COURSE_BUILD.
set -eu
: "${COURSE_ROOT:?}" "${COURSE_BUILD:?}"
machine=$COURSE_BUILD/scratch/machine
failures=0

fail() {
    printf 'FAILED: %s\n' "$1"
    printf '%s\n' "$2" | sed 's/^/    /'
    failures=$((failures + 1))
}

# expect NAME STATUS PATTERN ARGUMENTS...: `course ARGUMENTS` on the machine.
expect() {
    local name=$1 status=$2 pattern=$3 output code=0
    shift 3
    output=$(cd / && PATH=$machine/bin ./"${machine#/}"/tree/course "$@" 2>&1 </dev/null) || code=$?
    [ "$code" = "$status" ] || { fail "$name: status $code, expected $status" "$output"; return; }
    grep -qE -- "$pattern" <<<"$output" || fail "$name: no '$pattern'" "$output"
}

# stand_in NAME BODY: a program of the machine.
stand_in() {
    printf '#!/bin/bash\n%s\n' "$2" >"$machine/bin/$1"
    chmod +x "$machine/bin/$1"
}

rm -rf "$machine"
mkdir -p "$machine/bin" "$machine/tree"
cp "$COURSE_ROOT/course" "$machine/tree"
for tool in bash env dirname readlink sed grep tail head tr rm mkdir mktemp cat mv flock ln; do
    ln -s "$(command -v $tool)" "$machine/bin/$tool"
done
stand_in sleep ''  # nobody waits for apt's lock
export MACHINE=$machine

# A system without apt.
expect "no apt" 2 "This system has no apt.*" list
expect "no apt: what to install" 2 "CLI11, nlohmann-json" list

# Debian: the file `installed` holds what is there; apt-get adds to it, and says what it was asked.
installed=$machine/installed
: >"$installed"
# shellcheck disable=SC2016
stand_in dpkg-query 'while read -r p; do for q in "$@"; do [ "$p" = "$q" ] && echo "installed $p"; done; done <"$MACHINE/installed"; exit 1'
# shellcheck disable=SC2016
stand_in apt-get 'echo "apt-get $*" >>"$MACHINE/asked"
[ -e "$MACHINE/locked" ] && { rm "$MACHINE/locked"; echo "E: Could not get lock /var/lib/dpkg/lock-frontend"; exit 100; }
[ -e "$MACHINE/no_list" ] && [ "$1" = install ] && { mv "$MACHINE/no_list" "$MACHINE/locked"; echo "E: Unable to locate package"; exit 100; }
[ "$1" = update ] && exit 0
[ -e "$MACHINE/broken" ] && { echo "E: no network"; exit 100; }
for p in "$@"; do case $p in -* | install) ;; *) echo "$p" >>"$MACHINE/installed" ;; esac; done'
# The build: configuring makes build.ninja, building makes a program that says what it was given.
# shellcheck disable=SC2016
stand_in cmake 'echo "cmake $*" >>"$MACHINE/asked"
[ "$1" = --build ] && [ -e "$MACHINE/slow_build" ] && read -rt 1.5 <><(:)
[ "$1" = --build ] && echo "[1/2] Building"
[ "$1" = --build ] && mkdir -p "$2/bin" && rm -f "$2/bin/course" && printf "#!/bin/bash\necho program: \"\$@\"\n" >"$2/bin/course" && chmod +x "$2/bin/course"
[ "$1" = -S ] && echo "CMAKE_HOME_DIRECTORY:INTERNAL=$2" >"$4/CMakeCache.txt" && : >"$4/build.ninja"
[ -e "$MACHINE/broken_build" ] && echo "/x/y.cpp:1:2: error: no good" && exit 1
exit 0'
ln -s "$(command -v chmod)" "$machine/bin/chmod"

stand_in id 'echo 1000'
expect "no sudo: the exact command" 2 "sudo apt-get install -y --no-install-recommends g\+\+ cmake" list
# shellcheck disable=SC2016
stand_in sudo 'echo sudo >>"$MACHINE/asked"; "$@"'
expect "sudo, but nobody to ask" 2 "sudo apt-get install -y" list
[ ! -e "$machine/asked" ] || fail "nothing was run without leave" "$(cat "$machine/asked")"
expect "--yes answers, and is not the program's" 0 "^program: list --json$" list --yes --json
grep -q '^sudo$' "$machine/asked" || fail "sudo was used" "$(cat "$machine/asked")"
grep -q -- '--no-install-recommends g++ cmake ninja-build' "$machine/asked" || fail "apt-get was run" "$(cat "$machine/asked")"

: >"$machine/asked"
expect "a second call only builds" 0 "^program: render a b.scene$" render "a b.scene"
if grep -qE 'apt-get|cmake -S' "$machine/asked"; then fail "nothing else was run" "$(cat "$machine/asked")"; fi

stand_in id 'echo 0'
expect "tests need more" 0 "Installing libcgal-dev libgmp-dev libmpfr-dev catch2" check 01
grep -q 'cmake -S' "$machine/asked" || fail "new packages are found by configuring again" "$(cat "$machine/asked")"
sed -i /povray/d "$installed"
: >"$machine/locked"
expect "apt runs elsewhere: wait and say so" 0 "Waiting for another program that installs packages" references
grep -qx povray "$installed" || fail "and then install" "$(cat "$installed")"
sed -i /povray/d "$installed"
: >"$machine/no_list"
expect "the lists' lock is waited for, too" 0 "Waiting for another program that installs packages" references
grep -qx povray "$installed" || fail "and then install" "$(cat "$installed")"
sed -i /povray/d "$installed"
: >"$machine/broken"
expect "apt fails: its last words, and the command" 2 "E: no network" references
expect "apt fails: its last words, and the command" 2 "apt-get update && apt-get install .* povray" references
expect "other commands go on" 0 "^program: list$" list

rm "$machine/broken"
echo kept >"$machine/tree/build/witness"
expect "nothing is built anew" 0 "^program: list$" list
[ -e "$machine/tree/build/witness" ] || fail "a build is kept"
ln -s "$machine/tree" "$machine/link"
(cd "$machine/link" && PATH=$machine/bin ./course list) >/dev/null 2>&1 || fail "through a link"
[ -e "$machine/tree/build/witness" ] || fail "a build is kept when the tree is reached through a link"
printf 'CMAKE_HOME_DIRECTORY:INTERNAL=%s\n' "$machine/link" >"$machine/tree/build/CMakeCache.txt"
expect "a build that was made through a link is kept, too" 0 "^program: list$" list
[ -e "$machine/tree/build/witness" ] || fail "a build that was made through a link is kept, too"

: >"$machine/slow_build"
said=$(PATH=$machine/bin "$(command -v script)" -qec "$machine/tree/course list" /dev/null </dev/null)
[[ $said == *"Building, 1 s"*"program: list"* ]] || fail "on a terminal, a build that takes long counts its seconds" "$said"
rm "$machine/slow_build"

printf 'CMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere\n' >"$machine/tree/build/CMakeCache.txt"
echo '{"99.1":3}' >"$machine/tree/build/hints.json"
: >"$machine/asked"
expect "a moved tree is built anew" 0 "^program: $" ""
grep -q 'cmake -S' "$machine/asked" || fail "a moved tree is configured" "$(cat "$machine/asked")"
[ "$(cat "$machine/tree/.course/hints.json")" = '{"99.1":3}' ] || fail "hints of an earlier version are kept"

mkdir -p "$machine/it's"
cp "$COURSE_ROOT/course" "$machine/it's"
said=$(cd "$machine/it's" && PATH=$machine/bin ./course list 2>&1) && fail "a path that Ninja cannot follow" "$said"
[[ $said == *"Rename the folder." ]] || fail "a path that Ninja cannot follow is named" "$said"

# The build is asked only when something of what the program is made of has changed. Until here there was no find.
ln -s "$(command -v find)" "$machine/bin/find"
mkdir -p "$machine/tree/common/math" "$machine/tree/chapters/01_a"
: >"$machine/tree/common/math/x.cpp"
: >"$machine/tree/chapters/01_a/x.hpp"
# expect_build NAME YES-OR-NO: whether the next command asks for a build.
expect_build() {
    local asked=no
    : >"$machine/asked"
    expect "$1" 0 "^program: list$" list
    if grep -q 'cmake --build' "$machine/asked"; then asked=yes; fi
    [ $asked = "$2" ] || fail "$1: asks for a build: $asked, expected $2" "$(cat "$machine/asked")"
}
expect_build "what was never built with its stamp" yes
expect_build "nothing has changed" no
: >"$machine/tree/chapters/01_a/x.cpp"
expect_build "what students write is no part of the program" no
touch -d '1 day ago' "$machine/tree/common/math/x.cpp"
expect_build "a file that was replaced by an older one" yes
rm "$machine/tree/common/math/x.cpp"
expect_build "a file that was deleted" yes
: >"$machine/tree/chapters/01_a/y.hpp"
expect_build "a contract that is new" yes
rm "$machine/tree/chapters/01_a/y.hpp"
expect_build "and one that was deleted" yes
rm "$machine/tree/build/bin/course"
expect_build "the program itself" yes
: >"$machine/tree/build/build.ninja"
expect_build "a build that was configured with other options" yes
: >"$machine/tree/CMakeLists.txt"
: >"$machine/broken_build"
expect "a build that breaks" 1 "no good" tour
rm "$machine/broken_build"
expect_build "leaves no stamp" yes
expect_build "and one that succeeds does" no
rm "$machine/bin/find"

: >"$machine/broken_build"
expect "a broken build shows the error" 1 "y.cpp:1:2: error: no good" tour
expect "and nothing else runs" 1 "all of it: .*build.log" tour
expect "but the student's commands do, by the last program" 0 "^program: hint 02.1$" hint 02.1
expect "which is said" 0 "could be built last" reset 02
expect "with the error" 0 "y.cpp:1:2: error: no good" ""
rm "$machine/tree/build/last_program"
expect "if there is none, nothing runs" 1 "y.cpp:1:2: error: no good" hint 02.1
# shellcheck disable=SC2016
stand_in cmake 'printf "/x/caf\xe9.cpp:1:2: error: no \033[2Jgood\n"; exit 1'
expect "an error that is not UTF-8 is shown, too" 1 "cpp:1:2: error: no \?\[2Jgood" list

[ "$failures" = 0 ] && echo "everything is as it should be"
exit $((failures > 0))
