// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/container_table.h"

#include <QObject>

#include <vector>

namespace app {

class Session;
struct DocumentChange;

/// The group that a person has entered, to edit what is in it. Only its content is selected then:
/// its objects one by one, and the groups in it as a whole.
class EnteredGroup : public QObject {
    Q_OBJECT

public:
    explicit EnteredGroup(Session& session);

    ContainerId id() const { return chain_.empty() ? 0 : chain_.back(); } ///< 0: none
    /// Whether it is the entered group, or a group around it.
    bool contains(ContainerId group) const;
    void enter(ContainerId group); ///< 0, or a layer: leaves all groups
    void leave();                  ///< goes back to the group around it, if any

signals:
    void changed();

private:
    std::vector<ContainerId> chainOf(ContainerId group) const;
    void follow(const DocumentChange& change);
    void set(std::vector<ContainerId> chain);

    Session& session_;
    std::vector<ContainerId> chain_; ///< the entered group, after the groups around it
};

} // namespace app
