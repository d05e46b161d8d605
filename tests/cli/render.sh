#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# render: layers, the face seen from the front, the same bits whatever the
# threads, and nothing left behind by a failure.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"
readonly picture=$4
cd "$scratch" || exit 1

# ---- an EXR and its layers ---------------------------------------------------
works render wood -o all.exr --res 96x64 --spp 4
same "size and layers" "96 64 B G R albedo.B albedo.G albedo.R coverage dive fiber.x fiber.y fiber.z \
latewood radiance.B radiance.G radiance.R reference.x reference.z roughness specular time vessel" \
  "$("$picture" layers all.exr)"
check "every number is finite" "$picture" finite all.exr
check "the floor is lit" "$picture" between all.exr 2 2 R 0.2 1.2
check "no shape there" "$picture" between all.exr 2 2 coverage 0 0
check "the shape is in the middle" "$picture" between all.exr 48 32 coverage 1 1
check "a layer holds the texture's answer" "$picture" between all.exr 48 32 specular 0.5 0.5

works render wood -o some.exr --res 32x32 --spp 1 --channels dive,albedo
same "layers asked for" "32 32 B G R albedo.B albedo.G albedo.R coverage dive" "$("$picture" layers some.exr)"

# ---- straight at the face ----------------------------------------------------
# Checks of 10 mm on a face of 40 x 20 mm: four by two, the light ones where x
# and y fall in the same parity.
works render wood -o face.exr --shape plane --size 40x20 --camera front --res 80x40 --spp 1 --sky 0 --light 0,90
check "the face fills the picture: top left" "$picture" between face.exr 0 0 coverage 1 1
check "and bottom right" "$picture" between face.exr 79 39 coverage 1 1
check "x runs to the right from -20 mm" "$picture" between face.exr 0 0 reference.x -20 -19.5
check "to 20 mm" "$picture" between face.exr 79 0 reference.x 19.5 20
check "y runs up: the light check at (5, 5)" "$picture" between face.exr 50 10 albedo.R 0.75 0.75
check "the dark one at (5, -5)" "$picture" between face.exr 50 30 albedo.R 0.125 0.125
check "lit from straight above, without sky, it shows its albedo" "$picture" between face.exr 50 10 R 0.75 0.75
works render wood -o proportions.exr --shape plane --size 40x20 --camera front --spp 1 --channels time
check "the picture takes the face's proportions" grep -q '^1024 512 ' <("$picture" layers proportions.exr)

# ---- shapes ------------------------------------------------------------------
for shape in board sphere plane; do
  works render wood -o "$shape.exr" --shape "$shape" --res 32x24 --spp 2
  check "$shape: finite" "$picture" finite "$shape.exr"
  check "$shape: in the middle" "$picture" between "$shape.exr" 16 12 coverage 1 1
done
cat >pyramid.obj <<'OBJ'
v -10 0 -10
v 10 0 -10
v 10 0 10
v -10 0 10
v 0 18 0
f 1 4 5
f 4 3 5
f 3 2 5
f 2 1 5
f 1 2 3 4
OBJ
works render wood -o mesh.exr --shape pyramid.obj --scale 2 --res 32x24 --spp 2 --camera front
check "a mesh: finite" "$picture" finite mesh.exr
check "a mesh: in the middle" "$picture" between mesh.exr 16 12 coverage 1 1
cat >board.sozai <<'YAML'
material: wood
surface: {shape: mesh, mesh: pyramid.obj}
YAML
works render board.sozai -o from-file.exr --scale 2 --res 32x24 --spp 2 --camera front
check "a file's surface is the default shape" "$picture" same from-file.exr mesh.exr
echo 'surface: {shape: mesh, mesh: pyramid.obj, scale: 2}' | cat <(echo 'material: wood') - >scaled.sozai
works render scaled.sozai -o scaled.exr --res 32x24 --spp 2 --camera front
check "and its scale is the default scale" "$picture" same scaled.exr mesh.exr
refuses 2 "--scale|mesh" render wood -o gone.exr --scale 2 --res 8x8
refuses 2 "--bevel|board" render wood -o gone.exr --shape sphere --bevel 2 --res 8x8
refuses 2 "--bevel|board" render scaled.sozai -o gone.exr --bevel 2 --res 8x8

# ---- the same whatever the threads ---------------------------------------------
works render wood -o one.exr --res 100x70 --spp 5 --threads 1
works render wood -o three.exr --res 100x70 --spp 5 --threads 3
check "one thread and three" "$picture" same one.exr three.exr

# ---- PNG -----------------------------------------------------------------------
works render wood -o small.png --res 32x24 --spp 1
same "PNG" "32 24 B G R" "$("$picture" layers small.png)"
works render wood -o deep.png --res 32x24 --spp 1 --bits 16 --exposure -1
check "a stop darker is darker" "$picture" between deep.png 1 1 R 0.1 0.85

# ---- refusals ------------------------------------------------------------------
refuses 2 "--output|'picture.gif'" render wood -o picture.gif
refuses 2 "no output" render wood
refuses 2 "--shape|'cube'" render wood -o x.png --shape cube
refuses 2 "cannot read mesh 'none.obj'" render wood -o x.png --shape none.obj
echo 'v 1 2 3' >empty.obj
refuses 2 "empty.obj" render wood -o x.png --shape empty.obj
printf 'v 0 0 0\nv 1 0 0\nvt 0 0\nf 1/1 1/1 1/1\n' >flat.obj
refuses 2 "flat.obj|longest side|0 mm|0.001" render wood -o x.png --shape flat.obj
printf 'v nan nan nan\nv nan nan nan\nv nan nan nan\nf 1 2 3\n' >nan.obj
refuses 2 "nan.obj|x of point 0|nan" render wood -o x.png --shape nan.obj
# One vertex in many, in a text and in bytes, as a surface and as a hull.
for wrong in nan inf -inf 1e30; do
  printf 'v 0 0 0\nv 10 0 0\nv 0 %s 0\nv 0 0 10\nf 1 2 3\nf 1 2 4\n' $wrong >wrong.obj
  refuses 2 "wrong.obj: y of point 2|${wrong%30}" render wood -o x.png --shape wrong.obj
  refuses 2 "wrong.obj: y of point 2|${wrong%30}" grow fiber -o x.usda --hull wrong.obj
  refuses 2 "wrong.obj: y of point 2|${wrong%30}" bake wood -o x.png --shape wrong.obj --res 8
  for format in ascii binary_little_endian; do
    python3 - $format $wrong >wrong.ply <<'PY'
import struct, sys
wrong = float(sys.argv[2])
points = [(0, 0, 0), (10, 0, 0), (0, wrong, 0), (0, 0, 10)]
faces = [(0, 1, 2), (0, 1, 3)]
out = sys.stdout.buffer
out.write(("ply\nformat %s 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
           "element face 2\nproperty list uchar int vertex_indices\nend_header\n" % sys.argv[1]).encode())
for p in points:
    out.write(("%g %g %g\n" % p).encode() if sys.argv[1] == "ascii" else struct.pack("<3f", *p))
for f in faces:
    out.write(("3 %d %d %d\n" % f).encode() if sys.argv[1] == "ascii" else struct.pack("<B3i", 3, *f))
PY
    refuses 2 "wrong.ply: y of|2|${wrong%30}" render wood -o x.png --shape wrong.ply
    refuses 2 "wrong.ply: y of|2|${wrong%30}" grow fiber -o x.usda --hull wrong.ply
  done
done
printf 'v 900000 0 0\nv 900001 0 0\nv 900000 1 0\nf 1 2 3\n' >afar.obj
refuses 2 "afar.obj|longest side|1 mm|9" render wood -o x.png --shape afar.obj
printf 'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n' >line.obj
refuses 2 "line.obj|any area" render wood -o x.png --shape line.obj
for far in 1e20 -1e38 1.1e6; do
  printf 'v 0 0 0\nv 1 0 0\nv 0 %s 0\nf 1 2 3\n' $far >far.obj
  refuses 2 "far.obj|y of point 2|1000000" render wood -o x.png --shape far.obj
done
ply() { # first property's element and count, corners...
  printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n'
  printf 'property float z\nelement %s\nproperty list uchar int vertex_indices\nend_header\n' "$1"
  printf '0 0 0\n90 0 0\n0 90 0\n'
  printf '%s\n' "${@:2}"
}
ply 'face 1' '3 0 1 2' >good.ply
works render wood -o ply.exr --shape good.ply --res 8x8 --spp 1
for corner in 2000000000 3 -1; do
  ply 'face 2' '3 0 1 2' "3 0 1 $corner" >bad.ply
  refuses 2 "bad.ply|'face' 1|vertex index $corner|3 vertices" render wood -o x.png --shape bad.ply
done
ply 'face 1' '3 0 1' >bad.ply
refuses 2 "bad.ply|'face' 0|fewer" render wood -o x.png --shape bad.ply
ply 'face 2' '3 0 1 2' 0 >bad.ply
refuses 2 "bad.ply|'face' 1|no corner" render wood -o x.png --shape bad.ply
ply 'face 2' '3 0 1 2' >bad.ply
refuses 2 "bad.ply|'face' 1|end" render wood -o x.png --shape bad.ply
refuses 2 "--target|'1e20,0,0'|1000000" render wood -o x.png --target 1e20,0,0
refuses 2 "--target|'0,0,-1000001'|1000000" render wood -o x.png --target 0,0,-1000001
refuses 2 "--size|'10x20'|WxHxT" render wood -o x.png --size 10x20
refuses 2 "--size|'10x20x-3'|0.01" render wood -o x.png --size 10x20x-3
refuses 2 "--res|'0x5'|1 to 32768" render wood -o x.png --res 0x5
refuses 2 "--spp|'many'" render wood -o x.png --spp many
refuses 2 "--light|'1'" render wood -o x.png --light 1
refuses 2 "--camera|'behind'" render wood -o x.png --camera behind
refuses 2 "--bits|12" render wood -o x.png --bits 12
refuses 2 "cut|'diagonal'" render wood -o x.png --cut diagonal
refuses 2 "pitch|-4|0.1|1000" render wood -o x.png -p pitch=-4
refuses 2 "unknown channel 'shade'" render wood -o x.exr --channels shade
refuses 2 "--channels|an EXR|'x.png'" render wood -o x.png --channels albedo
for option in exposure=1 bits=8 display=sRGB view=Raw look=; do
  refuses 2 "--${option%=*}|a PNG|'x.exr'" render wood -o x.exr "--$option"
done
refuses 2 "--cut|'end'|-p cut=flat" render wood -o x.png -p cut=flat --cut end
refuses 2 "cannot write|nowhere" render wood -o nowhere/x.png
refuses 1 "none.ocio" render wood -o x.png --config none.ocio # the mock has no colour service
same "nothing is left of them" "" "$(find . -name '*x.png*' -o -name '*x.exr*' -o -name '.sozai-*')"

# ---- Ctrl-C --------------------------------------------------------------------
# It cleans up, and dies of the signal, as whoever started it waits to see.
begin() { # what SIGINT is to it: default or ignore
  env "--$1-signal=INT" "$sozai" render wood -o cancelled.exr --res 4096x4096 --spp 1024 \
    >cancel.out 2>cancel.err &
  pid=$!
  for _ in {1..100}; do
    [[ -n $(find . -name '.sozai-*.exr') ]] && break
    sleep 0.1
  done
}
for signal in INT TERM HUP; do
  begin default
  kill -"$signal" "$pid"
  wait "$pid"
  code=$?
  same "$signal: exit code when cancelled" "$signal" "$(kill -l "$code")"
  check "$signal: it says so" grep -q cancelled cancel.err
  same "$signal: nothing is left of it" "" "$(find . -name '*cancelled.exr*' -o -name '.sozai-*')"
done
begin ignore # as nohup, and a shell's background jobs, have it
kill -INT "$pid"
sleep 0.5
check "SIGINT that is ignored stays ignored" kill -0 "$pid"
kill -TERM "$pid"
wait "$pid"
same "but not SIGTERM" 143 $?
# Whom a file was open to, and nobody else.
touch private.png
for mode in 600 400; do
  chmod "$mode" private.png
  "$sozai" render wood -o private.png --res 16x16 --spp 1
  same "$mode: exit code" 0 $?
  same "$mode: a private picture stays private" 600 "$(stat -c %a private.png)"
done
# A shell's loop ends with it.
# shellcheck disable=SC2016 # the inner shell's own
env --default-signal=INT setsid bash -c 'for i in 1 2; do
  "$0" render wood -o looped.exr --res 4096x4096 --spp 1024 2>/dev/null
  echo $i >>looped.txt
done' "$sozai" &
pid=$!
for _ in {1..100}; do
  [[ -n $(find . -name '.sozai-*.exr') ]] && break
  sleep 0.1
done
kill -INT -- "-$pid" # as a terminal does: the shell and what it waits for
wait "$pid"
same "a loop's exit code" 130 $?
check "it did not go on" test ! -e looped.txt
same "nothing is left of it either" "" "$(find . -name '*looped*' -o -name '.sozai-*')"
cd / || exit 1
finish
