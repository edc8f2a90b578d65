// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/commands/undo_command.h"
#include "app/nodes/node_steps.h"

#include <QObject>

namespace app {

class Session;

/// The nodes of the selected objects: which of them are selected, and the undoable steps that
/// change them. Nodes are read when they are asked for, and again when the drawing has changed;
/// nodes of the same paths stay selected then.
class NodeEditing : public QObject {
    Q_OBJECT

public:
    explicit NodeEditing(Session& session);

    /// Nodes of more objects are not read.
    static constexpr std::size_t mostObjects = 100'000;

    /// Whether nodes are shown and can be selected: the tool is in hand.
    bool shown() const { return shown_; }
    void setShown(bool shown);

    const NodePath& path() const;
    const NodeSummary& summary() const;
    bool someSelected() const { return shown_ && summary().selected > 0; }
    /// Increases whenever nodes are read again: their addresses may then mean other nodes.
    std::uint64_t revision() const;
    std::size_t objectOf(std::size_t subpath) const; ///< the object that a subpath belongs to

    /// `change` changes which nodes are selected, and nothing else.
    template <class Change>
    void select(const Change& change)
    {
        path();
        change(read_.path);
        summary_.reset();
        emit changed();
    }
    void selectAll(bool selected);
    void selectOnly(const NodeAddress& node);
    void selectNeighbour(bool forwards); ///< of the selected node, in the order of the path

    /// Replaces the nodes, as one step. What cannot be done is refused by `Session::refused`;
    /// false then.
    bool apply(OwnedPaths paths, const QString& done, Merging merging = Merging::Never);
    bool apply(NodePath path, const QString& done, Merging merging = Merging::Never);
    /// Moves the selected nodes, as one step.
    bool move(const Point& by, Merging merging = Merging::Never);
    bool moveTo(const NodeAddress& node, const Point& to);
    bool insert(const NodeAddress& segment, double t); ///< and selects the new node
    /// Why a step is impossible now, in one sentence; empty: it is possible.
    QString refusal(const NodeStep& step) const;
    /// Takes the step. Returns what it did, in a sentence that may be empty, or why it is refused.
    Result<QString> tried(const NodeStep& step);
    /// The same; what is refused is said by `Session::refused`. False then.
    bool run(const NodeStep& step);
    /// Whether the step depends on `ArrangeOptions::joinWithin`. Two ends that were chosen are
    /// joined however far apart they are.
    bool asksTolerance(const NodeStep& step) const;

signals:
    void changed(); ///< which nodes are selected, or shown

private:
    void read() const;
    void carryOver(const OwnedPaths& before) const;
    QString lockedSentence(std::size_t object) const;
    QString whyNotEditable(const OwnedPaths& paths) const;
    QString put(OwnedPaths paths, const QString& done, Merging merging);
    JoinRule joinRule() const;
    QString toleranceText() const;
    QString whyNotJoined(const JoinRule& rule) const;
    bool refuse(const QString& sentence);

    Session& session_;
    bool shown_ = false, applying_ = false;
    mutable bool outdated_ = true;
    mutable std::uint64_t revision_ = 0;
    mutable OwnedPaths read_;                  ///< owners are numbers of objects
    mutable std::vector<std::size_t> objects_; ///< that were read
    mutable std::optional<NodeSummary> summary_;
};

} // namespace app
