#!/usr/bin/env bash
# The compiler's launcher in a scratch copy of the repository: where the repository's build has made an object by the
# same command from the same files, it is taken over, and else compiled. copy.sh sets the variables:
#   LENDER, LENDER_BUILD   the repository and its build directory
#   BORROWER               the copy, whose build directory is `build`
#   LENT                   the commands of the repository's build, and the files that each object depends on
#   BORROW_ELSE            the launcher that was in use before, if any
set -u

compile() { exec ${BORROW_ELSE:+"$BORROW_ELSE"} "$@"; }
[ -n "${LENDER:-}" ] || compile "$@"

# The command as the lender would give it, without what only ninja wants.
command="" output="" listing="" source=""
words=("$@")
for ((i = 0; i < $#; ++i)); do
    case ${words[i]} in
        -MD) continue ;;
        -MT) i=$((i + 1)); continue ;;
        -MF) i=$((i + 1)); listing=${words[i]}; continue ;;
        -o) output=${words[i + 1]} ;;
        -c) source=${words[i + 1]} ;;
    esac
    command+="${command:+ }${words[i]}"
done
command=${command//"$BORROWER/build"/$LENDER_BUILD}
command=${command//"$BORROWER"/$LENDER}
object=$output lent_source=${source/#"$BORROWER"/$LENDER}

# In a handout, the exercises as they were handed out are the lender's, and a student may have written a chapter as
# its solution does.
case $output in
    */solution_*/.course/pristine/*) chapter=/.course/pristine/ lent_chapter=/chapters/ kind=solution lent_kind=exercise ;;
    */exercise_*/chapters/*) chapter=/chapters/ lent_chapter=/solutions/ kind=exercise lent_kind=solution ;;
    *) chapter="" ;;
esac
if [ -n "$chapter" ] && ! cmp -s "$source" "$lent_source"; then
    command=${command//"$chapter"/$lent_chapter} object=${object//"$chapter"/$lent_chapter}
    command=${command//"/${kind}_"//${lent_kind}_} object=${object//"/${kind}_"//${lent_kind}_}
    lent_source=${lent_source//"$chapter"/$lent_chapter}
    # Exercises can be traced to their lines (CMakeLists.txt); what they compute is the same.
    traced=" -Wno-unused-parameter -g1 -D_GLIBCXX_ASSERTIONS"
    if [ "$lent_kind" = solution ]; then
        command=${command/"$traced"/} command=${command/exercise_headers.dir/common_math.dir}
    else
        command=${command/ -Wno-unused-parameter/"$traced"} command=${command/common_math.dir/exercise_headers.dir}
    fi
fi
object=$LENDER_BUILD/$object
if [ -z "$output" ] || [ -z "$listing" ] || [ ! -f "$object" ]; then compile "$@"; fi
grep -qxF -- "$command" "$LENT/commands" || compile "$@"

# The files that it depends on are older than the object, and the same in the copy.
is_same() {  # is_same LENT OURS
    case $1 in
        *.gch) ;;  # made of files that are named here, too
        "$LENDER_BUILD"/*)  # made by CMake, with names of directories in it, and contracts that only a copy has
            local ours
            ours=$(grep -v '^#include "chapters/9' "$2") || return 1
            [ "${ours//"$BORROWER"/$LENDER}" = "$(<"$1")" ] ;;
        *) [ -e "$2" ] && ! [ "$1" -nt "$2" ] && ! [ "$2" -nt "$1" ] && ! [ "$1" -nt "$object" ] ;;
    esac
}
made_of="$output:"
lent_object=${object#"$LENDER_BUILD/"}
while IFS= read -r file; do
    case $file in
        "$lent_source") ours=$source ;;
        "$LENDER_BUILD"/*) ours=$BORROWER/build${file#"$LENDER_BUILD"} ;;
        *) ours=$BORROWER${file#"$LENDER"} ;;
    esac
    is_same "$file" "$ours" || compile "$@"
    ours=${ours//'$'/'$$'}
    made_of+=" ${ours// /\\ }"
done < <(awk -v object="$lent_object:" 'index($0, object) == 1 { on = 1; next } /^[^ ]/ { on = 0 } on && /^ / { print substr($0, 5) }' "$LENT/files")
[ "$made_of" != "$output:" ] || compile "$@"

cp "$object" "$output" && printf '%s\n' "$made_of" >"$listing"
