/* SPDX-License-Identifier: Apache-2.0
 *
 * One object of every public type that no exported symbol leads to, so that
 * their layout stands in a library's debugging information and can be compared
 * with the recorded one: sozai.so uses only some of them, and hands its tables
 * out as const void *. A new public type gets a line here. */
#include "sozai_colour.h"

#define SHOW(type)                                                                                 \
  extern const type *const show_##type;                                                            \
  __attribute__((visibility("default"))) const type *const show_##type = 0

SHOW(sozai_entry_v1);
SHOW(sozai_buffer);
SHOW(sozai_value);
SHOW(sozai_parameter);
SHOW(sozai_preset);
SHOW(sozai_channel);
SHOW(sozai_texture_info);
SHOW(sozai_batch);
SHOW(sozai_textures_1);
SHOW(sozai_wood_1);
SHOW(sozai_column);
SHOW(sozai_table_info);
SHOW(sozai_generator_info);
SHOW(sozai_part);
SHOW(sozai_detail);
SHOW(sozai_mesh);
SHOW(sozai_curves);
SHOW(sozai_table);
SHOW(sozai_geometry_1);
SHOW(sozai_host);
SHOW(sozai_limit_info);
SHOW(sozai_limit);
SHOW(sozai_limits_1);
SHOW(sozai_memory);
SHOW(sozai_memory_1);
SHOW(sozai_colour_1);
SHOW(sozai_display_1);
SHOW(sozai_image_request);
SHOW(sozai_images_1);
SHOW(sozai_services_options);
SHOW(sozai_services_1);
