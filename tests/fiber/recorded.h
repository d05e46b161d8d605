/* SPDX-License-Identifier: Apache-2.0
 * What each grew into when it was recorded; `fiber.same -V` prints the lines. */
{"count=300", 0x842a27b0e0880754ull}, {"count=120 mode=exact cells=32", 0x20ccfbf7f459f3a0ull},
    {"count=120 mode=literal spacing=1", 0x48b75b9a7de1e957ull},
    {"count=150 diameter=300 contact=rigid rounds=8 diameter_spread=0.2 taper=0.3",
     0x89fcb8506323d0ecull},
    {"count=150 diameter=300 contact=bend rounds=8 length_spread=0.4 share_2=0.3",
     0x02d12b28735c5eafull},
