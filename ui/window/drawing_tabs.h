// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolBar>

#include <vector>

class QToolButton;

namespace ui {

class TabBar;

/// What the tab of an open drawing says.
struct DrawingTab {
    QString name{};
    QString tip{}; ///< the path of the file
    bool modified = false;
    friend bool operator==(const DrawingTab&, const DrawingTab&) = default;
};

/// The bar with a tab for each open drawing, above all others; hidden as long as there is only one.
/// The tab of a drawing with unsaved changes has a dot, in the place of the cross that closes it.
class DrawingTabs : public QToolBar {
    Q_OBJECT

public:
    explicit DrawingTabs(QWidget* parent = nullptr);

    void show(const std::vector<DrawingTab>& tabs, int current);
    int tabAt(const QPoint& onScreen) const; ///< -1: none
    void mark(int tab);                      ///< objects would be dropped on it; -1: on none
    QString name(int tab) const { return shown_[std::size_t(tab)].name; }

signals:
    void chosen(int tab); ///< may be the current one
    void closeWanted(int tab);
    void moved(int from, int to);
    void newWanted();

private:
    TabBar* bar_;
    std::vector<DrawingTab> shown_;
};

} // namespace ui
