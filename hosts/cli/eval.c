/* SPDX-License-Identifier: Apache-2.0
 *
 * A block of lines is read in order, then its slices are parsed, evaluated and
 * printed each on its own thread, then written in order. */
#include "commands.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cancel.h"
#include "columns.h"
#include "csv.h"
#include "output_file.h"
#include "parallel.h"
#include "session.h"
#include "ceilings.h"

#define SLICE 1024 /* lines */
#define MOST_SLICES 64
#define NUMBER_LENGTH 17 /* of "-1.23456789e-38" and what follows it, with room */

typedef struct slice {
  failure why; /* exit_code 0: none */
  char *text;
  size_t used;
} slice;

typedef struct job {
  const sozai_textures_1 *textures;
  const sozai_texture_info *info;
  const sozai_texture *texture;
  columns columns;
  uint32_t channels[EVAL_MOST_CHANNELS];
  uint32_t channel_count;
  uint32_t outputs[EVAL_MOST_OUTPUTS]; /* component of the texture's, in the order printed */
  uint32_t output_count;
  csv_lines lines;
  const char *to_name;
  float *arena; /* for each slice: COLUMNS + output_count arrays of SLICE */
  slice slices[MOST_SLICES];
} job;

/* ---- the channels ----------------------------------------------------- */

static bool missing_input(const job *j, const sozai_channel *c, failure *why) {
  char columns[128] = "";
  for (uint32_t i = 0; i < COLUMNS; i++)
    if (c->needs & ~j->columns.inputs & column_bit(i)) {
      size_t used = strlen(columns);
      snprintf(columns + used, sizeof columns - used, "%s%s", used ? "," : "", column_names[i]);
    }
  return fail(why, EXIT_BAD_INPUT, "channel '%s' needs columns %s, which %s lacks", c->id, columns,
              j->lines.name);
}

static bool choose_channels(job *j, const char *names, failure *why) {
  if (names) {
    if (!session_channels(j->info, names, j->channels, EVAL_MOST_CHANNELS, &j->channel_count, why))
      return false;
  } else
    for (uint32_t i = 0; i < j->info->channel_count && j->channel_count < EVAL_MOST_CHANNELS; i++)
      if (!(j->info->channels[i]->needs & ~j->columns.inputs)) j->channels[j->channel_count++] = i;
  for (uint32_t i = 0; i < j->channel_count; i++) {
    const sozai_channel *c = j->info->channels[j->channels[i]];
    if (c->needs & ~j->columns.inputs) return missing_input(j, c, why);
    if (j->output_count + c->components > EVAL_MOST_OUTPUTS)
      return fail(why, EXIT_FAILURE, "more than %d output columns", EVAL_MOST_OUTPUTS);
    for (uint32_t k = 0; k < c->components; k++) j->outputs[j->output_count++] = c->first + k;
  }
  if (j->output_count > 0) return true;
  return fail(why, EXIT_BAD_INPUT, "no channel of %s can do with the columns of %s", j->info->id,
              j->lines.name);
}

static void write_header(const job *j, FILE *to) {
  const char *comma = "";
  for (uint32_t i = 0; i < j->channel_count; i++) {
    const sozai_channel *c = j->info->channels[j->channels[i]];
    for (uint32_t k = 0; k < c->components; k++) {
      fprintf(to, "%s%s", comma, c->id);
      if (c->components > 1) fprintf(to, "_%c", c->suffixes[k]);
      comma = ",";
    }
  }
  fputc('\n', to);
}

/* ---- the rows --------------------------------------------------------- */

static bool parse_slice(const job *j, uint32_t first, uint32_t count, float *inputs, failure *why) {
  for (uint32_t i = 0; i < count; i++) {
    const char *line = csv_line(&j->lines, first + i);
    unsigned long long number = j->lines.numbers[first + i];
    float row[COLUMNS];
    int bad;
    uint32_t fields;
    if (csv_numbers(line, row, j->columns.count, &bad, &fields)) {
      for (uint32_t c = 0; c < j->columns.count; c++)
        inputs[j->columns.input[c] * SLICE + i] = row[c];
      continue;
    }
    if (bad < 0)
      return fail(why, EXIT_BAD_INPUT, "%s:%llu: %u value%s, but the header has %u columns",
                  j->lines.name, number, fields, fields == 1 ? "" : "s", j->columns.count);
    for (int c = 0; c < bad; c++) line = strchr(line, ',') + 1;
    size_t length = strcspn(line, ",");
    return fail(why, EXIT_BAD_INPUT, "%s:%llu: %s '%.*s' is not a number", j->lines.name, number,
                column_names[j->columns.input[bad]], (int)(length < 60 ? length : 60), line);
  }
  return true;
}

static bool evaluate_slice(const job *j, uint32_t count, const float *inputs, float *outputs,
                           failure *why) {
  float *out[EVAL_MOST_OUTPUTS] = {NULL};
  uint32_t out_count = 0;
  for (uint32_t i = 0; i < j->output_count; i++) {
    if (j->outputs[i] >= EVAL_MOST_OUTPUTS)
      return fail(why, EXIT_FAILURE, "the material has more than %d components", EVAL_MOST_OUTPUTS);
    out[j->outputs[i]] = outputs + i * SLICE;
    if (j->outputs[i] >= out_count) out_count = j->outputs[i] + 1;
  }
  sozai_batch batch = {.size = sizeof batch, .count = count, .out = out, .out_count = out_count};
  for (uint32_t k = 0; k < 3; k++) {
    batch.point[k] = inputs + k * SLICE;
    if (j->columns.inputs & SOZAI_INPUT_NORMAL) batch.normal[k] = inputs + (3 + k) * SLICE;
    if (j->columns.inputs & SOZAI_INPUT_LIGHT) batch.light[k] = inputs + (6 + k) * SLICE;
    if (j->columns.inputs & SOZAI_INPUT_LIGHT_COLOUR)
      batch.light_colour[k] = inputs + (9 + k) * SLICE;
    if (j->columns.inputs & SOZAI_INPUT_VIEW) batch.view[k] = inputs + (12 + k) * SLICE;
  }
  if (j->columns.inputs & SOZAI_INPUT_FOOTPRINT) batch.footprint = inputs + 15 * SLICE;
  if (j->textures->evaluate(j->texture, &batch) == SOZAI_OK) return true;
  return fail(why, EXIT_FAILURE, "evaluate: %s", j->textures->last_error());
}

static void print_slice(const job *j, uint32_t count, const float *outputs, slice *s) {
  for (uint32_t i = 0; i < count; i++)
    for (uint32_t k = 0; k < j->output_count; k++) {
      int length =
          snprintf(s->text + s->used, NUMBER_LENGTH + 1, "%.9g", (double)outputs[k * SLICE + i]);
      s->used += (size_t)length;
      s->text[s->used++] = k + 1 < j->output_count ? ',' : '\n';
    }
}

static void run_slice(void *context, uint32_t index) {
  job *j = context;
  slice *s = &j->slices[index];
  uint32_t first = index * SLICE;
  uint32_t count = j->lines.count - first < SLICE ? j->lines.count - first : SLICE;
  float *inputs = j->arena + (size_t)index * (COLUMNS + j->output_count) * SLICE;
  float *outputs = inputs + COLUMNS * SLICE;
  s->used = 0;
  if (parse_slice(j, first, count, inputs, &s->why) &&
      evaluate_slice(j, count, inputs, outputs, &s->why))
    print_slice(j, count, outputs, s);
}

static bool allocate(job *j, failure *why) {
  j->arena = malloc(sizeof(float) * MOST_SLICES * SLICE * (COLUMNS + j->output_count));
  bool ok = j->arena != NULL;
  for (uint32_t i = 0; i < MOST_SLICES; i++) {
    j->slices[i].text = malloc((size_t)SLICE * j->output_count * NUMBER_LENGTH + 1);
    ok = ok && j->slices[i].text;
  }
  return ok || fail(why, EXIT_FAILURE, "out of memory");
}

static bool unwritten(const job *j, FILE *to, failure *why) {
  if (to == stdout) return output_unprinted(why);
  return fail(why, EXIT_FAILURE, "cannot write %s: %s", j->to_name, strerror(errno));
}

static bool write_rows(job *j, uint32_t threads, FILE *to, failure *why) {
  for (;;) {
    if (!csv_next(&j->lines, MOST_SLICES * SLICE, why)) return false;
    if (j->lines.count == 0) return true;
    uint32_t slices = (j->lines.count + SLICE - 1) / SLICE;
    parallel_for(threads, slices, run_slice, j);
    for (uint32_t i = 0; i < slices; i++) {
      slice *s = &j->slices[i];
      if (s->why.exit_code) {
        *why = s->why;
        return false;
      }
      if (fwrite(s->text, 1, s->used, to) != s->used) return unwritten(j, to, why);
    }
    if (cancel_requested()) return fail(why, EXIT_FAILURE, "cancelled");
  }
}

static bool evaluate_stream(job *j, const char *channels, uint32_t threads, FILE *from,
                            const char *from_name, FILE *to, failure *why) {
  bool ok = csv_open(&j->lines, from, from_name, MOST_SLICES * SLICE, why) &&
            columns_read(&j->columns, &j->lines, why) && choose_channels(j, channels, why) &&
            allocate(j, why);
  if (ok) {
    write_header(j, to);
    ok = write_rows(j, threads, to, why);
  }
  if (ok && fflush(to) != 0) ok = unwritten(j, to, why);
  for (uint32_t i = 0; i < MOST_SLICES; i++) free(j->slices[i].text);
  free(j->arena);
  csv_close(&j->lines);
  return ok;
}

/* Open the files around evaluate_stream. */
static bool evaluate_files(job *j, const char *channels, uint32_t threads, const char *input,
                           const char *output, failure *why) {
  FILE *from = strcmp(input, "-") == 0 ? stdin : fopen(input, "rb");
  if (!from) return fail(why, EXIT_BAD_INPUT, "cannot read %s: %s", input, strerror(errno));
  const char *name = from == stdin ? "standard input" : input;
  bool ok;
  j->to_name = strcmp(output, "-") == 0 ? "standard output" : output;
  if (strcmp(output, "-") == 0)
    ok = evaluate_stream(j, channels, threads, from, name, stdout, why);
  else {
    output_file o;
    ok = output_begin(&o, output, why);
    if (ok) {
      FILE *to = fopen(o.writing, "wb");
      ok = to ? evaluate_stream(j, channels, threads, from, name, to, why)
              : fail(why, EXIT_FAILURE, "cannot write %s: %s", output, strerror(errno));
      if (to && fclose(to) != 0 && ok)
        ok = fail(why, EXIT_FAILURE, "cannot write %s: %s", output, strerror(errno));
      if (ok)
        ok = output_commit(&o, why);
      else
        output_discard(&o);
    }
  }
  if (from != stdin) fclose(from);
  return ok;
}

static bool evaluate_named(const char *name, const session_options *shared, const char *channels,
                           const char *input, const char *output, failure *why) {
  session s;
  recipe r;
  if (!session_open(&s, shared, why)) return false;
  bool ok = session_recipe(&r, name, shared, why);
  if (ok) {
    job j = {.textures = s.plugin.textures};
    sozai_texture *texture = NULL;
    j.info = recipe_info(&r, s.plugin.textures, s.plugin.geometry, why);
    ok = j.info && recipe_create(&r, s.plugin.textures, &s.host.abi, &texture, why);
    j.texture = texture;
    ok = ok && evaluate_files(&j, channels, s.host.threads, input, output, why);
    s.plugin.textures->destroy(texture);
    recipe_free(&r);
  }
  session_close(&s);
  return ok;
}

int run_eval(int argc, char **argv) {
  failure why = {0};
  session_options shared;
  if (!session_options_init(&shared, argc, &why)) return report(&why);
  const char *channels = NULL, *input = "-", *output = "-";
  const option options[] = {
      SESSION_TEXTURE_OPTIONS(shared),
      {"channels", 0, OPTION_TEXT, &channels, "A,B",
       "channels to print (default: all that the columns suffice for)", 0, 0},
      {"input", 'i', OPTION_TEXT, &input, "FILE", "CSV to read (default: standard input)", 0, 0},
      {"output", 'o', OPTION_TEXT, &output, "FILE", "CSV to write (default: standard output)", 0,
       0},
      SESSION_RUN_OPTIONS(shared)};
  static const char *const positional[] = {"material or .sozai file"};
  const command_line line = {
      .usage = "eval <material|file.sozai> [options] < points.csv",
      .about =
          "Evaluates a material at points.\n\n"
          "The input's first line names its columns: px,py,pz (mm), and any of nx,ny,nz\n"
          "(normal), lx,ly,lz (towards the light), lr,lg,lb (the light's colour), vx,vy,vz\n"
          "(towards the eye), footprint (mm). The output has a column for each component, and\n"
          "a line for each of the input's that has anything on it.\n",
      .options = options,
      .option_count = sizeof options / sizeof options[0],
      .positional = positional,
      .positional_count = 1};
  const char *name = NULL;
  int parsed = options_parse(&line, argc, argv, &name, &why);
  int code = 0;
  if (parsed == OPTIONS_BAD ||
      (parsed == OPTIONS_RUN && !evaluate_named(name, &shared, channels, input, output, &why)))
    code = report(&why);
  session_options_free(&shared);
  return code;
}
