#include "algebra/residue_rows_body.hpp"

namespace eliminant::algebra {

extern const ResidueRows residue_rows_avx2;
const ResidueRows residue_rows_avx2 = compiled_rows;

} // namespace eliminant::algebra
