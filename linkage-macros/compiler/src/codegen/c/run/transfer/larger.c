
static LinkageWide STEM_larger(LinkageWide a, LinkageWide b)
{
    return a > b ? a : b;
}

static LinkageWide STEM_size(LinkageWide a)
{
    return STEM_larger(a, -a);
}
