// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

namespace tests {

/// Whether all cases are tested, as the preset `deep` does. Otherwise long loops take a fixed tenth of them.
inline bool isDeep() { return qEnvironmentVariableIntValue("CLEARCUT_DEEP") == 1; }

/// The number of random cases, of which `all` are tested by `deep`.
inline int casesOf(int all) { return isDeep() ? all : (all + 9) / 10; }

/// The step of a loop over all cases: each, or each tenth.
inline int caseStep() { return isDeep() ? 1 : 10; }

} // namespace tests
