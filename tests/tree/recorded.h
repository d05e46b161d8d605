/* SPDX-License-Identifier: Apache-2.0
 * What `tree.same -V` prints: renewed when what is grown is meant to change, and
 * the generator's revision with it. */
{"sugi", "age=6", 0xc22026ed263d791dull}, {"sugi_paper", "age=7", 0x89212ab0b5fcd362ull},
    {"akamatsu", "age=14 seed=5", 0xe99c3f96576df92eull},
    {"cherry", "age=9 seed=2", 0xaf73a283f192b14bull},
    {"momiji", "age=60 orders=1", 0x0072d900ed866a87ull},
    {"karamatsu", "age=7.5 foliage=sprigs", 0xcef24534e862b3eaull},
