// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/style/colour_choice.h"

#include <QLabel>
#include <QToolBar>
#include <QToolButton>

namespace ui {

class GridChoice;
class LengthField;
class NodeRow;
class Segments;
class SnapChoice;
class StylePopup;
class ToolList;
class WindowOptions;

/// The bar across the top: undo, redo, the stroke of selected or new objects, or the options of the
/// tool Clip window in their place, while there is a window the side that is kept and how the
/// removed part is shown, panes if they are offered or there are several; at the right snapping,
/// grid, tiles and export. With the tool Nodes, the commands for nodes take the place of stroke,
/// clipping and panes. If it is narrow, it first drops the button of the tiles, then captions, the
/// grid's spacing, the list of kinds to snap to, and last the export button's text.
class OptionBar : public QToolBar {
    Q_OBJECT

public:
    OptionBar(app::Session& session, Canvas& canvas);

    /// Adds the buttons of these commands at the left.
    void addSteps(QAction& undo, QAction& redo);
    /// Adds the button of a command for nodes.
    void addNodeStep(QAction& step);
    /// Gives this command the button at the right.
    void setExport(QAction& exportCut);
    /// Gives this command a button left of it, shown while it is offered and there is room.
    void setTiles(QAction& tiles);
    void offerTiles(bool offered);
    void offerPanes(bool offered);
    /// Names this command's key on the button that opens the panel Style.
    void setStyleCommand(QAction& style);
    void openStyle();
    /// The next click on the canvas takes the colour of what is there.
    void takeColour(app::PaintPart part);

signals:
    void refused(const QString& sentence); ///< a typed length is not one
    void taken();                          ///< the length is valid again

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void addStroke();
    void addClipping();
    void addPanes(Canvas& canvas);
    void showOptionsOf(std::string_view tool);
    bool isOffered(QAction* action) const; ///< for the tool in hand
    void addExport();
    void fitInto(int width);
    void arrange(int step);
    QLabel* addCaption(const QString& text);
    void followDisplay();
    void followStyle();

    app::Session& session_;
    ColourChoice* strokeColour_;
    LengthField* width_;
    ToolList* dashes_;
    QToolButton* style_;
    StylePopup* stylePopup_;
    SnapChoice* snapping_;
    GridChoice* grid_;
    Segments *keep_, *removed_, *panes_;
    WindowOptions* window_;
    QAction* windowShown_ = nullptr; ///< the place of its options in the bar
    QList<QAction*> ofOthers_;       ///< not for it: the stroke, and Keep, which its panel has
    QList<QAction*> ofWindows_, ofPanes_;
    std::string_view tool_{};
    QList<QLabel*> captions_;
    NodeRow* nodes_;
    QAction* nodesShown_;     ///< the place of the commands for nodes in the bar
    QList<QAction*> instead_; ///< what they take the place of
    QToolButton *tiles_, *export_;
    QAction* tilesPlace_ = nullptr; ///< of the button
    bool tilesOffered_ = false, panesOffered_ = false, hasWindows_ = false, hasPanes_ = false;
};

} // namespace ui
