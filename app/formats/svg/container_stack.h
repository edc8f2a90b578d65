// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_builder.h"
#include "app/formats/svg/report.h"

namespace app::svg {

/// Puts objects into layers and groups in the order in which they are painted. A file may nest them
/// in any way; in a document the first level are layers, and groups hold groups only:
/// - What lies outside of all layers comes into a layer of its own, "Drawing"; above another layer,
///   that is a further one, "Drawing (2)".
/// - A layer in a group becomes a group.
/// - Containers above the limits dissolve into the one around them.
class ContainerStack {
public:
    /// Kept even if nothing is drawn in it. Each `open` needs its `close`, whether the container
    /// dissolves or not.
    void open(Container container);
    void close();
    void add(Object object); ///< on top of all others

    /// The document, without clip windows, and what it could not hold. All must be closed.
    Document take(const Page& page, About about, Report& report);

private:
    struct Open {
        bool dissolved = false;
        bool inGroup = false; ///< it is a group, or one around it is
        bool hidden = false;  ///< it would be hidden had it not dissolved, or one around it would
    };
    bool dissolves(const Container& container);
    void openDrawing();
    void closeDrawing();
    bool atFirstLevel() const { return builder_.depth() == int(drawingIsOpen_); }

    DocumentBuilder builder_;
    std::vector<Open> open_{{}}; ///< the first stands for the document
    std::size_t layers_ = 0, groups_ = 0;
    int drawings_ = 0; ///< layers for what lies outside of all layers
    int dissolved_ = 0;
    bool drawingIsOpen_ = false; ///< the layer for what lies outside of all layers
    bool mergesLayers_ = false;  ///< there are too many
};

} // namespace app::svg
