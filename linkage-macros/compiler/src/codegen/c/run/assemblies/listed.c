
/* Tangents of half the angles from which the circle is divided. The second is for an assembly that lies where the first
 * divides. */
#define FIRST_ORIGIN 0.1875
#define OTHER_ORIGIN 0.34375

/* The most assemblies of a group. */
#define MOST_ASSEMBLIES 60

/* The list in the order of the unknown, with the room of each. */
static void sort_assemblies(LinkageAssembly *all, uint32_t count)
{
    const uint32_t last = count - 1u;
    double around, before;
    uint32_t at;
    for (at = 1u; at < count; at++) {
        const LinkageAssembly one = all[at];
        uint32_t to = at;
        while (to > 0u && all[to - 1u].unknown > one.unknown) {
            all[to] = all[to - 1u];
            to -= 1u;
        }
        all[to] = one;
    }
    if (count == 0u) {
        return;
    }
    around = TAU - (all[last].unknown - all[0].unknown);
    before = around;
    for (at = 0u; at < count; at++) {
        const double behind = at < last ? all[at + 1u].unknown - all[at].unknown : around;
        all[at].room = fmin(before, behind) / 2.0;
        before = behind;
    }
}

/* The room of each assembly is halved until a search about it is inside. */
static void search_within(const Placed *placed, LinkageAssembly *all, uint32_t count)
{
    uint32_t at;
    for (at = 0u; at < count; at++) {
        double within = all[at].room;
        int step;
        for (step = 0; step < 52; step++) {
            const double ahead = missed(placed, all[at].unknown + within, all[at].sides);
            const double behind = missed(placed, all[at].unknown - within, all[at].sides);
            if (ahead == ahead && behind == behind) {
                break;
            }
            within /= 2.0;
        }
        all[at].within = within;
    }
}

/* The group with its numbers; 0 where a number is not finite or a bar has no length. */
static int placed_is_made(Placed *placed, const LinkagePinned *kind, const double *numbers)
{
    double size = fabs(numbers[0]);
    int at, bar, is_finite, has_bars = 1;
    LinkageBodyPin pins[4 + 16];
    placed->kind = kind;
    placed->places = &numbers[1];
    placed->length = numbers[0];
    placed->scale = 1.0;
    placed->origins[STANDING] = kind->pivot[0];
    placed->origins[TURNED] = kind->pivot[1];
    pins[0].body = STANDING;
    pins[0].place = kind->pivot[0];
    pins[1].body = TURNED;
    pins[1].place = kind->pivot[1];
    pins[2] = kind->equation[0];
    pins[3] = kind->equation[1];
    for (at = 0; at < kind->count; at++) {
        for (bar = 0; bar < 2; bar++) {
            const LinkageHungBar *of = &kind->dyads[at][bar];
            LinkageBodyPin *to = &pins[4 + 4 * at + 2 * bar];
            placed->origins[of->body] = of->ends[0];
            to[0] = of->outer;
            to[1].body = of->body;
            to[1].place = of->ends[1];
        }
    }
    is_finite = linkage_is_finite(numbers[0]);
    for (at = 0; at < 4 + 4 * kind->count; at++) {
        const Complex place = pin_of(placed, pins[at]);
        size = fmax(fmax(size, fabs(place.x)), fabs(place.y));
        is_finite = is_finite && linkage_is_finite(place.x) && linkage_is_finite(place.y);
    }
    for (at = 0; at < kind->count; at++) {
        for (bar = 0; bar < 2; bar++) {
            has_bars = has_bars && length_of(bar_of(placed, &kind->dyads[at][bar])) > 0.0;
        }
    }
    if (!is_finite || !has_bars || !(size > 0.0)) {
        return 0;
    }
    placed->scale = scalbn(1.0, -ilogb(size));
    return linkage_is_finite(placed->scale);
}

/* Lists all assemblies with the circle divided from one origin. */
static void list_from(const Placed *placed, const Nodes *nodes, double origin, LinkageBudget budget, LinkageAssembly *assemblies, LinkageAssemblies *list)
{
    Search search;
    list->count = 0u;
    list->samples = 0u;
    list->pieces = 0u;
    list->from = 0.0;
    list->to = 0.0;
    search.placed = placed;
    search.nodes = nodes;
    search.origin = origin;
    search.budget = budget;
    search.assemblies = assemblies;
    search.list = list;
    search.untold = 0;
    search.is_unplaced = 0;
    take_circle(&search);
    sort_assemblies(assemblies, list->count);
    search_within(placed, assemblies, list->count);
}

/* The list from the other origin in the place of one that is open, where it is proved. */
static LINKAGE_COLD void list_again(const Placed *placed, const Nodes *nodes, LinkageBudget budget, LinkageAssembly *assemblies, LinkageAssemblies *list)
{
    LinkageAssembly others[MOST_ASSEMBLIES];
    LinkageAssemblies again;
    LinkageBudget left;
    left.samples = budget.samples - list->samples;
    left.pieces = budget.pieces - list->pieces;
    list_from(placed, nodes, OTHER_ORIGIN, left, others, &again);
    again.samples += list->samples;
    again.pieces += list->pieces;
    if (again.outcome == LINKAGE_PROVED) {
        (void)memcpy(assemblies, others, again.count * sizeof *others);
        *list = again;
    }
    list->samples = again.samples;
    list->pieces = again.pieces;
}

void linkage_list_assemblies(const LinkagePinned *kind, const double *numbers, LinkageBudget budget, LinkageAssembly *assemblies, LinkageAssemblies *list)
{
    Placed placed;
    Nodes nodes;
    if (!placed_is_made(&placed, kind, numbers)) {
        list->outcome = LINKAGE_OPEN;
        list->count = 0u;
        list->from = -PI;
        list->to = PI;
        list->samples = 0u;
        list->pieces = 0u;
        return;
    }
    make_nodes(2 * kind->half + 1, &nodes);
    list_from(&placed, &nodes, FIRST_ORIGIN, budget, assemblies, list);
    if (list->outcome == LINKAGE_OPEN) {
        list_again(&placed, &nodes, budget, assemblies, list);
    }
}

int32_t linkage_nearest_angle(const double *angles, uint32_t count, double measured, double *off, double *runner_up)
{
    int32_t nearest = -1;
    double best = (double)NAN, next = (double)NAN;
    uint32_t at;
    for (at = 0u; at < count; at++) {
        const double distance = fabs(wrapped(angles[at] - measured));
        if (distance != distance) {
            continue;
        }
        if (nearest < 0 || distance < best) {
            next = best;
            best = distance;
            nearest = (int32_t)at;
        } else {
            next = fmin(next, distance);
        }
    }
    if (off != NULL) {
        *off = best;
    }
    if (runner_up != NULL) {
        *runner_up = next;
    }
    return nearest;
}

#endif /* LINKAGE_NO_DOUBLE */
