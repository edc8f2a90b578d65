// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace app::plug_in {

/// The first argument of this program when it runs as a judge's child, the only process that ever
/// loads a user's library. `judge-child answer LIBRARY` clips lines from standard input;
/// `judge-child race LIBRARY LINES RUNS SEED CONTRACT` times the library.
inline constexpr auto childKey = "judge-child";

/// The memory limit of a library in bytes, in addition to the child's own memory.
inline constexpr unsigned long memoryLimit = 512ul << 20;

bool isChild(const QStringList& arguments);

/// Leaves a supervisor behind (supervisor.h), prints the number of the process that loads the
/// library on standard output, loads the library, reports the result, and does what the arguments
/// ask. The library's output goes to standard error. Runs at most two minutes of processor time,
/// and not longer than the thread that started it; no process that the library started survives.
int runChild(const QStringList& arguments);

} // namespace app::plug_in

namespace app::plug_in {

/// The child's second line: a word for the result, a space, and the name of the algorithm or the
/// loader's message.
namespace hello {
inline constexpr auto ready = "ready", notLoadable = "not-loadable", noFunction = "no-function",
                      otherVersion = "other-version";
} // namespace hello

} // namespace app::plug_in
