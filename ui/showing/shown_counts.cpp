// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/showing/shown_counts.h"

#include "app/base/text.h"
#include "app/document/paper.h"
#include "ui/window/main_window.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {

namespace {

using app::Container;
using Window = MainWindow;

template <Container::Kind kind>
double containers(const Window& window)
{
    const app::Containers& all = window.session().now().containers();
    return double(std::ranges::count_if(all.inOrder(),
                                        [&](app::ContainerId id) { return all[id].kind == kind; }));
}

double paths(const Window& window)
{
    std::size_t count = 0;
    const app::Objects& objects = window.session().now().objects();
    objects.forEach(0, objects.size(), [&](std::size_t, const app::ObjectView& object) {
        count += object.path().subpaths().size();
    });
    return double(count);
}

double segments(const Window& window)
{
    std::size_t count = 0;
    const app::Objects& objects = window.session().now().objects();
    objects.forEach(0, objects.size(), [&](std::size_t, const app::ObjectView& object) {
        for (const app::Subpath& path : object.path().subpaths())
            count += path.segments.size() + path.closed;
    });
    return double(count);
}

/// From 1, as the digits choose them.
double algorithm(const Window& window)
{
    const auto& all = clipping::algorithms();
    return double(window.session().display().variant.algorithm - all.data()) + 1;
}

double microscopeStep(const Window& window)
{
    const app::Microscope& microscope = window.session().microscope;
    return microscope.isOpen() ? double(microscope.step()) + 1 : 0;
}

} // namespace

std::span<const ShownCount> shownCounts()
{
    // THE CATALOGUE. What is on or off is 1 or 0.
    static constexpr std::array all{
        ShownCount{"objects",
                   [](const Window& w) { return double(w.session().now().objects().size()); }},
        ShownCount{"paths", paths},
        ShownCount{"segments", segments},
        ShownCount{"groups", containers<Container::Kind::Group>},
        ShownCount{"layers", containers<Container::Kind::Layer>},
        ShownCount{"selected",
                   [](const Window& w) { return double(w.session().selection().size()); }},
        ShownCount{"windows",
                   [](const Window& w) { return double(w.session().now().windows().list.size()); }},
        ShownCount{"outside",
                   [](const Window& w) {
                       return double(w.session().now().windows().keep == app::Keep::Outside);
                   }},
        ShownCount{
            "guides",
            [](const Window& w) { return double(w.session().now().page().guides.list.size()); }},
        ShownCount{"page-width",
                   [](const Window& w) {
                       return std::round(app::millimetresOf(w.session().now().page()).x);
                   }},
        ShownCount{"grid",
                   [](const Window& w) { return double(w.session().display().grid.shown); }},
        ShownCount{"snapping", [](const Window& w) { return double(w.canvas().snaps()); }},
        ShownCount{"overlay",
                   [](const Window& w) { return double(w.session().display().overlay); }},
        ShownCount{"panes", [](const Window& w) { return double(w.canvas().panes().size()); }},
        ShownCount{"algorithm", algorithm},
        ShownCount{"zoom", [](const Window& w) { return std::round(100 * w.canvas().zoom()); }},
        ShownCount{"microscope-step", microscopeStep},
        ShownCount{"tiles", [](const Window& w) { return double(w.sheets().isOpen()); }},
        ShownCount{"lessons", [](const Window& w) { return double(w.showsLessons()); }},
    };
    return all;
}

const ShownCount* shownCount(const QString& name)
{
    const auto found = std::ranges::find_if(
        shownCounts(), [&](const ShownCount& one) { return app::latin(one.name) == name; });
    return found == shownCounts().end() ? nullptr : &*found;
}

} // namespace ui
