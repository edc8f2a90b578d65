// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/nodes/node_summary.h"

#include <QString>

#include <span>
#include <string_view>

namespace app {

/// The nodes of several objects, and to which of them each subpath belongs.
struct OwnedPaths {
    NodePath path{};
    std::vector<std::size_t> owners{}; ///< one for each subpath, ascending
};

/// Which ends of paths a step may join.
struct JoinRule {
    double tolerance = 0;              ///< how far apart they may be, in user units
    std::vector<std::uint32_t> pens{}; ///< of each subpath (end_joining.h)
};

/// One kind of change that commands make to the nodes of the selected paths.
struct NodeStep {
    std::string_view key; ///< "smooth-nodes"
    QString name;         ///< in menus: "Make nodes smooth"
    QString done;         ///< the name of the undoable step: "Make nodes smooth"
    bool needsNodes;      ///< selected ones; else, without any, it concerns the whole paths
    /// Why it is impossible, in one sentence; empty: it is possible.
    QString (*refusal)(const NodeSummary& nodes);
    /// False: nothing was changed, and `refused` says why.
    bool (*change)(OwnedPaths& paths, const JoinRule& rule);
    QString refused{};
    bool joins = false; ///< ends, at a tolerance that the person chooses
};

/// Every kind, in the order of the menu.
std::span<const NodeStep> nodeSteps();
const NodeStep& nodeStep(std::string_view key); ///< of one of them

constexpr double joiningMillimetres = 0.1; ///< the usual tolerance, on paper

/// Messages: what joining did, and that no ends lie within `tolerance`, a length as text.
QString joinedText(const OwnedPaths& before, const OwnedPaths& after, const QString& tolerance);
QString notJoinedText(const QString& tolerance);

} // namespace app
