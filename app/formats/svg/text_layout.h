// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/path_walk.h"
#include "app/formats/svg/text_content.h"
#include "app/formats/svg/text_style.h"
#include "app/formats/svg/transform.h"
#include "app/lettering/text_line.h"

#include <memory>

namespace app::svg {

/// How far below the line with this name the baseline lies: "middle", "hanging".
double depthOfBaseline(std::string_view line, const LineMeasures& measures);

/// Characters with the same style.
struct TextRun {
    LineFont font{};
    TextStyle::Anchor anchor = TextStyle::Anchor::Start;
    bool rightToLeft = false;
    bool vertical = false;                  ///< from top to bottom
    double lowered = 0;                     ///< below the baseline, in user units
    std::shared_ptr<const PathWalk> path{}; ///< along which they stand; null: a straight line
    double startOffset = 0;                 ///< on that path
};

/// Characters that are to be so long: the attribute textLength.
struct TextFit {
    qsizetype first = 0, end = 0;
    double length = 0;
    bool stretches = false; ///< the letters, too, not only the gaps between them
};

/// The place of letters on a line.
struct LetterCell {
    Matrix where{}; ///< from the line to the coordinates of the <text>
    double left = 0, right = 0;
    /// From `top` to `bottom` below the baseline.
    Subpath box(double top, double bottom) const;
};

/// Letters of one run that stand on one straight line, in the coordinates of the <text>.
struct LaidLetters {
    std::vector<Subpath> paths{};
    std::size_t run = 0;
    QString text{}; ///< that makes them again; empty: none does
    Point at{};     ///< the start of their baseline
    double width = 0;
    std::vector<LetterCell> cells{};
};

struct TextParts {
    std::vector<LaidLetters> letters{};
    QStringList missing{};   ///< characters that no font has
    bool leavesPath = false; ///< whether letters lie beyond the ends of their path
    int pictures = 0;        ///< letters without outlines
    int unfitted = 0;        ///< textLength attributes that were passed over
};

/// Lays out all characters. Needs a QGuiApplication.
TextParts laidOut(const TextContent& content, const std::vector<TextRun>& runs,
                  const std::vector<TextFit>& fits, LineFonts& fonts);

} // namespace app::svg
