/* SPDX-License-Identifier: Apache-2.0
 * What `tree.same -V` prints: renewed when what is grown is meant to change, and
 * the generator's revision with it. */
{"sugi", "age=6", 0x9bf39011357e65eaull, 0x215de36026bd29b3ull},
    {"sugi_paper", "age=7", 0xbf07e0f5174d9cb2ull, 0xf69e921b0c3d2baeull},
    {"akamatsu", "age=14 seed=5", 0x81694d004f0c7a7bull, 0x4cbe1ea183748dbfull},
    {"cherry", "age=9 seed=2", 0x58190677b935f151ull, 0xb738460176405f8dull},
    {"momiji", "age=60 orders=1", 0xf5a63cb809a6b34bull, 0x1d0ef2a1349aa308ull},
    {"keyaki", "age=50 orders=1 seed=3", 0xf828f4e2249b6e8bull, 0x9cc15201c3c713a7ull},
    {"shirakaba", "age=40 orders=1", 0x20e12518e7e7d1f6ull, 0x1052d8b042007247ull},
    {"karamatsu", "age=7.5 foliage=sprigs", 0x02245f75f3b455d0ull, 0x744f9c7cd68e080eull},
