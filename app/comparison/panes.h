// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"

#include <QString>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace app {

/// The panes in which one drawing is clipped side by side: what clips in each, and which of them is
/// the active one. There is always one. No two show the same, none an exhibit.
class Panes {
public:
    /// As many as are remembered while fewer are shown.
    static constexpr std::size_t most = 4;

    explicit Panes(const Variant& only);

    std::span<const Variant> choices() const { return choices_; }
    std::size_t size() const { return choices_.size(); }
    std::size_t active() const { return active_; }
    const Variant& chosen() const { return choices_[active_]; } ///< of the active pane
    bool showsAll() const { return all_; }

    /// 1 to `most` panes, those that were there before. What was chosen stays so: where it is not
    /// among them, it takes the last one's place.
    void show(std::size_t count);
    /// A pane for every algorithm, the exact one first, and one for the published form that loses
    /// lines which are visible.
    void showAll();

    void activate(std::size_t pane);
    /// Another choice for the active pane; a pane that has it already gets the old one. Where all
    /// are shown each algorithm keeps its place: its pane becomes the active one.
    void choose(const Variant& choice);
    /// Takes a pane away; the last one stays.
    void close(std::size_t pane);

    /// The panes to show where only so many have room: the first ones, and the active one.
    std::vector<std::size_t> shown(std::size_t room) const;

    /// For settings: "4 3 exact cohen-sutherland kodituwakku-wijeweera-chamikara:published …".
    QString text() const;
    /// What such a text says; of one pane only what others there were, not what it chose.
    static std::optional<Panes> fromText(const QString& text, const Variant& chosen);

private:
    std::optional<std::size_t> find(const Variant& choice) const;
    void remember();

    std::vector<Variant> choices_;
    std::size_t active_ = 0;
    bool all_ = false;
    std::array<Variant, most> remembered_;
};

} // namespace app
