// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

namespace app {
class Session;
}

namespace ui {

class Canvas;
class SelectionPanel;
class StylePanel;

/// What is selected: its style, and below that its numbers. With nothing selected it is the style
/// of new objects. Its height is always the same; what is not used is empty.
class PropertiesPanel : public QWidget {
    Q_OBJECT

public:
    PropertiesPanel(app::Session& session, Canvas& canvas, QWidget* parent = nullptr);

    QString title() const; ///< what is selected, or that nothing is

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void entered(); ///< a value was entered: the focus returns to the canvas
    void refused(const QString& sentence);
    void taken(); ///< a field's value is valid again
    void titled(const QString& remark);

private:
    bool isSomethingSelected() const;
    void follow();

    app::Session& session_;
    SelectionPanel* numbers_;
    StylePanel* style_;
    QTimer soon_; ///< merges several changes in one event into one update
};

} // namespace ui
