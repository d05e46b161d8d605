/* SPDX-License-Identifier: Apache-2.0
 *
 * What is written to standard output and error between two calls: a library must
 * write nothing there.
 */
#ifndef SOZAI_TEST_IMAGES_OUTPUT_H
#define SOZAI_TEST_IMAGES_OUTPUT_H

void output_catch(void);
/* Ends it; what was written, until the next call. */
const char *output_caught(void);

/* How many files this process has open. */
unsigned open_files(void);

#endif
