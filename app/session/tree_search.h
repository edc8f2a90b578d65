// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_tree.h"
#include "app/session/session.h"

#include <chrono>
#include <unordered_map>

namespace app {

/// Finds objects, groups and layers by what was typed. Every typed word must be a part of the name,
/// in upper or lower case; for an object or group also of the name of a layer or group around it
/// ("line walls"). Goes through the drawing from above, in slices, so that a large one does not
/// stop the window. To be made again when the drawing changes.
class TreeSearch {
public:
    TreeSearch(const Session& session, const QString& typed);

    bool advance(std::chrono::microseconds time); ///< true: all were looked at
    bool isDone() const { return objects_ == 0 && containers_.empty(); }
    std::size_t found() const { return found_; } ///< how many so far
    /// The topmost `most` of what is found so far, each below the layers and groups around it.
    std::vector<TreeRow> rows(std::size_t most) const;

private:
    using Words = std::uint32_t; ///< a bit for each typed word
    Words wordsIn(const QString& name) const;
    Words wordsAround(ContainerId id); ///< in the names of it and of what is around it
    Words wordsOf(std::size_t object, const ObjectView& view);
    void lookAtContainers(std::size_t count);
    void lookAtObjects(std::size_t count);

    static constexpr std::size_t mostKept = 20'000; ///< rows; further ones are counted only

    const Session& session_;
    QStringList words_;
    Words all_;
    bool hasDigits_;
    std::vector<ContainerId> containers_; ///< still to be looked at, the last one first
    std::size_t objects_;                 ///< as many from below are still to be looked at
    std::unordered_map<ContainerId, Words> around_;
    std::unordered_map<std::string_view, Words> ofKinds_; ///< by icon
    std::vector<ContainerId> foundContainers_;
    std::vector<std::size_t> foundObjects_; ///< descending
    std::size_t found_ = 0;
};

} // namespace app
