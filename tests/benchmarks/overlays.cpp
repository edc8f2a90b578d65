// SPDX-License-Identifier: GPL-3.0-or-later
// Measures what it costs to show what an algorithm sees while the pointer moves, at 1280 x 800 on
// many scattered lines, and paints every algorithm's overlay for lines of every kind:
// overlays [LINES] [FOLDER [light|dark]]
#include "ui/canvas/canvas.h"
#include "ui/look/look.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QTextStream>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "tests/app/document/sheet.h"

namespace {

app::Shape shapeOf(const clipping::Segment& line, const app::Colour& colour)
{
    app::Shape shape;
    shape.style.stroke = colour;
    shape.paths.push_back({line.a, {{line.b}}, false});
    return shape;
}

app::Sheet sheet()
{
    app::Sheet sheet;
    sheet.page = {{0, 0}, {1280, 800}, {1280, app::Unit::Px}, {800, app::Unit::Px}};
    sheet.window = {{400, 280}, {880, 560}};
    return sheet;
}

app::Sheet shortLines(int count)
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> x(0, 1280), y(0, 800), length(3, 17), angle(0, 2 * M_PI);
    app::Sheet all = sheet();
    for (int i = 0; i < count; ++i) {
        const app::Point a(x(random), y(random));
        const double l = length(random), t = angle(random);
        all.shapes.push_back(shapeOf({a, a + l * app::Point(std::cos(t), std::sin(t))}, {}));
    }
    return all;
}

struct Kind {
    const char* name;
    clipping::Segment line;
};
constexpr std::array kinds{Kind{"inside", {{500, 350}, {760, 480}}},
                           Kind{"one-edge", {{520, 400}, {1050, 610}}},
                           Kind{"two-edges", {{200, 380}, {760, 690}}},
                           Kind{"across-corners", {{220, 640}, {1010, 190}}},
                           Kind{"near-miss", {{180, 360}, {620, 90}}},
                           Kind{"trivial", {{450, 120}, {830, 200}}},
                           Kind{"horizontal", {{150, 420}, {1120, 420}}},
                           Kind{"vertical", {{640, 90}, {640, 480}}},
                           Kind{"point", {{300, 180}, {300, 180}}}};

void moveTo(QWidget& surface, const QPointF& at)
{
    QMouseEvent event(QEvent::MouseMove, at, surface.mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                      Qt::NoModifier);
    QCoreApplication::sendEvent(&surface, &event);
}

double medianOfHovering(ui::Canvas& canvas)
{
    std::vector<double> times;
    for (int i = 0; i < 41; ++i) {
        QElapsedTimer clock;
        clock.start();
        moveTo(*canvas.focusProxy(), QPointF(200 + 9 * i, 300 + 5 * i));
        canvas.repaint();
        QCoreApplication::processEvents();
        times.push_back(double(clock.nsecsElapsed()) * 1e-6);
    }
    std::ranges::nth_element(times, times.begin() + 20);
    return times[20];
}

void measure(app::Session& session, ui::Canvas& canvas, QTextStream& out)
{
    canvas.setTool("select");
    for (const clipping::Algorithm& algorithm : clipping::algorithms()) {
        app::Display display = session.display();
        display.variant.algorithm = &algorithm;
        out << algorithm.abbreviation.data() << ": a frame while hovering";
        for (const bool on : {false, true}) {
            display.overlay = on;
            session.setDisplay(display);
            canvas.settle();
            medianOfHovering(canvas);
            out << (on ? ", with the overlay " : " ") << medianOfHovering(canvas) << " ms";
        }
        out << '\n';
        out.flush();
    }
}

void paintAll(app::Session& session, ui::Canvas& canvas, const QDir& folder)
{
    app::Sheet lines = sheet();
    for (const Kind& kind : kinds)
        lines.shapes.push_back(shapeOf(kind.line, {90, 90, 90}));
    session.load({app::documentOf(lines), {}});
    app::Display display = session.display();
    display.overlay = true;
    for (const clipping::Algorithm& algorithm : clipping::algorithms()) {
        display.variant.algorithm = &algorithm;
        session.setDisplay(display);
        const auto save = [&](const QString& kind) {
            canvas.settle();
            QCoreApplication::processEvents();
            canvas.settle();
            canvas.grab().save(folder.filePath(
                QStringLiteral("%1-%2.png").arg(algorithm.abbreviation.data(), kind)));
        };
        session.inspect(std::nullopt);
        moveTo(*canvas.focusProxy(), QPointF(250, 600));
        save(QStringLiteral("none"));
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            session.inspect(i);
            save(QString::fromLatin1(kinds[i].name));
        }
        session.inspect(2);
        canvas.setZoom(4);
        save(QStringLiteral("near"));
        canvas.setZoom(0.15);
        save(QStringLiteral("far"));
        canvas.fitPage();
    }
    session.inspect(3);
    for (const int count : {4, 12}) {
        app::Panes panes = canvas.panes();
        count > 4 ? panes.showAll() : panes.show(std::size_t(count));
        canvas.setPanes(panes);
        canvas.fitPage();
        canvas.settle();
        canvas.grab().save(folder.filePath(QStringLiteral("panes-%1.png").arg(count)));
    }
}

} // namespace

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    const bool dark = argc > 3 && QByteArray(argv[3]) == "dark";
    ui::applyTheme(application, dark ? ui::Theme::Dark : ui::Theme::Light);
    QTextStream out(stdout);
    app::Session session;
    const int lines = argc > 1 ? QByteArray(argv[1]).toInt() : 100'000;
    session.load({app::documentOf(shortLines(lines)), {}});
    ui::Canvas canvas(session, ui::Backend::Raster);
    canvas.resize(1280 + 20, 800 + 20);
    canvas.show();
    canvas.settle();
    if (lines > 0)
        measure(session, canvas, out);
    if (argc > 2)
        paintAll(session, canvas, QDir(QString::fromLocal8Bit(argv[2])));
    return 0;
}
