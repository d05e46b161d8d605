#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# sozai bake: the same bytes in one run, in shares, after a kill, a full disk
# and a damaged piece; and no half-made file under the final name.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/lib.sh" "$@"
readonly make_mesh=$4
cd "$scratch" || exit 1
"$make_mesh" udim 6 >udim.obj

there() { # the number of pieces that the last command found
  sed -nE 's/^sozai: ([0-9]+) of [0-9]+ pieces are there already$/\1/p' <<<"$err"
}

# ---- one run, whatever the threads ---------------------------------------------------
readonly exr=(bake wood --res 512x384 --size 60x40 --mip)
readonly set=(bake wood --shape udim.obj --res 128 --outputs 'albedo,roughness')
works "${exr[@]}" -o one.exr --threads 1
works "${exr[@]}" -o three.exr --threads 3
check "one thread and three" cmp one.exr three.exr
works "${set[@]}" -o 'one_<output>.<UDIM>.tif'

# ---- shares, in any order, and merged ---------------------------------------------------
works "${exr[@]}" -o shares.exr --shard 3/3
check "no picture yet" test ! -e shares.exr
refuses 1 "pieces are not in shares.exr.bake" "${exr[@]}" -o shares.exr --merge
works "${exr[@]}" -o shares.exr --shard 1/3
"$sozai" "${exr[@]}" -o shares.exr --shard 2/3 & # two at once, one of them again
works "${exr[@]}" -o shares.exr --shard 1/3
wait $!
works "${exr[@]}" -o shares.exr --merge
check "three shares merged are the one run's bytes" cmp one.exr shares.exr
check "the pieces are gone" test ! -e shares.exr.bake
for i in 2 1 4 3; do works "${set[@]}" -o 'four_<output>.<UDIM>.tif' --shard $i/4; done
works "${set[@]}" -o 'four_<output>.<UDIM>.tif' --merge
for file in one_*.tif; do check "$file" cmp "$file" "four_${file#one_}"; done
same "a set of six tiles and two outputs" 12 "$(find . -name 'four_*.tif' | wc -l)"

# ---- killed, and taken up ------------------------------------------------------------------
# Cancelled before its end however fast the machine: the journal is watched.
stop_with() { # signal, name, argument... : once some pieces are there
  local signal=$1 folder=$2.bake
  shift 2
  rm -rf "$folder"
  # bash has background jobs ignore SIGINT, and what is ignored stays so
  env --default-signal=INT "$sozai" "$@" 2>stopped.txt &
  local process=$!
  # a piece is 1.3 MB
  until (($(stat -c %s "$folder/1-of-1.pieces" 2>/dev/null || echo 0) > 3000000)) || ! kill -0 $process 2>/dev/null; do :; done
  kill "-$signal" $process 2>/dev/null
  wait $process 2>/dev/null
  code=$?
}
readonly long=(bake wood --res 2048 --size 60x60 --outputs 'albedo,time' --threads 1)
works "${long[@]}" -o whole.exr
stop_with KILL killed.exr "${long[@]}" -o killed.exr
same "it was killed" 137 "$code"
check "no picture" test ! -e killed.exr
works "${long[@]}" -o killed.exr --resume
check "some pieces were taken up: $(there)" test "$(there)" -gt 0
check "a killed bake resumed is the one run's bytes" cmp whole.exr killed.exr

stop_with INT cancelled.exr "${long[@]}" -o cancelled.exr
same "it was cancelled" 130 "$code"
check "in one line that says how to go on: $(cat stopped.txt)" \
  grep -q 'cancelled.*cancelled.exr.bake.*--resume' stopped.txt
check "no picture" test ! -e cancelled.exr
refuses 2 "bake.txt|of another bake|2048 x 2048|1024 x 1024" "${long[@]}" --res 1024 -o cancelled.exr --resume
refuses 2 "of another bake|pitch: 10|pitch: 12" "${long[@]}" -p pitch=12 -o cancelled.exr --resume
works "${long[@]}" -o cancelled.exr --resume
check "resumed" cmp whole.exr cancelled.exr

# ---- a mesh whose points are in a file beside it ----------------------------------------------
triangle() { # the first corner's x, a float's bytes
  printf "$1"'%b' '\0\0\0\0\0\0\0\0' # x 0 0
  printf '%b' '\0\0\x20\x41\0\0\0\0\0\0\0\0' '\0\0\0\0\0\0\x20\x41\0\0\0\0' # 10 0 0, 0 10 0
  printf '%b' '\0\0\0\0\0\0\0\0' '\0\0\x80\x3f\0\0\0\0' '\0\0\0\0\0\0\x80\x3f' # UVs
}
cat >beside.gltf <<'JSON'
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}}]}],
 "buffers": [{"uri": "beside.bin", "byteLength": 60}],
 "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36},
                 {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                "min": [0, 0, 0], "max": [10, 10, 0]},
               {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}]}
JSON
readonly beside=(bake wood --shape beside.gltf --res 64 --outputs albedo -o 'beside.exr')
triangle '\0\0\0\0' >beside.bin
works "${beside[@]}" --shard 1/2
triangle '\0\0\x80\x3f' >beside.bin # 1 mm
refuses 2 "beside.exr.bake|of another bake|mesh: " "${beside[@]}" --shard 2/2
triangle '\0\0\0\0' >beside.bin
works "${beside[@]}" --shard 2/2
works "${beside[@]}" --merge

# ---- damage ----------------------------------------------------------------------------------
works "${exr[@]}" -o damaged.exr --shard 1/1
readonly journal=damaged.exr.bake/1-of-1.pieces
cp -r damaged.exr.bake good.bake
bytes=$(stat -c %s $journal)
truncate -s $((bytes - 5)) $journal # as by a machine that went down
refuses 1 "pieces are not in" "${exr[@]}" -o damaged.exr --merge
head -c 100000 /dev/urandom >>$journal
works "${exr[@]}" -o damaged.exr --resume
check "a journal cut short" cmp one.exr damaged.exr
cp -r good.bake damaged.exr.bake
printf 'x' | dd of=$journal bs=1 seek=$((bytes / 2)) conv=notrunc status=none
works "${exr[@]}" -o damaged.exr --resume
check "what follows a damaged piece is done again: $(there)" test "$(there)" -gt 0
check "a damaged journal" cmp one.exr damaged.exr

# ---- a full disk: here a limit on the size of files -----------------------------------------------
(
  ulimit -f $((2 * bytes / 3 / 1024))
  exec "$sozai" "${exr[@]}" -o full.exr 2>full.txt
)
same "a full disk" 1 $?
same "in one line" 1 "$(grep -c '' full.txt)"
check "that says so: $(cat full.txt)" grep -q 'cannot write.*full.exr.bake.*too large; what is done is kept.*--resume' full.txt
check "no picture" test ! -e full.exr
works "${exr[@]}" -o full.exr --resume
check "and on" cmp one.exr full.exr
(
  ulimit -f 4
  exec "$sozai" "${exr[@]}" -o none.exr 2>full.txt
)
same "a disk that is full from the first on" 1 $?
same "in one line" 1 "$(grep -c '' full.txt)"
check "that promises nothing: $(cat full.txt)" grep -q 'cannot write.*too large; nothing is done yet' full.txt
works "${exr[@]}" -o none.exr
check "and anew" cmp one.exr none.exr
works "${exr[@]}" -o end.exr --shard 1/1
(
  ulimit -f $(($(stat -c %s one.exr) / 2048))
  exec "$sozai" "${exr[@]}" -o end.exr --merge 2>full.txt
)
same "a full disk at the end" 1 $?
same "in one line" 1 "$(grep -c '' full.txt)"
check "that says so: $(cat full.txt)" grep -q 'cannot write' full.txt
check "no picture" test ! -e end.exr
check "nor half of one in the folder" test ! -e end.exr.bake/file-0.exr
works "${exr[@]}" -o end.exr --merge
check "and on" cmp one.exr end.exr

# ---- one writer to a journal, and one job to a folder ------------------------------------------------
works "${exr[@]}" -o locked.exr --shard 1/2
if command -v flock >/dev/null; then
  flock -x -o locked.exr.bake/1-of-2.pieces sleep 30 >/dev/null 2>&1 & # else the test waits for it
  sleeper=$!
  until ! flock -n locked.exr.bake/1-of-2.pieces true; do :; done
  refuses 2 "1-of-2.pieces|another bake" "${exr[@]}" -o locked.exr --shard 1/2
  kill $sleeper
  wait $sleeper 2>/dev/null
  works "${exr[@]}" -o merging.exr --shard 1/1
  flock -s -o merging.exr.bake/lock sleep 30 >/dev/null 2>&1 & # as a share that is not done
  sleeper=$!
  until ! flock -n merging.exr.bake/lock true; do :; done
  refuses 2 "merging.exr.bake|in use by another bake" "${exr[@]}" -o merging.exr --merge
  refuses 2 "in use by another bake" "${exr[@]}" -o merging.exr
  "$sozai" "${exr[@]}" -o merging.exr --resume 2>busy.txt
  check "nor does --resume put together" test $? -ne 0
  check "and says why: $(cat busy.txt)" grep -q 'in use by another bake.*kept' busy.txt
  works "${exr[@]}" -o merging.exr --shard 1/1
  kill $sleeper
  wait $sleeper 2>/dev/null
  works "${exr[@]}" -o merging.exr --merge
fi
refuses 2 "of another bake" "${exr[@]}" -o locked.exr -p rings=7 --shard 2/2
touch locked.exr.bake/mine.txt
works "${exr[@]}" -o locked.exr
check "one run starts over" cmp one.exr locked.exr
check "and takes away what is a bake's alone" test -e locked.exr.bake/mine.txt

# ---- two at once: one of them makes it, whichever; nothing of it is lost -----------------------
for i in 1 2 3 4 5; do
  "$sozai" "${exr[@]}" -o twice.exr --resume 2>twice.1.txt &
  first=$!
  "$sozai" "${exr[@]}" -o twice.exr --resume 2>twice.2.txt
  second=$?
  wait $first
  check "one of two ends well: $? $second $(cat twice.?.txt)" test $(($? * second)) -eq 0
  check "and is whole ($i)" cmp one.exr twice.exr
  rm -f twice.exr
  works "${exr[@]}" -o twice.exr --resume # what one of them left there, if it was refused late
  rm -f twice.exr
done
# A share's work stays when another bake gives up beside it.
"$sozai" "${exr[@]}" -o beside.exr --shard 1/2 2>share.txt &
share=$!
env --default-signal=INT "$sozai" "${exr[@]}" -o beside.exr --resume 2>beside.txt &
other=$!
sleep 0.1
kill -INT $other 2>/dev/null
wait $other
wait $share
check "the share ends well: $(cat share.txt)" test $? -eq 0
check "and its pieces are there, or the picture: $(cat beside.txt)" \
  test -s beside.exr.bake/1-of-2.pieces -o -e beside.exr
works "${exr[@]}" -o beside.exr --resume
check "which goes on" cmp one.exr beside.exr

# ---- the file that is replaced -------------------------------------------------------------------------
cp one.exr old.exr
ln -s old.exr link.exr
works "${exr[@]}" --outputs time -o link.exr
check "a link stays one" test -L link.exr
check "what it points to is the new picture" test "$(stat -c %s old.exr)" -ne "$(stat -c %s one.exr)"
finish
