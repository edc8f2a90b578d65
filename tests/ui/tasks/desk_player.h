// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/recovery/leftover.h"
#include "ui/explanation/explanation_window.h"
#include "ui/widgets/message_strip.h"
#include "ui/window/drawing_tabs.h"

#include <QApplication>
#include <QClipboard>
#include <QDir>

#include <functional>
#include <vector>

#include "tests/deep.h"
#include "tests/ui/editor/test_desk.h"

// Plays a task with several drawings as a person would: with the keyboard and the mouse in the
// program's window. The drawings are only read, at the end. Files that a person chooses in the
// dialogs of the system are prepared.

namespace desk_tasks {

/// What the objects of a drawing are: their number of points each.
using Counts = std::vector<std::size_t>;

class DeskPlayer {
public:
    /// Two files of one object each, plan.svg and part.svg, which Ctrl+O opens in this order.
    /// `left`: plan.svg was drawn on when the program was killed.
    explicit DeskPlayer(bool left = false)
    {
        home_.file(QStringLiteral("plan.svg"), 5);
        home_.file(QStringLiteral("part.svg"), 9);
        QGuiApplication::clipboard()->setText(QStringLiteral("Wall"));
        if (left)
            leave();
        begin();
        if (left) {
            home_.desk->keepJournals(unsaved());
            home_.desk->offerRecovery();
        }
        settle();
    }

    void key(const QString& sequence)
    {
        const QKeyCombination pressed = QKeySequence(sequence)[0];
        QTest::keyClick(receiver(), pressed.key(), pressed.keyboardModifiers());
        settle();
    }
    void type(const char* text)
    {
        for (const char* c = text; *c; ++c)
            QTest::keyClick(receiver(), *c);
        settle();
    }
    void clickTab(const QString& name, Qt::MouseButton button)
    {
        QTest::mouseClick(&home_.tabs(), button, {}, tabCentre(name));
        settle();
    }
    void dragTab(const QString& name, const QString& onto)
    {
        QTabBar& bar = home_.tabs();
        const QPoint from = tabCentre(name), to = tabCentre(onto) + QPoint(20, 0);
        QTest::mousePress(&bar, Qt::LeftButton, {}, from);
        for (const QPoint& at : {(from + to) / 2, to})
            send(bar, at, {});
        QTest::mouseRelease(&bar, Qt::LeftButton, {}, to);
        settle();
    }
    /// Drags what is drawn at a point onto a tab.
    void carry(const app::Point& from, const QString& tab, Qt::KeyboardModifiers with)
    {
        QWidget& area = *shown().canvas().focusProxy();
        const app::Point on = shown().canvas().view().toScreen(from);
        const QPoint at(qRound(on.x), qRound(on.y));
        const QPoint to = area.mapFromGlobal(home_.tabs().mapToGlobal(tabCentre(tab)));
        QTest::mouseMove(&area, at);
        QTest::mousePress(&area, Qt::LeftButton, {}, at);
        for (const QPoint& place : {at - QPoint(0, 20), to + QPoint(0, 1), to})
            send(area, place, with);
        QTest::mouseRelease(&area, Qt::LeftButton, with, to);
        settle();
    }
    /// Ends the program, and starts it again.
    void startAgain()
    {
        home_.desk->close();
        settle();
        home_.desk.reset();
        begin();
        settle();
    }

    bool isOpen() const { return home_.desk->isVisible(); }
    QStringList tabs() const
    {
        return home_.desk->count() > 1 ? home_.names() : QStringList(shown().files().name());
    }
    QString shownTab() const { return shown().files().name(); }
    int readTabs() const ///< their drawings have been read
    {
        int read = 0;
        for (int i = 0; i < home_.desk->count(); ++i)
            read += home_.desk->isRead(i);
        return read;
    }
    /// Of the drawing in front.
    Counts drawn() const { return countsOf(shown().session().now()); }
    /// Of a file.
    Counts saved(const QString& name) const
    {
        const auto read = app::readFile(home_.folder.filePath(name));
        return read ? countsOf(read.value->document) : Counts();
    }
    QString helpPage() const
    {
        for (const QWidget* top : QApplication::topLevelWidgets())
            if (qobject_cast<const ui::ExplanationWindow*>(top) && top->isVisible())
                return top->windowTitle();
        return {};
    }

private:
    /// Files are prepared, all other questions are asked in the window.
    struct Prepared : ui::Questions {
        Prepared(ui::MainWindow& window, QStringList& files)
            : Questions(window, window.findChild<ui::MessageStrip*>()), files_(files)
        {
        }
        QString fileToOpen(const QString&) override
        {
            return files_.isEmpty() ? QString() : files_.takeFirst();
        }
        QString fileToWrite(const QString&, const QString&, const QString&, const QString&) override
        {
            return {}; // cancelled
        }
        QStringList& files_;
    };

    ui::MainWindow& shown() const { return home_.desk->current(); }
    QString unsaved() const { return home_.folder.filePath(QStringLiteral("unsaved")); }
    void begin()
    {
        home_.desk = std::make_unique<ui::Desk>(ui::Backend::Raster);
        const auto prepare = [this](ui::MainWindow& window) {
            window.setQuestions(std::make_unique<Prepared>(window, toOpen_));
        };
        QObject::connect(home_.desk.get(), &ui::Desk::made, prepare);
        prepare(shown());
        home_.desk->resize(1280, 800);
        static_cast<QWidget&>(*home_.desk).show();
        [[maybe_unused]] const bool exposed = QTest::qWaitForWindowExposed(home_.desk.get());
        home_.desk->activateWindow();
        if (const QString file = home_.desk->restoreTabs(); !file.isEmpty())
            shown().files().open(file);
        settle();
        key(QStringLiteral("Ctrl+Alt+1")); // the workspace Draw
    }
    void leave()
    {
        const QString plan = home_.folder.filePath(QStringLiteral("plan.svg"));
        QDir().mkpath(unsaved());
        auto drawn = app::readFile(plan).value->document;
        drawn.apply(app::adding(drawn, drawn.objects(), drawn.containers().childrenOf(0)[0]));
        app::writeLeftover(drawn,
                           {QStringLiteral("plan.svg"), plan, QFileInfo(plan).lastModified()},
                           app::newLeftoverFile(unsaved()));
    }
    /// Waits until no file is read or written.
    void settle() const
    {
        const auto isBusy = [this] {
            for (int i = 0; i < home_.desk->count(); ++i)
                if (home_.desk->isRead(i) && home_.desk->at(i).files().busy())
                    return true;
            return false;
        };
        QCoreApplication::processEvents();
        (void)QTest::qWaitFor([&] { return !isBusy(); });
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QCoreApplication::processEvents();
        if (isOpen())
            shown().canvas().settle();
    }
    QWidget* receiver() const
    {
        QWidget* active = QApplication::activeWindow();
        QWidget* window = active && active->isVisible() ? active : home_.desk.get();
        return window->focusWidget() ? window->focusWidget() : window;
    }
    /// A place beside all tabs if there is none of that name.
    QPoint tabCentre(const QString& name) const
    {
        const auto tab = int(home_.names().indexOf(name));
        return tab < 0 ? home_.tabs().rect().bottomRight() + QPoint(5, 5)
                       : home_.tabs().tabRect(tab).center();
    }
    static void send(QWidget& to, const QPoint& at, Qt::KeyboardModifiers with)
    {
        QMouseEvent event(QEvent::MouseMove, at, to.mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                          with);
        QCoreApplication::sendEvent(&to, &event);
    }
    static Counts countsOf(const app::Document& drawing)
    {
        Counts counts;
        drawing.objects().forEach(0, drawing.objects().size(),
                                  [&](std::size_t, const app::ObjectView& object) {
                                      std::size_t points = 0;
                                      for (const app::Subpath& path : object.path().subpaths())
                                          points += 1 + path.segments.size();
                                      counts.push_back(points);
                                  });
        return counts;
    }

    ui::TestDesk home_{ui::TestDesk::Answers::Asked};
    QStringList toOpen_{home_.folder.filePath(QStringLiteral("plan.svg")),
                        home_.folder.filePath(QStringLiteral("part.svg"))};
};

struct DeskStep {
    QString what;
    std::function<void(DeskPlayer&)> play;
    int actions = 1;
};
using DeskSteps = std::vector<DeskStep>;
/// What is wrong; empty: nothing.
using DeskFault = std::function<QString(const DeskPlayer&)>;

inline DeskStep key(const QString& sequence)
{
    return {sequence, [sequence](DeskPlayer& player) { player.key(sequence); }};
}
inline DeskStep type(const char* text)
{
    return {QString::fromUtf8(text), [text](DeskPlayer& player) { player.type(text); },
            int(std::strlen(text))};
}
inline DeskStep clickTab(const QString& name, Qt::MouseButton button = Qt::LeftButton)
{
    return {"tab " + name, [=](DeskPlayer& player) { player.clickTab(name, button); }};
}
inline DeskStep dragTab(const QString& name, const QString& onto)
{
    return {"drag tab " + name, [=](DeskPlayer& player) { player.dragTab(name, onto); }};
}
inline DeskStep carry(const app::Point& from, const QString& tab, Qt::KeyboardModifiers with = {})
{
    return {"carry to " + tab, [=](DeskPlayer& player) { player.carry(from, tab, with); }};
}
inline DeskStep startAgain()
{
    return {"start again", [](DeskPlayer& player) { player.startAgain(); }};
}

inline QString faultOf(const DeskSteps& steps, const DeskFault& fault, bool left,
                       std::optional<std::size_t> without = {})
{
    DeskPlayer player(left);
    for (std::size_t i = 0; i < steps.size(); ++i)
        if (i != without)
            steps[i].play(player);
    return fault(player);
}

/// The actions of a task according to the table of README.md.
inline int listedDeskActions(const QString& task)
{
    static const QRegularExpression capital(QStringLiteral("([A-Z])"));
    const QString name = QString(task).replace(capital, QStringLiteral("_\\1")).toLower();
    QFile file(QStringLiteral(SOURCE_DIR "/tests/ui/tasks/README.md"));
    if (!file.open(QIODevice::ReadOnly))
        return -1;
    const QRegularExpression row(QStringLiteral("\n\\| `%1` \\| (\\d+) \\|").arg(name));
    const auto found = row.match(QString::fromUtf8(file.readAll()));
    return found.hasMatch() ? found.captured(1).toInt() : -1;
}

/// Plays the task, and plays it again without each of its steps (each tenth). `fault` says what is
/// wrong, nothing only after all steps.
inline void checkDesk(const DeskSteps& steps, const DeskFault& fault, bool left = false)
{
    int actions = 0;
    for (const DeskStep& step : steps)
        actions += step.actions;
    QCOMPARE(actions, listedDeskActions(QTest::currentTestFunction()));
    const QString wrong = faultOf(steps, fault, left);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    for (std::size_t i = 0; i < steps.size(); i += tests::caseStep())
        QVERIFY2(!faultOf(steps, fault, left, i).isEmpty(),
                 qPrintable(QString("step %1 (%2) is not needed").arg(i + 1).arg(steps[i].what)));
}

} // namespace desk_tasks
