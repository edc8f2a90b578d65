// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/session/samples.h"
#include "ui/explanation/explanation_window.h"
#include "ui/explanation/page_view.h"
#include "ui/showing/show_bar.h"
#include "ui/showing/show_steps.h"
#include "ui/showing/shown_commands.h"
#include "ui/showing/shown_counts.h"
#include "ui/showing/step_player.h"
#include "ui/widgets/sheet.h"
#include "ui/window/workspaces.h"

#include <QCryptographicHash>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>

#include "tests/test_class.h"
#include "tests/ui/editor/test_desk.h"

namespace showing_show_steps_test {

using namespace ui;

namespace {

app::ManualPage pageOf(const QString& steps) { return {"a", "Page", "# Page", {}, steps}; }

/// All that a step can change and a person can see.
QString stateOf(MainWindow& window)
{
    const app::Session& session = window.session();
    const Canvas& canvas = window.canvas();
    QStringList parts{QString::number(session.document.revision()),
                      QString::number(session.history.index()),
                      app::latin(canvas.tool()),
                      canvas.toolHint(),
                      QString::number(canvas.snaps()),
                      app::latin(session.nextWindow),
                      app::latin(window.workspace().key),
                      window.sheet() ? window.sheet()->objectName() : QString(),
                      QString::number(session.windowNumber().value_or(0)),
                      QString::number(canvas.pendingObject().has_value()),
                      app::latin(session.display().variant.algorithm->key),
                      QString::number(int(session.display().variant.form)),
                      QString::number(int(session.display().removed)),
                      QString::number(int(session.display().unit)),
                      QString::number(session.nodes.summary().selected),
                      window.findChild<QLabel*>("hint")->text(),
                      QString::number(session.pen.style.stroke.has_value())};
    for (const ShownCount& count : shownCounts())
        parts << QString::number(count.count(window));
    for (const double number : {canvas.view().centre.x, canvas.view().centre.y, canvas.zoom()})
        parts << QString::number(number);
    if (const auto box = session.selectionBounds())
        for (const double number : {box->min.x, box->min.y, box->max.x, box->max.y})
            parts << QString::number(number);
    for (const QAction* panel : window.panelToggles())
        parts << QString::number(panel->isChecked());
    return parts.join(u'|');
}

/// The same with its picture, in which gestures are seen that have not ended.
QByteArray pictureOf(MainWindow& window)
{
    window.canvas().settle();
    const QImage picture = window.canvas().grab().toImage();
    const QByteArrayView bytes(picture.constBits(), picture.sizeInBytes());
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha1);
}

/// Where a step begins, so that the pointer alone makes no difference.
void pointAt(MainWindow& window, const app::ShownStep& step)
{
    if (step.points.empty() || step.kind == app::ShownStep::Kind::Move)
        return;
    const app::Page& page = window.session().now().page();
    const app::Point at =
        window.canvas().view().toScreen(page.min + step.points.front() / page.millimetresPerUnit());
    const QPointF place(std::round(at.x), std::round(at.y));
    QWidget& area = *window.canvas().focusProxy();
    QMouseEvent event(QEvent::MouseMove, place, area.mapToGlobal(place), Qt::NoButton, {},
                      step.with);
    QCoreApplication::sendEvent(&area, &event);
}

/// Waits until no file is read and nothing is cut.
void settle(MainWindow& window)
{
    window.files().wait();
    QCoreApplication::processEvents();
}

/// Presses *Next step* until all is shown; `before` and `after` are called at each step.
using AtStep = std::function<void(std::size_t)>;
void playAll(StepPlayer& player, MainWindow& shown, const AtStep& before, const AtStep& after)
{
    for (int i = 0; player.isPlaying() && i < 1000; ++i) {
        const std::size_t step = player.step();
        before(step);
        bool isDone = false;
        const auto told = QObject::connect(&player, &StepPlayer::stepDone, [&] { isDone = true; });
        while (player.isPlaying() && !isDone) {
            player.next();
            settle(shown);
        }
        QObject::disconnect(told);
        after(step);
        player.next();
    }
}

struct Shown {
    explicit Shown(const app::ManualPage& page)
    {
        own = &home.desk->current();
        why = showSteps(*own, page);
        settle(home.desk->current());
        window = &home.desk->current();
        player = window->findChild<StepPlayer*>();
    }
    TestDesk home;
    MainWindow* own = nullptr;
    MainWindow* window = nullptr; ///< that shows
    QPointer<StepPlayer> player;
    QString why;
};

} // namespace

class ShowStepsTest : public QObject {
    Q_OBJECT

private slots:
    void everyPageShowsWhatItSays_data()
    {
        QTest::addColumn<QString>("topic");
        int pages = 0;
        for (const QString& topic : app::manualTopics())
            if (!app::manualPage(topic)->shows.isEmpty()) {
                QTest::newRow(qPrintable(topic)) << topic;
                ++pages;
            }
        QVERIFY(pages > 20);
    }
    // Each step changes something, and all of them end as the page says.
    void everyPageShowsWhatItSays()
    {
        QFETCH(QString, topic);
        const auto page = *app::manualPage(topic);
        const auto steps = app::shownSteps(page.shows);
        QVERIFY2(steps, qPrintable(steps.error));
        Shown shown(page);
        QCOMPARE(shown.why, QString());
        QVERIFY(shown.player && shown.window != shown.own);
        const QString own = stateOf(*shown.own);
        QString state;
        QByteArray picture;
        const auto look = [&](std::size_t step) {
            pointAt(*shown.window, steps.value->steps[step]);
            state = stateOf(*shown.window);
            picture = pictureOf(*shown.window);
        };
        const auto compare = [&](std::size_t step) {
            const bool isOther =
                stateOf(*shown.window) != state || pictureOf(*shown.window) != picture;
            const QString words = wordsFor(*shown.window, steps.value->steps[step]);
            QVERIFY2(isOther, qPrintable(QString("step %1 (%2)").arg(step + 1).arg(words)));
        };
        QStringList counts;
        playAll(*shown.player, *shown.window, look, compare);
        for (const app::ShownEnd& end : steps.value->ends)
            counts << QString("%1 %2").arg(end.what).arg(
                shownCount(end.what)->count(*shown.window));
        QVERIFY2(!shown.window->message().contains("did not end"), qPrintable(counts.join(' ')));
        QCOMPARE(shown.window->message(),
                 QString("These were the steps of the page. Your own drawing is as it was."));
        QCOMPARE(stateOf(*shown.own), own);
        QVERIFY(shown.window->session().history.isClean());
    }

    void aCopyHasWhatTheDrawingHas()
    {
        const auto steps = app::shownSteps("copy or nine-regions\nclick 50,90\nends objects +0");
        TestDesk home;
        home.open(home.file("plan.svg"));
        const app::Document& plan = home.desk->current().session().now();
        QCOMPARE(drawingFor(plan, *steps.value).objects(), plan.objects());
        app::ShownSteps outside = *steps.value;
        outside.steps[0].points[0].x = 101; // beside the page
        QVERIFY(drawingFor(plan, outside).objects().size() > plan.objects().size());
        QVERIFY(!drawingFor(app::newDrawing(), *steps.value).objects().empty());
    }

    // Each is one sentence, and nothing is opened.
    void whatCannotBeShownIsSaid_data()
    {
        QTest::addColumn<QString>("steps");
        QTest::addColumn<QString>("why");
        for (const char* key : {"no-such-command", "save", "quit", "print", "copy", "theme-1",
                                "help", "settings", "hard-cases", "full-screen"})
            QTest::newRow(key) << QString("new\ncommand %1\nends objects 1").arg(key)
                               << QString("it has no command \"%1\" to show.").arg(key);
        QTest::newRow("count") << "new\nclick 1,2\nends money +1"
                               << "\"money\" cannot be counted.";
        QTest::newRow("sample") << "no-sample\nclick 1,2\nends objects 1"
                                << "there is no sample \"no-sample\".";
        QTest::newRow("damaged") << "new\ncl"
                                 << "\"cl\" is not understood.";
    }
    void whatCannotBeShownIsSaid()
    {
        QFETCH(QString, steps);
        QFETCH(QString, why);
        const Shown shown(pageOf(steps));
        QCOMPARE(shown.why, "The steps of this page cannot be shown: " + why);
        QCOMPARE(shown.home.desk->count(), 1);
    }

    void withoutRoomForADrawingItIsSaid()
    {
        TestDesk home;
        home.desk->setMost(1);
        MainWindow& own = home.desk->current();
        QCOMPARE(showSteps(own, pageOf("new\nclick 1,2\nends objects +0")), QString());
        QCOMPARE(home.desk->count(), 1);
        QVERIFY(own.message().contains("no more can be"));
        TestWindow alone;
        QVERIFY(showSteps(*alone.window, pageOf("new\nclick 1,2\nends objects +0"))
                    .contains("no place for a further drawing"));
    }

    // Keys that a page types run no command that leaves the drawing.
    void typedKeysDoNotLeaveTheDrawing()
    {
        Shown shown(pageOf("new\ntype Ctrl+S Ctrl+Q Ctrl+C Ctrl+W\nends objects +0"));
        int commands = 0;
        for (const char* key : {"save", "quit", "copy", "close"})
            connect(shown.window->findChild<QAction*>(key), &QAction::triggered, this,
                    [&] { ++commands; });
        playAll(
            *shown.player, *shown.window, [](std::size_t) {}, [](std::size_t) {});
        QCOMPARE(commands, 0);
        QCOMPARE(shown.home.desk->count(), 2);
    }

    void escAndClicksStop()
    {
        for (const bool byKey : {true, false}) {
            Shown shown(
                pageOf("new\ncommand tool-line\nclick 50,50\nclick 90,50\nends objects +1"));
            QVERIFY(shown.player->isPlaying());
            QWidget* area = shown.window->canvas().focusProxy();
            if (byKey)
                QTest::keyClick(area, Qt::Key_Escape);
            else
                QTest::mouseClick(area, Qt::LeftButton);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            QVERIFY(!shown.player && !shown.window->findChild<ShowBar*>());
            QCOMPARE(shown.window->message(),
                     QString("The show has ended. Your own drawing is as it was."));
            QVERIFY(shown.window->session().now().objects().empty());
        }
    }

    // What a person presses meanwhile does nothing, but Enter is "Next step".
    void othersKeysAreHeldBack()
    {
        Shown shown(pageOf("new\ncommand tool-line\nclick 50,50\nends objects +0"));
        QWidget* area = shown.window->canvas().focusProxy();
        QTest::keyClick(area, Qt::Key_R);
        QVERIFY(shown.window->canvas().tool() != "rectangle"); // the show may have begun its step
        QTest::keyClick(area, Qt::Key_Return);
        QVERIFY(shown.window->canvas().tool() == "line");
        QVERIFY(shown.player->isPlaying());
    }

    void anotherTabEndsIt()
    {
        Shown shown(pageOf("new\ncommand tool-line\nclick 50,50\nends objects +0"));
        shown.home.desk->showWindow(*shown.own);
        QCoreApplication::processEvents();
        QVERIFY(!shown.player || !shown.player->isPlaying());
    }

    // It asks nothing, and the person's tool and workspace come back.
    void theDrawingIsClosedAsItCame()
    {
        Shown shown(pageOf("new\ncommand workspace-draw\ncommand tool-line\nclick 50,50\n"
                           "click 90,50\ncommand snap\nends objects +1"));
        playAll(
            *shown.player, *shown.window, [](std::size_t) {}, [](std::size_t) {});
        QCOMPARE(shown.window->session().now().objects().size(), 1U);
        auto* close = shown.window->findChild<MessageStrip*>()->findChild<QPushButton*>();
        QCOMPARE(close->text(), QString("Close this drawing"));
        close->click();
        QCoreApplication::processEvents();
        QCOMPARE(shown.home.desk->count(), 1);
        MainWindow& own = shown.home.desk->current();
        QCOMPARE(&own, shown.own);
        QVERIFY(own.canvas().tool() != "line" && own.canvas().snaps());
        QVERIFY(own.workspace().key == "workspace-cut");
    }

    void aShowInTheDrawingOfAnotherGivesBackTheOwnWorkspace()
    {
        TestDesk home;
        MainWindow& own = home.desk->current();
        own.choose(findWorkspace("workspace-draw"));
        own.canvas().setTool("line");
        MainWindow* from = &own;
        for (int show = 0; show < 2; ++show) {
            QCOMPARE(showSteps(*from, pageOf("new\ncommand snap\nends objects 0")), QString());
            settle(home.desk->current());
            from = &home.desk->current();
            playAll(
                *from->findChild<StepPlayer*>(), *from, [](std::size_t) {}, [](std::size_t) {});
        }
        QCOMPARE(home.desk->count(), 3);
        from->findChild<MessageStrip*>()->findChild<QPushButton*>()->click();
        QCoreApplication::processEvents();
        QCOMPARE(home.desk->count(), 2);
        QVERIFY(home.desk->current().workspace().key == "workspace-draw");
        QCOMPARE(home.desk->current().canvas().tool(), std::string_view("line"));
    }

    void theHelpOffersIt()
    {
        TestDesk home;
        home.run("help");
        auto* help = home.desk->current().findChild<ExplanationWindow*>();
        auto* show = help->findChild<QPushButton*>("show-steps");
        help->showManual("files");
        QVERIFY(!show->isVisible());
        help->showManual("lines");
        QVERIFY(show->isVisible());
        show->click();
        settle(home.desk->current());
        QCOMPARE(home.desk->count(), 2);
        QVERIFY(home.desk->current().findChild<StepPlayer*>()->isPlaying());
        QVERIFY(!help->isVisible()); // it would cover the drawing
        home.desk->showTab(0);
        QTRY_VERIFY(help->isVisible());
    }
};

} // namespace showing_show_steps_test

TEST_CLASS(showing_show_steps_test::ShowStepsTest, Widgets)
#include "tests/ui/showing/show_steps_test.moc"
