// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document.h"
#include "app/session/last_page.h"

#include <QTest>

#include "tests/test_class.h"

namespace session_last_page_test {

using app::Page;
using app::Unit;

class LastPageTest : public QObject {
    Q_OBJECT

private slots:
    void aPageIsReadBack()
    {
        Page page{{0, 0}, {14850, 10500}, {297, Unit::Mm}, {210, Unit::Mm}};
        page.scale = {50, Unit::Metre};
        page.margins = {20, 10, 10.5, 10, true};
        QCOMPARE(app::pageText(page), "297 210 scale=50 unit=m margins=20,10,10.5,10 shown");
        QCOMPARE(app::pageFromText(app::pageText(page)), page);
        page.background = {{1, 2, 3, 0}, true};
        QVERIFY(app::pageText(page).endsWith("shown background=#01020300 exported"));
        QCOMPARE(app::pageFromText(app::pageText(page)), page);
    }
    void thePaperOfAnyDrawingIsThatOfANewOne()
    {
        Page inches{{-5, 7}, {816, 1056}, {8.5, Unit::Inch}, {11, Unit::Inch}};
        const Page page = app::pageFromText(app::pageText(inches));
        QCOMPARE(page.min, app::Point(0, 0));
        QVERIFY(std::abs(page.size.x - 215.9) < 1e-9);
        QCOMPARE(page.usualUnit(), Unit::Inch);
        QCOMPARE(page.realMillimetresPerUnit(), 1.0);
    }
    void damagedSettingsGiveTheUsualPage_data()
    {
        QTest::addColumn<QString>("text");
        for (const char* text :
             {"", "A3", "0 297", "-1 297", "nan 297", "1e9 297", "420", "420 297 scale=0",
              "420 297 scale=nan", "420 297 scale=1e30", "420 297 unit=%", "420 297 unit=ell",
              "420 297 margins=1,2,3", "420 297 margins=1,2,3,x", "420 297 margins=400,0,400,0",
              "420 297 background=paper", "420 297 tilted"})
            QTest::newRow(text) << QString(text);
    }
    void damagedSettingsGiveTheUsualPage()
    {
        QFETCH(const QString, text);
        QCOMPARE(app::pageFromText(text), app::newDrawing().page());
    }
};

} // namespace session_last_page_test

TEST_CLASS(session_last_page_test::LastPageTest, Core)
#include "tests/app/session/last_page_test.moc"
