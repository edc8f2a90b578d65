// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/dash_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace app {
namespace {

// The current position in a dash pattern.
class Rhythm {
public:
    Rhythm(std::span<const double> pattern, double phase) : pattern_(pattern)
    {
        const double period = std::accumulate(pattern.begin(), pattern.end(), 0.0)
                              * (pattern.size() % 2 == 0 ? 1 : 2);
        double along = std::fmod(phase, period);
        if (along < 0)
            along += period;
        for (left_ = pattern_[0]; along > 0 && along >= left_;
             left_ = pattern_[index_ % pattern_.size()]) {
            along -= left_;
            ++index_;
        }
        left_ -= along;
    }
    bool drawn() const { return index_ % 2 == 0; }
    double left() const { return left_; } // distance to the next change
    void advance(double length) { left_ -= length; }
    void change() { left_ = pattern_[++index_ % pattern_.size()]; }

private:
    std::span<const double> pattern_;
    std::size_t index_ = 0;
    double left_ = 0;
};

} // namespace

std::optional<std::vector<DashPart>> dashParts(std::span<const double> lengths,
                                               std::span<const double> pattern, double phase,
                                               double shortest)
{
    const double period = std::accumulate(pattern.begin(), pattern.end(), 0.0);
    const bool usable = std::ranges::all_of(pattern, [](double d) { return d >= 0; });
    if (pattern.empty() || !usable || !(period >= shortest) || !(period > 0)
        || !std::isfinite(phase))
        return std::nullopt;
    Rhythm rhythm(pattern, phase);
    std::vector<DashPart> parts;
    bool open = false;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const double length = lengths[i];
        const auto share = [&](double at) { return length > 0 ? at / length : 0; };
        double at = 0;
        for (;;) {
            const double next = std::min(length, at + rhythm.left());
            const bool beginsAtEnd = !open && at == length && length > 0 && rhythm.left() > 0;
            const bool drawn = rhythm.drawn() && !beginsAtEnd;
            if (drawn)
                parts.push_back({i, share(at), share(next), !open});
            open = drawn;
            if (at + rhythm.left() > length)
                break;
            at = next;
            rhythm.change();
            open = false;
        }
        rhythm.advance(length - at);
    }
    return parts;
}

} // namespace app
