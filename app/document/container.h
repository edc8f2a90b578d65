// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

namespace app {

/// Names a container as long as its document lives; 0: the document itself.
using ContainerId = std::uint32_t;

/// A layer or a group.
struct Container {
    enum class Kind : std::uint8_t { Layer, Group };
    ContainerId id = 0;
    Kind kind = Kind::Layer;
    QString name{};                 ///< what people read
    QString svgId{};                ///< the SVG's; unique in a document, may be empty
    QString title{}, description{}; ///< as XML, as About keeps them
    bool visible = true;
    bool locked = false;
    friend bool operator==(const Container&, const Container&) = default;
};

} // namespace app
