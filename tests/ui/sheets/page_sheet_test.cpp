// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/paper.h"
#include "ui/bars/option_bar.h"
#include "ui/docks/window_panel.h"
#include "ui/sheets/page_frame.h"
#include "ui/sheets/sheets.h"
#include "ui/widgets/colour_popup.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/sheet.h"

#include <QAbstractButton>
#include <QLabel>
#include <QMouseEvent>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace ui::sheets_page_sheet_test {

/// The sheet of a window with two lines on a page of 100 × 100 mm.
struct Desk : TestWindow {
    Desk()
    {
        show();
        open(twoLines());
        run("page");
    }
    Sheet* sheet() const { return window->sheet(); }
    const app::Page& page() const { return window->session().now().page(); }
    app::Point paper() const { return app::millimetresOf(page()); }
    template <class Part = LengthField>
    Part* part(const char* name) const
    {
        return sheet()->findChild<Part*>(name);
    }
    void type(const char* field, const char* text, Qt::Key end = Qt::Key_Tab) const
    {
        auto* into = part(field);
        into->setFocus();
        into->selectAll();
        QTest::keyClicks(into, text);
        QTest::keyClick(into, end);
    }
    void pick(const char* row, int number) const
    {
        const auto buttons = part<Segments>(row)->findChildren<QAbstractButton*>();
        QTest::mouseClick(buttons[number], Qt::LeftButton);
    }
    /// Near the lower right corner of the page, where nothing is drawn.
    QColor colourOnPage() const
    {
        auto* frame = window->findChild<PageFrame*>("page-frame");
        const QPoint at = (frame->square(1, 1) - QPointF(30, 12)).toPoint();
        return window->canvas().paneSurface(0)->grab().toImage().pixelColor(at);
    }
    QString refusal() const
    {
        for (const auto* label : sheet()->findChildren<QLabel*>("page-refusal"))
            if (label->isVisible())
                return label->text();
        return {};
    }
};

class PageSheetTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void aPaperIsChosen()
    {
        const Desk desk;
        desk.pick("page-iso", 3);
        QCOMPARE(desk.paper(), app::Point(297, 420));
        desk.pick("page-orientation", 1);
        QCOMPARE(desk.paper(), app::Point(420, 297));
        QCOMPARE(desk.part("page-width")->text(), "420.00");
        desk.pick("page-american", 0);
        QCOMPARE(desk.paper(), app::Point(279.4, 215.9));
        desk.pick("page-american", 3); // its own size is typed
        QVERIFY(desk.part("page-width")->hasFocus());
        desk.type("page-width", "10in");
        QVERIFY(std::abs(desk.paper().x - 254) < 1e-9);
        QCOMPARE(desk.window->session().history.count(), 1);
    }
    void aScaleIsTyped()
    {
        const Desk desk;
        desk.type("page-scale", "50");
        QCOMPARE(desk.page().scale.ratio, 50.0);
        QCOMPARE(desk.page().size, app::Point(5000, 5000));
        QCOMPARE(desk.part<Segments>("page-usual-scales")->chosen(), 2);
        desk.pick("page-unit", 0);
        QCOMPARE(desk.window->session().display().unit, app::Unit::Metre);
        QCOMPARE(desk.page().scale.unit, std::optional(app::Unit::Metre));
        QCOMPARE(desk.part("page-width")->text(), "100.00"); // on paper
        const clipping::Window seen = desk.window->canvas().view().visible();
        QVERIFY(seen.max.x >= 5000 && seen.max.y >= 5000); // the whole page is seen
    }
    void fieldsShowRealLengths()
    {
        const Desk desk;
        const auto shown = [&](const QString& name) {
            QWidget* const places[]{&desk.window->windowPanel(), &desk.window->optionBar()};
            for (const QWidget* place : places)
                for (const auto* field : place->findChildren<LengthField*>())
                    if (field->accessibleName() == name)
                        return field->text();
            return QString();
        };
        desk.run("grid");
        QCOMPARE(shown("Width"), "100.00");
        desk.type("page-scale", "50");
        QCOMPARE(shown("Width"), "100.00"); // as it was drawn
        QCOMPARE(shown("Grid spacing"), "500.00 mm");
        desk.pick("page-unit", 0);
        QCOMPARE(shown("Width"), "0.100");
        QCOMPARE(shown("Grid spacing"), "0.500 m");
    }
    void thePaperStaysAsItIsSeenWhenAScaleIsUndone()
    {
        const Desk desk;
        desk.type("page-scale", "50", Qt::Key_Return);
        Canvas& canvas = desk.window->canvas();
        canvas.setZoom(0.5);
        const double corner = canvas.view().toScreen(desk.page().min).x;
        for (const char* command : {"undo", "redo"}) {
            desk.run(command);
            QVERIFY(std::abs(canvas.zoom() - 0.5) < 1e-9);
            QVERIFY(std::abs(canvas.view().toScreen(desk.page().min).x - corner) < 1e-6);
        }
    }
    void theEdgesOfThePageAreDragged()
    {
        const Desk desk;
        auto* frame = desk.window->findChild<PageFrame*>("page-frame");
        QVERIFY(frame && frame->isVisible());
        QCOMPARE(frame->sizeText(0), QStringLiteral("100\u00a0mm"));
        const app::View view = desk.window->canvas().view();
        const auto drag = [&](int across, int down, const app::Point& by) {
            const QPointF from = frame->square(across, down);
            const QPointF to = from + QPointF(by.x, by.y) * view.zoom;
            QTest::mousePress(frame, Qt::LeftButton, {}, from.toPoint());
            QMouseEvent move(QEvent::MouseMove, to, frame->mapToGlobal(to), Qt::NoButton,
                             Qt::LeftButton, {});
            QApplication::sendEvent(frame, &move);
            QTest::mouseRelease(frame, Qt::LeftButton, {}, to.toPoint());
        };
        drag(1, 0, {20, 7});
        QCOMPARE(desk.paper(), app::Point(120, 100));
        drag(-1, -1, {-10, 30});
        QCOMPARE(desk.paper(), app::Point(130, 70));
        QCOMPARE(desk.page().min, app::Point(-10, 30));
        QCOMPARE(desk.window->canvas().view().zoom, view.zoom);
        QCOMPARE(desk.window->session().history.count(), 1);
        drag(0, 1, {0, -500}); // not beyond the other edge
        QCOMPARE(desk.paper(), app::Point(130, 1));
        desk.sheet()->leave();
        QCOMPARE(desk.paper(), app::Point(100, 100));
        QVERIFY(!frame->isVisible());
    }
    void theMarginsAreDragged()
    {
        Desk desk;
        auto* frame = desk.window->findChild<PageFrame*>("page-frame");
        desk.part<QAbstractButton>("show-margins")->click();
        const double unit = desk.window->canvas().view().zoom / desk.page().millimetresPerUnit();
        const auto drag = [&](int across, int down, double x, double y,
                              Qt::KeyboardModifiers keys = {}) {
            const QPointF from = frame->square(across, down, PageFrame::Edges::Margins);
            const QPoint to = (from + QPointF(x, y) * unit).toPoint();
            QTest::mousePress(frame, Qt::LeftButton, {}, from.toPoint());
            QMouseEvent move(QEvent::MouseMove, to, frame->mapToGlobal(to), Qt::NoButton,
                             Qt::LeftButton, keys);
            QApplication::sendEvent(frame, &move);
            QTest::mouseRelease(frame, Qt::LeftButton, keys, to);
        };
        drag(-1, 0, 5, 0);
        QCOMPARE(desk.page().margins, (app::PaperMargins{15, 10, 10, 10, true}));
        drag(0, 1, 0, -7);
        QCOMPARE(desk.page().margins, (app::PaperMargins{15, 10, 10, 17, true}));
        drag(0, -1, 0, -60); // beyond the edge
        QCOMPARE(desk.page().margins.top, 0);
        drag(1, 0, -300, 0); // they would meet
        QCOMPARE(desk.page().margins.right, 10);
        drag(1, 0, 6, 0, Qt::ShiftModifier);
        QCOMPARE(desk.page().margins, (app::PaperMargins{4, 4, 4, 4, true}));
        QCOMPARE(desk.window->session().history.count(), 1);
    }
    void draggedInsideThePageMovesBelowTheDrawing()
    {
        Desk desk;
        auto* frame = desk.window->findChild<PageFrame*>("page-frame");
        const app::Document before = desk.window->session().now();
        const QPointF corner = frame->square(-1, -1);
        const QPoint from = frame->square(0, 0).toPoint(), to = from + QPoint(40, 25);
        QTest::mousePress(frame, Qt::LeftButton, {}, from);
        QMouseEvent move(QEvent::MouseMove, to, frame->mapToGlobal(to), Qt::NoButton,
                         Qt::LeftButton, {});
        QApplication::sendEvent(frame, &move);
        QTest::mouseRelease(frame, Qt::LeftButton, {}, to);
        const double zoom = desk.window->canvas().view().zoom;
        const app::Point by = desk.page().min - before.page().min;
        QVERIFY(std::abs(by.x + 40 / zoom) < 1e-9 && std::abs(by.y + 25 / zoom) < 1e-9);
        QVERIFY((frame->square(-1, -1) - corner).manhattanLength() < 1e-6); // as it was seen
        QVERIFY(desk.window->session().now().objects() == before.objects());
        QTest::keyClick(desk.sheet(), Qt::Key_Escape);
        QVERIFY(desk.window->session().now() == before);
    }
    void aBackgroundIsChosen()
    {
        Desk desk;
        desk.pick("page-background", 1);
        QCOMPARE(desk.page().background.colour.alpha, 0);
        desk.part<QAbstractButton>("export-background")->click();
        QVERIFY(desk.page().background.exported);
        QCOMPARE(desk.page().exportedBackground()->alpha, 0);
        desk.pick("page-background", 2); // opens the colours
        auto* colours = desk.sheet()->findChild<ColourPopup*>();
        QVERIFY(colours->isVisible());
        emit colours->picked(app::Colour{0xf4, 0xec, 0xd8});
        QCOMPARE(desk.page().background.colour, (app::Colour{0xf4, 0xec, 0xd8}));
        QCOMPARE(desk.colourOnPage(), QColor(0xf4, 0xec, 0xd8));
        desk.pick("page-background", 0);
        QCOMPARE(desk.colourOnPage(), QColor(Qt::white));
        QCOMPARE(desk.window->session().history.count(), 1);
    }
    void escapeLeavesThePageAsItWas_data()
    {
        QTest::addColumn<bool>("onCanvas");
        QTest::newRow("in the sheet") << false;
        QTest::newRow("on the canvas") << true;
    }
    void escapeLeavesThePageAsItWas()
    {
        QFETCH(const bool, onCanvas);
        const Desk desk;
        const app::Page before = desk.page();
        desk.pick("page-iso", 0);
        QVERIFY(desk.page() != before);
        if (onCanvas)
            desk.window->canvas().setFocus();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QCOMPARE(desk.sheet(), nullptr);
        QCOMPARE(desk.page(), before);
        QVERIFY(!desk.window->session().history.canUndo());
    }
    void enterAndDoneKeepIt()
    {
        const Desk desk;
        desk.type("page-scale", "20", Qt::Key_Return);
        QCOMPARE(desk.sheet(), nullptr);
        QCOMPARE(desk.page().scale.ratio, 20.0);
        desk.run("page");
        desk.pick("page-usual-scales", 4);
        QTest::mouseClick(desk.part<QAbstractButton>("done"), Qt::LeftButton);
        QCOMPARE(desk.sheet(), nullptr);
        QCOMPARE(desk.page().scale.ratio, 500.0);
        QCOMPARE(desk.window->session().history.undoText(), "Change page");
    }
    void badNumbersAreRefused_data()
    {
        QTest::addColumn<QByteArray>("field");
        QTest::addColumn<QByteArray>("text");
        for (const char* text : {"0", "-5", "nan", "1e30", "1/0"})
            for (const char* field : {"page-scale", "page-width", "page-height"})
                QTest::addRow("%s: %s", field, text) << QByteArray(field) << QByteArray(text);
        QTest::newRow("100 km") << QByteArray("page-width") << QByteArray("100000m");
        QTest::newRow("margins") << QByteArray("page-left") << QByteArray("100");
    }
    void badNumbersAreRefused()
    {
        QFETCH(const QByteArray, field);
        QFETCH(const QByteArray, text);
        const Desk desk;
        const app::Document before = desk.window->session().now();
        const QString shown = desk.part(field)->text();
        desk.type(field, text, Qt::Key_Return);
        QVERIFY(desk.sheet());
        QVERIFY(desk.refusal().endsWith(u'.'));
        QCOMPARE(desk.part(field)->text(), shown);
        QCOMPARE(desk.window->session().now(), before);
    }
    void thePageFitsTheDrawingOrTheWindows()
    {
        const Desk desk;
        QTest::mouseClick(desk.part<QAbstractButton>("page-to-windows"), Qt::LeftButton);
        QCOMPARE(desk.paper(), app::Point(120, 120));
        QTest::mouseClick(desk.part<QAbstractButton>("page-to-drawing"), Qt::LeftButton);
        QCOMPARE(desk.paper(), app::Point(120, 65));
        QCOMPARE(desk.page().min, app::Point(-10, -5));
        desk.run("select-all");
        desk.run("delete");
        QTest::mouseClick(desk.part<QAbstractButton>("page-to-drawing"), Qt::LeftButton);
        QCOMPARE(desk.refusal(), "Nothing is drawn yet. Draw something first.");
    }
    void theSheetSaysWhatLiesOutside()
    {
        const Desk desk;
        auto* check = desk.part<QLabel>("page-check");
        QCOMPARE(check->text(), "The object lies on the page.");
        desk.type("page-width", "90");
        QTRY_VERIFY(check->text().startsWith("1 object lies outside the page."));
        emit check->linkActivated("#");
        QCOMPARE(desk.window->session().selection(), app::ObjectRanges({0}));
    }
    void marginsCanBeAllTheSame()
    {
        const Desk desk;
        desk.type("page-left", "15");
        QCOMPARE(desk.page().margins.bottom, 15.0); // they were the same before
        QTest::mouseClick(desk.part<QAbstractButton>("same-margins"), Qt::LeftButton);
        desk.type("page-top", "20");
        QCOMPARE(desk.page().margins, (app::PaperMargins{15, 20, 15, 15}));
        QTest::mouseClick(desk.part<QAbstractButton>("show-margins"), Qt::LeftButton);
        QVERIFY(desk.page().margins.shown);
    }
    void aNewDrawingHasTheLastPage()
    {
        const Desk desk;
        desk.pick("page-iso", 4);
        desk.type("page-scale", "50", Qt::Key_Return);
        desk.answers->answer = PreparedAnswers::Answer::DontSave;
        desk.run("new");
        QCOMPARE(desk.paper(), app::Point(210, 297));
        QCOMPARE(desk.page().size, app::Point(10500, 14850));
        QCOMPARE(desk.page().scale.ratio, 50.0);
        desk.run("page");
        desk.pick("page-iso", 0);
        desk.sheet()->leave(); // is not kept
        desk.run("new");
        QCOMPARE(desk.paper(), app::Point(210, 297));
    }
    void anotherDrawingClosesTheSheet()
    {
        const Desk desk;
        desk.pick("page-iso", 0);
        desk.answers->answer = PreparedAnswers::Answer::DontSave;
        desk.run("new");
        QCOMPARE(desk.sheet(), nullptr);
    }
};

} // namespace ui::sheets_page_sheet_test

TEST_CLASS(ui::sheets_page_sheet_test::PageSheetTest, Widgets)
#include "tests/ui/sheets/page_sheet_test.moc"
