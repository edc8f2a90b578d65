// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

/// From now on the program's settings are a JSON file that is replaced only by a whole new one
/// which has reached the disk (QSettings' own formats empty it when the disk is full), and of which
/// only texts, numbers, truth values, lists of texts and bytes are read. What an earlier version
/// wrote (an INI file of that name) is read too. A file of more than 1 MB is no settings file: it
/// counts as empty.
void useSafeSettings();

} // namespace app
