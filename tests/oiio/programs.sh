#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# OpenImageIO's own programs over .sozai files, compared with the sozai command.
# programs.sh SOZAI PLUGIN SCRATCH
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/lib.sh" "$@"
for tool in iinfo oiiotool maketx; do command -v $tool >/dev/null || exit 77; done

cat >"$scratch/keyaki.sozai" <<'YAML'
material: wood
preset: keyaki
params: {cut: flat}
surface: {shape: board, size: [128, 128, 20]}
image: {resolution: 512, format: float}
YAML
readonly file=$scratch/keyaki.sozai

tool() { # program argument...: its output to $out; fails where it fails
  if ! out=$("$@" 2>"$scratch/err"); then
    failed "$*: $(<"$scratch/err")"
  fi
  checks=$((checks + 1))
}

holds() { # what, word...
  local what=$1 word
  shift
  for word; do
    checks=$((checks + 1))
    [[ $out == *"$word"* ]] || failed "$what has no '$word' in"$'\n'"$out"
  done
}

# ---- a name in capitals
cp "$file" "$scratch/KEYAKI.SOZAI"
tool iinfo "$scratch/KEYAKI.SOZAI"
holds "KEYAKI.SOZAI" "512 x  512, 3 channel, float sozai"
tool iinfo "$scratch/KEYAKI.SOZAI?res=64"
holds "KEYAKI.SOZAI?res=64" "64 x   64, 3 channel, float sozai"

# ---- iinfo
tool iinfo -v "$file"
holds "iinfo" "512 x  512, 3 channel, float sozai" "channel list: R, G, B" "tile size: 64 x 64" \
  'oiio:ColorSpace: "scene_linear"' 'wrapmodes: "clamp,clamp"' 'textureformat: "Plain Texture"' \
  'sozai_material: "wood"' 'sozai_preset: "keyaki"' 'sozai_mm_per_pixel: 0.25, 0.25' \
  'ResolutionUnit: "cm"' 'XResolution: 40' \
  "MIP-map levels: 512x512 256x256 128x128 64x64 32x32 16x16 8x8 4x4 2x2 1x1"
tool iinfo -v -a "$file"
holds "iinfo -a" 'oiio:subimagename: "albedo"' 'oiio:subimagename: "normal"' "normal.x, normal.y, normal.z" \
  'oiio:subimagename: "height"' 'oiio:subimagename: "roughness"' 'oiio:subimagename: "fiber"' \
  'oiio:ColorSpace: "data"'
tool iinfo -v "$file?res=4096x2048&format=half&wrap=mirror&outputs=height,albedo&preset=sugi"
holds "iinfo of a query" "4096 x 2048, 1 channel, float" "[h,h,h]" '"mirror,mirror"' "channel list: height" \
  'sozai_preset: "sugi"' "2 subimages"

tool iinfo -v "$file?res=256x64&outputs=albedo"
holds "iinfo of texels that are not square" 'sozai_mm_per_pixel: 0.5, 2' 'PixelAspectRatio: 0.25'

# ---- oiiotool reads what `sozai eval` says, at the same points and footprints
grid_points() { # step: texels
  awk -v step="$1" 'BEGIN {
    print "px,py,pz,nx,ny,nz,footprint"
    for (y = 0; y < 512; y += step) for (x = 0; x < 512; x += step)
      printf "%.9g,%.9g,10,0,0,1,0.25\n", (x + 0.5) / 4 - 64, 64 - (y + 0.5) / 4 }'
}
grid_points 37 >"$scratch/points.csv"
works eval "$file" --channels albedo,roughness,height,normal <"$scratch/points.csv"
tail -n +2 <<<"$out" | cut -d, -f1-3 | tr ',' ' ' >"$scratch/wanted"
tool oiiotool "$file?outputs=albedo" --selectmip 0 -o "$scratch/whole.exr"
oiiotool --dumpdata "$scratch/whole.exr" |
  awk '/Pixel/ { gsub(/[(),:]/, " "); if ($2 % 37 == 0 && $3 % 37 == 0) print $4, $5, $6 }' \
    >"$scratch/got"
check "eval and oiiotool have as many texels" \
  test "$(grep -c '' "$scratch/wanted")" = "$(grep -c '' "$scratch/got")"
worst=$(paste -d' ' "$scratch/wanted" "$scratch/got" | awk '{
  for (c = 1; c <= 3; c++) { d = $c - $(c + 3); if (d < 0) d = -d; if (d > worst) worst = d } }
  END { printf "%d", worst * 1e7 }')
check "oiiotool reads what eval says (off by $worst e-7)" test "$worst" -le 6 -a -s "$scratch/got"

# ---- stats, crop, resize, diff
tool oiiotool --stats "$file?outputs=albedo"
holds "stats" "Stats Avg" "Stats FiniteCount: 262144 262144 262144"
tool oiiotool "$file?outputs=albedo" --selectmip 0 --cut 100x80+200+150 -o "$scratch/crop.exr"
tool oiiotool "$scratch/whole.exr" --cut 100x80+200+150 "$scratch/crop.exr" --diff
tool oiiotool "$file?outputs=albedo" --selectmip 0 --resize 256x256 -o "$scratch/resized.exr"
# the level made for that size is close to the picture shrunk to it
tool oiiotool "$file?outputs=albedo" --selectmip 1 -o "$scratch/level1.exr"
tool oiiotool "$scratch/resized.exr" "$scratch/level1.exr" --fail 1 --failpercent 0 --diff
rms=$(awk '/RMS error/ { printf "%d", $NF * 10000 }' <<<"$out")
check "level 1 is near the shrunk picture (rms $rms e-4)" test "${rms:-9999}" -lt 200
# half is the float's nearest
tool oiiotool "$file?outputs=albedo&format=half" --selectmip 0 -d float -o "$scratch/half.exr"
tool oiiotool "$scratch/whole.exr" "$scratch/half.exr" --fail 0.00026 --diff
# all the layers, with their names, in one file
tool oiiotool "$file?res=64&outputs=albedo,normal,height" --selectmip 0 -o "$scratch/layers.exr"
tool iinfo -v -a "$scratch/layers.exr"
holds "an EXR of the layers" 'name: "normal"' "normal.x" 'name: "height"' "R, G, B"
# a crop of a picture that no machine could hold
tool oiiotool --cache 64 --autotile 64 "$file?res=65536&outputs=albedo&format=half" \
  --crop 96x64+40000+30000 -o "$scratch/far.exr"

# ---- all of a look in one subimage: as an EXR that was baked of it
readonly look="$file?outputs=albedo,normal,roughness,height,fiber&subimages=single"
tool iinfo -v "$look&format=auto"
holds "iinfo of one subimage" "11 channel, half/half/half/float" \
  "channel list: R (half), G (half), B (half), height (float), roughness (float), fiber.x (float)," \
  'oiio:ColorSpace: "scene_linear"'
check "there is one" test "${out/ subimages/}" = "$out"
tool oiiotool "$look" --selectmip 0 -o "$scratch/look.exr"
tool oiiotool "$look" --selectmip 0 "$scratch/look.exr" --diff
works bake "$file" -o "$scratch/baked.exr" --outputs albedo,normal,roughness,height,fiber --bits 32
tool oiiotool "$look" --selectmip 0 "$scratch/baked.exr" --diff
channels() { iinfo -v "$1" | sed -n 's/ *channel list: //p'; }
check "a baked file has the same channels" test "$(channels "$look")" = "$(channels "$scratch/baked.exr")"

# What is said of a picture stands in files, too, whatever formats OpenImageIO knows of.
tool iinfo -v "$scratch/whole.exr"
holds "a file written from one" 'sozai_material: "wood"' 'sozai_preset: "keyaki"'
tool iinfo -v "$scratch/baked.exr"
holds "a baked file" 'sozai_material: "wood"' 'sozai_preset: "keyaki"' 'sozai_mm_per_pixel: 0.25, 0.25'
path=$OIIO_LIBRARY_PATH
unset OIIO_LIBRARY_PATH
works bake "$file" -o "$scratch/alone.exr" --outputs albedo,normal,roughness,height,fiber --bits 32
export OIIO_LIBRARY_PATH=$path
check "the same file without the reader" cmp -s "$scratch/baked.exr" "$scratch/alone.exr"

# ---- maketx, which wants a name that is a file's
cat >"$scratch/albedo.sozai" <<'YAML'
include: keyaki.sozai
image: {outputs: albedo}
YAML
tool maketx --format exr -d half "$scratch/albedo.sozai" -o "$scratch/made.exr"
tool iinfo -v "$scratch/made.exr"
holds "maketx" "MIP-map levels: 512x512 256x256" "half openexr"
tool oiiotool "$scratch/whole.exr" "$scratch/made.exr" --selectmip 0 --fail 0.00026 --diff
sed -i 's/image:.*/image: {outputs: [albedo, normal, roughness, height, fiber], subimages: single}/' \
  "$scratch/albedo.sozai"
tool maketx "$scratch/albedo.sozai" -o "$scratch/made-look.exr"
tool oiiotool "$look" --selectmip 0 "$scratch/made-look.exr" --selectmip 0 --diff
check "maketx keeps the channels" test "$(channels "$look")" = "$(channels "$scratch/made-look.exr")"

# ---- what is wrong is said
for query in res=1e9 nothing=1 wrap=periodic outputs=none subimages=one; do
  checks=$((checks + 1))
  if iinfo "$file?$query" >"$scratch/out" 2>&1; then failed "iinfo took $query"; fi
  checks=$((checks + 1))
  grep -q "${query%%=*}" "$scratch/out" || failed "iinfo of $query: $(<"$scratch/out")"
done
finish
