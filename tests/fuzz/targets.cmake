# SPDX-License-Identifier: Apache-2.0
# Every fuzz target with the sources that it puts to the test, for whoever defines
# sozai_fuzz_target(name [LIBS library...] [INCLUDES folder...] SOURCES source...)
# and sozai_fuzz_options(target): this folder's CMakeLists.txt, and alone/ for a
# clang beside another compiler. Sources are compiled anew, under the sanitizers.
set(h ${SOZAI_SOURCE}/hosts)
set(p ${SOZAI_SOURCE}/plugin)

find_package(PkgConfig REQUIRED)
pkg_check_modules(FUZZ_YAML REQUIRED IMPORTED_TARGET yaml-0.1)
sozai_fuzz_target(recipe LIBS PkgConfig::FUZZ_YAML INCLUDES ${h}/common
  SOURCES recipe.c ${h}/common/recipe.c ${h}/common/recipe_file.c ${h}/common/recipe_image.c
    ${h}/common/ceilings.c ${h}/common/numbers.c ${h}/common/utf8.c ${h}/common/failure.c)
sozai_fuzz_target(csv INCLUDES ${h}/cli ${h}/common
  SOURCES csv.c ${h}/cli/csv.c ${h}/cli/columns.c ${h}/common/failure.c)
sozai_fuzz_target(options INCLUDES ${h}/cli ${h}/common ${h}/render ${h}/fiber
  SOURCES options.c ${h}/cli/options.c ${h}/cli/job_options.c ${h}/fiber/hulls.c
    ${h}/common/ceilings.c ${h}/common/ending.c ${h}/common/numbers.c ${h}/common/output_file.c ${h}/common/failure.c)
sozai_fuzz_target(pieces INCLUDES ${h}/bake ${h}/common
  SOURCES pieces.c ${h}/bake/pieces.c ${h}/bake/folder_lock.c ${h}/bake/job_text.c ${h}/bake/checksum.c
    ${h}/common/folder.c ${h}/common/failure.c)
sozai_fuzz_target(saw INCLUDES ${h}/saw ${h}/tree ${h}/common
  SOURCES saw.c ${h}/saw/plan.c ${h}/saw/live.c ${h}/saw/quarter.c ${h}/saw/rift.c
    ${h}/saw/rotary.c ${h}/common/failure.c)
sozai_fuzz_target(ply INCLUDES ${h}/common
  SOURCES ply.c ${h}/common/mesh_ply.c ${h}/common/mesh_ply_data.c ${h}/common/numbers.c
    ${h}/common/ceilings.c ${h}/common/failure.c)
pkg_check_modules(FUZZ_ASSIMP REQUIRED IMPORTED_TARGET assimp)
sozai_fuzz_target(mesh LIBS PkgConfig::FUZZ_ASSIMP INCLUDES ${h}/common
  SOURCES mesh.c ${h}/common/mesh_ply.c ${h}/common/mesh_ply_data.c ${h}/common/numbers.c
    ${h}/common/ceilings.c ${h}/common/failure.c)
sozai_fuzz_target(alias INCLUDES ${SOZAI_SOURCE}/colour
  SOURCES alias.cpp ${SOZAI_SOURCE}/colour/aliases.cpp)
sozai_fuzz_target(png INCLUDES ${SOZAI_SOURCE}/colour/images
  SOURCES png.cpp ${SOZAI_SOURCE}/colour/images/png.cpp)

set(settings ${p}/core/params.c ${p}/core/image_text.c ${p}/core/status.c
  ${p}/core/limits.c ${p}/core/meter.c bounded.c)
sozai_fuzz_target(params INCLUDES ${p} ${SOZAI_SOURCE}/tests/unit
  SOURCES params.c values.c ${settings} ${SOZAI_SOURCE}/tests/unit/every_kind.c)
sozai_fuzz_target(scan INCLUDES ${p} SOURCES scan.c ${p}/wood/scan.c ${p}/core/scalar.c)

# What takes long to compile stays out of the short test.
if(SOZAI_FUZZ_PARSERS)
  return()
endif()

# generators, all of them: geometry.c has a list
file(GLOB grown CONFIGURE_DEPENDS ${p}/tree/*.c ${p}/tree/species/*.c ${p}/fiber/*.c
  ${p}/fiber/materials/*.c)
add_library(fuzz-grown STATIC grown.c values.c ${settings} ${grown} ${p}/geometry.c
  ${p}/core/scalar.c ${p}/core/crew.c)
target_include_directories(fuzz-grown PUBLIC ${p})
target_link_libraries(fuzz-grown PUBLIC sozai::api)
sozai_fuzz_options(fuzz-grown)
foreach(name field hull grow)
  sozai_fuzz_target(${name} LIBS fuzz-grown SOURCES ${name}.c)
endforeach()
file(GLOB wood CONFIGURE_DEPENDS ${p}/wood/*.c ${p}/wood/species/*.c ${p}/wood/surface/*.c
  ${p}/wood/plies/*.c ${p}/wood/build/*.c
  ${p}/layout/*.c)
list(REMOVE_ITEM wood ${p}/wood/kernel.c ${p}/wood/material.c)
sozai_fuzz_target(knots LIBS fuzz-grown SOURCES knots.c ${wood}
  ${p}/core/colour.c ${p}/core/images.c ${p}/core/services.c)
