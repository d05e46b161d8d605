/* SPDX-License-Identifier: Apache-2.0
 *
 * A host of the whole of ABI 1.0, compiled once against the oldest header and once against the
 * newest: it asks a plugin for everything and prints what it is told, with a hash of all that was
 * evaluated. Both must print the same: hosts.sh.
 *
 *   host PLUGIN     what it was compiled with goes to stderr
 */
#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "sozai.h"

#define POINTS 96
#define COMPONENTS 64
#define LAST_KIND SOZAI_KIND_BUFFER /* of ABI 1.0 */

static const sozai_textures_1 *textures;
static int held;

/* ---- services, as far as the header of the day has them --------------------- */

static void *take(void *user, size_t size, size_t align) {
  (void)user;
  void *memory = NULL;
  held++;
  return posix_memalign(&memory, align < sizeof memory ? sizeof memory : align, size) ? NULL
                                                                                      : memory;
}

static void give_back(void *user, void *memory, size_t size, size_t align) {
  (void)user, (void)size, (void)align;
  held--;
  free(memory);
}

static int32_t parallel(void *user, uint32_t count, void (*task)(void *, uint32_t), void *context) {
  (void)user;
  for (uint32_t i = count; i > 0; i--) task(context, i - 1);
  return 0;
}

/* Behind what the header of the day has there is rubbish: whoever reads on is found out. */
#define AFTER 64
static struct {
  sozai_host host;
  unsigned char after[AFTER];
} services = {
    .host = {.size = sizeof(sozai_host), .alloc = take, .free = give_back, .parallel = parallel}};

/* ---- what it is told ---------------------------------------------------------- */

static void list(const sozai_texture_info *info) {
  printf("%s: %s (%u parameters, %u presets, %u channels, %u components)\n", info->id, info->label,
         info->parameter_count, info->preset_count, info->channel_count, info->component_count);
  for (uint32_t i = 0; i < info->parameter_count; i++) {
    const sozai_parameter *p = info->parameters[i];
    printf("  %s kind %u [%s] %s %g..%g\n", p->id, p->kind, p->unit, p->group, p->hard_min,
           p->hard_max);
    for (uint32_t c = 0; c < p->choice_count; c++) printf("    %s\n", p->choices[c]);
  }
  for (uint32_t i = 0; i < info->channel_count; i++)
    printf("  -> %s %u+%u needs %x\n", info->channels[i]->id, info->channels[i]->first,
           info->channels[i]->components, info->channels[i]->needs);
}

/* ---- evaluating ---------------------------------------------------------------- */

static uint64_t mix(uint64_t h, uint32_t bits) {
  h = (h ^ bits) * 0x9e3779b97f4a7c15u;
  return h ^ h >> 29;
}

static uint64_t evaluate(const sozai_texture *t, int with_host) {
  static float in[16][POINTS], out[COMPONENTS][POINTS], *list[COMPONENTS];
  static uint8_t active[POINTS];
  const sozai_texture_info *info = textures->info_of(t);
  for (int k = 0; k < 16; k++)
    for (int i = 0; i < POINTS; i++)
      in[k][i] = (float)((i * 37 + k * 101) % 211 - 105) * (k < 3 ? 1.7f : 0.01f);
  memset(out, 0, sizeof out);
  for (int i = 0; i < POINTS; i++) active[i] = (uint8_t)(i % 5 != 1);
  for (uint32_t k = 0; k < COMPONENTS; k++) list[k] = k % 7 == 6 ? NULL : out[k];
  sozai_batch b = {.size = sizeof b,
                   .count = POINTS,
                   .footprint = in[15],
                   .active = with_host ? active : NULL,
                   .out = list,
                   .out_count = info->component_count};
  for (int c = 0; c < 3; c++) {
    b.point[c] = in[c];
    b.normal[c] = in[3 + c];
    b.light[c] = in[6 + c];
    b.light_colour[c] = in[9 + c];
    b.view[c] = in[12 + c];
  }
  if (textures->evaluate(t, &b) != SOZAI_OK) printf("    evaluate: %s\n", textures->last_error());
  uint64_t h = 0;
  for (uint32_t k = 0; k < info->component_count; k++)
    for (int i = 0; i < POINTS; i++) {
      uint32_t bits;
      memcpy(&bits, &out[k][i], sizeof bits);
      h = mix(h, bits);
    }
  b.point[1] = NULL;
  printf("    without a point: %d %s\n", (int)textures->evaluate(t, &b), textures->last_error());
  return h;
}

/* ---- making -------------------------------------------------------------------- */

static void answer(const sozai_texture_info *info, const char *preset, const sozai_value *values,
                   uint32_t count, int with_host) {
  sozai_texture *t = NULL;
  int32_t r =
      textures->create(with_host ? &services.host : NULL, info->id, preset, values, count, &t);
  printf("  %s of %u values: %d", preset ? preset : "-", count, (int)r);
  if (r != SOZAI_OK) {
    printf(" %s\n", textures->last_error());
    return;
  }
  printf("\n");
  uint64_t h = evaluate(t, with_host);
  for (uint32_t i = 0; i < info->parameter_count; i += 7) {
    sozai_value v;
    int32_t told = textures->value(t, info->parameters[i]->id, &v);
    if (info->parameters[i]->kind <= LAST_KIND)
      printf("    %s: %d kind %u %.9g %.9g %.9g %s\n", info->parameters[i]->id, (int)told, v.kind,
             v.number[0], v.number[1], v.number[2], v.text ? v.text : "-");
  }
  printf("    %016llx %s\n", (unsigned long long)h, textures->instruction_set(t));
  textures->destroy(t);
}

/* Every parameter's default handed in by its own kind; one of a kind that this host does not know
 * as text. */
static uint32_t defaults(const sozai_texture_info *info, sozai_value *to) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < info->parameter_count; i++) {
    const sozai_parameter *p = info->parameters[i];
    sozai_value v = {.id = p->id, .kind = p->kind, .text = p->default_text};
    memcpy(v.number, p->default_number, sizeof v.number);
    if (p->kind == SOZAI_KIND_CHOICE) v.text = p->choices[(uint32_t)p->default_number[0]];
    if (p->kind == SOZAI_KIND_COLOUR) v.text = NULL;
    if (p->kind > LAST_KIND) v = (sozai_value){.id = p->id, .kind = SOZAI_KIND_STRING, .text = ""};
    to[count++] = v;
  }
  return count;
}

static void refusals(const sozai_texture_info *info) {
  sozai_value wrong[] = {
      {.id = "no_such_parameter", .kind = SOZAI_KIND_FLOAT},
      {.id = info->parameters[0]->id, .kind = SOZAI_KIND_TEXT, .text = "x"},
      {.id = info->parameters[0]->id, .kind = SOZAI_KIND_STRING, .text = "twelve"},
      {.id = info->parameters[0]->id, .kind = SOZAI_KIND_FLOAT, .number = {-1e30}},
      {.id = info->parameters[0]->id, .kind = 77u},
      {.id = NULL, .kind = SOZAI_KIND_FLOAT}};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) answer(info, NULL, &wrong[i], 1, 1);
  answer(info, "no_such_preset", NULL, 0, 1);
}

/* A table in the buffer of the day, shorter than today's. */
static void knots(const sozai_texture_info *info) {
  float rows[3][10];
  for (int i = 0; i < 3; i++) {
    const float row[] = {1, 2, -1, -1, (float)i, 0.4f, 300.0f * (float)i, 8, 0, 0};
    memcpy(rows[i], row, sizeof row);
  }
  struct {
    sozai_buffer table;
    unsigned char after[AFTER];
  } given = {.table = {.size = sizeof(sozai_buffer),
                       .kind = SOZAI_BUFFER_TABLE,
                       .dims = {3, 10},
                       .data = rows[0]}};
  memset(given.after, 0xa5, AFTER);
  sozai_value v = {.id = "knots", .kind = SOZAI_KIND_BUFFER, .buffer = &given.table};
  answer(info, NULL, &v, 1, 1);
  rows[1][0] = NAN;
  answer(info, NULL, &v, 1, 1);
}

static void rings(const sozai_wood_1 *wood) {
  sozai_texture *t = NULL;
  const float years[] = {0, 1, 20}, theta[] = {0, 1, -2}, y[] = {0, 100, -900};
  float r[3], x[3], z[3];
  if (!wood || textures->create(NULL, "wood", NULL, NULL, 0, &t) != SOZAI_OK) return;
  printf("rings: %d", (int)wood->ring_radius(t, 3, years, theta, y, r));
  printf(" pith: %d", (int)wood->pith(t, 3, y, x, z));
  for (int i = 0; i < 3; i++) printf(" %a %a %a", (double)r[i], (double)x[i], (double)z[i]);
  printf("\n");
  textures->destroy(t);
}

int main(int argc, char **argv) {
  void *library = argc == 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
  const sozai_entry_v1 *entry = library ? dlsym(library, SOZAI_ENTRY_SYMBOL) : NULL;
  if (!entry || entry->abi_major != SOZAI_ABI_MAJOR || entry->init("/nonexistent/x.so")) return 1;
  fprintf(stderr, "%u.%u host %zu buffer %zu\n", SOZAI_ABI_MAJOR, SOZAI_ABI_MINOR,
          sizeof(sozai_host), sizeof(sozai_buffer));
  memset(services.after, 0xa5, AFTER);
  textures = entry->get_factory(SOZAI_TEXTURES_1);
  if (!textures) return 1;
  printf("unknown: %d %d\n", !entry->get_factory("sozai.none/1"), !textures->find("none"));
  for (uint32_t i = 0; i < textures->count(); i++) {
    const sozai_texture_info *info = textures->info(i);
    static sozai_value values[512];
    list(info);
    answer(info, NULL, NULL, 0, 0);
    if (info->parameter_count <= 512) answer(info, NULL, values, defaults(info, values), 1);
    for (uint32_t k = 0; k < info->preset_count; k += 9)
      answer(info, info->presets[k]->id, NULL, 0, k & 1);
    refusals(info);
    if (strcmp(info->id, "wood") == 0) knots(info);
  }
  rings(entry->get_factory(SOZAI_WOOD_1));
  printf("held: %d\n", held);
  entry->deinit();
  dlclose(library);
  return held != 0;
}
