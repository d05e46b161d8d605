/* SPDX-License-Identifier: Apache-2.0
 *
 * A batch of which some points are not active: kernels see the others alone.
 */
#ifndef SOZAI_CORE_ACTIVE_H
#define SOZAI_CORE_ACTIVE_H

#include "kernel.h"

/* Components that a material may have: the stack has room for them, and not much more. */
#define ACTIVE_OUTPUTS 42

/* Stretches of active points where they stand, and what lies scattered side by side in memory of
 * its own, which an answer does not depend on. Inactive points cost a glance, and none of their
 * numbers is read. io->in->active is not NULL. */
void active_run(const kernel_set *use, const void *constants, const kernel_io *io);

#endif
