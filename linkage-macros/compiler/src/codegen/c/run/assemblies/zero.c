
/* The place at which the equation of a mode changes its sign, by halving. */
static double root_between(const Placed *placed, const double ends[2], uint32_t sides, int rises)
{
    double low = ends[0], high = ends[1];
    for (;;) {
        const double middle = (low + high) / 2.0;
        if (!(low < middle && middle < high)) {
            return middle;
        }
        if ((missed(placed, middle, sides) > 0.0) == rises) {
            high = middle;
        } else {
            low = middle;
        }
    }
}

/* The assembly at a zero of the product: the only mode whose equation changes its sign there. */
static int assembly_at(const Placed *placed, const double zero[2], LinkageAssembly *to)
{
    /* The widths of angles within which the mode of a zero is looked for. */
    static const double widths[4] = { 1e-12, 1e-11, 1e-10, 1e-9 };
    int at;
    for (at = 0; at < 4; at++) {
        const double ends[2] = { zero[0] - widths[at], zero[1] + widths[at] };
        uint32_t sides, changing = 0u;
        for (sides = 0u; sides < 1u << placed->kind->count; sides++) {
            const double low = missed(placed, ends[0], sides), high = missed(placed, ends[1], sides);
            if (low == low && high == high && (low > 0.0) != (high > 0.0)) {
                changing += 1u;
                to->sides = sides;
                to->rises = high > 0.0;
            }
        }
        if (changing == 1u) {
            const double root = root_between(placed, ends, to->sides, to->rises);
            to->unknown = wrapped(root);
            to->between[0] = ends[0] + (to->unknown - root);
            to->between[1] = ends[1] + (to->unknown - root);
            return 1;
        }
    }
    return 0;
}
