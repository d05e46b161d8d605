/* SPDX-License-Identifier: Apache-2.0
 *
 * cmocka wants these before it.
 */
#ifndef SOZAI_TEST_CMOCKA_ALL_H
#define SOZAI_TEST_CMOCKA_ALL_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

/* Print what is judged, then judge it. */
#define CHECK(condition, ...)                                                                      \
  do {                                                                                             \
    print_message(__VA_ARGS__);                                                                    \
    assert_true(condition);                                                                        \
  } while (0)

#endif
