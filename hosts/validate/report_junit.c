/* SPDX-License-Identifier: Apache-2.0
 * JUnit's XML as CI systems read it: a testsuite for each group. */
#include "report.h"
#include "utf8.h"

/* The length of the UTF-8 character at s that XML 1.0 may hold, or 0. */
static int xml_character(const unsigned char *s) {
  if (s[0] < 0x80) return s[0] >= 0x20 || s[0] == '\t' || s[0] == '\n' || s[0] == '\r';
  int n = utf8_length(s);
  return n == 3 && s[0] == 0xef && s[1] == 0xbf && s[2] >= 0xbe ? 0 : n; /* U+FFFE, U+FFFF */
}

static void escaped(FILE *to, const char *text) {
  for (const unsigned char *s = (const unsigned char *)text; *s;) {
    int n = xml_character(s);
    if (n == 0)
      fputs("\xef\xbf\xbd", to);
    else if (*s == '<' || *s == '>' || *s == '&' || *s == '"' || *s < 0x20)
      fprintf(to, "&#%d;", *s);
    else
      fwrite(s, 1, (size_t)n, to);
    s += n ? n : 1;
  }
}

static void attribute(FILE *to, const char *name, const char *text) {
  fprintf(to, " %s=\"", name);
  escaped(to, text);
  fputc('"', to);
}

static void lines(FILE *to, char text[VERDICT_LINES][VERDICT_LINE], atomic_uint *count) {
  for (uint32_t i = 0; i < reasons_kept(count); i++) {
    escaped(to, text[i]);
    fputc('\n', to);
  }
}

static void one(FILE *to, const report_head *head, const result *r) {
  verdict *v = r->verdict;
  outcome o = outcome_of(r, head->strict);
  fputs("    <testcase", to);
  attribute(to, "classname", r->group->id);
  attribute(to, "name", r->check->name);
  fprintf(to, " time=\"%.3f\">\n", r->seconds);
  if (atomic_load(&v->chance))
    fprintf(to, "      <properties><property name=\"seed\" value=\"%u\"/></properties>\n",
            head->seed);
  if (o == OUTCOME_SKIPPED) {
    fputs("      <skipped", to);
    attribute(to, "message", v->skip);
    fputs("/>\n", to);
  } else if (o == OUTCOME_FAILED) {
    fputs("      <failure", to);
    attribute(to, "message", r->check->shows);
    fputs(">", to);
    lines(to, v->failure, &v->failures);
    lines(to, v->warning, &v->warnings);
    fputs("</failure>\n", to);
  } else if (atomic_load(&v->warnings)) {
    fputs("      <system-out>", to);
    lines(to, v->warning, &v->warnings);
    fputs("</system-out>\n", to);
  }
  fputs("    </testcase>\n", to);
}

static void suite(FILE *to, const report_head *head, const result *results, uint32_t count) {
  totals t = totals_of(results, count, head->strict);
  fputs("  <testsuite", to);
  attribute(to, "name", results->group->id);
  fprintf(to, " tests=\"%u\" failures=\"%u\" errors=\"0\" skipped=\"%u\">\n", t.checks, t.failed,
          t.skipped);
  for (uint32_t i = 0; i < count; i++) one(to, head, &results[i]);
  fputs("  </testsuite>\n", to);
}

void report_junit(FILE *to, const report_head *head, const result *results, uint32_t count) {
  totals t = totals_of(results, count, head->strict);
  fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites", to);
  attribute(to, "name", head->path);
  fprintf(to, " tests=\"%u\" failures=\"%u\" errors=\"0\" skipped=\"%u\" time=\"%.3f\">\n",
          t.checks, t.failed, t.skipped, head->seconds);
  for (uint32_t i = 0; i < count;) {
    uint32_t n = 1;
    while (i + n < count && results[i + n].group == results[i].group) n++;
    suite(to, head, &results[i], n);
    i += n;
  }
  fputs("</testsuites>\n", to);
}
