#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# sozai bake: what is in the files, and what it refuses.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/lib.sh" "$@"
readonly picture=$4 make_mesh=$5
cd "$scratch" || exit 1
"$make_mesh" box 8 >box.obj
"$make_mesh" udim 8 >udim.obj

# ---- a plane: checks of 10 mm on 40 x 20 mm --------------------------------------
works bake wood -o plane.exr --size 40x20 --res 80x40
same "layers of an EXR" "80 40 B G R dive fiber.x fiber.y fiber.z latewood reference.x reference.z \
roughness specular time vessel" "$("$picture" layers plane.exr)"
check "finite" "$picture" finite plane.exr
check "x runs to the right from -20 mm" "$picture" between plane.exr 0 0 reference.x -19.76 -19.74
check "to 20 mm" "$picture" between plane.exr 79 0 reference.x 19.74 19.76
check "y runs up: the light check at (5, 5)" "$picture" between plane.exr 50 10 R 0.75 0.75
check "the dark one at (5, -5)" "$picture" between plane.exr 50 30 R 0.125 0.125
same "the pieces are gone" "" "$(ls -d ./*.bake 2>/dev/null)"

# ---- formats ------------------------------------------------------------------------
works bake wood -o plane.png --size 40x20 --res 80x40
same "albedo alone in a PNG" "80 40 B G R" "$("$picture" layers plane.png)"
check "in sRGB: 0.75 is 225 of 255" "$picture" between plane.png 50 10 R 0.882 0.883
works bake wood -o plane.tif --size 40x20 --res 80x40 --bits 32 --outputs reference
check "a float TIFF holds lengths" "$picture" between plane.tif 79 0 G 0 0
works bake wood -o 'set <output>.png' --size 40x20 --res 80x40 --outputs albedo,fiber,roughness
for output in albedo fiber roughness; do check "a file for $output" test -s "set $output.png"; done
check "directions are moved to between 0 and 1" "$picture" between "set fiber.png" 1 1 G 0.99 1
works bake wood -o half.exr --size 40x20 --res 80x40 --bits 16 --outputs roughness,albedo --tile 0
works bake wood -o years.exr --size 40x20 --res 80x40 --bits 16 --outputs time,albedo
if command -v oiiotool >/dev/null; then
  check "tiles of 64" grep -q 'tile size: 64 x 64' <(oiiotool --info -v plane.exr)
  check "scanlines, all half" grep -Eq '80 x +40, 4 channel, half openexr' <(oiiotool --info -v half.exr)
  check "but years, which half cannot hold" \
    grep -q 'time (float)' <(oiiotool --info -v years.exr)
  check "the working space" grep -q 'colorSpace: "Linear Rec.709"' <(oiiotool --info -v plane.exr)
  check "the scale" grep -q 'sozai_mm_per_pixel: 0.5, 0.5' <(oiiotool --info -v plane.exr)
  works bake wood -o mip.exr --size 40x20 --res 80x40 --mip --outputs reference,albedo
  check "levels" grep -q '80x40 40x20 20x10 10x5 5x2 2x1 1x1' <(oiiotool --info -v mip.exr)
  oiiotool mip.exr --selectmip 2 -o level.exr
  check "a level is evaluated at its own texels" "$picture" between level.exr 0 0 reference.x -19.01 -18.99
fi

# ---- to another file system, through a link -------------------------------------------
if [[ -w /dev/shm && $(stat -c %d /dev/shm) != "$(stat -c %d .)" ]]; then
  far=$(mktemp -d -p /dev/shm)
  ln -s "$far/plane.exr" far.exr
  for state in "not there yet" "there"; do
    works bake wood -o far.exr --size 40x20 --res 80x40
    check "$state: it is where the link leads" cmp plane.exr "$far/plane.exr"
    check "$state: the link stays" test -L far.exr
    same "$state: nothing else is left" plane.exr "$(ls -A "$far")"
    check "$state: nor the pieces" test ! -e far.exr.bake
  done
  rm -rf "$far"
fi

# ---- a .sozai file --------------------------------------------------------------------
cat >box.sozai <<'YAML'
material: wood
surface: {shape: mesh, mesh: box.obj, scale: 2}
image: {resolution: 128, outputs: "reference,albedo"}
YAML
works bake box.sozai -o box.exr
same "its outputs and size" "128 128 B G R reference.x reference.z" "$("$picture" layers box.exr)"
# The first chart is the side at x = -30 of the file, -60 mm at its scale.
check "a texel of a side" "$picture" between box.exr 20 100 reference.x -60.1 -59.9

# A size is the plane's without a shape, too.
cat >sized.sozai <<'YAML'
material: wood
surface: {size: [40, 20]}
image: {resolution: 80, outputs: "reference,albedo"}
YAML
works bake sized.sozai -o sized.exr
check "a size without a shape is the plane's" cmp -s sized.exr <(
  sed 's/size:/shape: plane, size:/' sized.sozai >shaped.sozai
  "$sozai" bake shaped.sozai -o shaped.exr && cat shaped.exr
)
same "of its size" "80 40" "$("$picture" layers sized.exr | cut -d' ' -f1,2)"

# ---- UDIM -----------------------------------------------------------------------------
works bake wood --shape udim.obj -o 'tile.<UDIM>.png' --res 32
for tile in 1001 1002 1003 1004 1011 1012; do check "tile $tile" test -s "tile.$tile.png"; done
works bake wood --shape udim.obj -o one.png --res 32 --udim 1011
check "one of them alone" cmp -s one.png tile.1011.png
refuses 2 "6 UDIM tiles|<UDIM>" bake wood --shape udim.obj -o one.png --res 32
refuses 2 "--udim|1005|1001" bake wood --shape udim.obj -o one.png --udim 1005
refuses 2 "--udim|'all'" bake wood --shape udim.obj -o one.png --udim all
refuses 2 "--udim|1001 stands twice" bake wood --shape udim.obj -o 'gone.<UDIM>.png' --udim 1001,1001
refuses 2 "--udim" bake wood -o one.png --udim 1001

# ---- overlapping charts are said ----------------------------------------------------------
cat >over.obj <<'OBJ'
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 5
v 1 0 5
v 0 1 5
vt 0.1 0.1
vt 0.9 0.1
vt 0.1 0.9
f 1/1 2/2 3/3
f 4/1 5/2 6/3
OBJ
works bake wood --shape over.obj -o over.png --res 16
same "a warning" "sozai: warning: of 2 triangles 1 lying over earlier ones, which are shown instead" "$err"

# ---- refusals -------------------------------------------------------------------------------
refuses 2 "no output" bake wood
refuses 2 "--tile|PNG" bake wood -o gone.png --res 32 --tile 32
refuses 2 "--scale|mesh" bake wood -o gone.exr --res 32 --scale 2
refuses 2 "--output|'gone.gif'" bake wood -o gone.gif
refuses 2 "cannot|nowhere" bake wood -o nowhere/gone.png --res 8
refuses 2 "material 'nothing'" bake nothing -o gone.png
refuses 2 "--bits|16 or 32" bake wood -o gone.exr --bits 8
refuses 2 "--bits|8 or 16" bake wood -o gone.png --bits 32
refuses 2 "--bits|12" bake wood -o gone.tif --bits 12
refuses 2 "--outputs|'shine'|albedo" bake wood -o gone.exr --outputs shine
refuses 2 "--outputs|'radiance'|light" bake wood -o gone.exr --outputs radiance
refuses 2 "--outputs|'albedo'|twice" bake wood -o gone.exr --outputs albedo,albedo
refuses 2 "--outputs|'time'|years|EXR" bake wood -o gone.png --outputs time
refuses 2 "--output|<output>" bake wood -o gone.png --outputs albedo,roughness
for res in 0 1e9 64x x64 6.5 4x4x4; do
  refuses 2 "--res|'$res'|1 to 65536" bake wood -o gone.exr --res "$res"
done
refuses 2 "--samples|'3'|1, 2, 4 or 8" bake wood -o gone.exr --samples 3
printf 'material: wood\nimage: {resolution: [8, 8, 8]}\n' >volume.sozai
refuses 2 "volume|image|two numbers" bake volume.sozai -o gone.exr
refuses 2 "--res|65536" bake wood -o gone.exr --res 65537
refuses 2 "--res|'nan'" bake wood -o gone.exr --res nan
refuses 2 "--size|'1x'" bake wood -o gone.exr --size 1x
refuses 2 "--size|'1x1e30'" bake wood -o gone.exr --size 1x1e30
refuses 2 "--tile|24|16" bake wood -o gone.exr --tile 24
refuses 2 "--tile|2048|1024" bake wood -o gone.exr --tile 2048
refuses 2 "--mip|EXR" bake wood -o gone.png --mip
refuses 2 "--mip|tiles" bake wood -o gone.exr --mip --tile 0
refuses 1 "--space|'ACEScg'" bake wood -o gone.png --space ACEScg # the mock has no colour service
refuses 2 "--shape|'cube'" bake wood -o gone.exr --shape cube
refuses 2 "none.obj" bake wood -o gone.exr --shape none.obj
for shard in 0/2 3/2 1 1/0 a/b 1.5/2 1/1e9 -1/2; do
  refuses 2 "--shard|'$shard'" bake wood -o gone.exr --shard "$shard"
done
refuses 2 "--merge|--shard" bake wood -o gone.exr --merge --shard 1/2
refuses 2 "no pieces|gone.exr.bake" bake wood -o gone.exr --merge
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >bare.obj
refuses 2 "bare.obj|no UVs" bake wood -o gone.exr --shape bare.obj
head -c 500 box.obj >cut.obj
refuses 2 "cut.obj" bake wood -o gone.exr --shape cut.obj
mkdir folder.exr
refuses 2 "folder.exr|not a file" bake wood -o folder.exr --res 8
same "nothing is left of them" "" "$(find . -name '*gone*' -o -name '.sozai-*')"
finish
