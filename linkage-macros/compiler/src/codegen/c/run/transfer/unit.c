
#ifdef LINKAGE_NO_DOUBLE
/* The power of two by which a size is about one: products of float then neither overflow nor vanish. */
static float STEM_unit(float size)
{
    int exponent = 0;
    (void)frexpf(size, &exponent);
    if (exponent < -120) {
        exponent = -120;
    }
    return ldexpf(1.0f, exponent > 120 ? -120 : -exponent);
}
#endif
