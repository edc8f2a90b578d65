// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/session/session.h"

namespace app {

// Other pages of a drawing, as values. No coordinate of the drawing changes. A failure is one
// sentence; lengths are in millimetres on paper.

constexpr double leastPaper = 1, mostPaper = 100'000; ///< a side of the page

/// The page in another size, with its top left corner where it is.
Result<Page> withPaper(Page page, const Point& millimetres);
/// With other edges, in user units.
Result<Page> withEdges(Page page, const clipping::Window& edges);
/// Its width and its height exchanged.
Page turnedPage(Page page);
/// At another scale, the page holds more or less of the drawing. The paper stays as large.
Result<Page> withScale(Page page, double ratio);
Result<Page> withMargins(Page page, const PaperMargins& margins);
/// The page just around a rectangle in user units and the margins.
Result<Page> fittedPage(Page page, const std::optional<clipping::Window>& box);

/// What "Page to drawing" and "Page to windows" fit the page around; empty: there is nothing.
std::optional<clipping::Window> drawingBox(const Session& session);
std::optional<clipping::Window> windowsBox(const Session& session);

/// The part of the page inside its margins, or all of it if they are not shown.
clipping::Window insideOf(const Page& page);
/// Which visible objects are not wholly inside it, by their lines, and a sentence about it; empty
/// without lines.
struct PageCheck {
    ObjectRanges outside{};
    QString text{};
};
PageCheck checkedPage(const Session& session);

/// Changes of the page that are one step to undo, however many they are.
class PageEditing {
public:
    explicit PageEditing(Session& session);

    /// Takes another page; empty: it did. Otherwise why not.
    std::optional<QString> change(const Result<Page>& page);
    void cancel(); ///< the page is as it was at first

private:
    bool isLastStep() const;

    Session& session_;
    Page before_;
    const UndoCommand* step_ = nullptr; ///< that was pushed last
    int stepsDone_ = 0;                 ///< with it
};

} // namespace app
