// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace app::plug_in {

/// "SIGXFSZ"; every signal of the system has a name.
QString signalName(int signal);

/// "it used memory that is not its own (SIGSEGV)": what a library did that a signal ended; the
/// name alone where a signal has no usual reason.
QString signalText(int signal);

} // namespace app::plug_in
