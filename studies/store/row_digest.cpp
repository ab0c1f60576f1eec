#include "studies/store/row_digest.hpp"

namespace ff::studies {

void add_rows(Digest& digest, const Database& database, std::string_view sql) {
    Statement rows(database.handle(), sql);
    while (rows.step()) {
        for (int column = 0; column < rows.columns(); ++column) {
            const bool number = rows.is_number(column);
            digest.add(number ? 1 : 0);
            if (number)
                digest.add_number(rows.real(column)).add(static_cast<std::uint64_t>(rows.integer(column)));
            else
                digest.add(rows.text(column));
        }
    }
}

}  // namespace ff::studies
