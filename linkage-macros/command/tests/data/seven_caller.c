/* Reads inputs, and writes both widths' lists at each as doubles. */
#include <stdio.h>
#include "seven_assemblies.h"

static void put(double number) { (void)fwrite(&number, sizeof number, 1, stdout); }

static void put_list(LinkageStatus status, const LinkageAssembly *found, const LinkageAssemblies *list)
{
    uint32_t at;
    put((double)status);
    put((double)list->outcome);
    put((double)list->count);
    put((double)list->samples);
    put((double)list->pieces);
    for (at = 0u; at < list->count; at++) {
        put(found[at].unknown);
        put(found[at].between[0]);
        put(found[at].between[1]);
        put(found[at].room);
        put(found[at].within);
        put((double)found[at].sides);
        put((double)found[at].rises);
    }
}

int main(void)
{
    const LinkageBudget budget = { LINKAGE_SAMPLES, LINKAGE_PIECES };
    double t;
    while (fread(&t, sizeof t, 1, stdin) == 1) {
        LinkageAssembly found[SEVEN_ASSEMBLIES];
        LinkageAssemblies list;
        LinkageStatus status = seven_assemblies(t, budget, found, &list, NULL);
        put_list(status, found, &list);
        status = seven_assemblies_f32((float)t, budget, found, &list, NULL);
        put_list(status, found, &list);
    }
    return 0;
}
