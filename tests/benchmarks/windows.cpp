// SPDX-License-Identifier: GPL-3.0-or-later
// Measures clip windows of every shape: windows MAP.svg [LINES]
// How long lines take with the algorithms that can clip there; five windows at once; and a drawing
// with all closed shapes filled, whose areas are cut anew in each frame while the windows move.
#include "app/document/recipe_outline.h"
#include "app/formats/format.h"
#include "app/scene/window_needs.h"
#include "app/session/samples.h"
#include "app/view/picture.h"

#include <QCoreApplication>

#include <cmath>
#include <numbers>

#include "tests/app/scene/block_scene.h"
#include "tests/benchmarks/figures.h"
#include "tests/benchmarks/short_lines.h"

namespace {

constexpr int rounds = 15;
constexpr double tolerance = 0.05;

app::WindowShape made(const app::Recipe& recipe)
{
    const auto outline = outlineOf(recipe);
    return app::PathShape{app::Path({&*outline, 1}), app::FillRule::NonZero, recipe};
}

struct Shapes {
    app::Point size;

    app::WindowShape upright(double x, double y) const
    {
        return app::RectangleShape{{at(x, y), at(x, y) + 0.25 * size}};
    }
    app::WindowShape rotated(double x, double y) const
    {
        return app::RectangleShape{{at(x, y), at(x, y) + 0.25 * size}, 0.3};
    }
    app::WindowShape circle(double x, double y) const
    {
        return made(app::StarRecipe{at(x, y), radius(), 0, 0, 64});
    }
    app::WindowShape star(double x, double y) const
    {
        return made(app::StarRecipe{at(x, y), radius(), 0.45 * radius(), 0, 5});
    }
    app::Point at(double x, double y) const { return {x * size.x, y * size.y}; }
    double radius() const { return 0.2 * std::min(size.x, size.y); }

    app::ClipRegion one(const app::WindowShape& shape) const
    {
        return app::regionOf({{{.shape = shape}}}, tolerance);
    }
    app::ClipRegion five(double dx) const
    {
        return app::regionOf(
            {{{.shape = rotated(0.1 + dx, 0.1)},
              {.shape = upright(0.5 + dx, 0.05)},
              {.shape = circle(0.3 + dx, 0.65)},
              {.shape = star(0.7 + dx, 0.6)},
              {.shape = circle(0.55 + dx, 0.4), .operation = app::WindowOperation::CutOut}}},
            tolerance);
    }
};

void lines(FigureTable& table, std::size_t count)
{
    const app::Document document = shortLines(int(count));
    BlockScene scene;
    scene.update(document.objects(), {}, tolerance);
    const Shapes shapes{document.page().size};
    struct Row {
        const char* name;
        app::ClipRegion region;
    };
    for (const Row& row : {Row{"rectangle", shapes.one(shapes.upright(0.3, 0.3))},
                           {"rotated rectangle", shapes.one(shapes.rotated(0.3, 0.3))},
                           {"circle of 64 edges", shapes.one(shapes.circle(0.5, 0.5))},
                           {"star", shapes.one(shapes.star(0.5, 0.5))},
                           {"five windows", shapes.five(0)}})
        for (const auto& algorithm : clipping::algorithms())
            if (app::canClip(algorithm, needsOf(row.region)))
                table.print(
                    (std::string(row.name) + ", " + std::string(algorithm.key)).c_str(),
                    Figures::of(rounds, [&](int) { scene.clip(row.region, {&algorithm}); }));
}

app::Objects filled(const app::Document& document)
{
    app::Objects objects;
    for (std::size_t i = 0; i < document.objects().size(); ++i) {
        app::Object object = document.objects()[i].copy();
        if (object.path.hasArea())
            object.style.fill = app::Colour{};
        objects.append(object);
    }
    return objects;
}

void areas(FigureTable& table, const QString& file)
{
    const auto read = app::readFile(file);
    if (!read)
        qFatal("%s", qPrintable(read.error));
    const app::Document& document = read.value->document;
    const app::Objects objects = filled(document);
    BlockScene scene;
    scene.update(objects, document.containers().hiddenRanges(), tolerance);
    const Shapes shapes{document.page().size};
    Figures clips, pictures, prepared;
    for (int i = 0; i < 4 * rounds; ++i) {
        app::ClipRegion region;
        prepared.times.push_back(processorTime([&] { region = shapes.five(0.001 * i); }));
        app::SceneFrame frame;
        clips.times.push_back(
            processorTime([&] { frame = scene.clip(region, {&clipping::exactAlgorithm()}); }));
        app::PictureOptions options;
        options.view.size = {1280, 800};
        options.view.fit(document.page().rectangle());
        options.region = &region;
        pictures.times.push_back(
            processorTime([&] { app::picture(objects.styles(), scene.lines(), frame, options); }));
    }
    table.print("filled map, prepare windows", prepared);
    table.print("filled map, clip lines", clips);
    table.print("filled map, picture with areas", pictures);
    table.print("filled map, objects", double(objects.size()), "objects");
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    const auto arguments = QCoreApplication::arguments();
    const std::size_t count = arguments.value(2).toULongLong();
    FigureTable table;
    lines(table, count > 0 ? count : 100'000);
    areas(table, arguments.value(1, QStringLiteral("resources/samples/street-map.svg")));
}
