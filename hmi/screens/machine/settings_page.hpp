// The computer's settings: date, zone, network, keyboard, and the language of the screens. What
// this computer does not let anybody change here is shown with the reason.
#pragma once
#include "hmi/widgets/screen.hpp"
#include "hmi/machine/tools/computer_settings.hpp"
#include "hmi/widgets/table.hpp"

namespace polyturn::hmi {

class SettingsPage : public QWidget {
public:
    SettingsPage(Context& context, QWidget* parent);
    void begin();  // is shown: everything is read anew
    void refresh();
    bool key(QKeyEvent* event) { return table_->key(event); }
    void addKeys(std::vector<SoftKey>& keys);
    std::vector<Sheet*> sheets() { return {table_, note_}; }
    Table& table() { return *table_; }
    ComputerSettings& computer() { return computer_; }
    const QString& told() const { return told_; }

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void change();
    bool onLanguage() const { return table_->row() == static_cast<int>(computerSettings().size()); }
    const ComputerSetting* chosen() const;
    void composeNote(Writer& w);
    Context& context_;
    ComputerSettings computer_;
    Table* table_;
    FreeSheet* note_;
    QString told_;
    bool good_ = true;
    int level_ = 0;
    qint64 lookAt_ = 0;
};

}  // namespace polyturn::hmi
