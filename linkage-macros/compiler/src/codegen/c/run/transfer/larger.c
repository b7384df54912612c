
static double STEM_larger(double a, double b)
{
    return a > b ? a : b;
}
