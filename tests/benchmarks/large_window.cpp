// SPDX-License-Identifier: GPL-3.0-or-later
// Measures what a person waits for who makes and moves a clip window with many edges in the
// editor's window of 1280 x 800, until the window is painted again: large_window [EDGES [LINES]]
#include "app/document/affine_map.h"
#include "app/document/window_shape.h"
#include "app/session/window_steps.h"

#include <cmath>
#include <numbers>

#include "tests/benchmarks/figures.h"
#include "tests/benchmarks/short_lines.h"
#include "tests/ui/test_window.h"

namespace {

constexpr int rounds = 3;

/// A coast: a circle whose radius changes at random.
app::WindowShape coast(int edges, const app::Point& middle, double radius)
{
    app::Subpath path{{}, {}, true};
    double rough = 1;
    for (int i = 0; i < edges; ++i) {
        rough += (double((i * 7919) % 101) / 100 - 0.5) * 0.001;
        const double angle = 2 * std::numbers::pi * i / edges;
        const app::Point at =
            middle + radius * rough * app::Point(std::cos(angle), std::sin(angle));
        if (i == 0)
            path.start = at;
        else
            path.segments.push_back({at});
    }
    return app::PathShape{app::Path({&path, 1})};
}

class Editing {
public:
    explicit Editing(int lines)
    {
        window_.show();
        session().load({shortLines(lines), {}});
        window_.action("fit-drawing")->trigger();
        window_.window->canvas().setTool("window");
        settle();
    }
    app::Session& session() { return window_.window->session(); }
    void settle() { window_.window->canvas().settle(); }
    void paint()
    {
        window_.window->repaint();
        QCoreApplication::processEvents();
    }
    void mouse(QEvent::Type type, const QPoint& at)
    {
        const auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
        const auto buttons = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
        QMouseEvent event(type, at, area()->mapToGlobal(at), button, buttons, {});
        QCoreApplication::sendEvent(area(), &event);
    }
    void hover(const QPoint& at)
    {
        QMouseEvent event(QEvent::MouseMove, at, area()->mapToGlobal(at), Qt::NoButton,
                          Qt::NoButton, {});
        QCoreApplication::sendEvent(area(), &event);
    }
    QPoint middle() { return area()->rect().center(); }

private:
    QWidget* area() const { return window_.drawingArea(); }
    ui::TestWindow window_;
};

template <class Act>
void print(FigureTable& table, const QByteArray& what, Act act)
{
    table.print(what, Figures::of(rounds, act));
}

} // namespace

int main(int argc, char** argv)
{
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    const auto arguments = QCoreApplication::arguments();
    const int edges = arguments.value(1, "100000").toInt(),
              lines = arguments.value(2, "100000").toInt();
    Editing editing(lines);
    app::Session& session = editing.session();
    const app::Point size = session.now().page().size;
    const app::WindowShape shape = coast(edges, 0.5 * size, 0.3 * std::min(size.x, size.y));
    FigureTable table;
    print(table, "prepare the region alone",
          [&](int) { app::regionOf(app::ClipWindows{{{.shape = shape}}}, session.now().page()); });
    print(table, "make the window", [&](int) {
        app::addWindow(session, {.shape = shape});
        editing.paint();
        session.history.undo();
    });
    app::addWindow(session, {.shape = shape});
    editing.paint();
    print(table, "paint again", [&](int) { editing.paint(); });
    print(table, "pan the pointer", [&](int i) {
        editing.hover(editing.middle() + QPoint(20 + i, 30));
        editing.paint();
    });
    print(table, "move by a field", [&](int i) {
        app::setWindowShape(session, app::mapped(shape, app::translation({i + 1.0, 0})),
                            "Move clip window");
        editing.paint();
    });
    editing.mouse(QEvent::MouseButtonPress, editing.middle());
    print(table, "a frame of a drag", [&](int i) {
        editing.mouse(QEvent::MouseMove, editing.middle() + QPoint(10 + 5 * i, 10));
        editing.paint();
    });
    print(table, "end of the drag", [&](int i) {
        if (i == 0)
            editing.mouse(QEvent::MouseButtonRelease, editing.middle() + QPoint(10, 10));
        editing.paint();
    });
    return 0;
}
