// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/variant.h"
#include "app/session/window_steps.h"
#include "app/session/window_values.h"
#include "ui/bars/option_bar.h"
#include "ui/bars/status_bar.h"
#include "ui/canvas/ruler.h"
#include "ui/docks/algorithm_panel.h"
#include "ui/docks/compare_panel.h"
#include "ui/docks/layers_panel.h"
#include "ui/docks/line_panel.h"
#include "ui/docks/start_panel.h"
#include "ui/docks/window_panel.h"
#include "ui/widgets/heading.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/tool_list.h"
#include "ui/window/arrangement.h"

#include <QDockWidget>
#include <QLineEdit>
#include <QRadioButton>

#include <functional>

#include "tests/app/document/one_window.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace docks_panels_test {

using namespace ui;

namespace {

void type(QDoubleSpinBox* field, const QString& text)
{
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
}

/// Of the clip window in the panel, in the order of app::WindowValue.
QList<LengthField*> numbersOf(const TestWindow& t)
{
    QList<LengthField*> numbers;
    for (const char* name : {"X", "Y", "Width", "Height", "Angle"})
        for (auto* field : t.window->findChild<WindowPanel*>()->findChildren<LengthField*>())
            if (field->accessibleName() == QLatin1StringView(name))
                numbers << field;
    return numbers;
}

/// Without the capsule of the chosen clip window, the panel has width and height.
void switchCapsulesOff(const TestWindow& t)
{
    t.window->canvas().setCapsuleHome(app::CapsuleHome::Off);
}

} // namespace

class PanelsTest : public QObject {
    Q_OBJECT

private slots:
    void aTypedNumberIsOneUndoStep()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        switchCapsulesOff(t);
        app::Session& session = t.window->session();
        const auto fields = numbersOf(t);
        QCOMPARE(fields.size(), 5);
        type(fields[0], "25");
        QCOMPARE(session.history.count(), 1);
        QCOMPARE(session.history.undoText(), "Move clip window");
        QCOMPARE(sheetOf(session.document).window, (clipping::Window{{25, 0}, {125, 100}}));
        type(fields[2], "2cm"); // a unit converts
        QCOMPARE(session.history.undoText(), "Resize clip window");
        QCOMPARE(session.history.count(), 2);
        QCOMPARE(sheetOf(session.document).window.max.x, 45.0);
        session.history.undo();
        session.history.undo();
        QCOMPARE(sheetOf(session.document).window, (clipping::Window{{0, 0}, {100, 100}}));
        QCOMPARE(fields[0]->text(), "0.00");
    }
    void whatTheCapsuleHasIsNotInThePanel()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        const auto fields = numbersOf(t);
        const auto shown = [&fields](app::WindowValue which) {
            return fields[qsizetype(which)]->isVisible();
        };
        using enum app::WindowValue;
        QVERIFY(shown(X) && shown(Y) && shown(Angle) && !shown(Width) && !shown(Height));
        t.window->canvas().setCapsuleHome(app::CapsuleHome::InBar);
        QVERIFY(shown(X) && !shown(Width));
        switchCapsulesOff(t);
        QVERIFY(shown(X) && shown(Y) && shown(Angle) && shown(Width) && shown(Height));
        t.window->canvas().setCapsuleHome(app::CapsuleHome::AtObject);
        QVERIFY(shown(X) && !shown(Width));
    }
    void nothingOfAWindowIsCutOffInTheNarrowestColumn()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.window->resize(1024, 640);
        t.show();
        switchCapsulesOff(t);
        t.window->session().changeDisplay([](app::Display& d) { d.unit = app::Unit::User; });
        ::setWindow(t.window->session().document, {{-841.25, 1189.25}, {1000.5, 2378.75}});
        const auto* panel = t.window->findChild<WindowPanel*>();
        QTRY_COMPARE(panel->window()->findChild<QDockWidget*>("window")->width(),
                     Arrangement::narrowest);
        int numbers = 0;
        for (const auto* field : panel->findChildren<LengthField*>()) {
            QVERIFY(field->isVisible());
            QCOMPARE(field->seenText(), field->text());
            ++numbers;
        }
        QCOMPARE(numbers, 5);
        for (const auto* part : panel->findChildren<QWidget*>())
            if (part->isVisible())
                QVERIFY2(panel->rect().contains({part->mapTo(panel, QPoint()), part->size()}),
                         part->metaObject()->className());
    }
    void aHiddenWindowHasNoNumbers()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        app::Session& session = t.window->session();
        auto* panel = t.window->findChild<WindowPanel*>();
        const LengthField& field = *panel->findChildren<LengthField*>().front();
        QVERIFY(field.isVisible());
        const int height = panel->sizeHint().height();
        const auto show = [&session](bool visible) {
            app::changeWindow(session, 0, "Eye",
                              [&](app::ClipWindow& window) { window.visible = visible; });
        };
        show(false); // they were those of the page
        QVERIFY(!session.windowNumber() && !field.isVisible());
        QCOMPARE(panel->sizeHint().height(), height);
        show(true);
        QVERIFY(field.isVisible());
    }
    void quickStepsOfAFieldAreOneUndoStep()
    {
        using namespace std::chrono_literals;
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        switchCapsulesOff(t);
        app::Session& session = t.window->session();
        std::chrono::steady_clock::time_point now{};
        session.history.setClock([&] { return now; });
        const auto before = sheetOf(session.document).window;
        for (LengthField* field : numbersOf(t))
            for (const auto wait : {999ms, 1000ms}) {
                const double start = field->value();
                for (int i = 0; i < 3; ++i, now += wait)
                    i < 2 ? QTest::keyClick(field, Qt::Key_Up) : field->stepUp();
                QCOMPARE(field->value(), start + 3);
                QCOMPARE(session.history.count(), wait < 1000ms ? 1 : 3);
                session.history.setIndex(0);
                QVERIFY(sheetOf(session.document).window == before);
                session.history.clear();
            }
        const auto fields = numbersOf(t);
        type(fields[0], "25"); // typed text is a step of its own
        type(fields[0], "26");
        QCOMPARE(session.history.count(), 2);
    }
    void quickStepsOfAStyleAreOneUndoStep()
    {
        TestWindow t;
        t.open(t.file("styles.svg", "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9' "
                                    "stroke='black'><path d='M1 1H8'/><path d='M1 2H8'/></svg>"));
        t.show();
        app::Session& session = t.window->session();
        std::chrono::steady_clock::time_point now{};
        session.history.setClock([&] { return now; });
        const auto before = sheetOf(session.document);
        session.select({0, 1});
        auto* width = t.window->findChild<OptionBar*>()->findChild<LengthField*>();
        auto* dashes = t.window->findChild<OptionBar*>()->findChild<ToolList*>();
        QCOMPARE(dashes->accessibleName(), QString("Dashes"));
        for (int i = 0; i < 3; ++i)
            width->stepUp();
        QCOMPARE(session.history.count(), 1);
        QCOMPARE(session.history.undoText(), QString("Stroke width"));
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(dashes, Qt::Key_Down);
        QCOMPARE(dashes->currentIndex(), 3);
        QCOMPARE(session.history.count(), 2);
        QCOMPARE(session.history.undoText(), QString("Dashes"));
        now += std::chrono::seconds(1);
        QTest::keyClick(dashes, Qt::Key_Up);
        QCOMPARE(session.history.count(), 3);
        session.select({1}); // other objects
        QTest::keyClick(dashes, Qt::Key_Up);
        QCOMPARE(session.history.count(), 4);
        session.history.setIndex(0);
        QVERIFY(sheetOf(session.document) == before);
    }
    /// One rule for panels, status bar, ruler and `clip -w`: lengths with a unit count from the
    /// paper's corner, numbers without one from the drawing's origin.
    void coordinatesCountFromThePagesCorner()
    {
        TestWindow t;
        t.open(t.file("centred.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' "
                                     "height='100mm' viewBox='-50 -50 100 100'>"
                                     "<path d='M-40-40 40 40' stroke='black'/></svg>"));
        t.show();
        app::Session& session = t.window->session();
        QCOMPARE(sheetOf(session.document).window, (clipping::Window{{-50, -50}, {50, 50}}));
        t.run("window-on-page");
        const auto fields = numbersOf(t);
        QCOMPARE(fields[0]->text(), "0.00");
        type(fields[0], "10");
        QCOMPARE(sheetOf(session.document).window, (clipping::Window{{-40, -50}, {60, 50}}));
        QCOMPARE(fields[0]->text(), "10.00");
        QTest::mouseMove(t.drawingArea(), t.drawingArea()->rect().center()); // about (0, 0)
        QTRY_VERIFY(t.window->status().position().contains("mm"));
        const QString place = t.window->status().position();
        QVERIFY2(place.section(' ', 1, 1).toDouble() > 25, qPrintable(place));
        app::Display display = session.display();
        display.unit = app::Unit::User;
        session.setDisplay(display);
        QVERIFY2(fields[0]->text().contains("40"), qPrintable(fields[0]->text()));
        type(fields[0], "-45");
        QCOMPARE(sheetOf(session.document).window, (clipping::Window{{-45, -50}, {55, 50}}));
    }
    void enterReturnsTheFocusToTheCanvas()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        switchCapsulesOff(t);
        const auto chosen = [&] { return t.window->session().display().variant.algorithm; };
        const auto digit = [](Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); };
        const auto fields = numbersOf(t);
        type(fields[0], "25");
        digit(Qt::Key_2);
        QCOMPARE(chosen(), &clipping::algorithms()[1]);
        type(t.window->findChild<OptionBar*>()->findChild<LengthField*>(), "0.5");
        digit(Qt::Key_3);
        QCOMPARE(chosen(), &clipping::algorithms()[2]);
        QCOMPARE(fields[0]->text(), "25.00");
        type(fields[2], "-5"); // is refused and must be typed again
        digit(Qt::Key_4);
        QCOMPARE(chosen(), &clipping::algorithms()[2]);
    }
    void aNegativeWidthIsRefusedWithAMessage()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        switchCapsulesOff(t);
        const auto fields = numbersOf(t);
        type(fields[2], "-5");
        QCOMPARE(t.window->session().history.count(), 0);
        QCOMPARE(t.window->message(), "Width must be at least 0.");
        QCOMPARE(fields[2]->text(), "100.00");
    }
    void aRefusalDisappearsWithTheNextAcceptedValue()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        switchCapsulesOff(t);
        const auto fields = numbersOf(t);
        auto* width = t.window->findChild<OptionBar*>()->findChild<LengthField*>();
        for (LengthField* field : {fields[2], width}) {
            t.window->tell({Message::Kind::Warning, "Markers were not kept."});
            type(field, "abc");
            QVERIFY(t.window->message().contains("abc"));
            type(field, "def");
            QVERIFY(t.window->message().contains("def"));
            type(field, "50");
            QCOMPARE(t.window->message(), "Markers were not kept."); // the import's remark again
            type(field, "abc");
            field->setFocus();
            QTest::keyClick(field, Qt::Key_Return); // the previous number is accepted
            QCOMPARE(t.window->message(), "Markers were not kept.");
            t.window->tell({});
            type(field, "abc");
            type(field, "60");
            QCOMPARE(t.window->message(), "");
        }
    }
    void proportionsAreKept()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        switchCapsulesOff(t);
        auto* panel = t.window->findChild<WindowPanel*>();
        const auto fields = numbersOf(t);
        type(fields[3], "50");
        panel->findChild<QToolButton*>("keep-ratio")->click();
        type(fields[2], "50");
        QCOMPARE(sheetOf(t.window->session().document).window,
                 (clipping::Window{{0, 0}, {50, 25}}));
    }
    void theUnitChangesEveryNumber()
    {
        TestWindow t;
        t.open(t.twoLines());
        app::Display display = t.window->session().display();
        display.unit = app::Unit::Inch;
        t.window->session().setDisplay(display);
        const auto fields = numbersOf(t);
        QCOMPARE(fields[2]->text(), "3.937");
    }
    void theVerdictCountsLostLines()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        AlgorithmPanel& panel = t.window->algorithmPanel();
        panel.compare();
        panel.finish();
        QCOMPARE(panel.verdict(), "All corrected algorithms agree here");
        QVERIFY(panel.disagreements().empty());
    }
    void aLineBeingDrawnKeepsTheVerdict()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.window->raisePanel("algorithm");
        t.show();
        app::Session& session = t.window->session();
        app::Sheet sheet;
        app::Subpath many{{0, 0}, std::vector<app::PathSegment>(150'001), false};
        for (std::size_t i = 0; i < many.segments.size(); ++i)
            many.segments[i].to = {double(i % 100), double(i % 77)};
        sheet.shapes.emplace_back().paths.push_back(std::move(many));
        session.load({app::documentOf(sheet), {}});
        AlgorithmPanel& panel = t.window->algorithmPanel();
        const auto labels = panel.findChildren<QLabel*>();
        const auto verdict = std::ranges::find(labels, "Agreement", &QLabel::accessibleName);
        QVERIFY(verdict != labels.end() && !(*verdict)->isVisible()); // only when it is asked for
        panel.compare();
        panel.finish();
        session.setPreview({.line = clipping::Segment{{1, 1}, {9, 9}}});
        QVERIFY((*verdict)->isVisible());
        session.setPreview(
            {.windows = withWindow(session.now().windows(), clipping::Window{{1, 1}, {9, 9}})});
        QVERIFY(!(*verdict)->isVisible());
    }
    void theRadioButtonsChooseTheForm()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        QTest::keyClick(t.drawingArea(), Qt::Key_1);
        const auto radios = t.window->algorithmPanel().findChildren<QRadioButton*>();
        QTest::mouseClick(radios[1], Qt::LeftButton, {}, QPoint(8, radios[1]->height() / 2));
        QCOMPARE(t.window->session().display().variant.form, clipping::Form::Published);
    }
    void aRowWithoutPublishedFormSaysSo()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        app::Session& session = t.window->session();
        const auto choose = [&](const clipping::Algorithm& algorithm) {
            session.setDisplay({.variant = {&algorithm, clipping::Form::Published}});
        };
        const auto radios = t.window->algorithmPanel().findChildren<QRadioButton*>();
        choose(clipping::algorithms().front());
        QVERIFY(radios[1]->isEnabled() && radios[1]->isChecked());
        QCOMPARE(radios[1]->text(), "as published");
        choose(app::usualAlgorithm());
        QVERIFY(!radios[1]->isEnabled() && radios[0]->isChecked());
        QCOMPARE(radios[1]->text(), "published: none");
        QCOMPARE(radios[1]->toolTip(),
                 "Exact has no published form, so the corrected form is used");
        QVERIFY(!t.action("form-published")->isChecked());
        QVERIFY(!t.action("form-published")->isEnabled());
    }
    void withoutALineThePanelOffersTheLessons()
    {
        TestWindow t;
        t.show();
        auto* lessons = t.window->findChild<LinePanel*>()->findChild<QPushButton*>("panel-lessons");
        QVERIFY(lessons->toolTip().contains("Ctrl+F1"));
        lessons->click();
        QVERIFY(t.window->showsLessons());
    }
    void theLinePanelShowsTheSteps()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        t.window->session().inspect(0);
        auto* panel = t.window->findChild<LinePanel*>();
        QTRY_VERIFY(!panel->steps().isEmpty());
        QVERIFY2(panel->steps().contains("Visible"), qPrintable(panel->steps()));
    }
    /// In millimetres that is the page's corner, in user units the drawing's own origin.
    void theRulersHaveTheOriginOfTheFields()
    {
        const auto rulerOf = [](const app::Point& corner, const app::Point& window,
                                app::Unit unit) {
            TestWindow t;
            app::Sheet sheet;
            sheet.page.min = corner;
            sheet.window = {window, window + 50.0};
            t.window->session().load({app::documentOf(sheet), {}});
            app::Display display = t.window->session().display();
            display.unit = unit;
            t.window->session().setDisplay(display);
            t.show();
            t.window->canvas().fitWindow();
            return t.window->findChild<Ruler*>()->grab().toImage();
        };
        const app::Point corner(-33, -17), at(25, 25);
        const auto ruler = rulerOf({0, 0}, at, app::Unit::Mm);
        QCOMPARE(rulerOf(corner, corner + at, app::Unit::Mm), ruler);
        QVERIFY(rulerOf(corner, at, app::Unit::Mm) != ruler);
        QCOMPARE(rulerOf(corner, at, app::Unit::User), rulerOf({0, 0}, at, app::Unit::User));
    }
    void theStepsAreInTheUnitOfTheTable()
    {
        TestWindow t;
        t.open(t.twoLines()); // in millimetres, from 0 to 100
        t.show();
        app::Display display = t.window->session().display();
        display.unit = app::Unit::Cm;
        t.window->session().setDisplay(display);
        t.window->session().inspect(0);
        auto* panel = t.window->findChild<LinePanel*>();
        QTRY_VERIFY2(panel->steps().contains("Visible: (0.0000; 5.0000) to (10.0000; 5.0000)"),
                     qPrintable(panel->steps()));
    }
    void theLastLineOfAPanelKeepsADistanceFromTheNextPanel_data()
    {
        QTest::addColumn<std::function<QWidget*(app::Session&)>>("make");
        using Make = std::function<QWidget*(app::Session&)>;
        QTest::addRow("algorithm")
            << Make([](app::Session& session) { return new AlgorithmPanel(session); });
        QTest::addRow("compare") << Make(
            [](app::Session& session) { return new ComparePanel(session); });
    }
    void theLastLineOfAPanelKeepsADistanceFromTheNextPanel()
    {
        QFETCH(std::function<QWidget*(app::Session&)>, make);
        app::Session session; // without a clip window
        const std::unique_ptr<QWidget> panel(make(session));
        const auto* last = panel->findChild<PageCaption*>();
        panel->show();
        panel->resize(320, panel->minimumSizeHint().height());
        QVERIFY(last->isVisible());
        const QPoint bottom = last->mapTo(panel.get(), last->contentsRect().bottomLeft());
        QVERIFY2(panel->height() - bottom.y() > 8, qPrintable(QString::number(bottom.y())));
    }
    void layersAreUndoable()
    {
        TestWindow t;
        t.open(t.twoLines());
        app::Session& session = t.window->session();
        auto* model = t.window->findChild<LayerModel*>();
        model->addLayer();
        QCOMPARE(model->rowCount(), 2);
        model->setData(model->index(0), "Sky", Qt::EditRole);
        QCOMPARE(sheetOf(session.document).layers[1].name, "Sky");
        model->setData(model->index(1), false, LayerModel::VisibleRole);
        QCOMPARE(session.scene.lines().size(), std::size_t(0));
        model->removeLayer(model->layerOf(model->index(1)));
        QCOMPARE(model->rowCount(), 1);
        while (session.history.canUndo())
            session.history.undo();
        QCOMPARE(sheetOf(session.document),
                 app::sheetOf(app::readFile(t.path("two.svg")).value->document));
    }
    void layersAreAddedAndDeletedByVisibleButtons()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        const auto buttons = t.window->findChild<LayersPanel*>()->findChildren<QToolButton*>(
            QString(), Qt::FindDirectChildrenOnly);
        QCOMPARE(buttons.size(), 2);
        QCOMPARE(buttons[0]->toolTip(), "Add layer");
        QCOMPARE(buttons[1]->toolTip(), "Delete layer");
        QVERIFY(buttons[0]->isVisible() && buttons[1]->isVisible());
        QVERIFY(!buttons[1]->isEnabled()); // the only layer stays
        QTest::mouseClick(buttons[0], Qt::LeftButton);
        QCOMPARE(sheetOf(t.window->session().document).layers.size(), std::size_t(2));
        QTest::mouseClick(buttons[1], Qt::LeftButton);
        QCOMPARE(sheetOf(t.window->session().document).layers.size(), std::size_t(1));
    }
    void theStartPanelFitsAnyHeight() // a scroll bar once appeared and disappeared endlessly
    {
        StartPanel panel;
        panel.show();
        for (const int width : {272, 396})
            for (int height = 300; height < 1000; ++height)
                panel.resize(width, height);
        QCOMPARE(panel.height(), 999);
    }
    void theTimesBelongToTheCurrentAlgorithm()
    {
        TestWindow t; // never shown, so that there are no other frames
        std::uint64_t clipping = 0;
        const auto frame = [&](std::uint64_t subject, double clipMs, double drawMs) {
            emit t.window->canvas().frameShown({.clipMs = clipMs,
                                                .drawMs = drawMs,
                                                .total = 5000,
                                                .clipping = ++clipping,
                                                .subject = subject});
        };
        for (int i = 0; i < 9; ++i)
            frame(1, 5, 7);
        frame(2, 2, 1); // another row, another window or another drawing
        QTRY_COMPARE(t.window->status().times(), "clip 2.00 ms  draw 1.00 ms");
        frame(2, 4, 30); // the picture that is seen took this time
        QTRY_COMPARE(t.window->status().times(), "clip 3.00 ms  draw 30.0 ms");
    }
    void theStatusBarSaysThatItPaintsAndHowLongItClipped()
    {
        TestWindow t;
        const auto frame = [&](bool painting, double lateMs = 0) {
            emit t.window->canvas().frameShown(
                {.clipMs = 2, .drawMs = 1, .total = 5000, .painting = painting, .lateMs = lateMs});
        };
        frame(true);
        QTRY_COMPARE(t.window->status().times(), "clip 2.00 ms  painting…");
        frame(true, 1240);
        QTRY_COMPARE(t.window->status().times(), "clip 2.00 ms  1.2 s late");
        frame(false);
        QTRY_COMPARE(t.window->status().times(), "clip 2.00 ms  draw 1.00 ms");
    }
    void theStatusBarCountsTheLinesThatDiffer()
    {
        TestWindow t;
        const auto frame = [&](std::size_t differing) {
            emit t.window->canvas().frameShown(
                {.visible = 7, .total = 50'000, .differing = differing});
        };
        frame(14);
        QTRY_COMPARE(t.window->status().visibility(), "7 of 50,000 visible, 14 differ");
        frame(20'001);
        QTRY_COMPARE(t.window->status().visibility(), "7 of 50,000 visible, over 20,000 differ");
        frame(0);
        QTRY_COMPARE(t.window->status().visibility(), "7 of 50,000 visible");
    }
    void theTimesOfAnotherFileAreNotShown()
    {
        TestWindow t; // never shown, so that there are no other frames
        emit t.window->canvas().frameShown({.visible = 18, .total = 41});
        QTRY_COMPARE(t.window->status().visibility(), "18 of 41 visible");
        emit t.window->canvas().frameShown({.visible = 17, .total = 41});
        t.open(t.twoLines());
        QCOMPARE(t.window->status().visibility(), "");
        QCOMPARE(t.window->status().times(), "");
        QTest::qWait(150); // earlier times are no longer shown
        QCOMPARE(t.window->status().visibility(), "");
        emit t.window->canvas().frameShown({.visible = 2, .total = 2});
        QTRY_COMPARE(t.window->status().visibility(), "2 of 2 visible");
    }
    void thePanelListsTheClipWindows()
    {
        TestWindow t;
        t.show();
        app::Session& session = t.window->session();
        const auto box = [](double at) {
            return app::RectangleShape{{{at, at}, {at + 50, at + 50}}};
        };
        app::ClipWindows windows;
        windows.list = {{.name = "Hidden", .shape = box(0), .visible = false},
                        {.name = "Main", .shape = box(10)},
                        {.shape = box(20), .operation = app::WindowOperation::CutOut}};
        session.document.apply({.windows = windows});
        const auto* list = t.window->findChild<QListView*>("clip-windows");
        QVERIFY(list->isVisible());
        QTRY_COMPARE(list->currentIndex().data().toString(), "Main");
        QCOMPARE(list->model()->rowCount(), 3);
        const int height = t.window->findChild<QDockWidget*>("window")->height();
        windows.list = {{.name = "Main", .shape = box(10)}};
        session.document.apply({.windows = windows});
        QCOMPARE(list->model()->rowCount(), 1);
        QCOMPARE(t.window->findChild<QDockWidget*>("window")->height(), height);
    }
    void aClipWindowIsHiddenWhereTheEyeIsReleased()
    {
        TestWindow t;
        t.show();
        app::Session& session = t.window->session();
        session.document.apply(
            {.windows = app::ClipWindows{{{.shape = app::RectangleShape{{{0, 0}, {50, 50}}}}}}});
        auto* list = t.window->findChild<QListView*>("clip-windows");
        QTRY_COMPARE(list->model()->rowCount(), 1);
        const auto isVisible = [&] { return session.now().windows().list[0].visible; };
        const QRect row = list->visualRect(list->model()->index(0, 0));
        const QPoint eye(row.left() + space::dockMargin + 8, row.center().y());
        for (const bool shown : {false, true}) {
            QTest::mousePress(list->viewport(), Qt::LeftButton, {}, eye);
            QCOMPARE(isVisible(), !shown);
            QTest::mouseRelease(list->viewport(), Qt::LeftButton, {}, eye);
            QCOMPARE(isVisible(), shown);
        }
    }
    void theStatusBarCounts()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        QTRY_COMPARE(t.window->status().visibility(), "2 of 2 visible");
        QTRY_COMPARE(t.window->status().times(), "too few lines to time");
        QTest::mouseMove(t.drawingArea(), QPoint(200, 200));
        QTRY_VERIFY(t.window->status().position().contains("mm"));
    }
};

} // namespace docks_panels_test

TEST_CLASS(docks_panels_test::PanelsTest, Widgets)
#include "tests/ui/docks/panels_test.moc"
