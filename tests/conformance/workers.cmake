# SPDX-License-Identifier: Apache-2.0
# The workers that builds by other compilers have too, each from one list of sources
# for both builds: one that is made from two lists is linked in one of them only.
set(here ${CMAKE_CURRENT_LIST_DIR})

add_library(conformance-plugin STATIC ${here}/plugin.c ${here}/batch.c ${here}/values.c)
target_link_libraries(conformance-plugin PUBLIC sozai::api ${CMAKE_DL_LIBS})

add_executable(identity-worker ${here}/identity_worker.c ${here}/identity_points.c
  ${here}/identity_textures.c)
target_link_libraries(identity-worker PRIVATE conformance-plugin pthread)

add_executable(hash-worker ${here}/hash_worker.c ${here}/identity_points.c)
target_link_libraries(hash-worker PRIVATE conformance-plugin)
