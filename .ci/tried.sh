# What .ci/all and .ci/machines share: steps that are tried one after another, whether or not those before them passed, and a
# table of them. The file that sources it has set `logs`, the folder of their outputs.
mkdir -p "$logs"
status=0
table=""

# try NAME COMMAND...: runs a step, and keeps its output in a file
try() {
    local name="$1" begin=$SECONDS verdict=passed
    shift
    printf '\n=== %s\n' "$name"
    "$@" 2>&1 | tee "$logs/$name.log" || verdict=FAILED status=1
    table+="$(printf '%-14s %-9s %5d s   %s' "$name" "$verdict" $((SECONDS - begin)) \
        "$(grep -E '^=+ .*(passed|failed)' "$logs/$name.log" | tail -n 1 | tr -d =)")"$'\n'
}

# leave NAME REASON: a step that cannot run here
leave() { table+="$(printf '%-14s %-9s           %s' "$1" "not run" "$2")"$'\n'; }

# finish: the table, and the exit status of all steps
finish() {
    printf '\n%s' "$table"
    exit "$status"
}
