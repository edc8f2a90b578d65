// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/drawing/typed_entry.h"
#include "app/session/session.h"

#include <span>
#include <string_view>

namespace app {

/// One number of a node, such as the length of a handle: a row of a catalogue.
struct NodeNumber {
    std::string_view key;
    QString label; ///< "L"
    QString name;  ///< "Length of the incoming handle"
    Quantity quantity;
    QString missing; ///< why the selected nodes have no such number, and what to do
    /// In user units from `origin`, or degrees; empty: the node has no such number.
    std::optional<double> (*value)(const NodeSubpath& subpath, std::size_t node,
                                   const Point& origin);
    /// Gives it to the selected nodes that can have it. False: it is impossible.
    bool (*set)(NodePath& path, double value, const Point& origin);
};

// THE CATALOGUE, in the order of the fields. To add a number: add its row.
std::span<const NodeNumber> nodeNumbers();

/// A number of the selected nodes.
struct NodeValue {
    double first;             ///< of the first node that has it
    bool mixed = false;       ///< nodes that have it differ
};
/// Empty: no selected node has this number.
std::optional<NodeValue> nodeValue(const Session& session, const NodeNumber& number);

/// Gives the selected nodes this number, as one step. False: it was refused.
bool setNodeNumber(Session& session, const NodeNumber& number, double value,
                   Merging merging = Merging::Never);

/// The type of all selected nodes; empty: they differ, or none is selected.
std::optional<NodeType> typeOfNodes(const Session& session);

/// What is selected, in words: "node 3 of 10", "4 of 10 nodes".
QString nodesText(const Session& session);

} // namespace app
