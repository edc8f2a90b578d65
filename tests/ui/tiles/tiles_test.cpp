// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/contents.h"
#include "app/session/window_steps.h"
#include "ui/bars/status_bar.h"
#include "ui/tiles/sheets_section.h"
#include "ui/tiles/tiles_page.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/message_strip.h"
#include "ui/widgets/refusal_frame.h"
#include "ui/widgets/segments.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QSpinBox>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace tiles_tiles_test {

using namespace ui;

namespace {

/// The editor with a poster of 540 × 540 mm, and its sheets.
class Stage : public TestWindow {
public:
    explicit Stage(const QByteArray& more = {})
    {
        open(file("rosette.svg",
                  "<svg xmlns='http://www.w3.org/2000/svg' width='540mm' height='540mm' "
                  "viewBox='0 0 540 540'><circle cx='270' cy='270' r='240' fill='#dbe8ff' "
                  "stroke='#204080' stroke-width='3'/><path d='M0 0L540 540M540 0L0 540' "
                  "stroke='#000' fill='none'/>"
                      + more + "</svg>"));
        show();
        before = window->session().now();
    }
    void openTiles()
    {
        QTest::keyClick(drawingArea(), Qt::Key_T, Qt::ControlModifier);
        QVERIFY(sheets().isOpen());
        QVERIFY(page().isVisible());
    }
    app::LiveSheets& sheets() { return window->sheets(); }
    TilesPage& page() { return *window->tilesPage(); }
    const app::Tiling& tiling() { return *sheets().tiling().value; }
    template <class Widget = QWidget>
    Widget& part(const char* name)
    {
        auto* found = page().findChild<Widget*>(name);
        if (!found)
            qFatal("there is no %s", name);
        return *found;
    }
    void type(const char* field, const QString& text, Qt::Key end = Qt::Key_Return)
    {
        QWidget& widget = part(field);
        widget.setFocus();
        QTest::keyClick(&widget, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(&widget, text);
        QTest::keyClick(&widget, end);
    }
    void pick(const char* segments, const QString& choice)
    {
        for (auto* button : part(segments).findChildren<QToolButton*>())
            if (button->text() == choice || button->toolTip() == choice)
                return QTest::mouseClick(button, Qt::LeftButton);
        qFatal("no choice %s", qPrintable(choice));
    }
    QString exportText() { return part<QPushButton>("export-sheets").text(); }
    void exportNow()
    {
        QTest::mouseClick(&part("export-sheets"), Qt::LeftButton);
        window->files().wait();
    }
    QStringList written(const QString& pattern) const
    {
        return QDir(folder.path()).entryList({pattern}, QDir::Files, QDir::Name);
    }
    bool isUnchanged()
    {
        return window->session().history.isClean() && window->session().history.count() == 0
               && sameAddress(before, window->session().now());
    }

    app::Document before;
};

} // namespace

class TilesTest : public QObject {
    Q_OBJECT

private slots:
    void aDoubleClickShowsAllSheets()
    {
        Stage t;
        t.openTiles();
        TilesView& view = t.page().view();
        const QPointF first = view.middleOf(0), last = view.middleOf(5);
        view.zoomBy(2);
        QVERIFY(view.middleOf(0) != first);
        QTest::mouseDClick(&view, Qt::LeftButton, {}, {2, 2});
        QCOMPARE(view.middleOf(0), first);
        QCOMPARE(view.middleOf(5), last);
    }
    void theyOpenAndEscCloses()
    {
        Stage t;
        t.openTiles();
        QCOMPARE(t.window->status().visibility(), "6 sheets, A4 portrait");
        QVERIFY(!t.window->canvas().isVisible());
        QVERIFY(t.page().view().hasFocus());
        QTest::keyClick(&t.page().view(), Qt::Key_Escape);
        QVERIFY(!t.sheets().isOpen());
        QVERIFY(t.window->canvas().isVisible());
        QTRY_COMPARE(t.window->focusWidget(), t.drawingArea());
        QVERIFY(t.isUnchanged());
        t.openTiles();
        QTest::mouseClick(&t.part("close-sheet"), Qt::LeftButton);
        QVERIFY(!t.sheets().isOpen());
    }

    void numbersChangeTheSheetsAtOnce()
    {
        Stage t;
        t.openTiles();
        QCOMPARE(t.exportText(), "Export 6 sheets…");
        t.type("sheets-overlap", "60 mm"); // 130 mm steps: (540 − 60) / 130
        QCOMPARE(t.tiling().columns, 4);
        QCOMPARE(t.exportText(), "Export 12 sheets…");
        QVERIFY(t.page().view().hasFocus()); // Enter returns there
        QCOMPARE(t.part<QSpinBox>("sheets-columns").value(), 4);
        QVERIFY(!t.part("sheets-columns").isEnabled());
        t.part<QComboBox>("sheets-paper").setCurrentText("A3");
        QCOMPARE(t.tiling().columns, 3); // 277 mm
        t.pick("sheets-orientation", "Landscape");
        QCOMPARE(t.tiling().rows, 3);
        QCOMPARE(t.tiling().columns, 2);
        QCOMPARE(t.window->status().visibility(), "6 sheets, A3 landscape");
        QTest::keyClick(&t.part("sheets-scale"), Qt::Key_Up);
        QCOMPARE(t.sheets().settings().plan.scale, 1.1);
        t.type("sheets-scale", "50");
        QCOMPARE(t.exportText(), "Export 1 sheet…"); // 270 × 270 mm
        QVERIFY(t.isUnchanged());
    }

    // 16 m in both directions are more sheets than a drawing may have.
    void aDrawingThatIsTooLargeWaitsForOtherNumbers()
    {
        Stage t;
        t.open(t.file("field.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='16000mm' "
                                   "height='16000mm' viewBox='0 0 16 16'><path d='M0 0L16 16' "
                                   "stroke='#000'/></svg>"));
        QTest::keyClick(t.drawingArea(), Qt::Key_T, Qt::ControlModifier);
        QVERIFY(!t.sheets().tiling());
        QVERIFY(!t.part("export-sheets").isEnabled());
        t.type("sheets-scale", "10");
        QVERIFY(t.sheets().tiling());
        QVERIFY(t.part("export-sheets").isEnabled());
    }

    void byNumberEverySheetIsAsLargeAsNeeded()
    {
        Stage t;
        t.openTiles();
        t.pick("sheets-by", "Number");
        QVERIFY(!t.part("sheets-paper").isEnabled());
        t.type("sheets-columns", "4");
        QCOMPARE(t.tiling().columns, 4);
        QCOMPARE(t.tiling().rows, 2);
        QCOMPARE(t.tiling().sheet, app::Point(570 / 4.0 + 20, 275 + 20));
    }

    // By number, the columns are those of the page; the sheet says what is added to them.
    void sheetsBeyondThePageAreSaid()
    {
        Stage t("<path d='M-30 20H50V700' stroke='#000' fill='none'/>");
        t.openTiles();
        auto& remark = t.part<QLabel>("sheets-remark");
        QCOMPARE(remark.text(), "Beyond the page: 1 column on the left, 1 row below.");
        QCOMPARE(t.tiling().columns, 4);
        QCOMPARE(t.exportText(), "Export 11 sheets…"); // of 4 × 3
        t.type("sheets-overlap", "190mm");
        QVERIFY(remark.text().startsWith("Overlap must be less"));
        t.type("sheets-overlap", "12");
        QCOMPARE(remark.text(), "Beyond the page: 1 column on the left, 1 row below.");
        t.pick("sheets-by", "Number");
        QCOMPARE(t.part<QSpinBox>("sheets-columns").value(), 3);
        QCOMPARE(t.tiling().columns, 4);
        TilesView& view = t.page().view();
        QTest::mouseClick(&view, Qt::LeftButton, {}, view.middleOf(1).toPoint());
        QVERIFY(t.tiling().tiles[1].leftOut);
        QVERIFY(t.sheets().settings().plan.beyond.left == 1);
    }

    // The old value stays, its field has a red border, and a sentence says why.
    void aRefusedValueIsExplained()
    {
        Stage t;
        t.openTiles();
        t.type("sheets-overlap", "190mm");
        auto& section = t.page().sheetsSection();
        QCOMPARE(section.refusal(), "Overlap must be less than 190\u00a0mm, the width of a sheet.");
        auto& field = t.part<LengthField>("sheets-overlap");
        QCOMPARE(field.text(), "10.00 mm");
        auto* frame = field.findChild<RefusalFrame*>();
        QVERIFY(frame && frame->isVisible());
        QCOMPARE(t.tiling().columns, 3);
        t.type("sheets-overlap", "12");
        QVERIFY(section.refusal().isEmpty());
        QVERIFY(frame->isHidden());
        t.type("sheets-margin", "2");
        QCOMPARE(section.refusal(), "Marks need a margin of at least 5\u00a0mm on each sheet.");
        t.type("sheets-margin", "abc");
        QVERIFY2(section.refusal().contains("abc"), qPrintable(section.refusal()));
        QCOMPARE(t.sheets().settings().plan.margin, 10.0);
    }

    void marksAreChosenOneByOne()
    {
        Stage t;
        t.openTiles();
        for (const char* box : {"registration-marks", "sheet-labels", "crop-lines"})
            QTest::mouseClick(&t.part<QCheckBox>(box), Qt::LeftButton, {}, {8, 8});
        QVERIFY(!t.sheets().settings().plan.marks.any());
        t.type("sheets-margin", "0");
        QTest::mouseClick(&t.part<QCheckBox>("crop-lines"), Qt::LeftButton, {}, {8, 8});
        QVERIFY(!t.part<QCheckBox>("crop-lines").isChecked());
        QVERIFY(t.page().sheetsSection().refusal().startsWith("Marks need a margin"));
    }

    void aFileForEachSheetIsWritten()
    {
        Stage t;
        t.openTiles();
        QCOMPARE(t.part<ElidedLabel>("sheets-files").whole(), "rosette-1-1.svg … rosette-2-3.svg");
        t.answers->directory = t.folder.path();
        t.exportNow();
        QCOMPARE(t.window->message(), "Exported 6 sheets: rosette-1-1.svg … rosette-2-3.svg");
        const QStringList names = t.written("rosette-*.svg");
        QCOMPARE(names.size(), 6);
        for (const QString& name : names) {
            const QString png = t.path("seen.png");
            QCOMPARE(runProgram("rsvg-convert", {"-o", png, t.folder.filePath(name)}).code, 0);
            QCOMPARE(QImage(png).size(), QSize(794, 1123)); // A4 at 96 dpi
        }
        QVERIFY(t.sheets().isOpen());
        QVERIFY(t.isUnchanged());
    }

    void existingFilesAreAskedAboutOnce()
    {
        Stage t;
        t.openTiles();
        t.answers->directory = t.folder.path();
        t.file("rosette-1-2.svg", "mine");
        t.file("rosette-2-2.svg", "mine");
        t.exportNow();
        QCOMPARE(t.answers->askedAboutFiles, 1);
        QCOMPARE(t.answers->existing.size(), 2);
        QCOMPARE(t.written("rosette-*.svg").size(), 2);
        QCOMPARE(contentOf(t.path("rosette-1-2.svg")), "mine");
        t.answers->overwrite = true;
        t.exportNow();
        QCOMPARE(t.written("rosette-*.svg").size(), 6);
        QVERIFY(contentOf(t.path("rosette-1-2.svg")).contains("<svg"));
    }

    void onePdfHasAPageForEachSheet()
    {
        Stage t;
        t.openTiles();
        QTest::mouseClick(&t.part<QRadioButton>("one-pdf"), Qt::LeftButton, {}, {8, 8});
        QTest::mouseClick(&t.part<QCheckBox>("overview-sheet"), Qt::LeftButton, {}, {8, 8});
        QCOMPARE(t.part<QLineEdit>("sheets-name").text(), "rosette.pdf");
        t.answers->save = t.path("all.pdf");
        t.exportNow();
        QVERIFY(t.answers->proposed.endsWith("/rosette.pdf"));
        const auto info = runProgram("pdfinfo", {t.path("all.pdf")});
        QVERIFY2(info.out.contains("Pages:           7"), info.out.constData());
        QVERIFY2(info.out.contains("A4"), info.out.constData());
    }

    void namesAreTypedAndChecked()
    {
        Stage t;
        t.openTiles();
        auto& name = t.part<QLineEdit>("sheets-name");
        name.setFocus();
        name.selectAll();
        QTest::keyClicks(&name, "part{n}");
        QCOMPARE(t.part<ElidedLabel>("sheets-files").whole(), "part1.svg … part6.svg"); // at once
        QTest::keyClick(&name, Qt::Key_Return);
        QCOMPARE(name.text(), "part{n}.svg");
        name.setFocus();
        t.type("sheets-name", "same.svg");
        QCOMPARE(name.text(), "part{n}.svg"); // the old one
        QVERIFY(name.findChild<RefusalFrame*>()->isVisible());
        QVERIFY(t.part<ElidedLabel>("sheets-files").whole().startsWith("Each sheet needs"));
        t.pick("sheets-format", "PNG");
        QCOMPARE(name.text(), "part{n}.png");
        QVERIFY(name.findChild<RefusalFrame*>()->isHidden());
        name.setFocus();
        name.selectAll();
        QTest::keyClicks(&name, "row{n}");
        QCOMPARE(name.text(), "row{n}"); // untouched while it is typed
        t.pick("sheets-format", "SVG");
        QCOMPARE(name.text(), "row{n}");
        t.part("sheets-margin").setFocus();
        QCOMPARE(name.text(), "row{n}.svg");
    }

    void aClickLeavesASheetOut()
    {
        Stage t;
        t.openTiles();
        TilesView& view = t.page().view();
        QTest::mouseClick(&view, Qt::LeftButton, {}, view.middleOf(1).toPoint());
        QCOMPARE(t.exportText(), "Export 5 sheets…");
        t.answers->directory = t.folder.path();
        t.exportNow();
        QVERIFY(!t.written("rosette-*.svg").contains("rosette-1-2.svg"));
        QCOMPARE(t.written("rosette-*.svg").size(), 5);
        QTest::mouseClick(&view, Qt::LeftButton, {}, view.middleOf(1).toPoint());
        QCOMPARE(t.exportText(), "Export 6 sheets…");
    }

    void emptySheetsAreLeftOutUnlessTheyAreWanted()
    {
        Stage t;
        app::addWindow(t.window->session(), {.shape = app::RectangleShape{{{5, 5}, {60, 60}}}});
        t.openTiles();
        t.sheets().wait();
        QCOMPARE(t.exportText(), "Export 1 sheet…");
        auto& empty = t.part<QCheckBox>("leave-out-empty-sheets");
        QVERIFY(empty.isChecked());
        QCOMPARE(empty.toolTip(), "5 empty sheets were left out.");
        QSignalSpy hints(&t.page(), &TilesPage::hinted);
        TilesView& view = t.page().view();
        QTest::mouseClick(&view, Qt::LeftButton, {}, view.middleOf(1).toPoint());
        QCOMPARE(t.exportText(), "Export 1 sheet…");
        QVERIFY(hints.last()[0].toString().startsWith("Sheet 1-2 is empty."));
        t.answers->directory = t.folder.path();
        t.exportNow();
        QCOMPARE(t.window->message(),
                 "Exported 1 sheet: rosette-1-1.svg. 5 empty sheets were left out.");
        QTest::mouseClick(&empty, Qt::LeftButton, {}, {8, 8});
        QVERIFY(!empty.isChecked());
        QCOMPARE(t.exportText(), "Export 6 sheets…");
    }

    void theButtonThatExportsIsSeenHoweverLowTheWindowIs()
    {
        Stage t;
        t.openTiles();
        t.window->resize(1280, 640);
        QCoreApplication::processEvents();
        QWidget& button = t.part("export-sheets");
        QCOMPARE(button.visibleRegion().boundingRect(), button.rect());
    }

    // Nothing moves under the pointer.
    void aMessageLiesOverTheSheets()
    {
        Stage t;
        t.openTiles();
        const auto placeOf = [&](QWidget& widget) {
            return QRect(widget.mapTo(t.window.get(), QPoint()), widget.size());
        };
        const QRect button = placeOf(t.part("export-sheets")), sheets = placeOf(t.page().view());
        t.window->tell({Message::Kind::Done, "Exported 6 sheets"});
        QCoreApplication::processEvents();
        QCOMPARE(placeOf(t.part("export-sheets")), button);
        QCOMPARE(placeOf(t.page().view()), sheets);
        auto* strip = t.window->findChild<MessageStrip*>();
        QVERIFY(strip->isVisible());
        QVERIFY(sheets.contains(placeOf(*strip)));
    }

    void aDraggedEdgeMovesTheCuts()
    {
        Stage t;
        t.openTiles();
        t.pick("tiles-arrangement", "In place");
        TilesView& view = t.page().view();
        const double part = 190, millimetre = 180 / (view.middleOf(1).x() - view.middleOf(0).x());
        const QPoint edge = (view.middleOf(0) + QPointF(part / 2 / millimetre, 0)).toPoint();
        const double before = t.tiling().tiles[1].window.min.x;
        QTest::mousePress(&view, Qt::LeftButton, {}, edge);
        QTest::mouseMove(&view, edge - QPoint(30, 0));
        QTest::mouseRelease(&view, Qt::LeftButton, {}, edge - QPoint(30, 0));
        const double moved = before - t.tiling().tiles[1].window.min.x;
        QVERIFY2(std::abs(moved - 30 * millimetre) < 1e-6, qPrintable(QString::number(moved)));
        QVERIFY(t.tiling().tiles.front().window.min.x < 0);
        QVERIFY(t.isUnchanged());
    }

    void theCursorTellsWhatADragDoes()
    {
        Stage t;
        t.openTiles();
        t.pick("tiles-arrangement", "In place");
        TilesView& view = t.page().view();
        const QPointF across = view.middleOf(1) - view.middleOf(0);
        const QPointF down = view.middleOf(3) - view.middleOf(0); // three columns
        const auto at = [&](const QPointF& place) {
            QTest::mouseMove(&view, place.toPoint());
            return view.cursor().shape();
        };
        QCOMPARE(at(view.middleOf(0)), Qt::PointingHandCursor); // leaves the sheet out
        QCOMPARE(at(view.middleOf(0) + across / 180 * 95), Qt::SplitHCursor); // half of 190 mm
        QCOMPARE(at(view.middleOf(0) + down / 267 * 138.5), Qt::SplitVCursor);
        QCOMPARE(at({2, 2}), Qt::OpenHandCursor);
        QTest::mousePress(&view, Qt::MiddleButton, {}, {2, 2});
        QTest::mouseMove(&view, QPoint(30, 30));
        QCOMPARE(view.cursor().shape(), Qt::ClosedHandCursor);
        QTest::mouseRelease(&view, Qt::MiddleButton, {}, {30, 30});
        QVERIFY(view.cursor().shape() != Qt::ClosedHandCursor);
    }

    // What is seen on a sheet is what a file of it shows.
    void theSheetsAreShownAsTheyAreExported()
    {
        Stage t;
        t.openTiles();
        TilesView& view = t.page().view();
        for (const char* box : {"registration-marks", "sheet-labels", "crop-lines"})
            QTest::mouseClick(&t.part<QCheckBox>(box), Qt::LeftButton, {}, {8, 8});
        view.settle();
        t.answers->directory = t.folder.path();
        t.exportNow();
        for (const auto& [sheet, drawn, image] : view.art().pictures()) {
            const app::Tile& tile = t.tiling().tiles[sheet];
            const QString svg = t.folder.filePath(
                QStringLiteral("rosette-%1-%2.svg").arg(tile.row).arg(tile.column));
            const QString png = t.path("seen.png");
            QCOMPARE(
                runProgram("rsvg-convert", {"-b", "white", "-w", QString::number(image.width()),
                                            "-h", QString::number(image.height()), "-o", png, svg})
                    .code,
                0);
            QImage ours(image.size(), QImage::Format_RGB32);
            ours.fill(Qt::white);
            QPainter(&ours).drawImage(0, 0, image);
            const QImage seen = QImage(png).convertToFormat(QImage::Format_RGB32);
            double sum = 0;
            for (int y = 0; y < ours.height(); ++y)
                for (int x = 0; x < ours.width(); ++x)
                    sum += std::abs(qGray(ours.pixel(x, y)) - qGray(seen.pixel(x, y)));
            const double apart = sum / ours.width() / ours.height();
            QVERIFY2(apart < 4, qPrintable(QStringLiteral("%1: %2").arg(sheet).arg(apart)));
        }
        QCOMPARE(view.art().pictures().size(), 6u);
    }

    // The microscope and presenting close them; the menu Edit works on the drawing below.
    void otherModes()
    {
        Stage t;
        t.openTiles();
        QTest::keyClick(&t.page().view(), Qt::Key_F2);
        QVERIFY(!t.sheets().isOpen());
        QVERIFY(t.window->session().microscope.isOpen());
        QTest::keyClick(t.window.get(), Qt::Key_T, Qt::ControlModifier);
        QVERIFY(t.sheets().isOpen());
        QVERIFY(!t.window->session().microscope.isOpen());
        t.window->togglePresenting();
        QVERIFY(!t.sheets().isOpen());
        QVERIFY(!t.action("tiles")->isEnabled());
        t.window->togglePresenting();
        QVERIFY(t.action("tiles")->isEnabled());
    }

    void aDrawingWithWindowsIsCutFirst()
    {
        Stage t("<metadata xmlns:clearcut='urn:clearcut:1'><clearcut:window xmin='0' ymin='0' "
                "xmax='100' ymax='100'/></metadata>");
        t.openTiles();
        t.answers->directory = t.folder.path();
        t.exportNow();
        QCOMPARE(app::contentsOf(t.sheets().drawing()).bounds.value().max, app::Point(100, 100));
        QCOMPARE(t.written("rosette-*.svg").size(), 1); // the others are empty
        QVERIFY(t.isUnchanged());
    }
};

} // namespace tiles_tiles_test

TEST_CLASS(tiles_tiles_test::TilesTest, Widgets)
#include "tests/ui/tiles/tiles_test.moc"
