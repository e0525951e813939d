#include "support/recorded_step.hpp"

#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

namespace rockslope::recorded_step {

namespace {

/// Visits all numbers of a recording in the order of the file: one list serves reading and writing.
template <class Step, class Visitor>
void visit_numbers(Step& step, Visitor& visit) {
    visit.word("recorded_step");
    visit.version(1);
    visit.word("iterations");
    visit(step.iterations);
    visit.word("factorizations");
    visit(step.factorizations);
    visit.end_line();
    visit.word("tolerance");
    visit(step.tolerance);
    visit.end_line();
    visit.word("rows");
    visit.count(step.rows);
    for (auto& row : step.rows) {
        visit(row.length);
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j <= i; ++j) visit(row.stiffness(i, j));
        for (auto* vector : {&row.load, &row.displacement})
            for (int i = 0; i < 6; ++i) visit((*vector)[i]);
        visit.end_line();
    }
    visit.word("contacts");
    visit.count(step.contacts);
    for (auto& contact : step.contacts) {
        auto& law = contact.law;
        visit(contact.rows.first);
        visit(contact.rows.second);
        for (auto* pair : {&contact.rows.first_arm, &contact.rows.second_arm, &law.opening, &law.shearing})
            for (int i = 0; i < 2; ++i) visit((*pair)[i]);
        for (auto* number :
             {&law.normal_stiffness, &law.shear_stiffness, &law.origin.normal, &law.origin.shear,
              &law.least_normal, &law.floor, &law.tilt, &law.forward.cohesion, &law.forward.slope,
              &law.backward.cohesion, &law.backward.slope})
            visit(*number);
        visit(contact.start.normal);
        visit(contact.start.slides);
        visit.end_line();
    }
}

class Writer {
  public:
    explicit Writer(const std::filesystem::path& file) : out_(file) { out_.precision(12); }
    void word(const char* name) { write(name); }
    void version(int number) {
        write(number);
        end_line();
    }
    template <class List>
    void count(const List& list) {
        write(list.size());
        end_line();
    }
    void operator()(double number) { write(number == 0 ? 0.0 : number); }
    void operator()(dda::RowIndex row) { write(row.exists() ? row.value() : -1); }
    void operator()(dda::Piece::Normal normal) { write(static_cast<int>(normal)); }
    void end_line() {
        out_ << '\n';
        is_line_begun_ = false;
    }
    bool is_good() const { return out_.good(); }

  private:
    template <class Value>
    void write(const Value& value) {
        if (is_line_begun_) out_ << ' ';
        out_ << value;
        is_line_begun_ = true;
    }

    std::ofstream out_;
    bool is_line_begun_ = false;
};

class Reader {
  public:
    explicit Reader(const std::filesystem::path& file) : file_(file), in_(file) {}
    void word(const std::string& name) { expect(next() == name, name); }
    void version(int number) { expect(next() == std::to_string(number), "another version"); }
    template <class List>
    void count(List& list) {
        list.resize(static_cast<std::size_t>(number()));
    }
    void operator()(double& to) { to = number(); }
    void operator()(int& to) { to = static_cast<int>(number()); }
    void operator()(dda::RowIndex& row) {
        const int index = static_cast<int>(number());
        row = index < 0 ? dda::RowIndex::none() : dda::RowIndex(index);
    }
    void operator()(dda::Piece::Normal& normal) { normal = static_cast<dda::Piece::Normal>(number()); }
    void end_line() {}

  private:
    std::string next() {
        std::string token;
        expect(static_cast<bool>(in_ >> token), "more");
        return token;
    }
    double number() { return std::stod(next()); }
    void expect(bool is_met, const std::string& what) const {
        if (!is_met) throw std::runtime_error("no recording, " + what + " expected: " + file_.string());
    }

    std::filesystem::path file_;
    std::ifstream in_;
};

}  // namespace

RecordedStep read_step(const std::filesystem::path& file) {
    RecordedStep step;
    Reader reader(file);
    visit_numbers(step, reader);
    for (RecordedStep::Row& row : step.rows) row.stiffness = row.stiffness.selfadjointView<Eigen::Lower>();
    return step;
}

void write_step(const RecordedStep& step, const std::filesystem::path& file) {
    Writer writer(file);
    visit_numbers(step, writer);
    if (!writer.is_good()) throw std::runtime_error("cannot be written: " + file.string());
}

Equations::Equations(const RecordedStep& recorded) {
    for (const RecordedStep::Row& row : recorded.rows) {
        length_.push_back(row.length);
        base_.stiffness.push_back(row.stiffness);
        base_.load.push_back(row.load);
        found_.push_back(row.displacement);
    }
    for (const RecordedStep::Contact& contact : recorded.contacts) {
        springs_.emplace_back().rows = contact.rows;
        contacts_.push_back(contact.law);
    }
    for (const dda::ContactIndex k : contacts_.indices()) contacts_[k].rows = &springs_[k].rows;
    row_contacts_.find(recorded.rows.size(), springs_);
}

}  // namespace rockslope::recorded_step
