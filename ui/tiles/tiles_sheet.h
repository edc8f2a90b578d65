// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/live_sheets.h"
#include "ui/widgets/sheet.h"

namespace ui {

class SheetsSection;

/// What the tiles are like and how they are exported: a section for each, and the button that
/// writes the files.
class TilesSheet : public Sheet {
    Q_OBJECT

public:
    /// `overview` shows the whole drawing, small.
    TilesSheet(app::Session& session, app::LiveSheets& sheets, QWidget& overview);

    SheetsSection& sheetsSection() { return *sheetsSection_; }

signals:
    void exportWanted();
    void entered(); ///< a value was typed, and taken: the focus may return to the tiles

private:
    SheetsSection* sheetsSection_;
};

} // namespace ui
