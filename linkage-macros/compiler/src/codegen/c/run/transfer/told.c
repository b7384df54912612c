
/* A side by a number and the rounding of that, and the side that is wanted: 1 or -1. */
static LinkageStatus STEM_told(LinkageWide value, LinkageWide rounding, int wanted, LinkageError *error, const char *group, const char *name)
{
    if (!(STEM_size(value) > rounding)) {
        return STEM_refused(error, LINKAGE_SINGULAR, group, name);
    }
    if ((value > 0) != (wanted > 0)) {
        return STEM_refused(error, LINKAGE_OTHER_ASSEMBLY, group, name);
    }
    return LINKAGE_OK;
}
