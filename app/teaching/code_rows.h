// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/narration.h"

#include <set>

namespace app {

/// A row of pseudo-code as it is read beside a run: a line, or a branch that was not taken.
struct CodeRow {
    int first = 0, last = 0; ///< lines of the pseudo-code, from 1
    QString text;            ///< the line, or what stands for the branch
    bool folds = false;      ///< begins a branch that was not taken, folded or not
    bool isFolded() const { return last > first; }
    friend bool operator==(const CodeRow&, const CodeRow&) = default;
};

/// The lines that the steps name.
std::set<int> linesRun(const Narration& narration);

/// The pseudo-code with each branch of at least two lines that was not taken as one row, unless
/// its first line is in `unfolded`. A branch is what stands deeper below a line; with that line
/// where it was not reached either, as `else` or a procedure. Without any line that was run
/// nothing is folded.
std::vector<CodeRow> codeRows(const QStringList& code, const std::set<int>& run,
                              const std::set<int>& unfolded = {});

} // namespace app
