/* SPDX-License-Identifier: Apache-2.0
 * What `tree.same -V` prints: renewed when what is grown is meant to change, and
 * the generator's revision with it. */
{"sugi", "age=6", 0x3c2772ec1ba22f54ull, 0x0e484856d297e397ull},
    {"sugi_paper", "age=7", 0x3f2fc505abb0e2ecull, 0xf69e921b0c3d2baeull},
    {"akamatsu", "age=14 seed=5", 0xc85d00720ae5e35bull, 0xe7718e1eacce5ef5ull},
    {"cherry", "age=9 seed=2", 0x881f02d6f1eab080ull, 0x58ae8684e763c836ull},
    {"momiji", "age=60 orders=1", 0x6ac31ac82e2ab075ull, 0x6848ffb33dd17d13ull},
    {"karamatsu", "age=7.5 foliage=sprigs", 0x31323d2d8606459aull, 0xaa1915c23f57c21full},
