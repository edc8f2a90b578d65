// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/formulas/evaluate.h"

#include <array>
#include <cstdio>

namespace app::formulas {

Scope::Scope(const Names& names, const clipping::Segment& s, const clipping::Window& w)
    : names_(names), values_(names.size()), known_(names.size()), numbers_(names.size(), 1),
      edges_(names.size(), clipping::Edge::NoEdge)
{
    const std::array given{s.a.x,   s.a.y,   s.b.x,   s.b.y,
                           w.min.x, w.min.y, w.max.x, w.max.y}; // the order of Names
    for (std::size_t i = 0; i < given.size(); ++i)
        set(int(i), given[i]);
}

double Scope::value(int slot) const
{
    if (!isKnown(slot))
        throw Unreadable(names_.at(slot) + " is not known yet");
    return values_[std::size_t(slot)];
}

void Scope::set(int slot, double value)
{
    values_[std::size_t(slot)] = value;
    known_[std::size_t(slot)] = 1;
}

clipping::Window Scope::window() const
{
    return {{values_[4], values_[5]}, {values_[6], values_[7]}};
}

void Scope::setWindow(const clipping::Window& w)
{
    set(4, w.min.x), set(5, w.min.y), set(6, w.max.x), set(7, w.max.y);
}

std::string Scope::text() const
{
    std::string all;
    for (std::size_t slot = 0; slot < values_.size(); ++slot)
        if (known_[slot] != 0)
            all += (all.empty() ? "" : ", ") + names_.at(int(slot)) + " = "
                   + formulas::text(values_[slot]);
    return all;
}

std::string text(double value)
{
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.17g", value);
    return buffer;
}

} // namespace app::formulas
