/* SPDX-License-Identifier: Apache-2.0 */
#include "folder.h"

#include <errno.h>
#include <sys/stat.h>

bool folder_make(const char *folder) {
  struct stat status;
  if (mkdir(folder, 0777) == 0) return true;
  int error = errno;
  if (error == EEXIST && stat(folder, &status) == 0 && S_ISDIR(status.st_mode)) return true;
  errno = error;
  return false;
}
