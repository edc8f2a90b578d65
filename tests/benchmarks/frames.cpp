// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the canvas on a drawing (drawings.h), 1280 x 800 unless told:
// frames [DRAWING] [raster|gl] [WIDTHxHEIGHT] [PICTURE.png]
// Also what it takes while all algorithms race on each frame, the frames of a dragged window for
// each row, and the memory. frames_table.py runs it on the drawings of the table in figures.md.
#include "app/experiment/block.h"
#include "app/race/live_race.h"
#include "ui/canvas/canvas.h"
#include "ui/canvas/pane_widget.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTextStream>
#include <QWheelEvent>

#include <algorithm>
#include <functional>
#include <map>

#include "tests/app/document/one_window.h"
#include "tests/benchmarks/drawings.h"
#include "tests/benchmarks/used_memory.h"

namespace {

double milliseconds(const QElapsedTimer& clock) { return double(clock.nsecsElapsed()) * 1e-6; }

struct Figures {
    std::vector<double> times;
    void print(QTextStream& out, const char* what)
    {
        std::ranges::sort(times);
        out << qSetFieldWidth(34) << Qt::left << what << qSetFieldWidth(0) << "median "
            << times[times.size() / 2] << " ms, worst " << times.back() << " ms\n";
    }
};

// One frame as a person sees it: the event, and until everything that it asked for is on the
// screen.
template <class Act>
double frame(
    QWidget& window, Act act, const std::function<void()>& finish = [] {})
{
    QElapsedTimer clock;
    clock.start();
    act();
    window.repaint();
    QCoreApplication::processEvents();
    finish();
    return milliseconds(clock);
}

void wheel(QWidget& surface, int notches)
{
    const QPointF at(500, 300);
    QWheelEvent event(at, surface.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&surface, &event);
}

void pan(QWidget& surface)
{
    QWheelEvent event({500, 300}, {500, 300}, {7, 3}, {7, 3}, Qt::NoButton, Qt::NoModifier,
                      Qt::ScrollUpdate, false);
    QCoreApplication::sendEvent(&surface, &event);
}

void hover(QWidget& surface, const QPointF& at)
{
    QMouseEvent event(QEvent::MouseMove, at, surface.mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                      Qt::NoModifier);
    QCoreApplication::sendEvent(&surface, &event);
}

constexpr std::size_t huge = 3'000'000; // lines; fewer frames are timed, in one pane only

// The frames of a window that is dragged; each is over when `finish` says so.
Figures moved(app::Session& session, ui::Canvas& canvas, const std::function<void()>& finish)
{
    const clipping::Window start = session.window();
    Figures figures;
    const int frames = session.scene.lines().size() > huge ? 6 : 30;
    for (int i = 0; i < frames; ++i) {
        const app::Point by(i, 0);
        const auto move = [&] {
            session.setPreview(
                {.windows = withWindow(session.now().windows(),
                                       clipping::Window{start.min + by, start.max + by}),
                 .drag = app::Preview::Drag::Moving});
        };
        figures.times.push_back(frame(canvas, move, finish));
    }
    session.setPreview({});
    return figures;
}

// Until the cut is seen in all panes of the canvas, at first perhaps a rough picture of it
// (FrameWish::rough).
class UntilSeen : public QObject {
public:
    explicit UntilSeen(ui::Canvas& canvas)
    {
        connect(&canvas, &ui::Canvas::frameShown, this,
                [this](const app::FrameTimes& times) { shown = times; });
        for (ui::PaneWidget* pane : canvas.findChildren<ui::PaneWidget*>())
            connect(pane, &ui::PaneWidget::frameShown, this,
                    [this, pane](const app::FrameTimes& times) {
                        painting_[pane] = times.painting && pane->isVisible();
                    });
    }
    void operator()() const
    {
        while (std::ranges::any_of(painting_, [](const auto& pane) { return pane.second; }))
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    app::FrameTimes shown; ///< of the active pane

private:
    std::map<ui::PaneWidget*, bool> painting_;
};

void printPanes(QTextStream& out, app::Session& session, ui::Canvas& canvas)
{
    for (const int count : {2, 4, 12, 1}) {
        app::Panes many = canvas.panes();
        count > 4 ? many.showAll() : many.show(std::size_t(count));
        canvas.setPanes(many);
        canvas.settle();
        UntilSeen untilSeen(canvas);
        moved(session, canvas, std::ref(untilSeen))
            .print(out, qPrintable(QStringLiteral("the cut is seen in panes: %1").arg(count)));
        canvas.settle();
        moved(session, canvas, [&] {
            canvas.settle();
        }).print(out, qPrintable(QStringLiteral("in full quality, panes: %1").arg(count)));
        out.flush();
    }
}

// For each row, from a moved window until the picture of its cut is seen.
void printRows(QTextStream& out, app::Session& session, ui::Canvas& canvas)
{
    const UntilSeen untilSeen(canvas);
    const app::Variant before = session.variant();
    out << "the window moves, by rows:        clipping, the cut is seen after, worst, ms; lines "
           "that differ\n";
    std::vector<const clipping::Algorithm*> all;
    for (const clipping::Algorithm& algorithm : clipping::algorithms())
        all.push_back(&algorithm);
    for (const app::Variant& variant : app::variantsOf(all)) {
        session.changeDisplay([&](app::Display& display) { display.variant = variant; });
        canvas.settle();
        Figures clip, seen = moved(session, canvas, [&] {
                          untilSeen();
                          clip.times.push_back(untilSeen.shown.clipMs);
                      });
        std::ranges::sort(clip.times);
        std::ranges::sort(seen.times);
        out << qSetFieldWidth(34) << Qt::left << keyOf(variant) << qSetFieldWidth(0)
            << clip.times[clip.times.size() / 2] << ", " << seen.times[seen.times.size() / 2]
            << ", " << seen.times.back() << ", " << untilSeen.shown.differing << '\n';
        out.flush();
    }
    session.changeDisplay([&](app::Display& display) { display.variant = before; });
}

void compare(QTextStream& out, app::Session& session, ui::Canvas& canvas)
{
    app::LiveRace race(session.document, session.scene);
    QObject::connect(&session, &app::Session::previewChanged, &race,
                     [&] { race.setWindow(session.window()); });
    std::vector<const clipping::Algorithm*> all;
    for (const clipping::Algorithm& algorithm : clipping::algorithms())
        all.push_back(&algorithm);
    race.setVariants(app::variantsOf(all));
    const auto inFull = [&] { canvas.settle(); }; // or painting threads would run beside the race
    const auto raced = [&] {
        canvas.settle();
        while (!race.upToDate())
            QCoreApplication::processEvents();
    };
    moved(session, canvas, inFull).print(out, "window moves, full quality");
    race.start();
    moved(session, canvas, raced).print(out, "the same, each frame raced on");
    double sum = 0;
    for (const app::RaceRow& row : race.rows())
        sum += row.summary().median;
    out << "sum of the algorithms' medians           " << sum << " ms\n";
    moved(session, canvas, [] {}).print(out, "window moves, a race behind it");
    race.stop();
    moved(session, canvas, [] {}).print(out, "window moves, the race is over");
    moved(session, canvas, inFull).print(out, "the same, full quality");
}

} // namespace

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    const bool gl = argc > 2 && QByteArray(argv[2]) == "gl";
    const QList<QByteArray> size = argc > 3 ? QByteArray(argv[3]).split('x') : QList<QByteArray>();
    const QString picture = argc > 4 ? QString::fromLocal8Bit(argv[4]) : QString();
    QTextStream out(stdout);
    app::Session session;
    session.load(drawingOf(QString::fromLocal8Bit(argc > 1 ? argv[1] : "100000")));
    QElapsedTimer clock;
    clock.start();
    ui::Canvas canvas(session, gl ? ui::Backend::OpenGL : ui::Backend::Raster);
    std::vector<double> clip;
    QObject::connect(&canvas, &ui::Canvas::frameShown,
                     [&](const app::FrameTimes& t) { clip.push_back(t.clipMs); });
    const bool sized = size.size() == 2 && size[0].toInt() > 0 && size[1].toInt() > 0;
    if (argc > 3 && !sized)
        qFatal("Usage: frames [DRAWING] [raster|gl] [WIDTHxHEIGHT] [PICTURE.png]");
    canvas.resize(20 + (sized ? size[0].toInt() : 1280), 20 + (sized ? size[1].toInt() : 800));
    canvas.show();
    QCoreApplication::processEvents();
    out << session.scene.lines().size() << " lines, " << canvas.backendReason()
        << "\nfirst frame after " << milliseconds(clock) << " ms";
    canvas.settle();
    out << ", in full quality after " << milliseconds(clock) << " ms\n";
    out.flush();

    QWidget& surface = *canvas.focusProxy();
    const UntilSeen untilSeen(canvas);
    Figures panned, zoomed, rest, drag, seen;
    canvas.setTool("hand");
    for (int i = 0; i < 30; ++i)
        panned.times.push_back(frame(
            canvas, [&] { pan(surface); }, std::ref(untilSeen)));
    for (int i = 0; i < 60; ++i)
        zoomed.times.push_back(frame(canvas, [&] { wheel(surface, i < 30 ? 1 : -1); }));
    for (int i = 0; i < 10; ++i) {
        wheel(surface, i % 2 ? 1 : -1);
        clock.start();
        canvas.settle();
        rest.times.push_back(milliseconds(clock));
    }
    drag = moved(session, canvas, [] {});
    seen = moved(session, canvas, std::ref(untilSeen));
    Figures hovered;
    canvas.setTool("select");
    for (int i = 0; i < 60; ++i)
        hovered.times.push_back(
            frame(canvas, [&] { hover(surface, QPointF(200 + 7 * i, 300 + 3 * i)); }));
    canvas.fitPage();
    Figures{clip}.print(out, "clipping of all lines, a frame");
    panned.print(out, "panning, until it is seen");
    zoomed.print(out, "frame while zooming");
    drag.print(out, "frame while the window moves");
    seen.print(out, "the window moves, its cut is seen");
    hovered.print(out, "frame while hovering");
    rest.print(out, "full quality after rest");
    const bool isHuge = session.scene.lines().size() > huge;
    if (!isHuge)
        printPanes(out, session, canvas);
    printRows(out, session, canvas);
    if (!isHuge)
        compare(out, session, canvas);
    out << "memory at most " << peakMegabytes() << " MB\n";
    canvas.settle();
    if (!picture.isEmpty())
        canvas.grab().save(picture);
    return 0;
}
