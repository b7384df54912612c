
/* A pose on another assembly of the solver `name`, or one whose group is at a limit. */
static LinkageStatus STEM_refused(LinkageError *error, LinkageStatus status, const char *group, const char *name)
{
    LinkageWhy why = linkage_why(0);
    why.status = status;
    why.group = group;
    why.name = status == LINKAGE_OTHER_ASSEMBLY ? name : NULL;
    return linkage_refused(&why, error);
}
