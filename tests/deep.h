// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

namespace tests {

/// The step of a long loop over all cases: each for the preset `deep`, otherwise a fixed tenth.
inline int caseStep() { return qEnvironmentVariableIntValue("CLEARCUT_DEEP") == 1 ? 1 : 10; }

} // namespace tests
