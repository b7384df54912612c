
/* The side of a pin: left or right of the way between the outer joints. */
static LinkageStatus STEM_across(double x, double y, double to_x, double to_y, double pin_x, double pin_y, double rounding,
    int wanted, LinkageError *error, const char *group, const char *name)
{
    const double right = pin_x - x, up = pin_y - y;
    const double size = STEM_larger(STEM_larger(fabs(x), fabs(y)), STEM_larger(fabs(right), fabs(up)));
    const double value = (to_x - x) * up - (to_y - y) * right;
    return STEM_told(value, rounding * size * size, wanted, error, group, name);
}
