/* SPDX-License-Identifier: Apache-2.0
 * What `tree.same -V` prints: renewed when what is grown is meant to change, and
 * the generator's revision with it. */
{"sugi", "age=6", 0xc83f88c31aa0eafbull}, {"sugi_paper", "age=7", 0x3f2fc505abb0e2ecull},
    {"akamatsu", "age=14 seed=5", 0xe655ca30c0637952ull},
    {"cherry", "age=9 seed=2", 0xdc4ce73be97f5cd8ull},
    {"momiji", "age=60 orders=1", 0xe5ba7abd7e20f153ull},
    {"karamatsu", "age=7.5 foliage=sprigs", 0xd509e5833799d7c2ull},
