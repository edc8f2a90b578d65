// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/live_export.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/test_class.h"

namespace session_live_export_test {

using namespace app;

namespace {

/// A4 with two lines of 100 mm.
Imported twoLines()
{
    DocumentBuilder builder;
    builder.open({.name = "Drawing"});
    for (const double y : {10.0, 50.0})
        builder.add(Object{.path = Path(clipping::Segment{{0, y}, {100, y}}),
                           .style = {.stroke = Colour{}, .width = 0.5}});
    builder.close();
    return {builder.take(Page{{0, 0}, {200, 100}, {200, Unit::Mm}, {100, Unit::Mm}, {}}), {}};
}

} // namespace

class LiveExportTest : public QObject {
    Q_OBJECT

private slots:
    void itFollowsTheDrawingAndTheSelection()
    {
        Session session;
        session.load(twoLines());
        LiveExport live(session);
        QSignalSpy changed(&live, &LiveExport::changed);
        live.change({.format = "pdf", .area = {ExportPart::Selection}});
        QCOMPARE(live.job().choice.area.part, ExportPart::Page); // nothing is selected
        live.wait();
        QCOMPARE(live.made()->facts.paths, std::size_t(2));
        QCOMPARE(live.made()->lines.size(), std::size_t(2));
        QVERIFY(live.bytes().value_or(0) > 100);
        QVERIFY(live.error().isEmpty());
        session.select(ObjectRanges{1});
        QVERIFY(live.making() && !live.bytes());
        live.wait();
        QCOMPARE(live.made()->facts.paths, std::size_t(1));
        QCOMPARE(live.made()->facts.paper, Point(100, 0.5));
        session.document.apply(
            {.windows = ClipWindows{{{.shape = RectangleShape{{{0, 0}, {50, 20}}}}}}});
        live.change({.format = "pdf"});
        live.wait();
        QCOMPARE(live.made()->facts.length, 50.0);
        QVERIFY(changed.size() > 5);
    }
    void whatCannotBeWrittenIsASentence()
    {
        Session session;
        session.load(twoLines());
        LiveExport live(session);
        live.change({.format = "png", .dpi = 1e9});
        live.wait();
        QVERIFY(live.made()); // it is shown, but not written
        QVERIFY2(live.error().startsWith("Nothing can be written: the picture would have"),
                 qPrintable(live.error()));
        QVERIFY(!live.bytes());
        live.change({.format = "png", .dpi = 10});
        live.wait();
        QVERIFY(live.error().isEmpty() && live.bytes());
    }
};

} // namespace session_live_export_test

TEST_CLASS(session_live_export_test::LiveExportTest, Core)
#include "tests/app/session/live_export_test.moc"
