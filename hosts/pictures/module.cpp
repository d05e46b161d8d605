// SPDX-License-Identifier: Apache-2.0
#include "module.h"

#include "writer.h"

extern "C" __attribute__((visibility("default"))) const pictures sozai_pictures;

const pictures sozai_pictures = {SOZAI_VERSION,  image_write,  image_read,  image_probe,
                                 image_has_text, image_text,   writer_open, writer_next_level,
                                 writer_rows,    writer_close, writer_drop};
