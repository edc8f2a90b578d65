// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_builder.h"
#include "app/formats/svg/report.h"

namespace app::svg {

/// Collects objects in layers and groups, in painting order. A file may nest them in any way. In a
/// document the first level consists of layers, and groups contain only groups. Therefore:
/// - Objects outside all layers get a layer of their own, "Drawing"; above another layer, they get
///   a further one, "Drawing (2)".
/// - A layer inside a group becomes a group.
/// - Containers beyond the limits dissolve into the container around them.
class ContainerStack {
public:
    /// Opens a container; it is kept even if nothing is drawn in it. Each `open` needs a `close`,
    /// even if the container dissolves.
    void open(Container container);
    void close();
    void add(Object object); ///< above all previous objects

    /// Returns the document, without clip windows, and reports what it could not keep. All
    /// containers must be closed.
    Document take(const Page& page, About about, Report& report);

private:
    struct Open {
        bool dissolved = false;
        bool inGroup = false; ///< whether it or a container around it is a group
        bool hidden = false;  ///< whether it or a container around it dissolved while hidden
    };
    bool dissolves(const Container& container);
    void openDrawing();
    void closeDrawing();
    bool atFirstLevel() const { return builder_.depth() == int(drawingIsOpen_); }

    DocumentBuilder builder_;
    std::vector<Open> open_{{}}; ///< the first element stands for the document
    std::size_t layers_ = 0, groups_ = 0;
    int drawings_ = 0; ///< number of layers for objects outside all layers
    int dissolved_ = 0;
    int lostImages_ = 0;         ///< in groups, or beyond the limit of layers
    bool drawingIsOpen_ = false; ///< whether the layer for objects outside all layers is open
    bool mergesLayers_ = false;  ///< whether there are too many layers
};

} // namespace app::svg
