// SPDX-License-Identifier: GPL-3.0-or-later
// The scale of a drawing, its margins and its background in its file.
#include <QTest>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_svg_scale_text_test {

namespace {

using app::Unit;

app::Page read(const QByteArray& attributes)
{
    const auto result = readText(
        drawing("<metadata xmlns:c='urn:clearcut:1'><c:page " + attributes + "/></metadata>"));
    return result ? result.value->document.page() : app::Page{};
}

QString report(const QByteArray& attributes)
{
    return reportOf("<metadata xmlns:c='urn:clearcut:1'><c:page " + attributes + "/></metadata>");
}

} // namespace

class ScaleTextTest : public QObject {
    Q_OBJECT

private slots:
    void aScaleIsWrittenAndReadBack()
    {
        app::Page page{{0, 0}, {14850, 10500}, {297, Unit::Mm}, {210, Unit::Mm}};
        page.scale = {50, Unit::Metre};
        page.margins = {20, 10, 10, 10, true};
        page.background = {{0xf4, 0xec, 0xd8, 0x80}, true};
        app::Document document;
        document.apply({.page = page});
        const QByteArray text = textOf(document);
        QVERIFY(text.contains("<clearcut:page scale=\"50\" unit=\"m\" margins=\"20 10 10 10\" "
                              "show-margins=\"yes\" background=\"#f4ecd880\" "
                              "export-background=\"yes\"/>"));
        QVERIFY(text.contains("width=\"297mm\"") && text.contains("viewBox=\"0 0 14850 10500\""));
        const auto back = readText(text);
        QVERIFY(back.value && back.value->document.page() == page);
        QVERIFY(back.value->report.empty());
    }
    void theUsualOneIsNotWritten()
    {
        QVERIFY(!textOf(app::Document()).contains("clearcut:page"));
        QCOMPARE(read("").scale, app::DrawingScale{});
        QCOMPARE(read("").margins, app::PaperMargins{});
        QCOMPARE(read("").background, app::PageBackground{});
        QVERIFY(report("").isEmpty());
    }
    void badNumbersAreReportedAndNotTaken_data()
    {
        QTest::addColumn<QByteArray>("attributes");
        for (const char* scale : {"0", "-50", "nan", "1e30", "inf", "fifty", ""})
            QTest::addRow("scale %s", scale) << "scale='" + QByteArray(scale) + "'";
        for (const char* unit : {"", "%", "ells", "mm2"})
            QTest::addRow("unit %s", unit) << "unit='" + QByteArray(unit) + "'";
        for (const char* margins : {"", "1", "1 2 3", "1 2 3 4 5", "1 2 3 -4", "1 2 3 nan"})
            QTest::addRow("margins %s", margins) << "margins='" + QByteArray(margins) + "'";
        for (const char* colour : {"", "#12", "paper", "currentColor", "none"})
            QTest::addRow("background %s", colour) << "background='" + QByteArray(colour) + "'";
    }
    void badNumbersAreReportedAndNotTaken()
    {
        QFETCH(const QByteArray, attributes);
        QCOMPARE(read(attributes).scale, app::DrawingScale{});
        QCOMPARE(read(attributes).margins, app::PaperMargins{});
        QCOMPARE(read(attributes).background, app::PageBackground{});
        QVERIFY(report(attributes).contains("scale, unit, margins or background of the page"));
    }
    /// Other programs know no metres: they would not find the size of the page.
    void lengthsOfSvgHaveItsOwnUnits()
    {
        const auto lost =
            readText("<svg xmlns='http://www.w3.org/2000/svg' width='1m' height='1ft' "
                     "viewBox='0 0 10 10'/>");
        QVERIFY(lost && lost.value->document.page().width.unit != Unit::Metre);
        QVERIFY(lost.value->document.page().height.unit != Unit::Foot);
    }
};

} // namespace formats_svg_scale_text_test

TEST_CLASS(formats_svg_scale_text_test::ScaleTextTest, Core)
#include "tests/app/formats/svg/scale_text_test.moc"
