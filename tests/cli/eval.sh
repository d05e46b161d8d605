#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# eval against the mock plugin, whose answers are known.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"

# ---- answers ----------------------------------------------------------------
works eval wood <<<$'px,py,pz\n1,2,3'
same "channels that a point suffices for" "albedo_r,albedo_g,albedo_b,fiber_x,fiber_y,fiber_z,time,\
latewood,vessel,reference_x,reference_z,specular,roughness
0.75,0.5,0.25,0,1,0,3.1622777,0,0,1,3,0.5,0.25" "$out"

works eval wood --channels dive,albedo <<<$'nz,py,px,ny,nx,pz\n0.6,2,11,0.8,0,3'
same "columns and channels in the order given" $'dive,albedo_r,albedo_g,albedo_b\n0.800000012,0.125,0.125,0.125' "$out"

works eval wood --channels radiance -p shiny=true <<<$'px,py,pz,nx,ny,nz,lx,ly,lz,lr,lg,lb\n0,0,0,0,0,1,0,0,1,2,1,0'
same "light colour and a parameter" $'radiance_r,radiance_g,radiance_b\n2.5,1,0' "$out"

works eval wood --preset mock_oak --channels albedo -p pitch=5 <<<$'px,py,pz\n1,2,3\n6,2,3'
same "preset, and a parameter on top" $'albedo_r,albedo_g,albedo_b\n0.5,0.25,0.125\n0.125,0.125,0.125' "$out"

works eval wood --channels reference <<<$' px , py,pz \r\n 1.5 ,2,\t-3e2\r\n0x10,0,1\r\n\r\n'
same "spaces, returns, hexadecimal, blank lines at the end" $'reference_x,reference_z\n1.5,-300\n16,1' "$out"
works eval wood --channels reference <<<$'\n\r\npx,py,pz\n\n1.5,2,3\n \t\n\r\n4,5,6'
same "blank lines anywhere are skipped" $'reference_x,reference_z\n1.5,3\n4,6' "$out"
# which are read 65536 lines at a time
rows() { # how many, and blank lines after them
  echo px,py,pz
  yes 1,2,3 | head -n "$1"
  yes '' | head -n "$2"
}
works eval wood --channels reference -i <(rows 65535 3)
same "rows before blank lines that two blocks share" 65536 "$(wc -l <"$scratch/out")"
works eval wood --channels reference -i <(rows 10 140000; echo 1,2,3)
same "and between them" 12 "$(wc -l <"$scratch/out")"
works eval wood --channels reference -i <(rows 10 0; head -c 20000000 /dev/zero | tr '\0' '\n'; echo 1,2,3)
same "though they fill blocks" 12 "$(wc -l <"$scratch/out")"
refuses 2 ":65539: 2 values" eval wood --channels reference -i <(rows 65535 2; echo 1,2) \
  -o "$scratch/blank.csv"

works eval wood --channels reference < <(printf '\xef\xbb\xbfpx,py,pz\n0.1,0,123456789')
same "a byte-order mark, no newline at the end, nine digits" $'reference_x,reference_z\n0.100000001,123456792' "$out"

works eval wood <<<$'px,py,pz,nx,ny,nz,lx,ly,lz,vx,vy,vz,footprint\nnan,inf,-inf,nan,nan,nan,inf,0,0,nan,0,0,nan\nNaN,-Infinity,1e99,0,0,0,0,0,0,0,0,0,-1'
check "points that are not numbers give numbers" not grep -qi 'nan\|inf' "$scratch/out"
same "rows for them" 3 "$(wc -l <"$scratch/out")"

works eval wood --channels time <<<'px,py,pz'
same "a header alone" time "$out"

# ---- many rows, in blocks and slices ----------------------------------------
awk 'BEGIN { print "px,py,pz"; for (i = 0; i < 150000; i++) printf "%d.5,%d,0\n", i, i % 7 }' >"$scratch/many.csv"
works eval wood --channels reference --threads 1 -i "$scratch/many.csv" -o "$scratch/one.csv"
works eval wood --channels reference --threads 3 -i "$scratch/many.csv" -o "$scratch/three.csv"
check "the same whatever the threads" cmp "$scratch/one.csv" "$scratch/three.csv"
check "every row, in order" cmp <(tail -n +2 "$scratch/many.csv" | sed 's/,.*/,0/') <(tail -n +2 "$scratch/one.csv")

# ---- refusals ---------------------------------------------------------------
refuses 2 "standard input|empty input" eval wood </dev/null
refuses 2 "standard input:1|column 'pw'" eval wood <<<$'px,py,pz,pw\n1,2,3,4'
refuses 2 "column 'py'|twice" eval wood <<<$'px,py,pz,py\n1,2,3,4'
refuses 2 "column 'pz'|missing" eval wood <<<$'px,py\n1,2'
refuses 2 "column 'ny'|missing" eval wood <<<$'px,py,pz,nx,nz\n1,2,3,4,5'

# A bad row names its line; what came before it is printed only when it is right.
bad_row() { # words, row
  run_command eval wood --channels time <<<$'px,py,pz\n1,2,3\n'"$2"
  same "exit code for row '$2'" 2 "$code"
  local word
  while IFS= read -r word; do
    check "'$word' in: $err" grep -qF -- "$word" "$scratch/err"
  done < <(tr '|' '\n' <<<"$1")
}
bad_row 'standard input:3|2 values|3 columns' '1,2'
bad_row 'standard input:3|4 values|3 columns' '1,2,3,4'
bad_row "standard input:3|pz|'x'" '1,2,x'
bad_row "standard input:3|py|''" '1,,3'
bad_row "standard input:3|px|'1;2'" '1;2,2,3'
bad_row "standard input:3|pz|'$(printf 'x%.0s' {1..60})'" "1,2,$(printf 'x%.0s' {1..60})"
bad_row "standard input:3|pz|'$(printf 'x%.0s' {1..60})'" "1,2,$(printf 'x%.0s' {1..65})"
bad_row "standard input:3|px|'1 2'" '1 2,2,3'
bad_row 'standard input:5|2 values' $'\n\n1,2'
printf 'px,py,pz\n1,2,\0003\n' >"$scratch/zero.csv"
refuses 2 "zero.csv:2|zero byte" eval wood -i "$scratch/zero.csv"
{
  echo px,py,pz
  head -c 100000 /dev/zero | tr '\0' 1
} >"$scratch/long.csv"
run_command eval wood -i "$scratch/long.csv"
same "exit code for a line without end" 2 "$code"
check "its line: $err" grep -q 'long.csv:2: longer' "$scratch/err"
awk 'BEGIN { print "px,py,pz"; for (i = 0; i < 100000; i++) print "1,2,3"; print "1,2,z"; print "1,2,y" }' >"$scratch/late.csv"
run_command eval wood -i "$scratch/late.csv" -o "$scratch/late-out.csv"
same "exit code for a late mistake" 2 "$code"
check "the first mistake's line: $err" grep -q "late.csv:100002: pz 'z'" "$scratch/err"
check "no output file is left" test ! -e "$scratch/late-out.csv"
same "nor a temporary one" "" "$(find "$scratch" -name '.*.csv')"

refuses 2 "unknown channel 'albido'|albedo" eval wood --channels albido <<<$'px,py,pz\n1,2,3'
refuses 2 "channel 'albedo'|twice" eval wood --channels albedo,albedo <<<$'px,py,pz\n1,2,3'
refuses 2 "channel 'radiance'|lx,ly,lz" eval wood --channels radiance <<<$'px,py,pz,nx,ny,nz\n1,2,3,0,0,1'
refuses 2 "unknown material 'ood'|wood" eval ood <<<$'px,py,pz\n1,2,3'
refuses 2 "'ptch'" eval wood -p ptch=3 <<<$'px,py,pz\n1,2,3'
refuses 2 "pitch|1e+09|0.1|1000" eval wood -p pitch=1e9 <<<$'px,py,pz\n1,2,3'
refuses 2 "pitch|'soft'" eval wood -p pitch=soft <<<$'px,py,pz\n1,2,3'
refuses 2 "cut|'diagonal'|quarter" eval wood -p cut=diagonal <<<$'px,py,pz\n1,2,3'
refuses 2 "'pitch'|name=value" eval wood -p pitch <<<$'px,py,pz\n1,2,3'
refuses 2 "'no_such_wood'" eval wood --preset no_such_wood <<<$'px,py,pz\n1,2,3'
refuses 2 "--threads|'0'|1 to 256" eval wood --threads 0 <<<$'px,py,pz\n1,2,3'
refuses 2 "cannot read|none.csv" eval wood -i "$scratch/none.csv"
refuses 2 "cannot write|nowhere" eval wood -o "$scratch/nowhere/out.csv" <<<$'px,py,pz\n1,2,3'
refuses 2 "not the name of a file" eval wood -o "$scratch" <<<$'px,py,pz\n1,2,3'

# ---- what is no file is written in place -------------------------------------
mkfifo "$scratch/pipe"
timeout 20 cat "$scratch/pipe" >"$scratch/piped" &
works eval wood --channels reference -o "$scratch/pipe" <<<$'px,py,pz\n1,2,3'
wait
same "through a pipe" $'reference_x,reference_z\n1,3' "$(<"$scratch/piped")"
check "which is still one" test -p "$scratch/pipe"
echo old >"$scratch/target"
ln -s target "$scratch/link"
works eval wood --channels reference -o "$scratch/link" <<<$'px,py,pz\n1,2,3'
check "a link stays a link" test -L "$scratch/link"
same "to the new file" $'reference_x,reference_z\n1,3' "$(<"$scratch/target")"
"$sozai" eval wood <<<$'px,py,pz\n1,2,3' >/dev/full 2>"$scratch/err"
same "exit code for a full disk" 1 $?
check "it says so" grep -q 'cannot write' "$scratch/err"
"$sozai" eval wood --channels reference -i "$scratch/many.csv" 2>"$scratch/err" | head -n 1 >/dev/null
same "exit code where nobody reads on" 141 "${PIPESTATUS[0]}"
same "of which nothing is said" "" "$(<"$scratch/err")"
finish
