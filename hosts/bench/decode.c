/* SPDX-License-Identifier: Apache-2.0
 *
 * Only as much of the encoding as says which vector operation it is: prefixes,
 * opcode map and opcode. No operands, no lengths. */
#include "decode.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct range {
  uint8_t first, last;
} range;

/* The maps by their numbers in VEX and EVEX: 0F, 0F 38, 0F 3A. */
static const range float_0f[] = {{0x2a, 0x2a}, {0x2c, 0x2f}, {0x51, 0x53}, {0x58, 0x5f},
                                 {0x7c, 0x7d}, {0xc2, 0xc2}, {0xd0, 0xd0}, {0xe6, 0xe6}};
static const range float_0f_evex[] = {{0x78, 0x7b}}; /* to and from unsigned */
static const range logic_0f[] = {{0x54, 0x57}};      /* of floats: and, andn, or, xor */
/* With the prefix 66 only: MMX, and other things, have these opcodes too. */
static const range integer_0f[] = {{0x64, 0x66}, {0x71, 0x76}, {0xd1, 0xd5}, {0xd8, 0xe5},
                                   {0xe8, 0xef}, {0xf1, 0xf6}, {0xf8, 0xfe}};
static const range float_38[] = {{0x13, 0x13}, {0x96, 0x9f}, {0xa6, 0xaf}, {0xb6, 0xbf}};
static const range float_38_evex[] = {{0x2c, 0x2d}, {0x42, 0x43}, {0x4c, 0x4f}};
static const range integer_38[] = {{0x01, 0x0b}, {0x10, 0x12}, {0x14, 0x15}, {0x17, 0x17},
                                   {0x1c, 0x1f}, {0x20, 0x25}, {0x28, 0x29}, {0x30, 0x35},
                                   {0x37, 0x41}, {0x45, 0x47}};
static const range integer_38_evex[] = {{0x26, 0x27}, {0x44, 0x44}, {0x50, 0x55},
                                        {0x64, 0x66}, {0x70, 0x73}, {0xc4, 0xc4}};
static const range float_3a[] = {{0x08, 0x0b}, {0x1d, 0x1d}};
static const range float_3a_evex[] = {{0x26, 0x27}, {0x50, 0x51}, {0x54, 0x57}, {0x66, 0x67}};
static const range integer_3a[] = {{0x02, 0x02}, {0x0c, 0x0e}, {0x4a, 0x4c}};
static const range integer_3a_evex[] = {{0x1e, 0x1f}, {0x25, 0x25}, {0x3e, 0x3f}};

typedef struct opcode {
  uint8_t map, prefix, code; /* prefix: 0 none, 1 66, 2 F3, 3 F2, as in VEX */
  bool evex;
} opcode;

static bool legacy_prefix(uint8_t b, opcode *o) {
  switch (b) {
  case 0x66:
    o->prefix = 1;
    return true;
  case 0xf3:
    o->prefix = 2;
    return true;
  case 0xf2:
    o->prefix = 3;
    return true;
  case 0x2e:
  case 0x36:
  case 0x3e:
  case 0x26:
  case 0x64:
  case 0x65:
  case 0x67:
  case 0xf0:
    return true;
  default:
    return (b & 0xf0) == 0x40; /* REX */
  }
}

static opcode read_opcode(const uint8_t *b) {
  opcode o = {0};
  while (legacy_prefix(*b, &o)) b++;
  if (*b == 0x62) return (opcode){.map = b[1] & 7, .prefix = b[2] & 3, .code = b[4], .evex = true};
  if (*b == 0xc4) return (opcode){.map = b[1] & 31, .prefix = b[2] & 3, .code = b[3]};
  if (*b == 0xc5) return (opcode){.map = 1, .prefix = b[1] & 3, .code = b[2]};
  if (*b != 0x0f) return o; /* map 0: nothing of ours */
  o.map = b[1] == 0x38 ? 2 : b[1] == 0x3a ? 3 : 1;
  o.code = o.map == 1 ? b[1] : b[2];
  return o;
}

static bool within(uint8_t code, const range *ranges, size_t count) {
  for (size_t i = 0; i < count; i++)
    if (code >= ranges[i].first && code <= ranges[i].last) return true;
  return false;
}
#define IN(ranges) within(o.code, ranges, sizeof(ranges) / sizeof *(ranges))

op_kind decode_op(const uint8_t *code) {
  opcode o = read_opcode(code);
  switch (o.map) {
  case 1:
    if (IN(float_0f) || (o.evex && IN(float_0f_evex))) return OP_FLOAT;
    return IN(logic_0f) || (o.prefix == 1 && IN(integer_0f)) ? OP_INTEGER : OP_OTHER;
  case 2:
    if (IN(float_38) || (o.evex && IN(float_38_evex))) return OP_FLOAT;
    return IN(integer_38) || (o.evex && IN(integer_38_evex)) ? OP_INTEGER : OP_OTHER;
  case 3:
    if (o.evex ? IN(float_3a_evex) || IN(float_3a) : IN(float_3a)) return OP_FLOAT;
    return IN(integer_3a) || (o.evex && IN(integer_3a_evex)) ? OP_INTEGER : OP_OTHER;
  default:
    return OP_OTHER;
  }
}
