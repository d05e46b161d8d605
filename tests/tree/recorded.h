/* SPDX-License-Identifier: Apache-2.0
 * What `tree.same -V` prints: renewed when what is grown is meant to change, and
 * the generator's revision with it. */
{"sugi", "age=6", 0x9bf39011357e65eaull, 0x215de36026bd29b3ull},
    {"sugi_paper", "age=7", 0xbf07e0f5174d9cb2ull, 0xf69e921b0c3d2baeull},
    {"akamatsu", "age=14 seed=5", 0x4743e35b0bbeb010ull, 0xa1a639fe22f91331ull},
    {"cherry", "age=9 seed=2", 0x4099d5738ef3871dull, 0x1a2d251f3789b301ull},
    {"momiji", "age=60 orders=1", 0x543414e715423cbdull, 0xd1e799ae3ed5d5ebull},
    {"keyaki", "age=50 orders=1 seed=3", 0x675d97d36cb663e6ull, 0x7936f07482cde53aull},
    {"shirakaba", "age=40 orders=1", 0x6786444a9b532a38ull, 0x9cc8baa87da45ed1ull},
    {"karamatsu", "age=7.5 foliage=sprigs", 0x02245f75f3b455d0ull, 0x744f9c7cd68e080eull},
