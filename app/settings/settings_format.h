// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

/// Stores the program's settings in a JSON file from now on. The file is replaced only by a
/// complete new file that is already on the disk (QSettings' own formats empty it when the disk is
/// full). Only texts, numbers, truth values, lists of texts and bytes are read. The INI file of an
/// earlier version, under the same name, is read too. A file larger than 1 MB counts as empty. Only
/// the user can read the file, which names other files.
void useSafeSettings();

} // namespace app
