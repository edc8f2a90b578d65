// SPDX-License-Identifier: GPL-3.0-or-later
// Measures what it takes to open a file, until its picture is on a canvas of 1280 x 800:
// opening FILE
// or writes the file to be opened with a drawing (drawings.h) in it:
// opening FILE DRAWING
#include "app/base/variant.h"
#include "app/view/raster.h"
#include "ui/canvas/canvas.h"

#include <QApplication>

#include "tests/app/scene/block_scene.h"
#include "tests/benchmarks/drawings.h"
#include "tests/benchmarks/figures.h"
#include "tests/benchmarks/used_memory.h"

namespace {

void write(const QString& path, const QString& drawing)
{
    if (const auto fault = app::writeFile(drawingOf(drawing).document, path, {}))
        qFatal("%s", qPrintable(*fault));
}

app::SceneFrame clip(const app::Session& session)
{
    static FrameClipping clipping;
    return clipping.clip(session.scene.lines(), session.region(), {&app::usualAlgorithm()});
}

app::Picture picture(app::Session& session, const app::SceneFrame& frame)
{
    app::PictureOptions options;
    options.view.size = {1280, 800};
    options.view.fit(session.now().page().rectangle());
    return app::picture(session.now().styles(), session.scene.lines(), frame, options);
}

// A stage of opening: what it takes, and the most memory until its end.
template <class Work>
double stage(FigureTable& table, const std::string& what, Work work)
{
    double elapsed = 0;
    const double busy = processorTime([&] { elapsed = elapsedTime(work); });
    table.print(what.c_str(), elapsed, "ms");
    table.print((what + ", processor").c_str(), busy, "ms");
    table.print((what + ", most memory").c_str(), peakMegabytes(), "MB");
    return elapsed;
}

// The parts of a frame, once it has been shown.
void printParts(FigureTable& table, app::Session& session)
{
    const auto five = [&](const char* what, auto work) {
        table.print(what, Figures::of(5, [&](int) { work(); }));
    };
    five("clip", [&] { clip(session); });
    const app::SceneFrame frame = clip(session);
    five("make a picture with ghosts", [&] { picture(session, frame); });
    const app::Picture made = picture(session, frame);
    five("paint it, 1 thread", [&] {
        app::rasterised(made, {0, 800}, {.width = 1280, .ghost = 0.25});
    });
}

} // namespace

int main(int argc, char** argv)
{
    const QApplication application(argc, argv);
    if (argc != 2 && argc != 3)
        qFatal("Usage: opening FILE [DRAWING]");
    const QString path = QString::fromLocal8Bit(argv[1]);
    if (argc == 3)
        return write(path, QString::fromLocal8Bit(argv[2])), 0;
    FigureTable table;
    table.print("before opening, most memory", peakMegabytes(), "MB");
    std::optional<app::Imported> read;
    app::Session session;
    double sum = stage(table, "read", [&] { read = drawingOf(path); });
    sum += stage(table, "load", [&] { session.load(*std::exchange(read, {})); });
    ui::Canvas canvas(session, ui::Backend::Raster);
    canvas.resize(1280 + 20, 800 + 20); // with the rulers
    sum += stage(table, "show", [&] {
        canvas.show();
        QCoreApplication::processEvents();
        canvas.repaint();
    });
    sum += stage(table, "show in full quality", [&] { canvas.settle(); });
    table.print("all of that", sum, "ms");
    table.print("lines", double(session.scene.lines().size()), "lines");
    printParts(table, session);
}
