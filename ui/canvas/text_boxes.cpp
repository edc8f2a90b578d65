// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/text_boxes.h"

#include "app/overlays/label_places.h"

namespace ui {

constexpr std::size_t mostLinesAround = 20'000; // more lines would take too long

TextBoxes::TextBoxes(const app::Scene& scene, QObject* parent) : QObject(parent), scene_(scene)
{
    connect(&scene, &app::Scene::outdated, this, [this] { view_.reset(); });
}

const std::vector<QRectF>& TextBoxes::in(const app::View& view)
{
    if (view == view_)
        return boxes_;
    view_ = view;
    boxes_.clear();
    if (scene_.lines().size() > mostLinesAround)
        return boxes_;
    std::vector<QLineF> lines;
    lines.reserve(scene_.lines().size());
    for (const app::SceneLines::Run& run : scene_.lines().runs())
        for (const clipping::Segment& segment : run.segments) {
            const app::Point a = view.toScreen(segment.a), b = view.toScreen(segment.b);
            lines.emplace_back(a.x, a.y, b.x, b.y);
        }
    boxes_ = app::boxesOfShortLines(lines, QRectF(0, 0, view.size.x, view.size.y));
    return boxes_;
}

} // namespace ui

#include "moc_text_boxes.cpp"
