/* SPDX-License-Identifier: Apache-2.0
 * What each grew into when it was recorded; `fiber.same -V` prints the lines. */
{"count=300", 0x713b0ec11a5f1e84ull}, {"count=120 mode=exact cells=32", 0x92c4b1325063cdc0ull},
    {"count=120 mode=literal spacing=1", 0xf083a005e0145f17ull},
    {"count=150 diameter=300 contact=rigid rounds=8 diameter_spread=0.2 taper=0.3",
     0x393fd9fd3df362bbull},
    {"count=150 diameter=300 contact=bend rounds=8 length_spread=0.4 share_2=0.3",
     0x49eed140b596c385ull},
