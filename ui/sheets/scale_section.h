// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sheets/page_section.h"

namespace ui {

class Segments;

/// The drawing's scale and the unit of its lengths.
class ScaleSection : public PageSection {
    Q_OBJECT

public:
    ScaleSection(app::Session& session, app::PageEditing& editing);

    void follow() override;

private:
    void takeUnit(app::Unit unit);

    LengthField* ratio_;
    Segments *usual_, *unit_;
    QLabel* meaning_;
};

} // namespace ui
