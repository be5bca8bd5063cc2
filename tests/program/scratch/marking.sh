# For scripts that mark or compare submissions, in a directory of their own. Sourced by those beside this folder.
# shellcheck shell=bash
# shellcheck source=tests/program/scratch/copy.sh
. "$(dirname "${BASH_SOURCE[0]}")/copy.sh"
course=$COURSE_BUILD/bin/course

# begin_in NAME: an empty directory of this name, where all else happens.
begin_in() {
    own_place=$COURSE_BUILD/scratch/$1
    rm -rf "$own_place"
    mkdir -p "$own_place"
    cd "$own_place" || exit
}

# best_of LEVEL...: the first of these levels of boxes that this machine can do.
best_of() {
    local level
    echo "no archive" >no.zip
    for level in "$@"; do
        "$course" similarity no.zip --chapter 01 --isolation "$level" >/dev/null 2>said && break
        grep -q "is not possible here" said || break
    done
    rm no.zip said
    echo "$level"
}

# end_there: removes the directory; the closing line, and the script's status.
end_there() {
    cd "$COURSE_ROOT" || exit
    rm -rf "$own_place"
    finish
}
