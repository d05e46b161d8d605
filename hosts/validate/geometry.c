/* SPDX-License-Identifier: Apache-2.0
 * What is grown: that it grows, and what is refused. Its shapes are judged in
 * geometry_shapes.c, how it does with a host in geometry_host.c. */
#include "geometry.h"

#include <stdlib.h>

#include "groups.h"

/* "Grow one": with no values, or refused for want of one that has no default. */
static void grows(subject *s) {
  if (!generators_start(s)) return;
  for (uint32_t i = 0; i < s->geometry->count(); i++) {
    const sozai_generator_info *info = s->geometry->info(i);
    grown g;
    if (!subject_wants(s, info->id)) continue;
    int32_t r = grow_plain(s, info, NULL, &g);
    if (!EXPECT(r == SOZAI_OK, "%s: grow gave %s: %s", info->id, result_name(r),
                s->geometry->last_error()))
      continue;
    if (!EXPECT(g.geometry, "%s: grow gave SOZAI_OK and nothing", info->id)) continue;
    EXPECT(s->geometry->info_of(g.geometry) == info, "%s: info_of is another", info->id);
    EXPECT(s->geometry->bytes(g.geometry) > 0, "%s: bytes() is 0", info->id);
    s->geometry->release(g.geometry);
  }
}

/* "NULL is allowed." of all three */
static void release_null(subject *s) {
  if (!generators_start(s)) return;
  doing("release, release_mesh and release_curves of NULL");
  s->geometry->release(NULL);
  s->geometry->release_mesh(NULL);
  s->geometry->release_curves(NULL);
  asked();
}

static void refuses(subject *s) {
  if (!generators_start(s)) return;
  for (uint32_t i = 0; i < s->geometry->count(); i++) {
    const char *id = s->geometry->info(i)->id;
    static const sozai_host no_size;
    const struct {
      const char *what;
      const sozai_host *host;
      const char *id, *preset;
      uint32_t count;
      int32_t wanted;
    } calls[] = {{"without an id", NULL, NULL, NULL, 0, SOZAI_ERROR_ARGUMENT},
                 {"of an unknown generator", NULL, "validate: none", NULL, 0, SOZAI_ERROR_UNKNOWN},
                 {"of an unknown preset", NULL, id, "validate: none", 0, SOZAI_ERROR_UNKNOWN},
                 {"of 3 values at NULL", NULL, id, NULL, 3, SOZAI_ERROR_ARGUMENT},
                 {"with a host of size 0", &no_size, id, NULL, 0, SOZAI_ERROR_ARGUMENT}};
    for (uint32_t c = 0; c < COUNT_OF(calls); c++) {
      sozai_geometry *g = POISON;
      doing("grow of %s, %s", id, calls[c].what);
      int32_t r =
          s->geometry->grow(calls[c].host, calls[c].id, calls[c].preset, NULL, calls[c].count, &g);
      EXPECT(r == calls[c].wanted, "grow %s (%s) gave %s, not %s", calls[c].what, id,
             result_name(r), result_name(calls[c].wanted));
      EXPECT(r == SOZAI_OK || !g, "grow %s (%s) failed and left *out as it was", calls[c].what, id);
      if (r == SOZAI_OK) s->geometry->release(g);
    }
    doing("grow with out NULL");
    int32_t r = s->geometry->grow(NULL, id, NULL, NULL, 0, NULL);
    EXPECT(r == SOZAI_ERROR_ARGUMENT, "grow of %s with out NULL gave %s", id, result_name(r));
  }
}

CHECKS(geometry, //
       {"geometry.grows", "describe.unique", "every generator grows of its defaults, or in a box",
        grows},
       {"geometry.release-null", "geometry.grows", "NULL may be released", release_null},
       {"geometry.refuses", "geometry.grows",
        "what is missing or unknown is refused, and *out set to NULL", refuses},
       {"geometry.mesh", "geometry.grows",
        "meshes: finite, unit normals, indices in range, parts without gaps, colours from 0 to 1",
        geometry_mesh},
       {"geometry.curves", "geometry.grows",
        "curves: finite, radii not negative, points and parts without gaps, colours from 0 to 1",
        geometry_curves},
       {"geometry.tables", "geometry.grows",
        "tables: finite, of their info; an unknown one is refused", geometry_tables},
       {"geometry.levels", "geometry.grows",
        "levels 0 to 8, none more than the one before; others refused", geometry_levels},
       {"geometry.same", "geometry.grows",
        "the same bits again, and with tasks in any order, refused or dropped", geometry_same},
       {"geometry.outlives", "geometry.grows", "meshes and curves outlive what they are of",
        geometry_outlives},
       {"geometry.cancelled", "geometry.grows", "growing stops where progress says so, cleanly",
        geometry_cancelled},
       {"geometry.allocator-fails", "geometry.grows",
        "where an allocation fails growing does, cleanly", geometry_allocator_fails},
       {"geometry.values", "geometry.grows", "value() gives what it was grown with",
        geometry_values},
       {"geometry.leaks", "geometry.grows", "what is grown and released leaves no memory behind",
        geometry_leaks});
