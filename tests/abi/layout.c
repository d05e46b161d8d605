/* SPDX-License-Identifier: Apache-2.0
 *
 * The size and the members' offsets of every public struct, as they are on the
 * 64-bit machines of version 1 of the ABI. Compiled for its assertions alone
 * (headers.sh), by every compiler and for every machine there is a compiler
 * for. A number here changes only with SOZAI_ABI_MAJOR; a struct that grows
 * gets new lines, and a new size, and no other line moves. */
#include "sozai_colour.h"

#ifdef __cplusplus
#define HOLDS static_assert
#else
#define HOLDS _Static_assert
#endif
#define SIZE(type, bytes) HOLDS(sizeof(type) == (bytes), "size of " #type)
#define AT(type, member, offset)                                                                   \
  HOLDS(offsetof(type, member) == (offset), "offset of " #type "." #member)

HOLDS(sizeof(void *) == 8, "the numbers are those of 64-bit machines");

SIZE(sozai_entry_v1, 32);
AT(sozai_entry_v1, abi_major, 0);
AT(sozai_entry_v1, abi_minor, 4);
AT(sozai_entry_v1, init, 8);
AT(sozai_entry_v1, deinit, 16);
AT(sozai_entry_v1, get_factory, 24);

SIZE(sozai_buffer, 88);
AT(sozai_buffer, size, 0);
AT(sozai_buffer, kind, 4);
AT(sozai_buffer, dims, 8);
AT(sozai_buffer, data, 32);
AT(sozai_buffer, points, 40);
AT(sozai_buffer, normals, 48);
AT(sozai_buffer, indices, 56);
AT(sozai_buffer, colour_space, 64);
AT(sozai_buffer, path, 72);
AT(sozai_buffer, wrap, 80);
AT(sozai_buffer, first_channel, 84);

SIZE(sozai_value, 56);
AT(sozai_value, id, 0);
AT(sozai_value, kind, 8);
AT(sozai_value, reserved, 12);
AT(sozai_value, number, 16);
AT(sozai_value, text, 40);
AT(sozai_value, buffer, 48);

SIZE(sozai_parameter, 136);
AT(sozai_parameter, size, 0);
AT(sozai_parameter, kind, 4);
AT(sozai_parameter, id, 8);
AT(sozai_parameter, label, 16);
AT(sozai_parameter, group, 24);
AT(sozai_parameter, unit, 32);
AT(sozai_parameter, doc, 40);
AT(sozai_parameter, hard_min, 48);
AT(sozai_parameter, hard_max, 56);
AT(sozai_parameter, soft_min, 64);
AT(sozai_parameter, soft_max, 72);
AT(sozai_parameter, default_number, 80);
AT(sozai_parameter, default_text, 104);
AT(sozai_parameter, choices, 112);
AT(sozai_parameter, choice_docs, 120);
AT(sozai_parameter, choice_count, 128);
AT(sozai_parameter, buffer_kind, 132);

SIZE(sozai_preset, 48);
AT(sozai_preset, size, 0);
AT(sozai_preset, value_count, 4);
AT(sozai_preset, id, 8);
AT(sozai_preset, label, 16);
AT(sozai_preset, doc, 24);
AT(sozai_preset, source, 32);
AT(sozai_preset, values, 40);

SIZE(sozai_channel, 56);
AT(sozai_channel, size, 0);
AT(sozai_channel, first, 4);
AT(sozai_channel, components, 8);
AT(sozai_channel, needs, 12);
AT(sozai_channel, uses, 16);
AT(sozai_channel, reserved, 20);
AT(sozai_channel, id, 24);
AT(sozai_channel, unit, 32);
AT(sozai_channel, suffixes, 40);
AT(sozai_channel, doc, 48);

SIZE(sozai_texture_info, 72);
AT(sozai_texture_info, size, 0);
AT(sozai_texture_info, revision, 4);
AT(sozai_texture_info, id, 8);
AT(sozai_texture_info, label, 16);
AT(sozai_texture_info, doc, 24);
AT(sozai_texture_info, parameters, 32);
AT(sozai_texture_info, presets, 40);
AT(sozai_texture_info, channels, 48);
AT(sozai_texture_info, parameter_count, 56);
AT(sozai_texture_info, preset_count, 60);
AT(sozai_texture_info, channel_count, 64);
AT(sozai_texture_info, component_count, 68);

SIZE(sozai_batch, 160);
AT(sozai_batch, size, 0);
AT(sozai_batch, count, 4);
AT(sozai_batch, point, 8);
AT(sozai_batch, normal, 32);
AT(sozai_batch, light, 56);
AT(sozai_batch, light_colour, 80);
AT(sozai_batch, view, 104);
AT(sozai_batch, footprint, 128);
AT(sozai_batch, active, 136);
AT(sozai_batch, out, 144);
AT(sozai_batch, out_count, 152);
AT(sozai_batch, reserved, 156);

SIZE(sozai_textures_1, 88);
AT(sozai_textures_1, count, 0);
AT(sozai_textures_1, info, 8);
AT(sozai_textures_1, find, 16);
AT(sozai_textures_1, create, 24);
AT(sozai_textures_1, destroy, 32);
AT(sozai_textures_1, evaluate, 40);
AT(sozai_textures_1, value, 48);
AT(sozai_textures_1, info_of, 56);
AT(sozai_textures_1, bytes, 64);
AT(sozai_textures_1, instruction_set, 72);
AT(sozai_textures_1, last_error, 80);

SIZE(sozai_wood_1, 16);
AT(sozai_wood_1, ring_radius, 0);
AT(sozai_wood_1, pith, 8);

SIZE(sozai_column, 24);
AT(sozai_column, id, 0);
AT(sozai_column, unit, 8);
AT(sozai_column, doc, 16);

SIZE(sozai_table_info, 32);
AT(sozai_table_info, size, 0);
AT(sozai_table_info, column_count, 4);
AT(sozai_table_info, id, 8);
AT(sozai_table_info, doc, 16);
AT(sozai_table_info, columns, 24);

SIZE(sozai_generator_info, 72);
AT(sozai_generator_info, size, 0);
AT(sozai_generator_info, revision, 4);
AT(sozai_generator_info, id, 8);
AT(sozai_generator_info, label, 16);
AT(sozai_generator_info, doc, 24);
AT(sozai_generator_info, parameters, 32);
AT(sozai_generator_info, presets, 40);
AT(sozai_generator_info, tables, 48);
AT(sozai_generator_info, parameter_count, 56);
AT(sozai_generator_info, preset_count, 60);
AT(sozai_generator_info, table_count, 64);
AT(sozai_generator_info, reserved, 68);

SIZE(sozai_part, 40);
AT(sozai_part, id, 0);
AT(sozai_part, first, 8);
AT(sozai_part, count, 16);
AT(sozai_part, colour, 24);
AT(sozai_part, flags, 36);

SIZE(sozai_detail, 8);
AT(sozai_detail, size, 0);
AT(sozai_detail, level, 4);

SIZE(sozai_mesh, 80);
AT(sozai_mesh, size, 0);
AT(sozai_mesh, part_count, 4);
AT(sozai_mesh, point_count, 8);
AT(sozai_mesh, triangle_count, 16);
AT(sozai_mesh, points, 24);
AT(sozai_mesh, normals, 32);
AT(sozai_mesh, uv, 40);
AT(sozai_mesh, owner, 48);
AT(sozai_mesh, indices, 56);
AT(sozai_mesh, parts, 64);
AT(sozai_mesh, colours, 72);

SIZE(sozai_curves, 72);
AT(sozai_curves, size, 0);
AT(sozai_curves, part_count, 4);
AT(sozai_curves, curve_count, 8);
AT(sozai_curves, point_count, 16);
AT(sozai_curves, points, 24);
AT(sozai_curves, radii, 32);
AT(sozai_curves, first, 40);
AT(sozai_curves, ids, 48);
AT(sozai_curves, parts, 56);
AT(sozai_curves, colours, 64);

SIZE(sozai_table, 32);
AT(sozai_table, size, 0);
AT(sozai_table, reserved, 4);
AT(sozai_table, info, 8);
AT(sozai_table, data, 16);
AT(sozai_table, rows, 24);

SIZE(sozai_geometry_1, 112);
AT(sozai_geometry_1, count, 0);
AT(sozai_geometry_1, info, 8);
AT(sozai_geometry_1, find, 16);
AT(sozai_geometry_1, grow, 24);
AT(sozai_geometry_1, release, 32);
AT(sozai_geometry_1, mesh, 40);
AT(sozai_geometry_1, release_mesh, 48);
AT(sozai_geometry_1, curves, 56);
AT(sozai_geometry_1, release_curves, 64);
AT(sozai_geometry_1, table, 72);
AT(sozai_geometry_1, value, 80);
AT(sozai_geometry_1, info_of, 88);
AT(sozai_geometry_1, bytes, 96);
AT(sozai_geometry_1, last_error, 104);

SIZE(sozai_host, 96);
AT(sozai_host, size, 0);
AT(sozai_host, reserved, 4);
AT(sozai_host, user, 8);
AT(sozai_host, log, 16);
AT(sozai_host, alloc, 24);
AT(sozai_host, free, 32);
AT(sozai_host, parallel, 40);
AT(sozai_host, progress, 48);
AT(sozai_host, get_service, 56);
AT(sozai_host, colour_config, 64);
AT(sozai_host, image_memory, 72);
AT(sozai_host, limits, 80);
AT(sozai_host, limit_count, 88);
AT(sozai_host, reserved_2, 92);

SIZE(sozai_limit_info, 48);
AT(sozai_limit_info, size, 0);
AT(sozai_limit_info, reserved, 4);
AT(sozai_limit_info, id, 8);
AT(sozai_limit_info, unit, 16);
AT(sozai_limit_info, doc, 24);
AT(sozai_limit_info, value, 32);
AT(sozai_limit_info, most, 40);

SIZE(sozai_limit, 16);
AT(sozai_limit, id, 0);
AT(sozai_limit, value, 8);

SIZE(sozai_limits_1, 24);
AT(sozai_limits_1, count, 0);
AT(sozai_limits_1, info, 8);
AT(sozai_limits_1, find, 16);

SIZE(sozai_memory, 24);
AT(sozai_memory, size, 0);
AT(sozai_memory, reserved, 4);
AT(sozai_memory, held, 8);
AT(sozai_memory, peak, 16);

SIZE(sozai_memory_1, 40);
AT(sozai_memory_1, texture, 0);
AT(sozai_memory_1, geometry, 8);
AT(sozai_memory_1, mesh, 16);
AT(sozai_memory_1, curves, 24);
AT(sozai_memory_1, last_error, 32);

SIZE(sozai_colour_1, 56);
AT(sozai_colour_1, size, 0);
AT(sozai_colour_1, reserved, 4);
AT(sozai_colour_1, self, 8);
AT(sozai_colour_1, config_name, 16);
AT(sozai_colour_1, working_space, 24);
AT(sozai_colour_1, has_space, 32);
AT(sozai_colour_1, to_working, 40);
AT(sozai_colour_1, from_working, 48);

SIZE(sozai_display_1, 48);
AT(sozai_display_1, size, 0);
AT(sozai_display_1, reserved, 4);
AT(sozai_display_1, self, 8);
AT(sozai_display_1, count, 16);
AT(sozai_display_1, item, 24);
AT(sozai_display_1, to_display, 32);
AT(sozai_display_1, chromaticities, 40);

SIZE(sozai_services_options, 24);
AT(sozai_services_options, size, 0);
AT(sozai_services_options, reserved, 4);
AT(sozai_services_options, config, 8);
AT(sozai_services_options, image_memory, 16);

SIZE(sozai_services_1, 24);
AT(sozai_services_1, open, 0);
AT(sozai_services_1, get, 8);
AT(sozai_services_1, close, 16);

SIZE(sozai_image_request, 72);
AT(sozai_image_request, size, 0);
AT(sozai_image_request, wrap_s, 4);
AT(sozai_image_request, wrap_t, 8);
AT(sozai_image_request, first_channel, 12);
AT(sozai_image_request, channels, 16);
AT(sozai_image_request, reserved, 20);
AT(sozai_image_request, path, 24);
AT(sozai_image_request, buffer, 32);
AT(sozai_image_request, colour_space, 40);
AT(sozai_image_request, most_pixels, 48);
AT(sozai_image_request, user, 56);
AT(sozai_image_request, progress, 64);

SIZE(sozai_images_1, 56);
AT(sozai_images_1, size, 0);
AT(sozai_images_1, reserved, 4);
AT(sozai_images_1, self, 8);
AT(sozai_images_1, open, 16);
AT(sozai_images_1, close, 24);
AT(sozai_images_1, resolution, 32);
AT(sozai_images_1, sample, 40);
AT(sozai_images_1, memory, 48);
