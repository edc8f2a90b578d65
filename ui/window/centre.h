// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QStackedWidget;
class QVBoxLayout;

namespace ui {

class Canvas;
class MessageStrip;
class MicroscopePage;
class Sheet;
class TilesPage;
class WindowNote;

/// The middle of the window: the canvas, or the microscope or the tiles in its place, with the
/// message strip and, at the first start, a note; a side sheet may stand at the right. These lie
/// over the upper edge of the drawing, so that the view stays when they come and go; the other
/// pages make room for them.
class Centre : public QWidget {
    Q_OBJECT

public:
    Centre(MessageStrip& strip, Canvas& canvas);

    void addNote(WindowNote& note); ///< until it deletes itself; other pages hide it
    void allowNote(bool allowed);   ///< false: it is hidden
    /// Uses this page from now on. The page before is deleted later: it may handle an event now.
    void setMicroscope(MicroscopePage* page);
    MicroscopePage* microscope() const { return microscope_; } ///< null: none yet

    void setTiles(TilesPage* page);             ///< once
    TilesPage* tiles() const { return tiles_; } ///< null: none yet

    /// Shows a side sheet; null: none. The one before is deleted later: it may handle an event now.
    void setSheet(Sheet* sheet);
    Sheet* sheet() const { return sheet_; } ///< null: none

    void showCanvas();
    void showTiles();
    void showMicroscope();
    void showPreview(); ///< of the sheet, which has one
    bool showsCanvas() const;
    void layOut(); ///< at once: nothing is painted in a wrong place before

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void show(QWidget& page);
    void placeMessages();

    QStackedWidget* pages_;
    QVBoxLayout* column_; ///< the pages, and room above them for messages
    QWidget* messages_;   ///< note and strip
    Canvas& canvas_;
    MicroscopePage* microscope_ = nullptr;
    TilesPage* tiles_ = nullptr;
    Sheet* sheet_ = nullptr;
    WindowNote* note_ = nullptr;
    bool noteAllowed_ = true;
};

} // namespace ui
