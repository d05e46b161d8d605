/* SPDX-License-Identifier: Apache-2.0
 *
 * How many elements an array has.
 */
#ifndef SOZAI_CORE_COUNT_H
#define SOZAI_CORE_COUNT_H

#define COUNT(a) (sizeof(a) / sizeof((a)[0]))

#endif
