// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/drawing.h"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace app {

Drawing::Drawing(Sheet sheet, QObject* parent) : QObject(parent), sheet_(std::move(sheet)) {}

void Drawing::load(Sheet sheet)
{
    {
        const std::lock_guard writing(lock_);
        std::swap(sheet_, sheet); // the old one goes when others may read again
    }
    emit changed({Change::Kind::Everything});
}

std::vector<Shape> Drawing::splice(std::size_t first, std::size_t count, std::vector<Shape> shapes)
{
    assert(first + count <= sheet_.shapes.size());
    std::unique_lock writing(lock_);
    auto& all = sheet_.shapes;
    const Change change{Change::Kind::Shapes, first, count, shapes.size()};
    const auto at = all.begin() + std::ptrdiff_t(first);
    const auto end = at + std::ptrdiff_t(count);
    std::vector<Shape> old{std::make_move_iterator(at), std::make_move_iterator(end)};
    const std::size_t common = std::min(count, shapes.size());
    const auto middle = shapes.begin() + std::ptrdiff_t(common);
    const auto rest = std::move(shapes.begin(), middle, at);
    if (count > common)
        all.erase(rest, end);
    else
        all.insert(rest, std::make_move_iterator(middle), std::make_move_iterator(shapes.end()));
    writing.unlock();
    emit changed(change);
    return old;
}

void Drawing::setWindow(const clipping::Window& window)
{
    {
        const std::lock_guard writing(lock_);
        sheet_.window = window;
    }
    emit changed({Change::Kind::Window});
}

void Drawing::setLayers(std::vector<Layer> layers)
{
    assert(!layers.empty());
    {
        const std::lock_guard writing(lock_);
        sheet_.layers = std::move(layers);
    }
    emit changed({Change::Kind::Layers});
}

void Drawing::setPage(const Page& page)
{
    {
        const std::lock_guard writing(lock_);
        sheet_.page = page;
    }
    emit changed({Change::Kind::Page});
}

std::size_t Drawing::endOfLayer(std::uint32_t layer) const
{
    const auto end = std::ranges::upper_bound(sheet_.shapes, layer, {}, &Shape::layer);
    return std::size_t(end - sheet_.shapes.begin());
}

} // namespace app
