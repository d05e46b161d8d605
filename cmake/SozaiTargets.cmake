# SPDX-License-Identifier: Apache-2.0
# What every target of ours is built with.

# -ffp-contract=off: no fused multiply-add, whose rounding differs between
# machines; the kernels promise the same bits everywhere.
# -g in every build: the recorded ABI is compared with what the library's
# debugging information says (tests/abi). It changes no code and is not loaded;
# `cmake --install build --strip` leaves it out.
add_compile_options(-ffp-contract=off -g)

function(sozai_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wno-psabi
    $<$<BOOL:${SOZAI_WERROR}>:-Werror>)
endfunction()
