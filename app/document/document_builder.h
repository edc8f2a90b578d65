// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/containers_builder.h"
#include "app/document/document.h"

namespace app {

/// Builds a document from bottom to top, for file readers: opens and closes containers, and adds
/// objects on top of the current container. O(1) a call.
class DocumentBuilder {
public:
    /// Whether another container can be opened here; see `ContainersBuilder::canOpen`.
    bool canOpen() const { return containers_.canOpen(); }
    /// Opens a layer or group inside the current container and returns its id; the id in
    /// `container` is ignored.
    ContainerId open(Container container) { return containers_.open(std::move(container)); }
    void close() { containers_.close(); }
    int depth() const { return containers_.depth(); } ///< the number of open containers

    /// The entry of a style for `addLine`.
    StyleEntry style(const Style& style) { return objects_.styles().entryOf(style); }
    // The following functions require an open container.
    void add(const Object& object);
    void add(const ObjectRow& row);
    void addLine(const clipping::Segment& line, const StyleEntry& style); ///< without an Object
    void add(const Objects& objects); ///< adds all; shares whole blocks, costs O(all blocks)
    const Objects& objects() const { return objects_; } ///< the objects added so far
    std::size_t size() const { return objects_.size(); }

    /// Returns the document; all containers must be closed. Without a layer it gets an empty one.
    /// The builder cannot be used afterwards.
    Document take(const Page& page, About about = {}, ClipWindows windows = {});

private:
    Objects objects_;
    ContainersBuilder containers_;
};

} // namespace app
