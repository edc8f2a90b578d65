// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/canvas.h"
#include "ui/lessons/lesson_panel.h"
#include "ui/look/look.h"
#include "ui/microscope/microscope_page.h"
#include "ui/tiles/tiles_page.h"
#include "ui/widgets/message_strip.h"
#include "ui/window/centre.h"
#include "ui/window/modes.h"

#include <QAction>
#include <QApplication>
#include <QSignalSpy>
#include <QStatusBar>
#include <QToolBar>

#include "tests/test_class.h"
#include "tests/ui/window/plain_panels.h"

namespace window_modes_test {

using namespace ui;

namespace {

/// A window with a canvas, two bars and plain panels, but without menus.
class Stage {
public:
    Stage()
    {
        canvas = new Canvas(session, Backend::Raster);
        centre = new Centre(*new MessageStrip, *canvas);
        window().setCentralWidget(centre);
        across = window().addToolBar("across");
        across->setObjectName("across");
        atSide = new QToolBar("side");
        atSide->setObjectName("side");
        window().addToolBar(Qt::LeftToolBarArea, atSide);
        modes = std::make_unique<Modes>(
            session, drawn, *canvas,
            Modes::Parts{
                window(), sheets, *centre, *plain.layout, {across, atSide}, *window().statusBar()});
        plain.show();
        window().activateWindow();
        canvas->setFocus();
    }
    QMainWindow& window() { return plain.window; }
    void toggleMicroscope()
    {
        session.microscope.isOpen() ? session.microscope.close() : drawn.look();
        QCoreApplication::processEvents();
    }
    void toggleSheets()
    {
        session.microscope.close();
        sheets.isOpen() ? sheets.close() : sheets.open();
        QCoreApplication::processEvents();
    }
    void showLessons()
    {
        modes->microscope().showLessons();
        QCoreApplication::processEvents();
    }
    void togglePresenting()
    {
        modes->togglePresenting();
        QCoreApplication::processEvents();
    }
    /// What the window shows although its mode should not, or does not show although it should.
    QStringList faults()
    {
        const Beside beside =
            modes->microscope().showsLessons() ? Beside::Lessons : Beside::Nothing;
        const Mode mode = modeOf(session, sheets, beside);
        const ModeParts parts = partsOf(mode);
        const bool presenting = session.display().presenting;
        QStringList faults;
        const auto expect = [&faults](const char* what, bool shown, bool wanted) {
            if (shown != wanted)
                faults << QLatin1StringView(what);
        };
        expect("another page", !centre->showsCanvas(), parts.microscope || parts.tiles);
        expect("sheets", centre->tiles() && centre->tiles()->isVisible(), parts.tiles);
        expect("canvas", canvas->isVisible(), !parts.microscope && !parts.tiles);
        expect("panels", !plain.inFront().empty(), parts.panels);
        expect("bar across", across->isVisible(), parts.barAcross);
        expect("bar at the side", atSide->isVisible(), parts.barAtSide);
        expect("status bar", window().statusBar()->isVisible(), parts.status);
        expect("large type", QApplication::font().pointSizeF() > type * 1.4, presenting);
        return faults;
    }

    const double type = QApplication::font().pointSizeF();
    app::Session session;
    app::DrawnLine drawn{session};
    app::LiveSheets sheets{session};
    PlainWindow plain;
    Canvas* canvas;
    Centre* centre;
    QToolBar *across, *atSide;
    std::unique_ptr<Modes> modes;
};

} // namespace

class ModesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { applyTheme(*qApp, Theme::Light); }

    void theSessionSaysWhichModeIsOn()
    {
        app::Session session;
        app::DrawnLine drawn(session);
        app::LiveSheets sheets(session);
        QCOMPARE(modeOf(session, sheets), Mode::Editing);
        drawn.look();
        QCOMPARE(modeOf(session, sheets), Mode::Microscope);
        QCOMPARE(modeOf(session, sheets, Beside::Lessons), Mode::Lessons);
        app::Display display = session.display();
        display.presenting = true;
        session.setDisplay(display);
        QCOMPARE(modeOf(session, sheets), Mode::PresentingMicroscope);
        QCOMPARE(modeOf(session, sheets, Beside::Lessons), Mode::PresentingLessons);
        session.microscope.close();
        QCOMPARE(modeOf(session, sheets), Mode::Presenting);
    }
    void eachModeShowsItsParts_data()
    {
        QTest::addColumn<Mode>("mode");
        QTest::addColumn<QString>("shown");
        QTest::newRow("editing") << Mode::Editing
                                 << "canvas, panels, bar across, bar at side, status bar";
        QTest::newRow("microscope") << Mode::Microscope << "microscope, bar at side, status bar";
        QTest::newRow("lessons") << Mode::Lessons << "microscope";
        QTest::newRow("presenting") << Mode::Presenting << "canvas, bar across, status bar";
        QTest::newRow("both") << Mode::PresentingMicroscope << "microscope, status bar";
        QTest::newRow("presented lessons") << Mode::PresentingLessons << "microscope";
        QTest::newRow("tiles") << Mode::Tiles << "tiles, status bar";
    }
    void eachModeShowsItsParts()
    {
        QFETCH(Mode, mode);
        const ModeParts parts = partsOf(mode);
        QStringList shown{parts.microscope ? "microscope" : parts.tiles ? "tiles" : "canvas"};
        if (parts.panels)
            shown << "panels";
        if (parts.barAcross)
            shown << "bar across";
        if (parts.barAtSide)
            shown << "bar at side";
        if (parts.status)
            shown << "status bar";
        QTEST(shown.join(", "), "shown");
    }
    void everyWayThroughTheModesEndsAsItBegan_data()
    {
        // m: microscope, p: presenting, t: tiles, l: lessons, which end with the microscope
        QTest::addColumn<QString>("toggles");
        for (const char* toggles :
             {"mm", "pp", "mpmp", "mppm", "pmpm", "pmmp", "mmppmpmp", "tt", "tmm", "mtt", "tpp",
              "lm", "mlm", "lppm", "plmp", "lpmp", "ltt"})
            QTest::newRow(toggles) << QString(toggles);
    }
    void everyWayThroughTheModesEndsAsItBegan()
    {
        QFETCH(QString, toggles);
        Stage stage;
        QCOMPARE(stage.faults().join(","), QString());
        const QStringList panels = stage.plain.inFront();
        for (const QChar toggle : toggles) {
            toggle == u'm'   ? stage.toggleMicroscope()
            : toggle == u't' ? stage.toggleSheets()
            : toggle == u'l' ? stage.showLessons()
                             : stage.togglePresenting();
            QCOMPARE(stage.faults().join(","), QString());
        }
        QCOMPARE(modeOf(stage.session, stage.sheets), Mode::Editing);
        QCOMPARE(stage.plain.inFront(), panels);
        QCOMPARE(QApplication::font().pointSizeF(), stage.type);
    }
    void aBarThatThePersonHidStaysHidden()
    {
        Stage stage;
        stage.atSide->hide();
        for (int i = 0; i < 2; ++i) {
            stage.toggleMicroscope();
            QVERIFY(!stage.atSide->isVisible());
        }
        stage.atSide->show();
        for (int i = 0; i < 2; ++i)
            stage.toggleMicroscope();
        QVERIFY(stage.atSide->isVisible());
    }
    void presentingFillsTheScreenAndRestoresTheWindow()
    {
        Stage stage;
        const QSize size = stage.window().size();
        stage.togglePresenting();
        QVERIFY(stage.window().isFullScreen());
        stage.togglePresenting();
        QVERIFY(!stage.window().isFullScreen());
        QTRY_COMPARE(stage.window().size(), size);
    }
    void theFocusReturnsFromTheMicroscope()
    {
        Stage stage;
        for (const bool deleted : {false, true}) {
            auto* field = new QWidget;
            field->setFocusPolicy(Qt::StrongFocus);
            stage.atSide->addWidget(field);
            QTRY_VERIFY(field->isVisible());
            field->setFocus();
            QVERIFY(field->hasFocus());
            stage.toggleMicroscope();
            QVERIFY(!field->hasFocus());
            if (deleted)
                delete field;
            stage.toggleMicroscope();
            QCOMPARE(stage.window().focusWidget(), deleted ? stage.canvas->focusProxy() : field);
        }
    }
    void theMicroscopeIsMadeWhenItIsEnteredAndAnewForAnotherType()
    {
        Stage stage;
        const QSignalSpy made(&stage.modes->microscope(), &MicroscopeMode::made);
        stage.togglePresenting();
        stage.togglePresenting();
        QVERIFY(!stage.centre->microscope());
        for (int i = 0; i < 3; ++i)
            stage.toggleMicroscope();
        QCOMPARE(made.size(), 1);
        const MicroscopePage* const before = stage.centre->microscope();
        stage.togglePresenting();
        QCOMPARE(made.size(), 2);
        QVERIFY(stage.centre->microscope() != before && stage.centre->microscope()->isVisible());
    }
    void lessonsAreReadOnWhilePresentingAndEndWithTheMicroscope()
    {
        Stage stage;
        MicroscopeMode& microscope = stage.modes->microscope();
        const QSignalSpy changed(stage.modes.get(), &Modes::changed);
        microscope.showLessons();
        QCOMPARE(modeOf(stage.session, stage.sheets), Mode::Microscope);
        stage.session.course.begin(0);
        stage.togglePresenting();
        QVERIFY(microscope.showsLessons() && stage.session.course.lesson());
        stage.toggleMicroscope();
        QVERIFY(!microscope.showsLessons() && !stage.session.course.lesson());
        QCOMPARE(stage.faults().join(","), QString());
        QVERIFY(changed.size() >= 4);
    }
    void loadingADrawingLeavesTheMicroscope()
    {
        Stage stage;
        stage.toggleMicroscope();
        stage.session.load({});
        QCOMPARE(stage.faults().join(","), QString());
        QVERIFY(modeOf(stage.session, stage.sheets) == Mode::Editing);
    }
    void typeIsTheProgramsAndGoesWithTheWindow()
    {
        const double type = QApplication::font().pointSizeF();
        {
            Stage stage;
            stage.togglePresenting();
            QVERIFY(QApplication::font().pointSizeF() > type);
        }
        QCOMPARE(QApplication::font().pointSizeF(), type);
    }
};

} // namespace window_modes_test

TEST_CLASS(window_modes_test::ModesTest, Widgets)
#include "tests/ui/window/modes_test.moc"
