// SPDX-License-Identifier: Apache-2.0
// cmocka, which wants these before it, in C++.
#ifndef TESTS_OIIO_CMOCKA_CPP_H
#define TESTS_OIIO_CMOCKA_CPP_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
extern "C" {
#include <cmocka.h>
}

#endif
