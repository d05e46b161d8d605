/* SPDX-License-Identifier: Apache-2.0
 * What `tree.same -V` prints: renewed when what is grown is meant to change, and
 * the generator's revision with it. */
{"sugi", "age=6", 0xfbbd0b1671e8cedcull, 0xffcd88b01e9b0eefull},
    {"sugi_paper", "age=7", 0x283ea83cbb21efecull, 0xc4c6df08cdc1b349ull},
    {"akamatsu", "age=14 seed=5", 0x04b2975454add0f0ull, 0xd302edfecb718211ull},
    {"cherry", "age=9 seed=2", 0x97a755f6268fa341ull, 0xbbe9dc25746905e8ull},
    {"momiji", "age=60 orders=1", 0xdc43695047e6896full, 0xab54a2da3426336eull},
    {"keyaki", "age=50 orders=1 seed=3", 0xd9b19ea8e2443f92ull, 0x9ebed4cda8db247cull},
    {"shirakaba", "age=40 orders=1", 0x14fdb01a2e450a9bull, 0x28daf9f3e69b7937ull},
    {"karamatsu", "age=7.5 foliage=sprigs", 0x6db89a768ca1a707ull, 0x8f1615842b897031ull},
