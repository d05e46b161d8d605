#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs a program with locales among which there is one with a decimal comma.
set -euo pipefail
program=$1 scratch=$2
# shellcheck source=tests/locale.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../locale.sh"
if ! comma_locale "$scratch/locales"; then
  echo "no locale with a decimal comma can be made here"
  exit 77
fi
exec "$program"
