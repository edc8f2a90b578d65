// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/figure_text.h"
#include "app/teaching/microscope.h"

#include <QTest>

#include "tests/test_class.h"

namespace teaching_figure_text_test {

class FigureTextTest : public QObject {
    Q_OBJECT

private slots:
    void saysWindowLineAndStep()
    {
        app::Microscope microscope;
        microscope.open(line_, 2);
        QCOMPARE(textOf(microscope),
                 QStringLiteral("The clip window is a rectangle from (−100, −75) to (100, 75). The "
                                "line runs from End 1 at (−160, −30) to End 2 at (70, 130). %1")
                     .arg(microscope.narrated()->sentence));
    }
    void saysNothingOfCoveredSteps()
    {
        app::Microscope microscope;
        microscope.openCovered(line_, 0);
        QVERIFY(textOf(microscope).endsWith("End 2 at (70, 130)."));
    }
    void countsTheCornersOfAPolygon()
    {
        app::TracedLine polygon = line_;
        polygon.corners = {{0, 0}, {10, 0}, {0, 10}};
        QVERIFY(app::figureText(polygon, {}, 0).contains("a polygon with 3 corners"));
    }

private:
    static QString textOf(const app::Microscope& microscope)
    {
        return app::figureText(microscope.tracedLine(), microscope.narration(), microscope.step());
    }
    app::TracedLine line_{{clipping::findAlgorithm("cohen-sutherland")},
                          {{-160, -30}, {70, 130}},
                          {{-100, -75}, {100, 75}}};
};

} // namespace teaching_figure_text_test

TEST_CLASS(teaching_figure_text_test::FigureTextTest, None)
#include "tests/app/teaching/figure_text_test.moc"
