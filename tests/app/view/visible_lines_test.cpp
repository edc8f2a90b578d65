// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/usual_algorithm.h"
#include "app/document/legacy.h"
#include "app/view/visible_lines.h"

#include <QTest>

#include <random>

using namespace app;

class VisibleLinesTest : public QObject {
    Q_OBJECT

private slots:
    void aLineCountsOnceWhateverIsLeftOfIt()
    {
        // inside, across (a piece on either side), one end out, outside
        const std::vector<clipping::Segment> lines{
            {{2, 2}, {8, 8}}, {{-5, 5}, {15, 5}}, {{5, 5}, {5, 20}}, {{20, 0}, {20, 9}}};
        QCOMPARE(visible(lines, Keep::Inside), std::size_t(3));
        QCOMPARE(visible(lines, Keep::Outside), std::size_t(3));
        QCOMPARE(visible({lines[0]}, Keep::Outside), std::size_t(0)); // an empty canvas
        QCOMPARE(visible({lines[3]}, Keep::Inside), std::size_t(0));
    }
    void randomLinesCountAsTheyLie()
    {
        std::mt19937 random(2);
        std::uniform_real_distribution<double> place(-10, 20);
        std::vector<clipping::Segment> lines(500);
        std::size_t notWhollyInside = 0;
        const auto inside = [](const Point& p) {
            return p.x >= 0 && p.x <= 10 && p.y >= 0 && p.y <= 10;
        };
        for (auto& line : lines) {
            line = {{place(random), place(random)}, {place(random), place(random)}};
            notWhollyInside += !inside(line.a) || !inside(line.b);
        }
        QCOMPARE(visible(lines, Keep::Outside), notWhollyInside);
    }

private:
    static std::size_t visible(const std::vector<clipping::Segment>& lines, Keep keep)
    {
        Sheet sheet;
        for (const auto& line : lines) {
            sheet.shapes.emplace_back();
            sheet.shapes.back().paths.push_back({line.a, {{line.b}}, false});
        }
        const EditedDocument document(documentOf(sheet));
        Scene scene(document);
        return visibleLines(
            scene.clip(usualAlgorithm().corrected, {{0, 0}, {10, 10}}, Scene::Removed::Kept), keep);
    }
};

QTEST_MAIN(VisibleLinesTest)
#include "visible_lines_test.moc"
