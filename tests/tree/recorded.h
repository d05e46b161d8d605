/* SPDX-License-Identifier: Apache-2.0
 * What `tree.same -V` prints: renewed when what is grown is meant to change, and
 * the generator's revision with it. */
{"sugi", "age=6", 0xf577fa6ecce28739ull}, {"sugi_paper", "age=7", 0x48d50ce57b4057a7ull},
    {"akamatsu", "age=14 seed=5", 0xc963470fd304d288ull},
    {"cherry", "age=9 seed=2", 0x236b12aed76dd509ull},
    {"momiji", "age=60 orders=1", 0x7899e9f5bab7224aull},
    {"karamatsu", "age=7.5 foliage=sprigs", 0x70f722a802fdfa0aull},
