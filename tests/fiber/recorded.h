/* SPDX-License-Identifier: Apache-2.0
 * What each grew into when it was recorded; `fiber.same -V` prints the lines. */
{"count=300", 0}, {"count=120 mode=exact cells=32", 0}, {"count=120 mode=literal spacing=1", 0},
    {"count=150 diameter=300 contact=rigid rounds=8 diameter_spread=0.2 taper=0.3", 0},
    {"count=150 diameter=300 contact=bend rounds=8 length_spread=0.4 share_2=0.3", 0},
