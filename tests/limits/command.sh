#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Ceilings from the command line and from the environment.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/lib.sh" "$@"
cd "$scratch" || exit 1
unset SOZAI_LIMITS
readonly small=(--res 16x16 --spp 1)

# ---- the list ------------------------------------------------------------------
works limits
check "a row for each layer" grep -Eq '^plugin +texture_bytes +4294967296 ' <<<"$out"
works limits --limit texture_bytes=2K --limit recipe_includes=3
check "in force" grep -Eq '^plugin +texture_bytes +2048 ' <<<"$out"
check "a program's own" grep -Eq '^programs +recipe_includes +3 ' <<<"$out"
works limits --json
check "as JSON" grep -q '"id": "mesh_triangles"' <<<"$out"

# ---- wrongly set ----------------------------------------------------------------
refuses 2 "no limit|texture_bites" limits --limit texture_bites=1
refuses 2 "texture_bytes|outside 0 to" limits --limit texture_bytes=99999999G
refuses 2 "--limit|photo_pixels|outside" limits --limit photo_pixels=1T
refuses 2 "threads|fixed at 256" limits --limit threads=4
for bad in texture_bytes texture_bytes= =5 texture_bytes=-1 texture_bytes=1e9 \
  texture_bytes=5KK texture_bytes=99999999999999999999; do
  refuses 2 "--limit|$bad|NAME=VALUE" limits --limit "$bad"
done
SOZAI_LIMITS=nonsense refuses 2 "SOZAI_LIMITS|nonsense" render wood -o a.png "${small[@]}"
SOZAI_LIMITS=texture_bites=1 refuses 2 "texture_bites" grow tree -o a.obj -p age=3
for bad in ',' 'texture_bytes=1M,' ',texture_bytes=1M' 'texture_bytes=1M,,leaves=9'; do
  SOZAI_LIMITS=$bad refuses 2 "SOZAI_LIMITS|''|NAME=VALUE" grow tree -o a.obj -p age=3
done
SOZAI_LIMITS='' works grow tree -o a.obj -p age=3

# ---- the plugin's ---------------------------------------------------------------
refuses 2 "texture_bytes, 1024" render wood -o a.png "${small[@]}" --limit texture_bytes=1K
works render wood -o a.png "${small[@]}" --limit texture_bytes=1M
refuses 2 "geometry_bytes, 1024" grow tree -o a.obj -p age=3 --limit geometry_bytes=1K
refuses 2 "mesh_bytes, 1024" grow tree -o a.obj -p age=3 --limit mesh_bytes=1K
refuses 2 "strands, 9" grow fiber --hull ball -o a.usda -p count=10 --limit strands=9
SOZAI_LIMITS=leaves=10 refuses 2 "leaves, 10" grow tree -o a.obj --species cherry -p age=6 -p orders=4
SOZAI_LIMITS=leaves=10 works grow tree -o a.obj --species cherry -p age=6 -p orders=4 --limit leaves=1M
printf 'px,py,pz\n0,0,0\n' >points.csv
refuses 2 "texture_bytes, 1" eval wood --limit texture_bytes=1 <points.csv
refuses 2 "texture_bytes, 1" bake wood -o a.exr --size 10x10 --res 8x8 --limit texture_bytes=1

# ---- the programs' ---------------------------------------------------------------
{
  printf 'material: wood\n'
  head -c 3000 /dev/zero | tr '\0' '#'
  printf '\n'
} >long.sozai
works render long.sozai -o a.png "${small[@]}"
refuses 2 "long.sozai|recipe_bytes, 2048" render long.sozai -o a.png "${small[@]}" --limit recipe_bytes=2K
printf 'include: long.sozai\n' >one.sozai
printf 'include: one.sozai\n' >two.sozai
refuses 2 "long.sozai|recipe_includes, 2" render two.sozai -o a.png "${small[@]}" --limit recipe_includes=2
works render two.sozai -o a.png "${small[@]}" --limit recipe_includes=3

printf '%s\n' 'material: wood' 'params:' '  seed: 2' '  taper: 5' '  undulation: 1' >many.sozai
refuses 2 "many.sozai:5|recipe_parameters, 2" render many.sozai -o a.png "${small[@]}" --limit recipe_parameters=2
refuses 2 "view_bytes, 1024" render wood -o a.png "${small[@]}" --limit view_bytes=1K
works grow fiber --hull ball -o hull.gltf -p count=5
printf 'v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n' >mesh.obj
refuses 2 "mesh.obj|mesh_triangles, 3" render wood -o a.png --shape mesh.obj "${small[@]}" --limit mesh_triangles=3
refuses 2 "mesh.obj|mesh_file_bytes, 9" render wood -o a.png --shape mesh.obj "${small[@]}" --limit mesh_file_bytes=9

# ---- the OpenImageIO reader -------------------------------------------------------
if command -v oiiotool >/dev/null && [[ -e ${SOZAI_PLUGIN%/*}/sozai.imageio.so ]]; then
  printf 'material: wood\n' >plain.sozai
  export OIIO_LIBRARY_PATH=${SOZAI_PLUGIN%/*}
  check "the reader reads" oiiotool --info plain.sozai
  for limit in texture_bytes=1K recipe_bytes=5 nonsense; do
    said=$(SOZAI_LIMITS=$limit oiiotool --info plain.sozai 2>&1)
    same "exit code under $limit" 1 $(($? != 0))
    check "the reader says why under $limit: $said" grep -q "${limit%%=*}" <<<"$said"
  done
fi
finish
