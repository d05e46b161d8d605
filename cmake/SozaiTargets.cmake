# SPDX-License-Identifier: Apache-2.0
# What every target of ours is built with.

# -ffp-contract=off: no fused multiply-add, whose rounding differs between
# machines; the kernels promise the same bits everywhere.
# Lines for the debugger in every build, and no more in a release: types and variables take a
# fifth of the compiler's time again. They change no code and are not loaded;
# `cmake --install build --strip` leaves them out.
set(SOZAI_DEBUG_LINES $<IF:$<CONFIG:Release>,-g1,-g>)
add_compile_options(-ffp-contract=off ${SOZAI_DEBUG_LINES})

function(sozai_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wno-psabi
    $<$<BOOL:${SOZAI_WERROR}>:-Werror>)
endfunction()
