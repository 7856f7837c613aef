// The contour calculator: lines and arcs entered one by one with what the drawing says, the rest
// computed, several solutions chosen in the picture, written as blocks of the channel's language
// under a description that is read back.
#pragma once
#include "hmi/contour/contour_text.hpp"
#include "hmi/screens/programs/editor_overlay.hpp"
#include "hmi/widgets/number_pad.hpp"
#include "hmi/widgets/pictures/contour_picture.hpp"
#include "hmi/widgets/table.hpp"

namespace polyturn::hmi {

contour::Writing contourWriting(const Live& live, unsigned channel, const QString& language);

class ContourPage : public EditorOverlay {
public:
    ContourPage(Context& context, QWidget* parent);
    // The description that the cursor (line from 0) is in; otherwise a new contour there.
    void open(const QStringList& lines, int cursor, contour::Writing writing);
    void refresh() override;
    bool key(QKeyEvent* event) override;
    void addKeys(std::vector<SoftKey>& keys) override;
    std::vector<Sheet*> sheets() override { return {elements_, data_, pad_, note_}; }
    Table& elements() { return *elements_; }  // row 0 is the start point
    Table& data() { return *data_; }
    NumberPad& pad() { return *pad_; }
    ContourPicture& picture() { return *picture_; }
    const contour::Description& description() const { return now_; }
    const contour::Solved& solved() const { return solved_; }
    // of the data table; -1: this element has no such datum
    int rowOf(const char* datum) const;
    void load(const contour::Description& description);  // as if it had been entered

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    struct Datum;
    static const std::vector<Datum>& dataOf(int kind);  // -1: the start
    const Datum* datum() const;
    QString unitOf(const Datum& datum) const;
    contour::Element* element();
    std::optional<double> value(const Datum& datum) const;
    void put(const Datum& datum, std::optional<double> value);
    void input(std::optional<double> value);
    void add(contour::Kind kind);
    void remove();
    void choose(std::size_t choice, std::size_t solution);
    void changed();
    void write();
    QString stateText(std::size_t element) const;
    QString summary(const contour::Element& element) const;
    void composeNote(Writer& w);

    Context& context_;
    Table *elements_, *data_;
    NumberPad* pad_;
    ContourPicture* picture_;
    FreeSheet* note_;
    std::vector<std::string> lines_;
    int cursor_ = 0;
    contour::Place place_;  // of what is read back
    contour::Writing writing_;
    contour::Description now_, before_;
    contour::Solved solved_;
    QString hint_;
    bool edited_ = false;  // its blocks were changed by hand since
};

}  // namespace polyturn::hmi
