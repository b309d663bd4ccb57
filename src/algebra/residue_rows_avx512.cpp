#include "algebra/residue_rows_body.hpp"

namespace eliminant::algebra {

extern const ResidueRows residue_rows_avx512;
const ResidueRows residue_rows_avx512 = compiled_rows;

} // namespace eliminant::algebra
