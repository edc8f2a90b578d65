// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"
#include "ui/docks/compare_model.h"
#include "ui/widgets/dense_table.h"

#include <QSortFilterProxyModel>

namespace ui {

class CompareCells;

/// The algorithms of a race, in the order of the catalogue. A click on a heading sorts them once;
/// the rows then stay where they are, whatever is measured. A second click returns to the order of
/// the catalogue. Selecting a row selects its algorithm in the session, and a click on a time its
/// form. If space is short, the table drops the full names, then the lane of times, then digits. A
/// last column is shown only where not every algorithm can clip at all clip windows: it says which
/// can.
class CompareTable : public DenseTable {
    Q_OBJECT

public:
    explicit CompareTable(app::Session& session, QWidget* parent = nullptr);

    /// As CompareModel::show.
    void showRows(std::span<const app::RaceRow> rows, std::size_t lines,
                  app::WindowNeeds needs = app::WindowNeeds::Rectangle,
                  const QString& limiting = {});
    void sortByTime(); ///< once; of the corrected forms, if they are shown
    /// Low rows are for panels without room for others.
    enum class Rows : std::uint8_t { High, Low };
    int heightFor(int rows, Rows height = Rows::High) const; ///< with the headings
    void setRows(Rows height);
    const CompareModel& content() const { return model_; }

    QSize sizeHint() const override; ///< for all rows

signals:
    void menuWanted(const clipping::Algorithm& algorithm, const QPoint& place); ///< of a row

protected:
    void contextMenuEvent(QContextMenuEvent* event) override;
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void choose(const QModelIndex& index, std::optional<clipping::Form> form = {});
    void follow();
    void sortBy(int column);
    void sortOnce(int column);
    void fitColumns();
    bool hides(int column) const;
    int widthOf(int column) const;
    int spread(bool lane, int digits);

    app::Session& session_;
    CompareModel model_;
    QSortFilterProxyModel sorted_;
    CompareCells* cells_;
    Rows rows_ = Rows::High;
    int sortedBy_ = -1; ///< the column; -1: the rows are in the order of the catalogue
    /// They only grow while the drawing is the same, so that nothing jumps.
    std::vector<int> widths_;
    bool following_ = false;
};

} // namespace ui
