// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/containers_builder.h"
#include "app/document/document.h"

namespace app {

/// Puts a document together from the bottom up, for readers: containers are opened and closed, and
/// objects come into the one that is open, each above all that is there. O(1) a call.
class DocumentBuilder {
public:
    /// Whether one more container can be opened here; see `ContainersBuilder::canOpen`.
    bool canOpen() const { return containers_.canOpen(); }
    /// Opens a layer or a group in the one that is open. Gives its id; the one in `container` does
    /// not matter.
    ContainerId open(Container container) { return containers_.open(std::move(container)); }
    void close() { containers_.close(); }
    int depth() const { return containers_.depth(); } ///< how many are open

    /// The number by which `addLine` and `add(ObjectRow)` know a style.
    StyleIndex style(const Style& style) { return objects_.styles().indexOf(style); }
    // There must be a container that is open.
    void add(const Object& object);
    void add(const ObjectRow& row);
    void addLine(const clipping::Segment& line, StyleIndex style); ///< without an Object between
    void add(const Objects& objects); ///< all of them; shares whole blocks, costs O(all blocks)
    const Objects& objects() const { return objects_; } ///< so far
    std::size_t size() const { return objects_.size(); }

    /// The document; all containers must be closed. Without a layer it gets an empty one. Start
    /// with another builder then.
    Document take(const Page& page, About about = {}, ClipWindows windows = {});

private:
    Objects objects_;
    ContainersBuilder containers_;
};

} // namespace app
