// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace app::plug_in {

/// "SIGXFSZ"; every signal of the system has a name.
QString signalName(int signal);

/// "it used memory that is not its own (SIGSEGV)": why a signal ended a library; only the name for
/// a signal without a usual reason.
QString signalText(int signal);

} // namespace app::plug_in
