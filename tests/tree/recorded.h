/* SPDX-License-Identifier: Apache-2.0
 * What `tree.same -V` prints: renewed when what is grown is meant to change, and
 * the generator's revision with it. */
{"sugi", "age=6", 0x0a075badc0ebca75ull, 0xffcd88b01e9b0eefull},
    {"sugi_paper", "age=7", 0xd7077e53daf76abdull, 0xc4c6df08cdc1b349ull},
    {"akamatsu", "age=14 seed=5", 0xe6683676fef54fa5ull, 0xd302edfecb718211ull},
    {"cherry", "age=9 seed=2", 0x55bb57803370cc54ull, 0xbab1c9574534a1a1ull},
    {"momiji", "age=60 orders=1", 0x7d9f2b61426bd71dull, 0xdb1ae7ea3e7892b6ull},
    {"keyaki", "age=50 orders=1 seed=3", 0xa6a6b34c6b6f4e4aull, 0x40b5002e484a420aull},
    {"shirakaba", "age=40 orders=1", 0x63529b0969a6912bull, 0x18166b3f88e5bb19ull},
    {"karamatsu", "age=7.5 foliage=sprigs", 0xdc25b62b4abe3f3dull, 0x8f1615842b897031ull},
