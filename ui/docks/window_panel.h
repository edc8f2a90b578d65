// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QStackedLayout>
#include <QToolButton>

class QMenu;

class QHBoxLayout;

namespace ui {

class Segments;
class WindowFields;
class WindowList;

/// The list of clip windows with the side that is kept, and the window that tools act on: what it
/// does, its numbers.
class WindowPanel : public QWidget {
    Q_OBJECT

public:
    explicit WindowPanel(app::Session& session, QWidget* parent = nullptr);

    QString title() const;     ///< of all windows: "Old town − Market hall + Star"
    void showSize(bool shown); ///< width and height: false if the window's capsule has them
    void rename();             ///< opens the field for the name of the window that tools act on

signals:
    void titled(const QString& remark);
    void entered(); ///< a number or a unit was entered: the focus returns to the canvas
    void refused(const QString& sentence); ///< the typed text is not a length
    void taken();                          ///< a field's value is valid again
    void menuWanted(const QPoint& place);  ///< on the screen, for that window

private:
    QWidget* makeList();
    QWidget* makeKeep();
    void addTools(QHBoxLayout& row);
    QWidget* makeOffer(); ///< shown if there is no clip window
    QToolButton* makeAdd();
    void follow();

    app::Session& session_;
    WindowList* list_;
    Segments* keep_;
    WindowFields* fields_;
    QStackedLayout* pages_; ///< the list, or the offer
};

} // namespace ui
