// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

namespace app {

/// Identifies a container during the life of its document; 0 is the document itself.
using ContainerId = std::uint32_t;

/// A layer or a group.
struct Container {
    enum class Kind : std::uint8_t { Layer, Group };
    ContainerId id = 0;
    Kind kind = Kind::Layer;
    QString name{};                 ///< shown to people
    QString svgId{};                ///< the SVG id; unique in a document, may be empty
    QString title{}, description{}; ///< XML, in the form that About describes
    /// The style of new objects as CSS declarations (app/formats/svg/declarations.h); empty: none.
    QString newStyle{};
    bool visible = true;
    bool locked = false;
    friend bool operator==(const Container&, const Container&) = default;
};

} // namespace app
