// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace app::plug_in {

/// The first argument of this program where it is to be the child of a judge: the only process that
/// ever loads a user's library. `judge-child answer LIBRARY` clips what comes on standard input;
/// `judge-child race LIBRARY LINES RUNS SEED CONTRACT` times it.
inline constexpr auto childKey = "judge-child";

/// What a library can be asked to do with at most, in bytes: beyond what the child itself takes.
inline constexpr unsigned long memoryLimit = 512ul << 20;

bool isChild(const QStringList& arguments);

/// Leaves a warden behind (warden.h), says on standard output the number of the process that loads
/// the library, loads it, says how that went, and does what is asked. What the library prints goes
/// to standard error. Never longer than two minutes of the processor's time, and never longer than
/// the thread that started it; nothing that the library started is left.
int runChild(const QStringList& arguments);

/// What the child says in the line after its number: the word of how it went, a space, and the name
/// of the algorithm or the loader's sentence.
namespace hello {
inline constexpr auto ready = "ready", notLoadable = "not-loadable", noFunction = "no-function",
                      otherVersion = "other-version";
} // namespace hello

} // namespace app::plug_in
