// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"

#include <QString>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace app {

/// The panes in which one drawing is clipped side by side: the variant of each pane, and which pane
/// is active. There is always at least one pane. No two panes have the same variant, and none has a
/// known misprint.
class Panes {
public:
    /// The number of variants that are remembered while fewer panes are shown.
    static constexpr std::size_t most = 4;

    explicit Panes(const Variant& only);

    std::span<const Variant> choices() const { return choices_; }
    std::size_t size() const { return choices_.size(); }
    std::size_t active() const { return active_; }
    const Variant& chosen() const { return choices_[active_]; } ///< of the active pane
    bool showsAll() const { return all_; }

    /// Shows 1 to `most` panes with the remembered variants. The chosen variant stays chosen: if it
    /// is not among them, it replaces the last one.
    void show(std::size_t count);
    /// Shows a pane for every algorithm, the exact one first, and one more for the published form
    /// that loses visible lines.
    void showAll();

    void activate(std::size_t pane);
    /// Gives the active pane another variant; a pane that already has this variant gets the old
    /// one. With all algorithms shown, each keeps its place: the pane of that algorithm becomes
    /// active.
    void choose(const Variant& choice);
    /// Removes a pane; the last one stays.
    void close(std::size_t pane);

    /// The panes to show if there is room for only `room`: the first ones, and the active one.
    std::vector<std::size_t> shown(std::size_t room) const;

    /// For settings: "4 3 exact cohen-sutherland kodituwakku-wijeweera-chamikara:published …".
    QString text() const;
    /// Reads such a text. If it shows one pane, that pane gets `chosen`, and the rest is
    /// remembered.
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
