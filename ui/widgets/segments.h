// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QButtonGroup>
#include <QStringList>
#include <QToolButton>

#include <string_view>
#include <vector>

namespace ui {

/// A row of joined buttons of which one is checked: a choice whose options are all visible.
class Segments : public QWidget {
    Q_OBJECT

public:
    /// `name` is the accessible name of the whole row.
    Segments(const QString& name, const QStringList& choices, QWidget* parent = nullptr);

    /// Shows an icon instead of each text, which becomes the tooltip.
    void setIcons(const std::vector<std::string_view>& keys);
    /// Shows a picture above each text.
    void setPictures(const std::vector<QIcon>& pictures);
    void setTips(const QStringList& tips); ///< the tooltip of each button
    /// Disables a button and says why in its tooltip; empty: it is enabled, with its own tooltip.
    void setReason(int index, const QString& why);

    int chosen() const { return group_.checkedId(); }
    void choose(int index); ///< without a signal
    void chooseNone();      ///< the current state is not among the choices

signals:
    void picked(int index); ///< by the person

private:
    QButtonGroup group_;
    QStringList tips_;
};

} // namespace ui
