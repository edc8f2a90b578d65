// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/paper.h"

#include <QTest>

#include "tests/not_empty.h"
#include "tests/test_class.h"

namespace document_paper_test {

using app::Page;
using app::Unit;

class PaperTest : public QObject {
    Q_OBJECT

private slots:
    void aPageHasTheNameOfItsPaper()
    {
        for (const app::NamedPaper& paper : notEmpty(app::namedPapers())) {
            const double x = paper.millimetres.x, y = paper.millimetres.y;
            QVERIFY(x < y);
            QCOMPARE(app::paperNamed(paper.name), &paper);
            const Page inches{{0, 0}, {y, x}, {y / 25.4, Unit::Inch}, {x / 25.4, Unit::Inch}};
            QCOMPARE(app::namedPaperOf({{0, 0}, {x, y}, {x, Unit::Mm}, {y, Unit::Mm}}), &paper);
            QCOMPARE(app::namedPaperOf(inches), &paper);
        }
        QCOMPARE(app::namedPaperOf({{0, 0}, {210, 298}, {210, Unit::Mm}, {298, Unit::Mm}}),
                 nullptr);
        QCOMPARE(app::paperNamed("A11"), nullptr);
    }
    void aScaleMultipliesTheRealSizeOfAUnit()
    {
        Page page{{0, 0}, {14850, 10500}, {297, Unit::Mm}, {210, Unit::Mm}};
        QCOMPARE(page.realMillimetresPerUnit(), page.millimetresPerUnit());
        page.scale.ratio = 50;
        QCOMPARE(page.millimetresPerUnit(), 0.02);
        QVERIFY(page.realMillimetresPerUnit() == 1); // exactly
        page.width = page.height = {100, Unit::Percent};
        QCOMPARE(page.realMillimetresPerUnit(), 50 * 25.4 / 96);
    }
    void lengthsOnPaperAreInSmallUnits()
    {
        Page page;
        QCOMPARE(page.paperUnit(Unit::Metre), Unit::Mm);
        QCOMPARE(page.paperUnit(Unit::Foot), Unit::Inch);
        QCOMPARE(page.paperUnit(Unit::Cm), Unit::Cm);
        page.scale.ratio = 50;
        QCOMPARE(page.paperUnit(Unit::Cm), Unit::Mm);
        QCOMPARE(page.paperUnit(Unit::Inch), Unit::Inch);
    }
    void theUnitOfTheScaleGoesBeforeThatOfTheWidth()
    {
        Page page;
        QCOMPARE(page.usualUnit(), Unit::Mm);
        page.scale.unit = Unit::Metre;
        QCOMPARE(page.usualUnit(), Unit::Metre);
    }
};

} // namespace document_paper_test

TEST_CLASS(document_paper_test::PaperTest, Core)
#include "tests/app/document/paper_test.moc"
