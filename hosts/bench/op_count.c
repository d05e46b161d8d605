/* SPDX-License-Identifier: Apache-2.0
 *
 * The processor's trap flag stops after every instruction with a SIGTRAP, and
 * its handler looks at the next one. So the count is of what was executed, with
 * the branches that were taken and the loops as long as they ran; no symbols,
 * no privileges and nothing of the plugin's insides are needed. */
#define _GNU_SOURCE /* REG_RIP */
#include "op_count.h"

#if defined(__x86_64__) && defined(__linux__)

#include <signal.h>
#include <string.h>
#include <ucontext.h>
#include "decode.h"

#define TRAP_FLAG 0x100

static volatile sig_atomic_t stepping;
static op_count counts;

static void on_trap(int number, siginfo_t *info, void *context) {
  (void)number;
  (void)info;
  ucontext_t *u = context;
  /* The flags as they will be on return: stepping begins and ends here. */
  if (!stepping) {
    u->uc_mcontext.gregs[REG_EFL] &= ~TRAP_FLAG;
    return;
  }
  u->uc_mcontext.gregs[REG_EFL] |= TRAP_FLAG;
  op_kind kind = decode_op((const uint8_t *)(uintptr_t)u->uc_mcontext.gregs[REG_RIP]);
  counts.instructions++;
  counts.floating += kind == OP_FLOAT;
  counts.integer += kind == OP_INTEGER;
}

bool op_count_run(void (*work)(void *context), void *context, op_count *out) {
  struct sigaction action, before;
  memset(&action, 0, sizeof action);
  action.sa_sigaction = on_trap;
  action.sa_flags = SA_SIGINFO;
  sigemptyset(&action.sa_mask);
  if (sigaction(SIGTRAP, &action, &before) != 0) return false;
  memset(&counts, 0, sizeof counts);
  stepping = 1;
  raise(SIGTRAP); /* its return sets the flag */
  work(context);
  stepping = 0; /* the next trap clears it */
  raise(SIGTRAP);
  sigaction(SIGTRAP, &before, NULL);
  *out = counts;
  return counts.floating > 0;
}

#else

bool op_count_run(void (*work)(void *context), void *context, op_count *out) {
  (void)work;
  (void)context;
  *out = (op_count){0};
  return false;
}

#endif
