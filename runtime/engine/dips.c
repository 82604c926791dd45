/* The determinant of the position matrix from step to step; see dips.h. */
#include "dips.h"

int flexel_dips_look(flexel_dips *o, const flexel_matrix *P, int known)
{
    const int sign = flexel_matrix_sign(P);
    const double size = flexel_matrix_logarithm(P), fall = o->size - size;
    const int found = known && (sign != o->sign || fall >= FLEXEL_DIP || o->fall >= FLEXEL_DIP);
    *o = (flexel_dips){sign, size, known ? fall : 0};
    return found;
}
