# For scripts that try something in a scratch copy of the repository: the copy, and what is expected of it.
# Sourced by those beside this folder; `course test` sets COURSE_ROOT and COURSE_BUILD for them.
# shellcheck shell=bash
: "${COURSE_ROOT:?}" "${COURSE_BUILD:?}"
failures=0

fail() {
    printf 'FAILED: %s\n' "$1"
    [ -z "${2:-}" ] || printf '%s\n' "$2" | sed 's/^/    /'
    failures=$((failures + 1))
}

# expect NAME STATUS PATTERN COMMAND...: the command ends with STATUS and says PATTERN somewhere.
expect() {
    local name=$1 status=$2 pattern=$3 output code=0
    shift 3
    output=$("$@" 2>&1) || code=$?
    [ "$code" = "$status" ] || { fail "$name: status $code, expected $status" "$output"; return; }
    grep -qE -- "$pattern" <<<"$output" || fail "$name: no '$pattern'" "$output"
}

# lend_to DIRECTORY: what is built there and is the same as in the repository is not compiled again: borrow.sh takes it
# from the repository's build.
lend_to() {
    export LENDER=$COURSE_ROOT LENDER_BUILD=$COURSE_BUILD BORROWER=$1 LENT=$COURSE_BUILD/scratch/lent
    mkdir -p "$LENT"
    sed -n 's/^ *"command": "\(.*\)",$/\1/p' "$COURSE_BUILD/compile_commands.json" >"$LENT/commands"
    # What each object depends on in the repository: a line that begins with its name, then a line for each file.
    ninja -C "$COURSE_BUILD" -t deps | awk -v root="$COURSE_ROOT/" -v build="$COURSE_BUILD/" '
        !/^    / { print; next }
        {
            file = substr($0, 5)
            if (file !~ "^/") file = build file
            while (sub("[^/]+/[.][.]/", "", file)) {}
            if (index(file, root) == 1) print "    " file
        }' >"$LENT/files"
    export BORROW_ELSE=${CMAKE_CXX_COMPILER_LAUNCHER:-}
    export CMAKE_CXX_COMPILER_LAUNCHER=$COURSE_ROOT/tests/program/scratch/borrow.sh NO_COLOR=1
}

# go_to_copy DIRECTORY: makes a copy there and goes to it.
go_to_copy() {
    lend_to "$1"
    rm -rf "$BORROWER"
    mkdir -p "$BORROWER"
    cd "$COURSE_ROOT" || exit
    # With their times, by which files are seen to be the same.
    cp -pR CMakeLists.txt course common chapters solutions references tests "$BORROWER"
    cd "$BORROWER" || exit
    # There are hundreds, CMake has a program for each, and nobody builds them here. Lessons show some.
    rm -rf tests/*/variants
    grep -rhoE '<!-- mistake [^ ]+' chapters | sed 's/.* //' | sort >"$COURSE_BUILD/scratch/shown"
    find tests -name '*.mistake' | while IFS= read -r mistake; do
        grep -qx "$(basename "$mistake" .mistake)" "$COURSE_BUILD/scratch/shown" || rm "$mistake"
    done
}

# finish: the closing line, and the script's status.
finish() {
    [ "$failures" = 0 ] && echo "everything is as it should be"
    exit $((failures > 0))
}
