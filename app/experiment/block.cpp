// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/block.h"

#include "app/experiment/threads.h"

#include <algorithm>
#include <cassert>

namespace app {

std::vector<Variant> variantsOf(std::span<const clipping::Algorithm* const> algorithms,
                                clipping::Form form)
{
    std::vector<Variant> all;
    for (const auto* algorithm : algorithms)
        if (clipping::functionsOf(*algorithm, form))
            all.push_back({algorithm, form});
    return all;
}

std::vector<Variant> variantsOf(std::span<const clipping::Algorithm* const> algorithms)
{
    auto all = variantsOf(algorithms, clipping::Form::Corrected);
    const auto published = variantsOf(algorithms, clipping::Form::Published);
    all.insert(all.end(), published.begin(), published.end());
    return all;
}

QString wordOf(clipping::Form form)
{
    return form == clipping::Form::Corrected ? QStringLiteral("corrected")
                                             : QStringLiteral("published");
}

namespace {

using Singles = clipping::BasicSegment<float>;

clipping::BasicWindow<float> single(const clipping::Window& window)
{
    return {glm::vec2(window.min), glm::vec2(window.max)};
}

Singles single(const clipping::Segment& line) { return {glm::vec2(line.a), glm::vec2(line.b)}; }

clipping::Segment exactly(const Singles& line) { return {glm::dvec2(line.a), glm::dvec2(line.b)}; }

template <class T>
std::size_t clipped(std::size_t threads, ClipAllOf<T> clipAll,
                    const std::vector<clipping::BasicSegment<T>>& lines,
                    const clipping::BasicWindow<T>& window,
                    std::vector<clipping::BasicClipped<clipping::BasicSegment<T>>>& visible)
{
    if (threads == 1)
        return clipAll(lines, window, visible);
    return clipInThreads<T>(threads, clipAll, lines, window, visible);
}

} // namespace

QString wordOf(Precision precision)
{
    return precision == Precision::Double ? QStringLiteral("double") : QStringLiteral("single");
}

Block::Block(const Clipping& how) : how_(how)
{
    if (how_.precision == Precision::Single) {
        const auto window = single(how_.window);
        how_.window = {glm::dvec2(window.min), glm::dvec2(window.max)};
    }
}

void Block::refill(std::size_t count, const std::function<void(std::span<clipping::Segment>)>& fill)
{
    lines_.resize(count);
    fill(lines_);
    visible_.resize(lines_.size());
    if (how_.precision == Precision::Double)
        return;
    singleLines_.resize(lines_.size());
    singleVisible_.resize(lines_.size());
    std::ranges::transform(lines_, singleLines_.begin(),
                           [](const clipping::Segment& line) { return single(line); });
    std::ranges::transform(singleLines_, lines_.begin(), exactly);
}

std::size_t Block::clip(const Variant& variant)
{
    const clipping::Algorithm& algorithm = *variant.algorithm;
    if (how_.shape)
        return clipAllAt(*how_.shape, variant, lines_, visible_);
    if (how_.precision == Precision::Single) {
        assert(variant.form == clipping::Form::Corrected);
        return clipped<float>(how_.threads, algorithm.floats->clipAll, singleLines_,
                              single(how_.window), singleVisible_);
    }
    return clipped<double>(how_.threads, clipping::functionsOf(algorithm, variant.form)->clipAll,
                           lines_, how_.window, visible_);
}

std::span<const clipping::Clipped> Block::pieces(std::size_t count)
{
    if (how_.precision == Precision::Single)
        std::transform(singleVisible_.begin(), singleVisible_.begin() + std::ptrdiff_t(count),
                       visible_.begin(), [](const auto& piece) -> clipping::Clipped {
                           return {exactly(piece.segment), piece.source, piece.cut};
                       });
    return std::span(visible_).first(count);
}

} // namespace app
