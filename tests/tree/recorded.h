/* SPDX-License-Identifier: Apache-2.0
 * What `tree.same -V` prints: renewed when what is grown is meant to change, and
 * the generator's revision with it. */
{"sugi", "age=6", 0xc83f88c31aa0eafbull, 0x0e484856d297e397ull},
    {"sugi_paper", "age=7", 0x3f2fc505abb0e2ecull, 0xf69e921b0c3d2baeull},
    {"akamatsu", "age=14 seed=5", 0xe655ca30c0637952ull, 0x32908a3368b47cedull},
    {"cherry", "age=9 seed=2", 0xdc4ce73be97f5cd8ull, 0xe043bba300c255daull},
    {"momiji", "age=60 orders=1", 0xe5ba7abd7e20f153ull, 0xb2b7f3bae2dd7327ull},
    {"karamatsu", "age=7.5 foliage=sprigs", 0xd509e5833799d7c2ull, 0x0ce413780180d7afull},
