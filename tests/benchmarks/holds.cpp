// SPDX-License-Identifier: GPL-3.0-or-later
// How long events hold the interface's thread, on a drawing of long lines (both ends anywhere on
// the page, as in the paper) or on a file, while random events come: holds [LINES|FILE [EVENTS
// [SEED]]] Of each kind of event, the longest in processor time is printed, which other programs on
// the machine do not make longer.
#include "app/base/clock.h"

#include <QElapsedTimer>
#include <QMetaEnum>
#include <QTextStream>
#include <QWheelEvent>

#include <algorithm>
#include <ctime>
#include <map>
#include <random>
#include <ranges>

#include "tests/benchmarks/drawings.h"
#include "tests/ui/test_window.h"

namespace {

constexpr double most = 8; // milliseconds

double processorMs()
{
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6;
}

/// Measures each event from its delivery until its receiver returns, with all that it causes.
class WatchedApplication : public QApplication {
public:
    using QApplication::QApplication;

    struct Hold {
        double processor = 0, wall = 0;
        QString during; ///< what the person did
        int longer = 0; ///< how many events took more than the limit
    };
    QString doing;
    std::map<QString, Hold> holds;

    bool notify(QObject* receiver, QEvent* event) override
    {
        if (depth_ > 0)
            return QApplication::notify(receiver, event);
        const QString what = nameOf(*receiver, *event);
        return watched(what, [&] { return QApplication::notify(receiver, event); });
    }
    template <class Work>
    bool watched(const QString& what, const Work& work)
    {
        ++depth_;
        QElapsedTimer clock;
        clock.start();
        const double before = processorMs();
        const bool result = work();
        note(what, processorMs() - before, double(clock.nsecsElapsed()) * 1e-6);
        --depth_;
        return result;
    }

private:
    static QString nameOf(const QObject& receiver, const QEvent& event)
    {
        const char* type = QMetaEnum::fromType<QEvent::Type>().valueToKey(event.type());
        return QStringLiteral("%1 %2").arg(QLatin1StringView(receiver.metaObject()->className()),
                                           QLatin1StringView(type ? type : "event"));
    }
    void note(const QString& what, double processor, double wall)
    {
        Hold& hold = holds[what];
        hold.longer += processor > most;
        if (processor <= hold.processor)
            return;
        hold.processor = processor;
        hold.wall = wall;
        hold.during = doing;
    }

    int depth_ = 0;
};

WatchedApplication& application() { return *static_cast<WatchedApplication*>(qApp); }

/// A person at the window: every gesture is made of events.
class Person {
public:
    Person(ui::TestWindow& test, unsigned seed) : test_(test), random_(seed) {}

    void act()
    {
        static constexpr std::pair<const char*, void (Person::*)()> acts[]{
            {"hover", &Person::hover},
            {"hover", &Person::hover},
            {"wheel", &Person::wheel},
            {"drag the window", &Person::dragWindow},
            {"drag the window", &Person::dragWindow},
            {"drag anything", &Person::drag},
            {"click", &Person::click},
            {"key", &Person::key},
            {"command", &Person::command},
            {"resize", &Person::resize}};
        const auto& [name, act] = acts[below(std::size(acts))];
        application().doing = QLatin1StringView(name);
        (this->*act)();
        application().doing += QStringLiteral(", afterwards");
        for (int i = below(4); i >= 0; --i)
            turn();
    }
    void wheel()
    {
        QWidget* area = test_.drawingArea();
        const QPointF at = place();
        QWheelEvent event(at, area->mapToGlobal(at), {}, {0, below(2) ? 120 : -120}, Qt::NoButton,
                          below(4) ? Qt::NoModifier : Qt::ShiftModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(area, &event);
    }
    void turn() { QCoreApplication::processEvents(QEventLoop::AllEvents, 5); }

private:
    std::size_t below(std::size_t bound) { return random_() % bound; }
    QPoint place()
    {
        const QSize size = test_.drawingArea()->size();
        return {int(below(std::size_t(size.width()))), int(below(std::size_t(size.height())))};
    }
    void move(const QPointF& at, Qt::MouseButtons buttons)
    {
        QWidget* area = test_.drawingArea();
        QMouseEvent event(QEvent::MouseMove, at, area->mapToGlobal(at), Qt::NoButton, buttons,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(area, &event);
        turn();
    }
    void dragFrom(const QPoint& from)
    {
        QTest::mousePress(test_.drawingArea(), Qt::LeftButton, {}, from);
        const QPoint to = place();
        for (int i = 1; i <= 6; ++i)
            move(from + (to - from) * i / 6.0, Qt::LeftButton);
        QTest::mouseRelease(test_.drawingArea(), Qt::LeftButton, {}, to);
    }
    void hover()
    {
        for (int i = 0; i < 4; ++i)
            move(place(), Qt::NoButton);
    }
    void drag() { dragFrom(place()); }
    void dragWindow()
    {
        QTest::keyClick(test_.drawingArea(), Qt::Key_W);
        const auto window = test_.window->session().clipWindow();
        if (!window)
            return;
        const app::Point at = test_.window->canvas().view().toScreen(
            below(2) ? (window->min + window->max) * 0.5 : window->max);
        if (test_.drawingArea()->rect().contains(int(at.x), int(at.y)))
            dragFrom({int(at.x), int(at.y)});
    }
    void click() { QTest::mouseClick(test_.drawingArea(), Qt::LeftButton, {}, place()); }
    void key()
    {
        static constexpr Qt::Key keys[]{Qt::Key_1,      Qt::Key_3, Qt::Key_5,    Qt::Key_6,
                                        Qt::Key_V,      Qt::Key_W, Qt::Key_Left, Qt::Key_Down,
                                        Qt::Key_Escape, Qt::Key_H, Qt::Key_F3};
        QTest::keyClick(test_.drawingArea(), keys[below(std::size(keys))]);
    }
    void command()
    {
        static constexpr const char* commands[]{"fit-drawing",    "fit-window",     "deselect",
                                                "select-all",     "undo",           "redo",
                                                "removed-hidden", "removed-ghosted"};
        const char* name = commands[below(std::size(commands))];
        QAction* action = test_.action(name);
        if (!action)
            qFatal("there is no command %s", name);
        application().doing = QLatin1StringView(name);
        application().watched(QStringLiteral("command ") + QLatin1StringView(name), [&] {
            action->trigger();
            return true;
        });
    }
    void resize() { test_.window->resize(1100 + int(below(200)), 700 + int(below(160))); }

    ui::TestWindow& test_;
    std::mt19937 random_;
};

void print(QTextStream& out)
{
    std::vector<std::pair<QString, WatchedApplication::Hold>> all(application().holds.begin(),
                                                                  application().holds.end());
    std::ranges::sort(all, std::greater(), [](const auto& each) { return each.second.processor; });
    int longer = 0;
    for (const auto& [what, hold] : all)
        longer += hold.longer;
    out << "events that held the thread more than " << most << " ms: " << longer
        << "\nlongest, ms of processor time (wall)\n";
    for (const auto& [what, hold] : all | std::views::take(25))
        out << qSetFieldWidth(9) << Qt::right << Qt::fixed << qSetRealNumberPrecision(1)
            << hold.processor << qSetFieldWidth(0) << "  (" << hold.wall << ")  " << what
            << (hold.longer > 1 ? QStringLiteral(", %1 times more than the limit").arg(hold.longer)
                                : QString())
            << ", during: " << hold.during << '\n';
}

} // namespace

int main(int argc, char** argv)
{
    WatchedApplication watched(argc, argv);
    QTextStream out(stdout);
    const QString drawing =
        argc > 1 ? QString::fromLocal8Bit(argv[1]) : QStringLiteral("long1000000");
    const int events = argc > 2 ? QByteArray(argv[2]).toInt() : 200;
    ui::TestWindow test;
    test.show();
    QElapsedTimer clock;
    clock.start();
    Person person(test, argc > 3 ? QByteArray(argv[3]).toUInt() : 1);
    watched.doing = QStringLiteral("opening");
    if (!QFile::exists(drawing)) {
        app::Imported made = drawingOf(drawing);
        watched.watched(QStringLiteral("loading"), [&] {
            test.window->session().load(std::move(made));
            return true;
        });
    } else {
        test.open(drawing);
    }
    out << test.window->session().scene.lines().size() << " lines, " << events << " events\n";
    person.wheel(); // before the first picture
    person.turn();
    for (int i = 0; i < events; ++i)
        person.act();
    out << "seconds: " << double(clock.elapsed()) * 1e-3 << '\n';
    print(out);
    return 0;
}
