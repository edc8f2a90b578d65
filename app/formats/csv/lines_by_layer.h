// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace app::csv {

/// Groups lines by layer, as a document stores all lines of a layer together. Lines of the same
/// layer keep their order.
class LinesByLayer {
public:
    LinesByLayer() { none_.styles(); }

    StyleEntry style(const Style& style) { return none_.styles().entryOf(style); }
    /// Sets the layer of the following lines. Layers beyond `Containers::mostLayers` join the last
    /// one.
    void turnTo(std::string_view layer);
    void add(const clipping::Segment& line, const StyleEntry& style);
    /// Adds the lines of one row as one path; nothing, if there are none.
    void add(std::span<const Subpath> lines, const StyleEntry& style);

    std::size_t size() const { return size_; } ///< rows added so far
    int beyond() const { return beyond_; }     ///< lines of layers beyond the limit

    /// Returns all lines as a document whose page encloses them. The object cannot be used for
    /// further lines.
    Document take();
    /// For each object of the document, the index of its line in the order of `add`. Call after
    /// `take`.
    std::vector<std::uint32_t> order();

private:
    struct Layer {
        std::string name;
        Objects objects;
        std::vector<std::uint32_t> order{};
    };

    std::size_t layerOf(std::string_view name);

    Objects none_; ///< without objects; holds all styles
    std::vector<Layer> layers_;
    std::map<std::string, std::size_t, std::less<>> found_; ///< layer indices by name
    std::string name_;                                      ///< the last argument of `turnTo`
    std::size_t layer_ = 0;                                 ///< the current layer
    bool isBeyond_ = false;                                 ///< not the requested layer
    std::size_t size_ = 0;
    int beyond_ = 0;
};

} // namespace app::csv
