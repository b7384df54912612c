
/* The side of a pin: left or right of the way between the outer joints. */
static LinkageStatus STEM_across(LinkageWide x, LinkageWide y, LinkageWide to_x, LinkageWide to_y, LinkageWide pin_x,
    LinkageWide pin_y, LinkageWide rounding, int wanted, LinkageError *error, const char *group, const char *name)
{
    const LinkageWide right = pin_x - x, up = pin_y - y;
    const LinkageWide size = STEM_larger(STEM_larger(STEM_size(x), STEM_size(y)), STEM_larger(STEM_size(right), STEM_size(up)));
#ifdef LINKAGE_NO_DOUBLE
    const float unit = STEM_unit(size), own_x = x * unit, own_y = y * unit;
    const LinkagePair first = linkage_pair_times(linkage_pair_sum(to_x * unit, -own_x), linkage_pair_sum(pin_y * unit, -own_y));
    const LinkagePair other = linkage_pair_times(linkage_pair_sum(to_y * unit, -own_y), linkage_pair_sum(pin_x * unit, -own_x));
    const float value = linkage_pair_plus(first, linkage_pair_minus(other)).high, scaled = size * unit;
    return STEM_told(value, rounding * scaled * scaled, wanted, error, group, name);
#else
    const double value = (to_x - x) * up - (to_y - y) * right;
    return STEM_told(value, rounding * size * size, wanted, error, group, name);
#endif
}
