/* SPDX-License-Identifier: Apache-2.0
 *
 * Instructions as an assembler writes them, and what the bench takes them for. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "decode.h"

typedef struct sample {
  const char *text;
  uint8_t code[12];
  op_kind kind;
} sample;

static const sample samples[] = {
    {"addps xmm1,xmm2", {0x0f, 0x58, 0xca}, OP_FLOAT},
    {"mulss xmm9,xmm2", {0xf3, 0x44, 0x0f, 0x59, 0xca}, OP_FLOAT},
    {"cvttps2dq xmm1,xmm2", {0xf3, 0x0f, 0x5b, 0xca}, OP_FLOAT},
    {"cmpltps xmm1,xmm2", {0x0f, 0xc2, 0xca, 0x01}, OP_FLOAT},
    {"paddd xmm1,xmm2", {0x66, 0x0f, 0xfe, 0xca}, OP_INTEGER},
    {"psrld xmm1,3", {0x66, 0x0f, 0x72, 0xd1, 0x03}, OP_INTEGER},
    {"andps xmm1,xmm2", {0x0f, 0x54, 0xca}, OP_INTEGER},
    {"vmulps ymm1,ymm2,ymm3", {0xc5, 0xec, 0x59, 0xcb}, OP_FLOAT},
    {"vpmulld ymm1,ymm2,ymm3", {0xc4, 0xe2, 0x6d, 0x40, 0xcb}, OP_INTEGER},
    {"vblendvps ymm1,ymm2,ymm3,ymm4", {0xc4, 0xe3, 0x6d, 0x4a, 0xcb, 0x40}, OP_INTEGER},
    {"vsubps zmm1,zmm2,zmm3", {0x62, 0xf1, 0x6c, 0x48, 0x5c, 0xcb}, OP_FLOAT},
    {"vblendmps zmm1{k1},zmm2,zmm3", {0x62, 0xf2, 0x6d, 0x49, 0x65, 0xcb}, OP_INTEGER},
    {"vpternlogd zmm1,zmm2,zmm3,1", {0x62, 0xf3, 0x6d, 0x48, 0x25, 0xcb, 0x01}, OP_INTEGER},
    {"movaps xmm1,xmm2", {0x0f, 0x28, 0xca}, OP_OTHER},
    {"shufps xmm1,xmm2,0", {0x0f, 0xc6, 0xca, 0x00}, OP_OTHER},
    {"vbroadcastss zmm1,xmm2", {0x62, 0xf2, 0x7d, 0x48, 0x18, 0xca}, OP_OTHER},
    {"vgatherdps ymm1,[rax+ymm2*4],ymm3", {0xc4, 0xe2, 0x65, 0x92, 0x0c, 0x90}, OP_OTHER},
    {"vmovups zmm1,[rax]", {0x62, 0xf1, 0x7c, 0x48, 0x10, 0x08}, OP_OTHER},
    {"kandw k1,k2,k3", {0xc5, 0xec, 0x41, 0xcb}, OP_OTHER},
    {"imul eax,ecx", {0x0f, 0xaf, 0xc1}, OP_OTHER},
    {"je near", {0x0f, 0x84, 0x00, 0x01, 0x00, 0x00}, OP_OTHER},
    {"add eax,ecx", {0x01, 0xc8}, OP_OTHER},
    {"rorx eax,ecx,3", {0xc4, 0xe3, 0x7b, 0xf0, 0xc1, 0x03}, OP_OTHER},
};

static void test_samples(void **state) {
  (void)state;
  for (size_t i = 0; i < sizeof samples / sizeof *samples; i++) {
    op_kind got = decode_op(samples[i].code);
    if (got != samples[i].kind)
      fail_msg("%s: taken for %d, and is %d", samples[i].text, got, samples[i].kind);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_samples)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
