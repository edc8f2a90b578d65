// SPDX-License-Identifier: GPL-3.0-or-later
// Measures what a person waits for while editing many lines in the editor's window of 1280 x 800,
// with real events, until the window is painted again: editing [LINES], or 100,000 and 1,000,000.
// Beside each time that passes is the processor time of the window's thread, which other programs
// disturb less.
#include "tests/benchmarks/figures.h"
#include "tests/benchmarks/short_lines.h"
#include "tests/ui/test_window.h"

namespace {

/// In milliseconds.
struct Waited {
    double passed = 0, processor = 0;
};

class Editing {
public:
    explicit Editing(int lines)
    {
        window_.show();
        window_.window->session().load({shortLines(lines), {}});
        window_.action("fit-drawing")->trigger();
        canvas().settle();
    }

    /// How long it takes until what an event changed is on the screen.
    template <class Act>
    Waited wait(Act act)
    {
        canvas().settle(); // the picture before is complete
        return frame(act);
    }
    /// The same in the middle of a movement, when the picture before may still be coarse.
    template <class Act>
    Waited frame(Act act)
    {
        Waited waited;
        waited.passed = elapsedTime([&] {
            waited.processor = processorTime([&] {
                act();
                window_.window->repaint();
                QCoreApplication::processEvents();
            });
        });
        return waited;
    }
    void wheel(int notches)
    {
        const QPointF at(500, 300);
        QWheelEvent event(at, area()->mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(area(), &event);
    }
    void scroll(const QPoint& by)
    {
        const QPointF at(500, 300);
        QWheelEvent event(at, area()->mapToGlobal(at), by, by, Qt::NoButton, Qt::NoModifier,
                          Qt::ScrollUpdate, false);
        QCoreApplication::sendEvent(area(), &event);
    }
    void key(const QString& sequence)
    {
        const QKeyCombination pressed = QKeySequence(sequence)[0];
        QTest::keyClick(area(), pressed.key(), pressed.keyboardModifiers());
    }
    void press(const QPoint& at, Qt::KeyboardModifiers with = {})
    {
        QTest::mousePress(area(), Qt::LeftButton, with, at);
    }
    void move(const QPoint& at, Qt::MouseButtons buttons)
    {
        QMouseEvent event(QEvent::MouseMove, at, area()->mapToGlobal(at), Qt::NoButton, buttons,
                          {});
        QCoreApplication::sendEvent(area(), &event);
    }
    void release(const QPoint& at) { QTest::mouseRelease(area(), Qt::LeftButton, {}, at); }
    app::Point firstEnd() { return window_.window->session().scene.lines()[0].a; }
    std::size_t selected() { return window_.window->session().selection().size(); }
    ui::Canvas& canvas() { return window_.window->canvas(); }

private:
    QWidget* area() const { return window_.drawingArea(); }
    ui::TestWindow window_;
};

/// Prints the times of something that is done several times.
template <class Act>
void print(FigureTable& table, const QByteArray& what, Act act, int times = 15)
{
    Figures passed, processor;
    for (int i = 0; i < times; ++i) {
        const Waited waited = act();
        passed.times.push_back(waited.passed);
        processor.times.push_back(waited.processor);
    }
    table.print(what, passed);
    table.print(what + ", processor", processor);
}

void measure(int lines)
{
    Editing editing(lines);
    FigureTable table;
    table.print("lines", lines, "");
    const QPoint corner(60, 60), end(700, 500), by(30, 20);
    print(table, "select all", [&] {
        editing.key("Escape");
        return editing.wait([&] { editing.key("Ctrl+A"); });
    });
    table.print("lines selected", double(editing.selected()), "lines");
    const app::Point before = editing.firstEnd();
    print(table, "nudge everything", [&] { return editing.wait([&] { editing.key("Right"); }); });
    table.print("so far moved", (editing.firstEnd() - before).x, "user units");
    print(table, "undo that", [&] {
        editing.key("Left");
        return editing.wait([&] { editing.key("Ctrl+Z"); });
    });
    print(table, "redo that", [&] {
        editing.key("Ctrl+Z");
        return editing.wait([&] { editing.key("Ctrl+Y"); });
    });
    print(table, "drag everything, a frame", [&] {
        editing.press(end);
        editing.move(end + by / 2, Qt::LeftButton);
        const Waited frame = editing.wait([&] { editing.move(end + by, Qt::LeftButton); });
        editing.key("Escape");
        editing.release(end + by);
        return frame;
    });
    print(table, "draw a selection box, a frame", [&] {
        editing.key("Escape");
        editing.press(corner, Qt::ShiftModifier);
        editing.move(corner + by, Qt::LeftButton);
        const Waited frame = editing.wait([&] { editing.move(end, Qt::LeftButton); });
        editing.release(end);
        return frame;
    });
    table.print("lines selected by the box", double(editing.selected()), "lines");
    print(table, "release a selection box", [&] {
        editing.key("Escape");
        editing.press(corner, Qt::ShiftModifier);
        editing.move(end, Qt::LeftButton);
        return editing.wait([&] { editing.release(end); });
    });
    print(table, "delete these, and undo", [&] {
        return editing.wait([&] {
            editing.key("Delete");
            editing.key("Ctrl+Z");
        });
    });
    print(
        table, "pan, a frame",
        [&, i = 0]() mutable {
            return editing.frame([&] { editing.scroll({++i % 60 < 30 ? 7 : -7, 3}); });
        },
        60);
    print(
        table, "zoom, a frame",
        [&, i = 0]() mutable { return editing.frame([&] { editing.wheel(++i <= 30 ? 1 : -1); }); },
        60);
}

} // namespace

int main(int argc, char** argv)
{
    const QApplication application(argc, argv);
    if (argc > 1)
        return measure(QString::fromLocal8Bit(argv[1]).toInt()), 0;
    for (const int lines : {100'000, 1'000'000})
        measure(lines);
}
