
/* The side of a pin: ahead of the outer joint along a guide, or behind it. */
static LinkageStatus STEM_along(double x, double y, double along_x, double along_y, double pin_x, double pin_y,
    double rounding, int wanted, LinkageError *error, const char *group, const char *name)
{
    const double right = pin_x - x, up = pin_y - y;
    const double size = STEM_larger(STEM_larger(fabs(x), fabs(y)), STEM_larger(fabs(right), fabs(up)));
    return STEM_told(along_x * right + along_y * up, rounding * size, wanted, error, group, name);
}
