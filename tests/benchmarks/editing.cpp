// SPDX-License-Identifier: GPL-3.0-or-later
// Measures what a person waits for while editing many lines in the editor's window of 1280 x 800,
// with real events, until the window is painted again: editing [LINES]
#include "tests/benchmarks/figures.h"
#include "tests/benchmarks/short_lines.h"
#include "tests/ui/test_window.h"

namespace {

class Editing {
public:
    explicit Editing(int lines)
    {
        window_.show();
        window_.window->session().load({shortLines(lines), {}});
        window_.action("fit-drawing")->trigger();
        canvas().settle();
    }

    /// The milliseconds until what an event changed is on the screen.
    template <class Act>
    double wait(Act act)
    {
        canvas().settle(); // the picture before is complete
        return elapsedTime([&] {
            act();
            window_.window->repaint();
            QCoreApplication::processEvents();
        });
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

template <class Act>
Figures several(Act act)
{
    Figures figures;
    for (int i = 0; i < 15; ++i)
        figures.times.push_back(act());
    return figures;
}

} // namespace

int main(int argc, char** argv)
{
    const QApplication application(argc, argv);
    Editing editing(argc > 1 ? QString::fromLocal8Bit(argv[1]).toInt() : 100'000);
    FigureTable table;
    const QPoint corner(60, 60), end(700, 500), by(30, 20);
    table.print("select all", several([&] {
                    editing.key("Escape");
                    return editing.wait([&] { editing.key("Ctrl+A"); });
                }));
    table.print("lines selected", double(editing.selected()), "lines");
    const app::Point before = editing.firstEnd();
    table.print("nudge everything",
                several([&] { return editing.wait([&] { editing.key("Right"); }); }));
    table.print("so far moved", (editing.firstEnd() - before).x, "user units");
    table.print("undo that", several([&] {
                    editing.key("Left");
                    return editing.wait([&] { editing.key("Ctrl+Z"); });
                }));
    table.print("redo that", several([&] {
                    editing.key("Ctrl+Z");
                    return editing.wait([&] { editing.key("Ctrl+Y"); });
                }));
    table.print("drag everything, a frame", several([&] {
                    editing.press(end);
                    editing.move(end + by / 2, Qt::LeftButton);
                    const double frame =
                        editing.wait([&] { editing.move(end + by, Qt::LeftButton); });
                    editing.key("Escape");
                    editing.release(end + by);
                    return frame;
                }));
    table.print("draw a selection box, a frame", several([&] {
                    editing.key("Escape");
                    editing.press(corner, Qt::ShiftModifier);
                    editing.move(corner + by, Qt::LeftButton);
                    const double frame = editing.wait([&] { editing.move(end, Qt::LeftButton); });
                    editing.release(end);
                    return frame;
                }));
    table.print("lines selected by the box", double(editing.selected()), "lines");
    table.print("release a selection box", several([&] {
                    editing.key("Escape");
                    editing.press(corner, Qt::ShiftModifier);
                    editing.move(end, Qt::LeftButton);
                    return editing.wait([&] { editing.release(end); });
                }));
    table.print("delete these, and undo", several([&] {
                    return editing.wait([&] {
                        editing.key("Delete");
                        editing.key("Ctrl+Z");
                    });
                }));
}
