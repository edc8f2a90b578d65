// SPDX-License-Identifier: GPL-3.0-or-later
// The lines that two rows cut differently, beside all pieces of every line.
#include "app/document/document_builder.h"
#include "app/scene/differing_lines.h"
#include "app/scene/scene_clipping.h"
#include "app/scene/scene_lines.h"

#include <QTest>

#include <algorithm>

#include "tests/app/scene/mixed_windows.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace scene_differing_lines_test {

namespace {

using clipping::Segment;

const app::Page page{{0, 0}, {100, 100}, {100, app::Unit::Mm}, {100, app::Unit::Mm}};

/// Lines with both ends anywhere, many of them short or nearly upright.
app::Document mixedLines(MixedWindows& mixed, int count)
{
    app::DocumentBuilder builder;
    builder.open({.name = "Lines"});
    for (int i = 0; i < count; ++i) {
        Segment line = mixed.line();
        if (mixed.whole(0, 1))
            line.b.x = line.a.x + mixed.number(-1, 1);
        if (mixed.whole(0, 3) == 0)
            line.b.y = line.a.y + mixed.number(-3, 3);
        builder.addLine(line, builder.style({.stroke = app::Colour{}}));
    }
    builder.close();
    return builder.take(page);
}

bool isShort(const Segment& s, double tolerance)
{
    return std::max(std::abs(s.a.x - s.b.x), std::abs(s.a.y - s.b.y)) <= tolerance;
}

bool isNear(const Segment& s, const Segment& t, double tolerance)
{
    return isShort({s.a, t.a}, tolerance) && isShort({s.b, t.b}, tolerance);
}

/// What a frame keeps of each line of each block.
std::vector<std::vector<std::vector<Segment>>> keptBy(const app::SceneFrame& frame,
                                                      double tolerance)
{
    std::vector<std::vector<std::vector<Segment>>> kept;
    for (const auto& block : frame.blocks) {
        const auto& segments = block.block->segments;
        auto& lines = kept.emplace_back(segments.size());
        for (std::size_t line = 0; line < segments.size(); ++line)
            if (block.remains[block.block->chunkOf(line)] == app::Remains::Whole)
                lines[line].push_back(segments[line]);
        for (const auto& piece : block.pieces)
            lines[piece.source].push_back(piece.segment);
        for (auto& pieces : lines)
            std::erase_if(pieces, [&](const Segment& s) { return isShort(s, tolerance); });
    }
    return kept;
}

std::vector<app::FrameLine> expected(const app::SceneFrame& a, const app::SceneFrame& b,
                                     double tolerance)
{
    const auto keptA = keptBy(a, tolerance), keptB = keptBy(b, tolerance);
    std::vector<app::FrameLine> differing;
    for (std::size_t at = 0; at < keptA.size(); ++at)
        for (std::size_t line = 0; line < keptA[at].size(); ++line)
            if (!std::ranges::equal(
                    keptA[at][line], keptB[at][line], [&](const Segment& s, const Segment& t) {
                        return isNear(s, t, tolerance) || isNear(s, {t.b, t.a}, tolerance);
                    }))
                differing.push_back({at, line});
    return differing;
}

} // namespace

class DifferingLinesTest : public QObject {
    Q_OBJECT

private slots:
    void theyAreThoseWithOtherPieces()
    {
        constexpr std::size_t all = 1'000'000;
        const char* const rows[]{"kodituwakku-wijeweera-chamikara", "sobkow-pospisil-yang",
                                 "liang-barsky", "midpoint-subdivision"};
        std::size_t found = 0;
        for (unsigned seed = 1; seed <= 40; ++seed) {
            MixedWindows mixed(seed);
            const app::Document document = mixedLines(mixed, mixed.whole(1, 700));
            const app::SceneLines lines = linesOf(document);
            const auto region = regionOf(
                mixed.windows(1 + int(seed) % 3, seed % 2 ? Mixed::Rectangle : Mixed::Any), 0.001);
            app::SceneClipping one, other;
            const app::SceneFrame exact =
                one.clip(lines, region, clipping::exactAlgorithm().corrected.clipAll);
            for (const char* row : rows) {
                const auto* uses =
                    clipping::functionsOf(*clipping::findAlgorithm(row), clipping::Form::Published);
                const app::SceneFrame frame = other.clip(
                    lines, region,
                    uses ? uses->clipAll : clipping::findAlgorithm(row)->corrected.clipAll);
                for (const double tolerance : {0.0, 1e-9, 0.2, 5.0}) {
                    const auto differing = differingLines(frame, exact, tolerance, all);
                    VERIFY_OR_SAY(differing == expected(frame, exact, tolerance),
                                  qPrintable(QString("%1, %2").arg(seed).arg(row)));
                    VERIFY_OR_SAY(differing == differingLines(exact, frame, tolerance, all),
                                  qPrintable(QString("%1, %2").arg(seed).arg(row)));
                    found += differing.size();
                }
                const auto few = differingLines(frame, exact, 0, 3);
                const auto whole = differingLines(frame, exact, 0, all);
                QCOMPARE(few.size(), std::min<std::size_t>(whole.size(), 4));
                QVERIFY(std::ranges::includes(whole, few));
            }
        }
        QVERIFY2(found > 1000, qPrintable(QString::number(found)));
    }
    /// The algorithm that judges differs from itself nowhere.
    void noneOfTheSame()
    {
        MixedWindows mixed(5);
        const app::SceneLines lines = linesOf(mixedLines(mixed, 500));
        const auto region = regionOf(mixed.windows(2, Mixed::Any), 0.001);
        app::SceneClipping one, other;
        const auto clipAll = clipping::exactAlgorithm().corrected.clipAll;
        const app::SceneFrame a = one.clip(lines, region, clipAll),
                              b = other.clip(lines, region, clipAll);
        QVERIFY(differingLines(a, b, 0, 10).empty());
    }
};

} // namespace scene_differing_lines_test

TEST_CLASS(scene_differing_lines_test::DifferingLinesTest, None)
#include "tests/app/scene/differing_lines_test.moc"
