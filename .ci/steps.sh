# What `run` and `nightly` share: steps, what each takes, and what was left out. It is sourced.
set -euo pipefail
here=$PWD/.ci
mkdir -p target

# Nothing is edited between the steps, and what the compiler keeps for the next edit would be most of what they write
# to disk.
export CARGO_INCREMENTAL=0
# The linter compiles what is built here: nothing is read twice, and a warning is an error.
export RUSTC_WORKSPACE_WRAPPER=$here/lint CLIPPY_ARGS=-Dwarnings
LINKAGE_CLIPPY=$(rustc --print sysroot)/bin/clippy-driver
export LINKAGE_CLIPPY
# Tests append what they leave out, a line each.
export LINKAGE_SKIPS=${LINKAGE_SKIPS:-$PWD/target/skips.txt}
[ -n "${LINKAGE_TURN:-}" ] || : >"$LINKAGE_SKIPS"
table=()

# Processor seconds, of this shell and of all that it has waited for. A subshell would count its own.
processor() {
    times >target/times.txt
    spent=$(awk '{ for (k = 1; k <= 2; k++) { split($k, t, /[ms]/); sum += 60 * t[1] + t[2] } } END { print sum }' target/times.txt)
}

# The processor seconds of a crate that never changes, on both cores as most steps are.
yardstick() {
    local before other
    processor && before=$spent
    compile_yardstick one &
    other=$!
    compile_yardstick other
    wait $other
    processor && unit=$(awk "BEGIN { print ($spent - $before) / 2 }")
}

compile_yardstick() {
    rustc --edition 2024 --crate-name "$1" --crate-type lib --emit obj -O -o "target/yardstick.$1.o" .ci/yardstick.rs
}

# step NAME COMMAND…: runs it, and keeps what it took: seconds, processor seconds, and these in yardsticks, of which one is
# measured before the step and one behind it.
step() {
    local name=$1 from=$SECONDS before yard=$unit
    shift
    printf '\n== %s (at %d s)\n' "$name" "$SECONDS"
    processor && before=$spent
    "$@"
    processor
    local took=$((SECONDS - from)) cpu
    cpu=$(awk "BEGIN { print $spent - $before }")
    yardstick
    table+=("$(awk "BEGIN { printf \"%6d %9.0f %9.1f\", $took, $cpu, 2 * $cpu / ($yard + $unit) }")  $name")
}

# The compiler's own tests with these arguments, by the build of the README's command: alone they would ask for another
# build of the run-time.
compiler_tests() {
    cargo test --test compiler -- "$@"
}

# Says that something was left out.
skipped() {
    printf 'skipped: %s\n' "$1"
    printf '%s\n' "$1" >>"$LINKAGE_SKIPS"
}

# The table, and whether a step takes more than the yardsticks that the file named stores.
closing() {
    local worse=0
    printf '\n seconds processor yardsticks step\n'
    printf '%s\n' "${table[@]}"
    if [ -n "${1:-}" ]; then
        if [ -n "${LINKAGE_STORE:-}" ]; then
            printf '%s\n' "${table[@]}" | awk '{ printf "%.1f %s\n", $3, substr($0, 29) }' >"$here/$1"
        fi
        # A step of less than two yardsticks is too short to be judged.
        printf '%s\n' "${table[@]}" | awk -v stored="$here/$1" '
            BEGIN { while ((getline line < stored) > 0) { split(line, part, " "); of[substr(line, length(part[1]) + 2)] = part[1] } }
            { name = substr($0, 29)
              if (!(name in of)) { print "not stored in .ci/'"$1"': " name; worse = 1 }
              else if ($3 > 1.5 * of[name] && $3 > 2) { printf "%s takes %.1f yardsticks, more than 1.5 times the %.1f that are stored\n", name, $3, of[name]; worse = 1 } }
            END { exit worse }' || worse=1
    fi
    return $worse
}

# What was left out, and whether it is more than `skips.txt` has: what a machine with Rust, gcc, Python and node leaves out.
left_out() {
    printf '\nleft out:\n'
    sort -u "$LINKAGE_SKIPS" | sed 's/^/  /'
    sort -u "$LINKAGE_SKIPS" | comm -23 - <(sort "$here/skips.txt") |
        awk '{ print "not in .ci/skips.txt: " $0; found = 1 } END { exit found }'
}

yardstick
