#!/usr/bin/env bash
# The archive for Gradescope in a bare Debian: debootstrap makes a root directory, setup.sh builds in it, and
# run_autograder marks what must get known marks, with no more rights than a container's root has. For maintainers
# who are root; it takes some minutes, and 2 GB in build/ that are gone afterwards.
set -euo pipefail
cd "$(dirname "$0")/../.."
[ "$(id -u)" = 0 ] || { echo "Only root can make a Debian's root directory." >&2; exit 2; }
# In mounts of its own, which end with it.
[ -n "${OWN_MOUNTS:-}" ] || OWN_MOUNTS=1 exec unshare --mount --propagation private bash "$PWD/tests/grading/${0##*/}"

image=$PWD/build/image place=$PWD/build/image/autograder
chapter=01_ray_casting attacked=plane.cpp
# As Docker has them: above all, no mounts.
rights=-all,+chown,+dac_override,+fowner,+fsetid,+kill,+setgid,+setuid,+setpcap,+sys_chroot,+mknod,+setfcap
failed=0

for tool in debootstrap unzip jsonschema; do
    command -v $tool >/dev/null || { echo "$tool is not installed." >&2; exit 2; }
done
rm -rf "$image"
trap 'umount "$image/proc" && rm -rf "$image"' EXIT

timed() {  # timed NAME COMMAND...
    local start=$SECONDS
    "${@:2}" >"$image.log" 2>&1 || { tail -n 20 "$image.log"; echo "$1: FAILED"; exit 1; }
    printf '%s: %d s\n' "$1" $((SECONDS - start))
}
inside() { setpriv --bounding-set="$rights" --inh-caps=-all chroot "$image" "$@"; }

mkdir -p "$image/proc"
timed "debootstrap" debootstrap --variant=minbase bookworm "$image" \
    "$(awk '/^URIs:/ { print $2; exit }' /etc/apt/sources.list.d/debian.sources)"
mount -t proc proc "$image/proc"
timed "the archive" ./course --yes autograder build/autograder.zip --chapter ${chapter%%_*} --seed 5
# As Gradescope does it.
mkdir -p "$place/source" "$place/submission" "$place/results"
unzip -q build/autograder.zip -d "$place/source"
cp "$place/source/run_autograder" "$place"
timed "setup.sh" inside /autograder/source/setup.sh

# marked NAME POINTS SAYS: what is in submission/ gets so many points, and its results say this.
marked() {
    local results=$place/results/results.json points
    rm -rf "$results"
    timed "$1" inside /autograder/run_autograder
    cat "$image.log"
    points=$(grep -oE '"score": [0-9.]+' "$results" | awk '{ sum += $2 } END { print sum + 0 }')
    if jsonschema -i "$results" tests/grading/schemas/gradescope.schema.json && [ "$points" = "$2" ] &&
        grep -q -- "$3" "$results"; then
        printf '    %s points\n' "$points"
    else
        cat "$results"
        printf '%s: FAILED: %s points instead of %s, or other results\n' "$1" "$points" "$2"
        failed=1
    fi
}

submission=$place/submission
cp solutions/$chapter/*.cpp "$submission"
marked "all solved" 80 "isolation: user"
cp chapters/$chapter/*.cpp "$submission"
marked "as handed out" 0 "todo"
cp solutions/$chapter/*.cpp "$submission"
echo "int moon(" >>"$submission/$attacked"
marked "a file does not compile" 40 "not compiled"

# The solution's name can be seen, but nothing can be read: not by the compiler ...
secret=/autograder/source/course/solutions/$chapter/$attacked
echo "#include \"$secret\"" >"$submission/$attacked"
marked "an attack that includes the solution" 40 "not compiled"
# ... and not by the program, which is right as soon as it can read anything, and else ends itself.
{
    cat solutions/$chapter/$attacked
    cat <<END
#include <fcntl.h>
#include <unistd.h>
static const bool can_read = [] {
    for (const char* file : {"$secret", "/autograder/source/run_autograder", "/autograder/results/results.json",
                             "/autograder/submission/camera.cpp"})
        if (open(file, O_RDONLY) >= 0) return true;
    _exit(3);
}();
END
} >"$submission/$attacked"
marked "an attack that reads the grader's files" 0 "ended with status 3"

[ $failed = 0 ] && echo "everything is as it should be"
exit $failed
