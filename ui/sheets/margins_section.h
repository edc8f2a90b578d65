// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sheets/page_section.h"

class QCheckBox;

namespace ui {

/// The margins of the page.
class MarginsSection : public PageSection {
    Q_OBJECT

public:
    MarginsSection(app::Session& session, app::PageEditing& editing);

    void follow() override;

private:
    void takeSide(std::size_t side, double millimetres);

    std::array<LengthField*, 4> sides_; ///< left, top, right, bottom
    QCheckBox *shown_, *same_;
    QLabel* unit_;
};

} // namespace ui
