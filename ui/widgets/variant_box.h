// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"
#include "ui/widgets/tool_list.h"

#include <functional>

namespace ui {

/// Chooses what clips, among all there are, each with its marker; perhaps after some other choices.
class VariantBox : public ToolList {
    Q_OBJECT

public:
    /// `name` is what it is called to those who do not see it.
    explicit VariantBox(const QString& name, const QStringList& before = {},
                        QWidget* parent = nullptr);

    /// Nothing: one of the choices before; currentIndex() says which.
    std::optional<app::Variant> variant() const;
    void choose(const app::Variant& variant);
    /// Only those that fit can be chosen. If the current one cannot, the first choice is.
    void offer(const std::function<bool(const app::Variant&)>& fits);

protected:
    void changeEvent(QEvent* event) override;

private:
    int rowOf(const app::Variant& variant) const;
    void paintMarkers();

    std::vector<app::Variant> all_;
    int before_;
};

} // namespace ui
