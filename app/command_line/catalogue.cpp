// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/command.h"

#include <cstdio>

namespace app {

std::span<const Command> commands() { return {}; }

bool isCommandLine(const QStringList& arguments)
{
    return arguments.contains(QStringLiteral("--version"));
}

int runCommandLine(const QStringList&)
{
    std::puts("clearcut " CLEARCUT_VERSION);
    return int(Exit::Done);
}

} // namespace app
