// SPDX-License-Identifier: GPL-3.0-or-later
// Included before an algorithm's file, takes the calls of its watcher out of the text. A parameter
// of that name stays: it is not followed by a parenthesis.
#pragma once
#define watch(...) static_cast<void>(0)
