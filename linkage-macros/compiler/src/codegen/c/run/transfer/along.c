
/* The side of a pin: ahead of the outer joint along a guide, or behind it. */
static LinkageStatus STEM_along(LinkageWide x, LinkageWide y, LinkageWide along_x, LinkageWide along_y, LinkageWide pin_x,
    LinkageWide pin_y, LinkageWide rounding, int wanted, LinkageError *error, const char *group, const char *name)
{
    const LinkageWide right = pin_x - x, up = pin_y - y;
    const LinkageWide size = STEM_larger(STEM_larger(STEM_size(x), STEM_size(y)), STEM_larger(STEM_size(right), STEM_size(up)));
    return STEM_told(along_x * right + along_y * up, rounding * size, wanted, error, group, name);
}
