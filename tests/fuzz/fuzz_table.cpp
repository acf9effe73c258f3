#include "base/table.h"
#include "expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto table = tumble::parse_table(std::string(fuzz::text_of(data, size)), "table.csv");
    if (!table) {
        fuzz::expect_helpful(table.problems());
        return 0;
    }
    // What was read once is written and read again as the same cells.
    std::string written = tumble::csv_line(table->heads());
    for (std::size_t row = 0; row < table->rows(); ++row) {
        std::vector<std::string> cells;
        for (std::size_t column = 0; column < table->heads().size(); ++column)
            cells.emplace_back(table->cell(row, column));
        written += tumble::csv_line(cells);
    }
    const auto again = tumble::parse_table(written, "again.csv");
    fuzz::expect(again.ok() && again->heads() == table->heads() && again->rows() == table->rows(), "same shape again");
    for (std::size_t row = 0; row < table->rows(); ++row)
        for (std::size_t column = 0; column < table->heads().size(); ++column)
            fuzz::expect(again->cell(row, column) == table->cell(row, column), "same cell again");
    for (const std::string& head : table->heads())
        if (const auto numbers = table->numbers(head); !numbers)
            fuzz::expect_helpful(numbers.problems());
    return 0;
}
