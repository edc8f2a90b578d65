// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"
#include "ui/widgets/tool_list.h"

namespace ui {

/// Selects one of all variants, each shown with its marker; optionally after some other choices.
class VariantBox : public ToolList {
    Q_OBJECT

public:
    /// `name` is the accessible name; `before` are the other choices.
    explicit VariantBox(const QString& name, const QStringList& before = {},
                        QWidget* parent = nullptr);

    /// Empty if one of the `before` choices is selected; currentIndex() says which.
    std::optional<app::Variant> variant() const;
    void choose(const app::Variant& variant);

private:
    int rowOf(const app::Variant& variant) const;

    std::vector<app::Variant> all_;
    int before_;
};

} // namespace ui
