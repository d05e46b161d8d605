#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# saw: plans, recipes and a picture; a board's recipe shows the log's wood at the
# board's place; and nothing is left behind by what fails or is stopped.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"
readonly json_check=$4 picture=$5
cd "$scratch" || exit 1
readonly log=(--species akamatsu --age 30 --log-height 2000 --log-length 800 --seed 3)
readonly quick=("${log[@]}" --res 640x360)

number() { # FILE KEY [BOARD]: a number of saw.json, of its whole or of a board
  awk -v key="\"$2\":" -v board="${3:-0}" '$1 == "\"board\":" { at = $2 + 0 }
    $1 == key && at == board + 0 { print $2 + 0; exit }' "$1/saw.json"
}

param() { # FILE NAME: what a recipe says
  sed -n "s/^  $2: //p" "$1" | tr -d '[],"'
}

# ---- every plan: its files, and what the boards show --------------------------

readonly columns=$'px,py,pz,nx,ny,nz,footprint\n'
points() { # the places on a face of W x L x T that are looked at
  awk -v w="$1" -v l="$2" -v z="$3" 'BEGIN {
    for (i = 0; i < 60; i++)
      printf "%.4f,%.4f,%.4f,0,0,1,1\n", w * (i * 0.618034 % 1 - 0.5) * 0.98,
             l * ((i + 0.5) / 60 - 0.5) * 0.98, z }'
}

to_log() { # RECIPE: points of its object in the log, by the words of describe wood
  awk -F, -v cut="$(param "$1" cut)" -v d="$(param "$1" cut_distance)" \
    -v h="$(param "$1" cut_height)" -v turn="$(param "$1" cut_rotation)" \
    -v t="$(param "$1" veneer_thickness)" -v offset="$(param "$1" cut_offset)" 'BEGIN {
      pi = atan2(0, -1); a = turn * pi / 180; c = cos(a); s = sin(a); split(offset, o, " ")
      x0 = cut == "quarter" ? d : cut == "rift" ? d * sqrt(0.5) : 0
      z0 = cut == "flat" ? d : cut == "rift" ? d * sqrt(0.5) : 0 }
    { if (cut == "rotary") {
        r = sqrt(d * d - t * $1 / pi); b = a + pi / 2 - 2 * pi * (d - r) / t
        printf "%.8f,%.8f,%.8f,%.8f,0,%.8f,1\n", (r + $3) * cos(b), $2 + h, (r + $3) * sin(b), cos(b), sin(b)
      } else {
        x = $1 + x0; z = $3 + z0
        printf "%.8f,%.8f,%.8f,%.8f,0,%.8f,1\n", c * x - s * z + o[1], $2 + h + o[2], s * x + c * z + o[3], -s, c } }'
}

shows_the_log() { # RECIPE Z [SHARE of its width]
  local size w l
  size=$(sed -n 's/^  size: \[\(.*\)\]/\1/p' "$1" | tr -d ,)
  read -r w l _ <<<"$size"
  w=$(awk "BEGIN { print $w * ${3:-1} }")
  points "$w" "$l" "$2" >places
  { printf '%s' "$columns"; cat places; } >board.csv
  { printf '%s' "$columns"; to_log "$1" <places; } >log.csv
  works eval "$1" --channels albedo,knot -i board.csv -o board.out
  works eval wood --preset akamatsu -p tree=akamatsu -p tree_age=30 -p seed=3 -p log_height=2000 \
    -p cut=log --channels albedo,knot -i log.csv -o log.out
  local far
  far=$(paste -d, board.out log.out | awk -F, 'NR > 1 { worst = 0
    for (i = 1; i <= 4; i++) { d = $i - $(i + 4); if (d < 0) d = -d; if (d > worst) worst = d }
    if (worst > 1e-4) n++ } END { print n + 0, NR - 1 }')
  same "$1 shows the log's wood: points of 60 that differ by more than 1e-4" "0 60" "$far"
}

# Whether a recipe's origin is the middle of the plan's board.
stands_in_place() { # PLAN BOARD RECIPE
  local wanted got
  wanted=$(awk -v board="$2" '$1 == "\"board\":" { at = $2 + 0 }
    $1 == "\"middle\":" && at == board + 0 { on = 1; next } on && /]/ { exit }
    on { printf "%.4f ", $1 }' "$1/saw.json")
  got=$(echo 0,0,0 | to_log "$3" | awk -F, '{ printf "%.4f %.4f %.4f ", $1, $2, $3 }')
  same "$3 stands in the plan's place" "${wanted//-0.0000/0.0000}" "${got//-0.0000/0.0000}"
}

for plan in live quarter rift rotary; do
  # of veneer sheets, where x is small enough to be a float without loss
  sheets=()
  [[ $plan == rotary ]] && sheets=(--width 900)
  works saw "${quick[@]}" --plan "$plan" "${sheets[@]}" -o "$plan"
  check "$plan: saw.json is JSON" "$json_check" "$plan/saw.json"
  check "$plan: the picture is finite" "$picture" finite "$plan/log.png"
  boards=$(grep -c '"board":' "$plan/saw.json")
  same "$plan: as many recipes as boards" "$boards" "$(find "$plan" -name 'board-*.sozai' | wc -l)"
  yield=$(number "$plan" yield_percent)
  check "$plan: yields $yield percent" awk "BEGIN { exit !($yield > 10 && $yield < 90) }"
  last=$(printf '%s/board-%02d.sozai' "$plan" "$boards")
  for recipe in "$plan/board-01.sozai" "$last"; do
    z=$(param "$recipe" cut | awk -v t="$(sed -n 's/.*size: .*, \([0-9.]*\)\]/\1/p' "$recipe")" '{
      print $1 == "rotary" ? 0 : t / 2 }')
    shows_the_log "$recipe" "$z"
  done
  for ((i = 1; i <= boards; i++)); do
    stands_in_place "$plan" "$i" "$(printf '%s/board-%02d.sozai' "$plan" "$i")"
  done
done
works saw "${quick[@]}" --plan rotary -o sheet
same "one sheet" 1 "$(grep -c '"board":' sheet/saw.json)"
shows_the_log sheet/board-01.sozai 0 0.05

works render live/board-03.sozai -o board.exr --res 160x120 --spp 2 --camera front
check "a board is rendered" "$picture" finite board.exr
same "its size is the plan's" "$(sed -n 's/^  size: //p' live/board-03.sozai | tr -d '[] ')" \
  "$(awk '$1 == "\"board\":" { at = $2 + 0 } $1 == "\"size\":" && at == 3 { on = 1; next }
     on && /]/ { exit } on { printf "%s", $1 }' live/saw.json)"

# Knots that are counted are there to be seen, and where none is there is none but a sliver: the
# wood rounds a knot's collar where the count has a cone.
for plan in live quarter rift; do
  with=0
  for ((i = 1; i <= $(grep -c '"board":' "$plan/saw.json"); i++)); do
    knots=$(number "$plan" knots "$i") share=$(number "$plan" knot_share "$i")
    check "$plan: board $i: $knots knots, a share of $share" \
      awk "BEGIN { exit !($knots > 0 ? $share > 0 && $share < 0.3 : $share < 2e-4) }"
    ((knots > 0)) && with=$((with + 1))
  done
  check "$plan: some boards have knots: $with" test "$with" -gt 1
done
# The whole sheet has each knot that the wood shows on the branch's axis between bark and core.
works grow tree --species akamatsu --age 30 -p seed=3 -p orders=1 --table knots -o knots.csv
read -r from to < <(awk '/"knife_radius"/ { on = 1; next } on && /]/ { exit } on { printf "%g ", $1 }' \
  sheet/saw.json)
awk -F, -v from="$from" -v to="$to" 'NR > 1 && $7 > 1500 && $7 < 3300 {
  for (u = to; u <= from; u += 1) {
    y = $7 - 2000 + u * sin($6) / cos($6)
    if (y > 0 && y < 800) printf "%.4f,%.4f,%.4f,%d\n", u * cos($5), y, u * sin($5), NR } }' knots.csv >axes
{ echo px,py,pz; cut -d, -f1-3 axes; } >axes.csv
works eval wood --preset akamatsu -p tree=akamatsu -p tree_age=30 -p seed=3 -p log_height=2000 \
  --channels knot -i axes.csv -o axes.out
seen=$(tail -n +2 axes.out | paste -d, axes - | awk -F, '$5 > 0.5 { print $4 }' | sort -u | wc -l)
check "there are knots to be seen: $seen" test "$seen" -gt 3
same "knots on the sheet" "$seen" "$(number sheet knots 1)"

# ---- a tree that was measured ---------------------------------------------------

cat >measured.field <<'EOT'
# a trunk of 6 m with branches to the east and to the south
trunk
200 0 90 30
200 0 90 24
200 0 90 12
B100
0
80 90 20 4
B200
0
0
60 180 10 3
EOT
works saw --field measured.field --species akamatsu --age 30 --log-height 1500 --log-length 1000 \
  --res 640x360 -o measured
check "measured: saw.json is JSON" "$json_check" measured/saw.json
check "measured: the picture is finite" "$picture" finite measured/log.png
same "measured: the cone's radius at the upper end" 87.5 "$(number measured radius_upper)"
check "measured: a recipe has the whole table" grep -q 'tree_field: "# a trunk.*x0aB200' measured/board-01.sozai
crossed=0
for ((i = 1; i <= $(grep -c '"board":' measured/saw.json); i++)); do
  knots=$(number measured knots "$i") share=$(number measured knot_share "$i")
  check "measured: board $i: $knots knots, a share of $share" \
    awk "BEGIN { exit !($knots > 0 ? $share > 0 && $share < 0.3 : $share < 2e-4) }"
  ((knots > 0)) && crossed=$((crossed + 1))
done
check "measured: boards that the branch to the east crosses: $crossed" test "$crossed" -gt 0
# the branch to the east, half way out, as the board's own recipe and the log have it
works eval wood --preset akamatsu -p tree=akamatsu -p "tree_field=$(<measured.field)" -p tree_age=30 \
  -p log_height=1500 --channels knot -i <(printf 'px,py,pz\n40,%s,0\n-40,500,0\n' \
    "$(awk 'BEGIN { print 500 + 40 * sin(20 * 3.14159265 / 180) / cos(20 * 3.14159265 / 180) }')") -o east.out
same "measured: a knot to the east, none to the west" "1 0" "$(tail -n +2 east.out | awk '{ printf "%s%d", s, $1 + 0.5; s = " " }')"
works saw --field measured.field --wood sugi --age 30 --log-height 1500 --log-length 1000 --plan quarter \
  --res 640x360 -o unnamed
check "measured: --wood alone will do" grep -qx 'preset: "sugi"' unnamed/board-01.sozai

# ---- the same again, and instead -----------------------------------------------

works saw "${quick[@]}" --plan live -o again --threads 1
check "the same picture, whatever the threads" cmp -s live/log.png again/log.png
check "the same plan" cmp -s live/saw.json again/saw.json
touch again/mine.txt
works saw "${quick[@]}" --plan live --thickness 60 -o again
same "an earlier plan's further boards are gone" "$(grep -c '"board":' again/saw.json)" \
  "$(find again -name 'board-*.sozai' | wc -l)"
check "what is not the plan's stays" test -f again/mine.txt
works saw "${quick[@]}" --wood sugi -p "object=a \"b\" \\ c" -o named/
check "a parameter is written" grep -qF 'object: "a \"b\" \\ c"' named/board-01.sozai
works eval named/board-01.sozai --channels albedo -i board.csv
check "--wood names the preset" grep -qx 'preset: "sugi"' named/board-01.sozai

# ---- refusals: one line, and nothing left ---------------------------------------

mkdir shut && : >file
printf 'trunk\n50 0 90 9\nnan 0 90 9\n' >short.field
: >empty.field
printf 'trunk\n50 0 90 9\0\n' >zero.field
head -c 70000 /dev/zero | tr '\0' '#' >huge.field
chmod 500 shut
find . | sort | grep -vx -e ./out -e ./err -e ./before >before
refuses 2 "--species" saw --age 10 -o bad
refuses 2 "no folder|-o DIR" saw --species akamatsu
refuses 2 "cannot read|no/such" saw --species akamatsu --field no/such -o bad
refuses 2 "--wood|field table" saw --field measured.field -o bad
refuses 2 "field: line 3|length" saw --species akamatsu --field short.field -o bad
refuses 2 "empty" saw --species akamatsu --field empty.field -o bad
refuses 2 "zero byte" saw --species akamatsu --field zero.field -o bad
refuses 2 "field_bytes" saw --species akamatsu --field huge.field -o bad
refuses 2 "--log-length|above the ground" saw --species akamatsu --field measured.field -o bad \
  --log-height 5000 --log-length 2000
refuses 2 "tree_field" saw "${quick[@]}" -p tree_field=x -o bad
refuses 2 "triffid" saw --species triffid -o bad
refuses 2 "--wood|sugi_paper" saw --species sugi_paper -o bad
refuses 2 "no-such-wood" saw "${quick[@]}" --wood no-such-wood -o bad
refuses 2 "--plan|sideways|quarter" saw "${quick[@]}" --plan sideways -o bad
refuses 2 "--log-length|above the ground" saw "${quick[@]}" --log-length 20000 -o bad
refuses 2 "--log-length|radius" saw --species akamatsu --age 4 --log-height 500 --log-length 300 -o bad
refuses 2 "--thickness|900" saw "${quick[@]}" --thickness 900 -o bad
refuses 2 "--thickness|veneer|10" saw "${quick[@]}" --plan rotary --thickness 20 -o bad
refuses 2 "--kerf|rotary" saw "${quick[@]}" --plan rotary --kerf 3 -o bad
refuses 2 "--thickness|999" saw "${quick[@]}" --thickness 0.1 --kerf 0 -o bad
for option in age thickness width kerf log-height log-length azimuth knot-size; do
  for value in nan inf 1e30 -1e30 '' x; do
    refuses 2 "--$option|'$value'" saw "${quick[@]}" "--$option=$value" -o bad
  done
done
refuses 2 "cut_distance" saw "${quick[@]}" -p cut_distance=5 -o bad
refuses 2 "no_such" saw "${quick[@]}" -p no_such=5 -o bad
refuses 2 "ring_width" saw "${quick[@]}" -p ring_width=nan -o bad
refuses 2 "NAME=VALUE" saw "${quick[@]}" -p ring_width -o bad
refuses 2 "--res" saw "${quick[@]}" --res 1x1 -o bad
refuses 2 "--output|file" saw "${quick[@]}" -o file
refuses 2 "--output|file/in" saw "${quick[@]}" -o file/in
refuses 2 "--output|none/of/it" saw "${quick[@]}" -o none/of/it
refuses 2 "--output" saw "${quick[@]}" -o "$(printf 'x%.0s' {1..300})"
[[ $EUID == 0 ]] || refuses 2 "--output|shut" saw "${quick[@]}" -o shut
[[ $EUID == 0 ]] || refuses 2 "--output|shut/in" saw "${quick[@]}" -o shut/in
# a disk that is full half way
(
  ulimit -f 20
  "$sozai" saw "${quick[@]}" -o bad 2>full.txt
  echo $? >code
)
same "a full disk: exit code" 1 "$(<code)"
same "a full disk: lines" 1 "$(grep -c '' full.txt)"
rm -f code full.txt
find . | sort | grep -vx -e ./out -e ./err -e ./before -e ./after >after
same "nothing is left" "" "$(diff before after)"

# ---- a folder's name as long as names can be ---------------------------------------

printf -v name '%255s' ''
works saw "${quick[@]}" -o "${name// /n}"
check "its plan is there" test -s "${name// /n}/saw.json"
rm -rf "${name// /n}"
same "nothing else is" "" "$(compgen -G '.saw*')"

# ---- stopped ---------------------------------------------------------------------

for signal in INT TERM; do
  # enough work to be under way when the signal comes
  # bash has background jobs ignore SIGINT, and what is ignored stays so
  env --default-signal=INT "$sozai" saw "${log[@]}" --res 8000x6000 -o stopped 2>stopped.err &
  pid=$!
  for ((i = 0; i < 600; i++)); do
    compgen -G '.saw-*' >nowhere && break
    sleep 0.05
  done
  check "$signal: the work had begun" test -s nowhere
  kill -"$signal" "$pid"
  wait "$pid"
  code=$?
  same "$signal: exit code" "$signal" "$(kill -l "$code")"
  check "$signal: says so" grep -q 'cancelled' stopped.err
  same "$signal: nothing is left" "" "$(find . \( -name '*stopped*' -o -name '.saw-*' \) ! -name stopped.err)"
done
finish
