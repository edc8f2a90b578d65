// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/dock_title.h"

namespace ui {

/// A panel at the side of the window with our own heading, whose buttons are visible only while
/// the pointer or the focus is in the panel. In a tab group the tab is the heading.
class Dock : public QDockWidget {
    Q_OBJECT

public:
    Dock(std::string_view key, const QString& title, QWidget* body, QWidget* parent = nullptr);

    QWidget& body() const { return *body_; } ///< also while the panel is folded

    // In the heading; the tab keeps the dock's own name.
    void setSign(const QIcon& sign) { title_->setSign(sign); }
    void setName(const QString& name) { title_->setName(name); }
    void setRemark(const QString& remark) { title_->setRemark(remark); } ///< muted, after the name
    void setValue(const SectionValue& value) { title_->setValue(value); }

    /// A folded panel is only its heading, unless its tab is the heading.
    void setFoldable(bool foldable); ///< with a chevron in the heading
    bool isFoldable() const { return foldable_; }
    void setFolded(bool folded);
    bool isFolded() const { return folded_; }
    void focusHeading() { title_->chevron().setFocus(); }
    bool hasFocusInHeading() const { return title_->chevron().hasFocus(); }

    enum class Title : std::uint8_t { Shown, InTab };
    void setTitle(Title where);

    /// Whether another tab of its place is in front of it. Qt moves such docks off the screen.
    bool isBehind() const { return x() < 0 && !isFloating(); }

signals:
    void foldWanted(bool folded);

private:
    void showFolded();

    DockTitle* title_;
    QWidget *noTitle_, *body_;
    QWidget* nothing_; ///< in place of the body
    bool foldable_ = false, folded_ = false;
};

} // namespace ui
