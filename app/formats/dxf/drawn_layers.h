// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/formats/dxf/tables.h"
#include "app/formats/dxf/text_code.h"

namespace app::dxf {

/// The layers of a drawing with their objects. A document stores all objects of a layer together,
/// a file need not.
class DrawnLayers {
public:
    DrawnLayers(const Tables& tables, const Header& header);

    /// The layer of this name; a new one if the file does not describe it. Beyond
    /// `Containers::mostLayers` the last one.
    std::size_t indexOf(std::string_view name);
    const LayerEntry& operator[](std::size_t layer) const { return layers_[layer].entry; }
    StyleEntry style(const Style& style) { return none_.styles().entryOf(style); }
    void addLine(std::size_t layer, const clipping::Segment& line, const StyleEntry& style);
    void add(std::size_t layer, const ObjectRow& object);
    int beyond() const { return beyond_; } ///< layers beyond the limit

    /// All objects as a document, on a page around them. The object cannot be used afterwards.
    Document take();

private:
    struct Layer {
        LayerEntry entry;
        Objects objects;
    };
    std::size_t added(const LayerEntry& entry, std::string capitals);

    const Header& header_;
    Objects none_; ///< without objects; holds all styles
    std::vector<Layer> layers_;
    std::map<std::string, std::size_t, std::less<>> found_; ///< by name, in capitals
    std::string_view name_;                                 ///< the last argument of `indexOf`
    std::size_t index_ = 0;                                 ///< its result
    int beyond_ = 0;
};

} // namespace app::dxf
