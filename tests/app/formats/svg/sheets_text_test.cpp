// SPDX-License-Identifier: GPL-3.0-or-later
// How a document is divided among sheets, in its file.
#include <QTest>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_svg_sheets_text_test {

namespace {

QByteArray textOf(const app::PageSheets& sheets)
{
    app::Document document;
    app::Page page;
    page.sheets = sheets;
    document.apply({.page = page});
    return ::textOf(document);
}

QByteArray metadata(const QByteArray& elements)
{
    return "<metadata xmlns:c='urn:clearcut:1'>" + elements + "</metadata>";
}

std::optional<app::PageSheets> read(const QByteArray& text)
{
    const auto result = readText(text);
    return result ? result.value->document.page().sheets : std::nullopt;
}

const app::PageSheets byPaper{"A3",
                              true,
                              false,
                              {.margin = 7.5,
                               .overlap = 12,
                               .marks = {true, false, true},
                               .scale = 1.5,
                               .shift = {3, -4.25},
                               .leftOut = {2, 6}}};

} // namespace

class SheetsTextTest : public QObject {
    Q_OBJECT

private slots:
    void sheetsAreWrittenAndReadBack()
    {
        const QByteArray text = textOf(byPaper);
        QVERIFY2(text.contains("<clearcut:sheets paper=\"A3 landscape\" margin=\"7.5\" "
                               "overlap=\"12\" scale=\"1.5\" shift=\"3 -4.25\" "
                               "marks=\"registration crop\" left-out=\"2 6\"/>"),
                 text);
        QVERIFY(read(text) == byPaper);
        const app::PageSheets byNumber{
            "Letter", false, true, {.columns = 3, .rows = 2, .empty = app::EmptySheets::Written}};
        QVERIFY(textOf(byNumber).contains("columns=\"3\" rows=\"2\""));
        QVERIFY(read(textOf(byNumber)) == byNumber);
        app::PageSheets beyond = byPaper;
        beyond.plan.beyond = {1, 0, 0, 2};
        QVERIFY(textOf(beyond).contains("left-out=\"2 6\" beyond=\"1 0 0 2\""));
        QVERIFY(read(textOf(beyond)) == beyond);
        QVERIFY(!::textOf(app::Document()).contains("sheets"));
        QVERIFY(!read(::textOf(app::Document())));
    }
    void badSheetsAreDroppedAndReported()
    {
        const QByteArray lengths = " margin='1' overlap='2' scale='1'";
        for (const QByteArray& bad :
             {QByteArray(" margin='1' overlap='x' scale='1'"), QByteArray(" margin='1'"),
              " margin='-1' overlap='2' scale='1'" + QByteArray(),
              lengths + " columns='0' rows='2'", lengths + " columns='2'",
              lengths + " columns='2.5' rows='2'", lengths + " shift='1'",
              lengths + " left-out='1,b'", lengths + " left-out='0'", lengths + " beyond='1 0 0'",
              lengths + " beyond='-1 0 0 0'", lengths + " beyond='0.5 0 0 0'",
              lengths + " beyond='1e9 0 0 0'", lengths + " columns='1e9' rows='1'"}) {
            const QByteArray element = metadata("<c:sheets paper='A4'" + bad + "/>");
            QVERIFY2(!read(drawing(element)), bad);
            QVERIFY2(reportOf(element).contains("division among sheets with a missing"), bad);
        }
        QVERIFY(read(drawing(metadata("<c:sheets paper='A4'" + lengths + "/>"))).has_value());
    }
};

} // namespace formats_svg_sheets_text_test

TEST_CLASS(formats_svg_sheets_text_test::SheetsTextTest, None)
#include "tests/app/formats/svg/sheets_text_test.moc"
