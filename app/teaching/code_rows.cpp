// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/code_rows.h"

#include "app/base/text.h"

#include <algorithm>

namespace app {
namespace {

qsizetype indentOf(const QString& line)
{
    const auto text = std::ranges::find_if(line, [](QChar c) { return c != u' '; });
    return text - line.begin();
}

class Folding {
public:
    Folding(const QStringList& code, const std::set<int>& run) : code_(code), run_(run) {}

    /// The last line of what stands deeper below a line; the line itself if nothing does.
    int lastBelow(int line) const
    {
        int last = line;
        while (last < code_.size() && indentOf(code_[last]) > indentOf(code_[line - 1]))
            ++last;
        return last;
    }
    bool isRun(int first, int last) const
    {
        const auto found = run_.lower_bound(first);
        return found != run_.end() && *found <= last;
    }
    /// The last line of the branch that begins there and was not taken; 0: none begins there.
    int branch(int line) const
    {
        const int above = line - 1; // a test that was made, and failed
        if (above > 0 && isRun(above, above) && lastBelow(above) > line
            && !isRun(line, lastBelow(above)))
            return lastBelow(above);
        const int below = lastBelow(line);
        return below > line && !isRun(line, below) ? below : 0;
    }

private:
    const QStringList& code_;
    const std::set<int>& run_;
};

} // namespace

std::set<int> linesRun(const Narration& narration)
{
    std::set<int> lines;
    for (const NarratedStep& step : narration.steps)
        lines.insert(step.line);
    lines.erase(0);
    return lines;
}

std::vector<CodeRow> codeRows(const QStringList& code, const std::set<int>& run,
                              const std::set<int>& unfolded)
{
    const Folding folding(code, run);
    std::vector<CodeRow> rows;
    int shown = 0; // up to this line a branch is unfolded, with all in it
    for (int line = 1; line <= code.size(); ++line) {
        const QString& text = code[line - 1];
        const int last = run.empty() || line <= shown ? 0 : folding.branch(line);
        if (last == 0 || unfolded.contains(line)) {
            rows.push_back({line, line, text, last > 0});
            shown = std::max(shown, last);
            continue;
        }
        const bool withHead = folding.lastBelow(line) == last;
        const QString indent = text.left(indentOf(text));
        rows.push_back(
            {line, last,
             indent
                 + (withHead ? Text::tr("%1 …", "a branch that was not taken").arg(text.trimmed())
                             : Text::tr("not the case")),
             true});
        line = last;
    }
    return rows;
}

} // namespace app
