// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/properties/colour_choice.h"
#include "ui/tools/tool.h"

#include <QLabel>
#include <QToolBar>
#include <QToolButton>

#include <functional>
#include <vector>

namespace ui {

class ArrangeRow;
class GridChoice;
class NodeRow;
class Segments;
class ShapeOptions;
class StrokeRow;
class StylePopup;

/// The bar across the top: undo and redo, the tool in hand, and what belongs to it. With a tool
/// that draws the stroke. With it, or while nothing is selected, and while there is a window, how
/// the removed part is shown. With selected objects what arranges them; their stroke is in their
/// capsule. With the tools Nodes and Clip window their options, with Hand and Zoom what fits the
/// view. What is chosen may have its capsule here. Panes if they are offered or there are several.
/// At the right snapping, grid and export, always at the same place. If it is narrow, it drops
/// captions, then the tool's name, the removed part and what arranging refers to, some parts of
/// the capsule, the grid's spacing, the export button's text, and last what arranges: the menu has
/// that, too.
class OptionBar : public QToolBar {
    Q_OBJECT

public:
    OptionBar(app::Session& session, Canvas& canvas);

    /// Adds the buttons of these commands at the left.
    void addSteps(QAction& undo, QAction& redo);
    /// Adds the button of a command for nodes.
    void addNodeStep(QAction& step);
    /// Adds the button of a command that fits the view.
    void addViewStep(QAction& step);
    /// Gives this command the button at the right.
    void setExport(QAction& exportSheet);
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
    /// Parts of the bar that are offered together.
    struct Group {
        QList<QAction*> parts;
        std::function<bool()> offered;
        int until = 99; ///< the step of arrange() at which there is no room for it
    };
    void addTool();
    void addCapsule();
    void addStroke();
    void addStyle();
    void addClipping();
    void addPanes();
    void addFixed();
    void addExport();
    void addGroup(const std::function<void()>& add, std::function<bool()> offered, int until = 99);
    QLabel* addCaption(const QString& text);
    bool has(ToolInfo::Options options) const; ///< the tool in hand
    bool arranges() const;                     ///< the selected objects are in hand
    bool drawsOrRests() const;
    bool rests() const; ///< nothing is selected, with Select
    void follow();
    void fitInto(int width);
    void arrange(int step);

    app::Session& session_;
    Canvas& canvas_;
    QToolButton* tool_; ///< its icon and name
    StrokeRow* stroke_;
    QToolButton* style_;
    ArrangeRow* arranging_;
    StylePopup* stylePopup_;
    GridChoice* grid_;
    ShapeOptions* shape_;
    QWidget* capsule_; ///< of what is chosen, if the person wants it here
    Segments *removed_, *panes_;
    NodeRow* nodes_;
    QWidget* view_;
    QToolButton* export_;
    std::vector<Group> groups_;
    QList<QAction*> captions_;
    bool panesOffered_ = false, fitting_ = false;
    std::vector<bool> shown_; ///< of each group: whether it was offered when all was arranged
    QString named_;           ///< and the tool and the shape then
};

} // namespace ui
