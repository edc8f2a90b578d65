// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/fold_button.h"
#include "ui/widgets/icon_sign.h"
#include "ui/widgets/look_label.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>

namespace ui {

/// One value of a section, at the right of its heading.
struct SectionValue {
    QString text;
    std::string_view sign = {}; ///< the key of an icon before it; empty: none
    QColor Look::*colour = &Look::text;
    friend bool operator==(const SectionValue&, const SectionValue&) = default;
};

/// The heading of a section: a chevron if it folds, a sign, its name, its result and one value.
/// While the pointer or the focus is in the section, buttons stand in the value's place; what is at
/// the left does not move.
class DockTitle : public QWidget {
    Q_OBJECT

public:
    explicit DockTitle(QDockWidget& dock);

    void setSign(const QIcon& sign);
    void setName(const QString& name);
    void setRemark(const QString& remark);
    void setValue(const SectionValue& value);

    void setFoldable(bool foldable); ///< with a chevron; a click on the heading folds it, too
    void showFolded(bool folded);
    FoldButton& chevron() { return *chevron_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void foldWanted(bool folded);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void addButton(QAction* action, QLayout& row);
    void addValue();
    void showButtons();

    QDockWidget& dock_;
    FoldButton* chevron_;
    IconSign* sign_;
    QLabel* name_;
    ElidedLabel* remark_;
    QStackedWidget* aside_; ///< the value, or the buttons
    IconSign* valueSign_;
    LookLabel* value_;
    SectionValue shown_{};
    std::optional<QPoint> pressed_{};
};

} // namespace ui
