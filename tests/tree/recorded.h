/* SPDX-License-Identifier: Apache-2.0
 * What `tree.same -V` prints: renewed when what is grown is meant to change, and
 * the generator's revision with it. */
{"sugi", "age=6", 0xfa5e61420fb5c211ull}, {"sugi_paper", "age=7", 0x89212ab0b5fcd362ull},
    {"akamatsu", "age=14 seed=5", 0x4d77a02bc0744023ull},
    {"cherry", "age=9 seed=2", 0xcf91766980476493ull},
    {"momiji", "age=60 orders=1", 0x0072d900ed866a87ull},
    {"karamatsu", "age=7.5 foliage=sprigs", 0xe82b90434d278d1cull},
