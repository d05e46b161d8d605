/* SPDX-License-Identifier: Apache-2.0
 * What `tree.same -V` prints: renewed when what is grown is meant to change, and
 * the generator's revision with it. */
{"sugi", "age=6", 0x3c2772ec1ba22f54ull, 0x215de36026bd29b3ull},
    {"sugi_paper", "age=7", 0x3f2fc505abb0e2ecull, 0xf69e921b0c3d2baeull},
    {"akamatsu", "age=14 seed=5", 0xc166f8b7f0ce6885ull, 0xfaf3f197d813d7fdull},
    {"cherry", "age=9 seed=2", 0x881f02d6f1eab080ull, 0xfe270b07d08545b6ull},
    {"momiji", "age=60 orders=1", 0xb078114009e7e162ull, 0x8d9e2c23831b7988ull},
    {"keyaki", "age=50 orders=1 seed=3", 0x556c92c364c174b9ull, 0xdf5eeba47c516f30ull},
    {"shirakaba", "age=40 orders=1", 0xc9f1f8275ed86290ull, 0xeb5ae64c1493d2aaull},
    {"karamatsu", "age=7.5 foliage=sprigs", 0x31323d2d8606459aull, 0x744f9c7cd68e080eull},
