// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/remembered_choice.h"

#include <QTemporaryDir>
#include <QTest>

#include "tests/test_class.h"

namespace export_remembered_choice_test {

using namespace app;

class RememberedChoiceTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void aChoiceIsReadBack()
    {
        const ExportChoice choice{.format = "png",
                                  .area = {.part = ExportPart::Selection},
                                  .paper = ExportPaper::Page,
                                  .dpi = 150.5,
                                  .precision = 3,
                                  .background = Colour{1, 171, 3, 0},
                                  .dxf = DxfVersion::R12,
                                  .plain = true,
                                  .projection = Projection::WebMercator};
        const auto read = choiceOf(textOf(choice));
        QVERIFY2(read == choice, qPrintable(textOf(choice)));
    }
    void garbageIsAsUsual()
    {
        QVERIFY(!choiceOf({}));
        QVERIFY(!choiceOf("gif area=page"));
        QCOMPARE(choiceOf("png dpi=0 precision=99 area=moon background=xyz paper=").value(),
                 ExportChoice{.format = "png"});
        QCOMPARE(choiceOf("png dpi=1e99").value(), ExportChoice{.format = "png"});
        QCOMPARE(choiceOf("png dpi=nan").value(), ExportChoice{.format = "png"});
        QCOMPARE(choiceOf("svg svg=fancy").value(), ExportChoice{});
        QCOMPARE(choiceOf("dxf dxf=r14").value(), ExportChoice{.format = "dxf"});
        QCOMPARE(choiceOf("geojson projection=globe").value(), ExportChoice{.format = "geojson"});
    }
    void eachFormatAndEachDrawingHasItsOwn()
    {
        QSettings settings(folder_.filePath("a"), QSettings::IniFormat);
        QCOMPARE(lastFormat(settings), std::string("svg"));
        const ExportChoice png{.format = "png", .dpi = 96}, pdf{.format = "pdf", .precision = 2};
        remember(settings, {"/a.svg", "/a.png", png});
        remember(settings, {"/b.svg", "/b.pdf", pdf});
        remember(settings, {{}, "/c.pdf", pdf}); // of a drawing that was never saved
        QCOMPARE(lastFormat(settings), std::string("pdf"));
        QCOMPARE(lastChoice(settings, "png"), png);
        QCOMPARE(lastChoice(settings, "csv"), ExportChoice{.format = "csv"});
        QCOMPARE(lastExport(settings, "/a.svg").value().file, QString("/a.png"));
        QCOMPARE(lastExport(settings, "/a.svg").value().choice, png);
        QVERIFY(!lastExport(settings, "/c.svg") && !lastExport(settings, {}));
        remember(settings, {"/a.svg", "/other.pdf", pdf});
        QCOMPARE(lastExport(settings, "/a.svg").value().file, QString("/other.pdf"));
    }
};

} // namespace export_remembered_choice_test

TEST_CLASS(export_remembered_choice_test::RememberedChoiceTest, None)
#include "tests/app/export/remembered_choice_test.moc"
