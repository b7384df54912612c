/* Reads machines of eleven doubles, and writes what both widths say of each as doubles. */
#include <stdio.h>
#include <math.h>
#include "triad_assemblies.h"

static void put(double number) { (void)fwrite(&number, sizeof number, 1, stdout); }

static void put_list(LinkageStatus status, const LinkageAssemblies *list)
{
    put((double)status);
    put((double)list->outcome);
    put((double)list->count);
    put((double)list->samples);
    put((double)list->pieces);
}

static void put_assembly(const LinkageAssembly *at)
{
    put(at->unknown);
    put(at->between[0]);
    put(at->between[1]);
    put(at->room);
    put(at->within);
    put((double)at->sides);
    put((double)at->rises);
}

int main(void)
{
    const LinkageBudget budget = { LINKAGE_SAMPLES, LINKAGE_PIECES };
    double given[11];
    while (fread(given, sizeof given, 1, stdin) == 1) {
        const Triad wide = { given[1], given[2], given[3], given[4], given[5], given[6], given[7], given[8], given[9], given[10] };
        const TriadF32 narrow = { (float)given[1], (float)given[2], (float)given[3], (float)given[4], (float)given[5],
            (float)given[6], (float)given[7], (float)given[8], (float)given[9], (float)given[10] };
        LinkageAssembly found[TRIAD_ASSEMBLIES];
        LinkageAssemblies list = { LINKAGE_OPEN, 0u, 0.0, 0.0, 0u, 0u };
        double angles[TRIAD_ASSEMBLIES], off, runner_up;
        uint32_t at;
        put_list(triad_assemblies(&wide, given[0], budget, found, &list, NULL), &list);
        for (at = 0u; at < list.count; at++) {
            const TriadAssembly own = triad_with(&wide, &found[at]);
            TriadAssemblyPosition pose;
            put_assembly(&found[at]);
            put((double)triad_assembly_position(&own, given[0], &pose, NULL));
            put(pose.R.x);
            put(pose.R.y);
            angles[at] = at == 0u ? (double)NAN : found[at].unknown;
        }
        /* The first one has no angle. */
        put((double)linkage_nearest_angle(angles, list.count, 40.0, &off, &runner_up));
        put(off);
        put(runner_up);
        list.count = 0u;
        put_list(triad_assemblies_f32(&narrow, (float)given[0], budget, found, &list, NULL), &list);
        for (at = 0u; at < list.count; at++) {
            const TriadAssemblyF32 own = triad_with_f32(&narrow, &found[at]);
            put_assembly(&found[at]);
            put((double)own.phi_near);
            put((double)own.PQ_side);
            put((double)own.phi_trend);
        }
    }
    return 0;
}
