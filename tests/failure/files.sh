#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Disks that are full, and files that are missing, unreadable, cut short, or no
# files at all: one line that names it, an exit code, nothing half made.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/lib.sh" "$@"
cd "$scratch" || exit 1
mkdir in made
readonly tiny=(--res 16x16 --spp 1)

# ---- what is read ----------------------------------------------------------------
printf 'v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n' >in/mesh.obj
printf 'material: wood\n' >in/plain.sozai
{
  echo px,py,pz
  for ((i = 0; i < 400; i++)); do printf '%d,0,0\n' "$i"; done
} >in/points.csv
works render wood -o in/photo.png --res 96x96 --spp 1 --shape plane
works grow tree -o in/tree.field -p age=4
mkfifo in/pipe.png in/pipe.obj in/pipe.sozai
mkdir in/folder.png in/folder.obj in/folder.sozai in/folder.field in/folder.csv

# Every command that writes a file, cheaply: what it writes, then how.
commands() { # each line: ending|words
  cat <<'LIST'
png|render wood --res 16x16 --spp 1
exr|render stone --res 16x16 --spp 1
exr|bake wood --size 40x20 --res 80x40
csv|eval wood --input in/points.csv
obj|grow tree -p age=4
gltf|grow tree -p age=4
csv|grow tree -p age=4 --table branches
png|grow tree -p age=2 --res 16x16 --spp 1
usda|grow fiber --hull ball -p count=40
hair|grow fiber --hull ball -p count=40
sozai|match in/photo.png
LIST
}

# A failure of some command: its code, its one line, and nothing left in made.
must_fail() { # what, file that the line names, [argument...]
  local what=$1 name=$2
  shift 2
  run_command "$@"
  check "$what: sozai $* fails; it exited with $code" test "$code" -ne 0 -a "$code" -lt 126
  # (libpng says a line of its own, which OpenImageIO lets through)
  same "$what: lines of message of sozai $*: $err" 1 "$(grep -vc '^libpng error: ' "$scratch/err")"
  check "$what: sozai $* names $name in: $err" grep -qF -- "$name" "$scratch/err"
  same "$what: nothing is left by sozai $*" "" "$(find made -mindepth 1)"
  rm -rf made
  mkdir made
}

# ---- without the library for pictures, and with one that is none -------------------
mkdir -p alone/bin alone/lib
cp "$sozai" alone/bin/
alone() { # words of the line
  alone/bin/sozai render wood "${tiny[@]}" -o made/x.png >out 2>err
  same "exit code without $1" 1 $?
  same "lines of message without $1" 1 "$(grep -c '' err)"
  check "'$1' in: $(<err)" grep -qF -- "$1" err
  same "nothing is left without $1" "" "$(find made -mindepth 1)"
}
alone "sozai-pictures.so not found in $scratch/alone/bin/../lib"
cp "$SOZAI_PLUGIN" alone/lib/sozai-pictures.so
alone "cannot load $scratch/alone/bin/../lib/sozai-pictures.so"
check "what needs no picture goes on" alone/bin/sozai list >out

# ---- what is written ---------------------------------------------------------------
while IFS='|' read -r ending words; do
  read -ra arguments <<<"$words"
  # as it should be, first: or the rest would prove nothing
  works "${arguments[@]}" -o "made/good.$ending"
  check "sozai $words writes" test -s "made/good.$ending"
  same "and nothing else" "made/good.$ending" "$(find made -mindepth 1)"
  size=$(stat -c %s "made/good.$ending")
  rm -rf made
  mkdir made

  # a link to a file that is not there, whose name is as long as a name can be
  printf -v name '%*s' $((254 - ${#ending})) ''
  name=${name// /n}.$ending
  mkdir made/far
  ln -s "far/$name" "made/link.$ending"
  works "${arguments[@]}" -o "made/link.$ending"
  same "a link: what sozai $words leaves" "made/far/$name made/link.$ending" \
    "$(find made -type l -o -type f -size +0 | sort | paste -sd ' ')"
  check "a link: sozai $words leaves it a link" test -L "made/link.$ending"
  rm -rf made
  mkdir made

  # a device that is full
  ln -sf /dev/full "in/full.$ending"
  run_command "${arguments[@]}" -o "in/full.$ending"
  check "full: sozai $words fails" test "$code" -ne 0 -a "$code" -lt 126
  same "full: lines of message of sozai $words: $err" 1 "$(grep -c '' "$scratch/err")"
  check "full: sozai $words names it in: $err" grep -qF "full.$ending" "$scratch/err"
  check "full: the link stays" test -L "in/full.$ending"

  # a disk that is full in the middle: a file may grow to so much and no more (the
  # limit holds for the messages' file too, so they go through a pipe)
  err=$( (
    ulimit -f $((size / 2048))
    "$sozai" "${arguments[@]}" -o "made/short.$ending" 2>&1 >/dev/null
    echo "exit $?"
  ) | cat)
  code=${err##*exit }
  err=${err%exit *}
  check "half of $size B: sozai $words fails, and exited with $code: $err" \
    test "$code" -ne 0 -a "$code" -lt 126
  same "half: lines of message of sozai $words: $err" 1 "$(printf '%s' "$err" | grep -c '')"
  check "half: sozai $words names it in: $err" grep -qF "made/short.$ending" <<<"$err"
  # what a bake has finished is kept for --resume
  same "half: nothing is left by sozai $words" "" \
    "$(find made -mindepth 1 -not -path '*.bake*')"
  rm -rf made
  mkdir made
done < <(commands)

for words in "png|render wood --res 16x16 --spp 1" "exr|bake wood --size 40x20 --res 80x40" \
  "csv|eval wood --input in/points.csv" "obj|grow tree -p age=4" \
  "usda|grow fiber --hull ball -p count=40" "sozai|match in/photo.png"; do
  ending=${words%%|*}
  read -ra arguments <<<"${words#*|}"
  must_fail "no folder" "none/a.$ending" "${arguments[@]}" -o "made/none/a.$ending"
  must_fail "a file for a folder" "in/mesh.obj/a.$ending" "${arguments[@]}" -o "in/mesh.obj/a.$ending"
  mkdir -p "in/taken.$ending"
  must_fail "a folder for a file" "in/taken.$ending" "${arguments[@]}" -o "in/taken.$ending"
done

# ---- links -----------------------------------------------------------------------------
links() { # those below, in made
  mkdir made/there made/links
  ln -s ../there/a.png made/links/first.png
  ln -s "$PWD/made/links/first.png" made/second.png
  ln -s none/a.png made/astray.png
  ln -s there/new/ made/folder.png
  ln -s round.png made/about.png
  ln -s about.png made/round.png
}
for words in "render wood --res 16x16 --spp 1" "bake wood --size 40x20 --res 80x40"; do
  read -ra arguments <<<"$words"
  links
  find made | sort >before
  works "${arguments[@]}" -o made/second.png
  check "from link to link: sozai $words" test -s made/there/a.png
  rm -f made/there/a.png
  refuses 2 "'made/astray.png'|'made/none/a.png'|whose folder is not there" "${arguments[@]}" -o made/astray.png
  refuses 2 "'made/folder.png'|'made/there/new/'|not the name of a file" "${arguments[@]}" -o made/folder.png
  refuses 2 "'made/about.png'|a link that leads back to itself" "${arguments[@]}" -o made/about.png
  same "the links are as they were, after sozai $words" "" "$(find made | sort | diff before -)"
  rm -rf made
  mkdir made
done
# As long as a name can be, and longer.
printf -v name '%251s' ''
for words in "render wood --res 16x16 --spp 1" "bake wood --size 40x20 --res 80x40"; do
  read -ra arguments <<<"$words"
  works "${arguments[@]}" -o "made/${name// /n}.png"
  same "all that sozai $words leaves" "made/${name// /n}.png" "$(find made -mindepth 1)"
  rm -rf made
  mkdir made
done
printf -v name '%252s' ''
must_fail "too long a name" "File name too long" render wood "${tiny[@]}" -o "made/${name// /n}.png"

# ---- folders of files ------------------------------------------------------------------
readonly sawn=(saw --species sugi --age 20 --log-length 300 --res 320x320)
err=$( (
  ulimit -f 1
  "$sozai" "${sawn[@]}" -o made/set 2>&1 >/dev/null
  echo "exit $?"
) | cat)
code=${err##*exit }
check "full: sozai ${sawn[*]} fails: $err" test "$code" -ne 0 -a "$code" -lt 126
check "full: it names the folder that was asked for: $err" grep -qF "made/set/" <<<"$err"
same "full: no half file is left by sozai ${sawn[*]}" "" \
  "$(find made -type f \( -name '.*' -o -size 0 -o -size +2 \))"
rm -rf made
mkdir made
must_fail "a file for a folder" "in/mesh.obj" "${sawn[@]}" -o in/mesh.obj
# their pictures take minutes: before any is drawn
must_fail "a file for a folder" "in/mesh.obj" figures stone-06 -o in/mesh.obj

# ---- what is read: missing, folders, pipes that nobody writes to, cut short ----------
for from in in/none.sozai in/folder.sozai in/pipe.sozai; do
  must_fail "recipe" "$from" render "$from" -o made/a.png "${tiny[@]}"
  printf 'include: %s\n' "${from#in/}" >in/includes.sozai
  must_fail "included" "includes.sozai:1" render in/includes.sozai -o made/a.png "${tiny[@]}"
done
must_fail "recipe" in/pipe.sozai bake in/pipe.sozai -o made/a.exr
must_fail "recipe" in/pipe.sozai eval in/pipe.sozai --input in/points.csv -o made/a.csv
# a picture that is the very file that asks for it
printf 'material: wood\nparams: {section: loop.sozai}\n' >in/loop.sozai
OIIO_LIBRARY_PATH=${SOZAI_PLUGIN%/*} must_fail "itself" loop.sozai \
  render in/loop.sozai -o made/a.png "${tiny[@]}"
printf 'material: wood\nparams: {section: LOOP.SOZAI}\n' >in/LOOP.SOZAI
OIIO_LIBRARY_PATH=${SOZAI_PLUGIN%/*} must_fail "itself" "LOOP.SOZAI: a .sozai file" \
  render in/LOOP.SOZAI -o made/a.png "${tiny[@]}"
works render wood -o made/a.png "${tiny[@]}" --shape in/mesh.obj
rm -f made/a.png
for from in in/none.obj in/folder.obj in/pipe.obj; do
  must_fail "mesh" "$from" render wood -o made/a.png "${tiny[@]}" --shape "$from"
  must_fail "hull" "$from" grow fiber --hull "$from" -o made/a.usda
  printf 'material: wood\nsurface: {shape: mesh, mesh: %s}\n' "${from#in/}" >in/meshed.sozai
  must_fail "baked mesh" "$from" bake in/meshed.sozai -o made/a.exr --res 16x16
done
for from in in/none.png in/folder.png in/pipe.png; do
  must_fail "photograph" "$from" match "$from" -o made/a.sozai
  must_fail "picture" "$from" render wood -o made/a.png "${tiny[@]}" -p "section=$from"
done
for part in 1 500; do
  head -c "$part" in/photo.png >in/cut.png
  must_fail "photograph cut at $part" in/cut.png match in/cut.png -o made/a.sozai
  must_fail "picture cut at $part" in/cut.png render wood -o made/a.png "${tiny[@]}" -p section=in/cut.png
done
for from in in/none.csv in/folder.csv; do
  must_fail "points" "$from" eval wood --input "$from" -o made/a.csv
done
for from in in/none.field in/folder.field; do
  must_fail "field" "$from" grow tree --field "$from" -o made/a.obj
done
head -c 30 in/tree.field >in/cut.field
must_fail "field cut short" "field" grow tree --field in/cut.field -o made/a.obj

# A full disk where pictures are kept is nobody's mistake, and says so by its code.
for words in "render wood --res 16x16 --spp 1 -o made/a.png" "eval wood --input in/points.csv" \
  "bake wood --size 4x2 --res 8x4 -o made/a.png"; do
  read -ra arguments <<<"$words"
  err=$( (
    ulimit -f 64
    "$sozai" "${arguments[@]}" -p section=in/photo.png 2>&1 >/dev/null
    echo "exit $?"
  ) | cat)
  same "no room for pictures: exit code of sozai $words" 1 "${err##*exit }"
  check "no room for pictures: sozai $words says so: $err" grep -q "section: no room for .* of pictures in" <<<"$err"
  rm -rf made
  mkdir made
done

# ---- what goes while it is wanted -------------------------------------------------------
# a share of a bake, gone before they are put together
readonly share=(bake wood --size 40x20 --res 256x128 -o made/shared.exr)
works "${share[@]}" --shard 1/2
find made -type f | head -n 1 | xargs -r rm -f
run_command "${share[@]}" --merge
check "a share that went: sozai bake --merge fails, and exited with $code" test "$code" -ne 0
check "and no picture is there" not test -e made/shared.exr
rm -rf made
mkdir made
finish
