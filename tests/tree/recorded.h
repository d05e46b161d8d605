/* SPDX-License-Identifier: Apache-2.0
 * What `tree.same -V` prints: renewed when what is grown is meant to change, and
 * the generator's revision with it. */
{"sugi", "age=6", 0x3c2772ec1ba22f54ull, 0x0e484856d297e397ull},
    {"sugi_paper", "age=7", 0x3f2fc505abb0e2ecull, 0xf69e921b0c3d2baeull},
    {"akamatsu", "age=14 seed=5", 0x2ee98478f24f1c6eull, 0x32908a3368b47cedull},
    {"cherry", "age=9 seed=2", 0x1ed7d130fab92289ull, 0xe043bba300c255daull},
    {"momiji", "age=60 orders=1", 0x87faf5c1be41b9c4ull, 0xb2b7f3bae2dd7327ull},
    {"karamatsu", "age=7.5 foliage=sprigs", 0xf3cdf952fce7ce27ull, 0x0ce413780180d7afull},
