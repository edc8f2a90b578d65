// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/node_numbers.h"

#include <QWidget>

#include <vector>

namespace ui {

class LengthField;

/// The selected nodes in numbers: place and handles. Each edit is one undo step. Where nodes
/// differ, a field says "mixed", and what is typed is for all of them.
class NodeFields : public QWidget {
    Q_OBJECT

public:
    explicit NodeFields(app::Session& session, QWidget* parent = nullptr);

    void follow();

signals:
    void entered(); ///< a number was entered: the focus returns to the canvas
    void refused(const QString& sentence);
    void taken(); ///< a field's value is valid again

private:
    LengthField* makeField(const app::NodeNumber& number);

    app::Session& session_;
    std::vector<LengthField*> fields_; ///< in the order of app::nodeNumbers()
};

} // namespace ui
