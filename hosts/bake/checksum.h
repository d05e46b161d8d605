/* SPDX-License-Identifier: Apache-2.0
 * A sum of 64 bits over bytes, against accidents, not against forgers. */
#ifndef SOZAI_BAKE_CHECKSUM_H
#define SOZAI_BAKE_CHECKSUM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Goes on from sum. Data in parts gives the same where all parts but the last
 * are of a multiple of 8 bytes. */
uint64_t checksum_bytes(uint64_t sum, const void *data, size_t bytes);
/* Of a file's bytes; false: it cannot be read. */
bool checksum_file(const char *path, uint64_t *sum);

#endif
