// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <map>
#include <string>
#include <vector>

namespace app::csv {

/// Collects lines that come in any order of layers: a document has all of a layer together. Within
/// a layer they stay in the order in which they came.
class LinesByLayer {
public:
    LinesByLayer() { none_.styles(); }

    StyleIndex style(const Style& style) { return none_.styles().indexOf(style); }
    /// Lines that come now are on this layer; beyond `Containers::mostLayers`, on the last one.
    void turnTo(std::string_view layer);
    void add(const clipping::Segment& line, StyleIndex style);

    std::size_t size() const { return size_; } ///< lines so far
    int beyond() const { return beyond_; }     ///< lines of layers beyond that

    /// All of them on the page around them. Start with another one then.
    Document take();
    /// For each object of the document the number that it came as. To be called after `take`.
    std::vector<std::uint32_t> order();

private:
    struct Layer {
        std::string name;
        Objects objects;
        std::vector<std::uint32_t> order{};
    };

    std::size_t layerOf(std::string_view name);

    Objects none_; ///< has the styles of all
    std::vector<Layer> layers_;
    std::map<std::string, std::size_t, std::less<>> found_; ///< layers by their names
    std::string name_;                                      ///< what `turnTo` was last called with
    std::size_t layer_ = 0;                                 ///< which is this one
    bool isBeyond_ = false;                                 ///< not the one asked for
    std::size_t size_ = 0;
    int beyond_ = 0;
};

} // namespace app::csv
