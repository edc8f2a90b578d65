// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QDialog>
#include <QLabel>

namespace ui {

class LengthField;

/// Asks how far apart the ends may be that a step joins, and takes the step. The distance is
/// remembered.
class JoinDialog : public QDialog {
    Q_OBJECT

public:
    JoinDialog(app::Session& session, const app::NodeStep& step, QWidget* parent = nullptr);

    void accept() override;

signals:
    void joined(const QString& sentence); ///< what was done

private:
    app::Session& session_;
    const app::NodeStep& step_;
    LengthField* distance_;
    QLabel* sentence_; ///< what will be joined, or why nothing was
};

} // namespace ui
