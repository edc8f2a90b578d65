// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"
#include "ui/widgets/checked_model.h"

namespace ui {

/// The clip windows of the drawing in the order in which they apply. Every change is an undoable
/// step.
class WindowModel : public CheckedModel {
    Q_OBJECT

public:
    /// CountsRole: whether it has an effect. IconRole: the key of the shape's icon. ColourRole: a
    /// QColor, not valid for the usual one.
    enum Role { VisibleRole = Qt::UserRole, CountsRole, OperationRole, IconRole, ColourRole };

    explicit WindowModel(app::Session& session, QObject* parent = nullptr);

protected:
    int rows() const override;
    QVariant cell(int row, int column, int role) const override;
    bool change(int row, const QVariant& value, int role) override;
    Qt::ItemFlags moreFlags() const override { return Qt::ItemIsEditable; }

private:
    void follow();

    app::Session& session_;
    app::ClipWindows shown_; ///< as last reported to views
};

} // namespace ui
