// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QLabel>

#include <string_view>

namespace ui {

class DockTitle;

/// A panel at the side of the window with our own title bar, whose buttons are visible only while
/// the pointer or the focus is in the panel. In a tab group the tab is the title.
class Dock : public QDockWidget {
    Q_OBJECT

public:
    Dock(std::string_view key, const QString& title, QWidget* body, QWidget* parent = nullptr);

    void setName(const QString& name); ///< in the title bar; the tab keeps the dock's own name
    /// The muted text after the name.
    void setRemark(const QString& remark);

    /// A folded panel is only its title bar, unless its tab is the title.
    void setFoldable(bool foldable); ///< with a button in the title bar
    void setFolded(bool folded);
    bool isFolded() const { return folded_; }
    void setFoldedRemark(const QString& remark); ///< while it is folded, in place of the remark

    enum class Title : std::uint8_t { Shown, InTab };
    void setTitle(Title where);

    /// Whether another tab of its place is in front of it. Qt moves such docks off the screen.
    bool isBehind() const { return x() < 0 && !isFloating(); }

signals:
    void foldWanted(bool folded);

private:
    void showFolded();

    DockTitle* title_;
    QWidget* noTitle_;
    QString remark_, foldedRemark_;
    bool folded_ = false;
};

} // namespace ui
