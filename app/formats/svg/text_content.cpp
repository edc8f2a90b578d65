// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/text_content.h"

#include "app/formats/svg/scanner.h"

#include <array>
#include <cmath>

namespace app::svg {
namespace {

constexpr std::string_view listSeparators = " \t\r\n\f,";

struct LetterList {
    std::string_view name;
    double LetterPlace::*part;
    int axis;     ///< of the viewport, for percentages
    bool repeats; ///< whether its last number is for all further characters, too
};
constexpr std::array letterLists{
    LetterList{"x", &LetterPlace::x, 0, false},
    LetterList{"y", &LetterPlace::y, 1, false},
    LetterList{"dx", &LetterPlace::dx, 0, false},
    LetterList{"dy", &LetterPlace::dy, 1, false},
    LetterList{"rotate", &LetterPlace::rotate, 0, true},
};

} // namespace

void TextContent::append(const QString& text, std::size_t run, bool keepsBlanks)
{
    for (const QChar each : text) {
        const bool blank = each == u' ' || each == u'\n' || each == u'\t' || each == u'\r';
        const bool joins = blank && !keepsBlanks && (text_.isEmpty() || text_.back() == u' ');
        if (joins)
            continue;
        text_ += blank ? QChar(u' ') : each;
        runs_.push_back(run);
        places_.emplace_back();
        lastIsKept_ = keepsBlanks;
    }
}

void TextContent::trimEnd()
{
    if (!text_.endsWith(u' ') || lastIsKept_)
        return;
    text_.chop(1);
    runs_.pop_back();
    places_.pop_back();
}

void TextContent::place(const Tree& tree, Node node, qsizetype first, const Lengths& lengths,
                        Report& report)
{
    for (const LetterList& list : letterLists) {
        std::string_view rest = tree.attribute(node, list.name);
        double last = notGiven;
        for (qsizetype i = first; i < text_.size(); ++i) {
            if (text_[i].isLowSurrogate())
                continue;
            const auto one = takeWord(rest, listSeparators);
            if (one.empty() && !(list.repeats && !std::isnan(last)))
                break;
            if (!one.empty()) {
                const bool hasUnit =
                    list.repeats && one.find_first_not_of("0123456789.eE+-") != one.npos;
                const auto number =
                    hasUnit ? std::nullopt : lengths.parse(one, lengths.viewport[list.axis]);
                if (!number) {
                    report.add(losses::value, std::string(list.name) + ": " + std::string(one));
                    break;
                }
                last = *number;
            }
            double& part = places_[std::size_t(i)].*list.part;
            part = std::isnan(part) ? last : part;
        }
    }
}

} // namespace app::svg
