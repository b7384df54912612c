
/* The part of a piece at which it is divided: beside its middle, where a drawing has its symmetries. */
#define DIVIDED_AT 0.515625

/* The shortest piece that is divided, in half an angle. */
#define SHORTEST 1e-8

/* The count of pieces that tell nothing behind which the search ends. */
#define MOST_UNTOLD 16

/* The most pieces that wait at once: each that is divided leaves one waiting, and none is divided thirty times. */
#define WAITING 64

/* The part of a bar's length, squared, within which a dyad is not said to fail. */
#define ROUNDING 1e-9

/* A part of one half of the circle, z = z0 (1 + i t)/(1 - i t) or its opposite, from one t to another. */
typedef struct Piece {
    double from;
    double to;
    int is_opposite;
} Piece;

/* A search under way, and the tangent of half the angle from which halves of the circle are counted. */
typedef struct Search {
    const Placed *placed;
    const Nodes *nodes;
    double origin;
    LinkageBudget budget;
    LinkageAssembly *assemblies;
    LinkageAssemblies *list;
    int untold;    /* the count of pieces that tell nothing, and the first of them with what follows it at once */
    double first[2];
    int is_unplaced; /* 1 if a zero was found at which no mode changes its sign alone */
    double unplaced[2];
} Search;

/* (1 + i t)/(1 - i t) of a real t. */
static Disc unit(Disc tangent)
{
    const Disc one = disc_of(1.0, 0.0, 0.0), i = disc_of(0.0, 1.0, 0.0);
    const Disc half = plus_disc(one, times_disc(i, tangent));
    const Disc square = plus_disc(one, times_disc(tangent, tangent));
    return times_disc(times_disc(half, half), inverse_disc(square));
}

static double angle_at(const Search *search, int is_opposite, double tangent)
{
    return 2.0 * (atan(tangent) + atan(search->origin)) + (is_opposite ? PI : 0.0);
}

static void angles_of(const Search *search, const Piece *piece, const double ends[2], double angles[2])
{
    const double from = angle_at(search, piece->is_opposite, ends[0]);
    const double turns = floor((from + PI) / TAU);
    angles[0] = from - turns * TAU;
    angles[1] = angle_at(search, piece->is_opposite, ends[1]) - turns * TAU;
}

/* The tangent at a node of a piece, which is off by ten units of a cosine and by four of the greater end at most. */
static Disc tangent_at(const Piece *piece, double at)
{
    const double x = (piece->from + piece->to) / 2.0 + (piece->to - piece->from) / 2.0 * at;
    return disc_of(x, 0.0, 16.0 * DBL_EPSILON * fmax(fabs(piece->from), fabs(piece->to)));
}

/* True if a dyad on the turned body and on what stands still does not assemble as near to an angle: its base is longer than
 * both bars, or shorter than their difference, by more than the base can change. */
static int has_none(const Placed *placed, double angle, double within)
{
    int at, is_none = 0;
    for (at = 0; at < placed->kind->count; at++) {
        const LinkageHungBar *bars = placed->kind->dyads[at];
        const LinkageBodyPin first = bars[0].outer, second = bars[1].outer;
        if (first.body + second.body == STANDING + TURNED && first.body != second.body) {
            const Complex arm = pin_of(placed, first.body == TURNED ? first : second);
            const Complex far = pin_of(placed, first.body == TURNED ? second : first);
            const double base = square_of(minus_complex(times_complex(turned(angle), arm), far));
            const double change = 2.0 * length_of(arm) * length_of(far) * within;
            const double one = length_of(bar_of(placed, &bars[0])), other = length_of(bar_of(placed, &bars[1]));
            const double sum = (one + other) * (one + other), difference = (one - other) * (one - other);
            const double room = ROUNDING * (base + sum + change);
            is_none |= base - change > sum + room || base + change < difference - room;
        }
    }
    return is_none;
}

/* The zeros in a piece, between tangents. */
static Told zeros_in(const Search *search, const Piece *piece, double ends[2])
{
    const int count = search->nodes->count;
    double values[COEFFICIENTS], radius = 0.0;
    Polynomial polynomial;
    Told told;
    int at;
    for (at = 0; at < count; at++) {
        const Disc tangent = tangent_at(piece, search->nodes->cosines[2 * at + 1]);
        const Disc square = plus_disc(disc_of(1.0, 0.0, 0.0), times_disc(tangent, tangent));
        Disc turn = times_disc(unit(tangent), unit(disc_of(search->origin, 0.0, 0.0))), value;
        int power;
        turn = piece->is_opposite ? disc_of(-turn.x, -turn.y, turn.radius) : turn;
        value = product(search->placed, turn);
        for (power = 0; power < count / 2; power++) {
            value = times_disc(value, square);
        }
        values[at] = value.x;
        /* A radius that is no number stays one. */
        radius = radius != radius || value.radius <= radius ? radius : value.radius;
    }
    interpolate(search->nodes, values, radius, &polynomial);
    told = zeros_of(&polynomial, ends);
    if (told == ONE_ZERO) {
        ends[0] = tangent_at(piece, ends[0]).x;
        ends[1] = tangent_at(piece, ends[1]).x;
    }
    return told;
}

/* A piece that tells nothing. */
static void add_untold(Search *search, const double angles[2])
{
    if (search->untold == 0) {
        search->first[0] = angles[0];
        search->first[1] = angles[1];
    } else if (fabs(angles[0] - search->first[1]) < 2.0 * SHORTEST) {
        search->first[1] = angles[1];
    }
    search->untold += 1;
}

/* A zero between two angles: an assembly of the list. */
static void add_zero(Search *search, const double angles[2])
{
    const uint32_t most = 2u * search->placed->kind->half;
    LinkageAssembly found;
    (void)memset(&found, 0, sizeof found);
    if (search->list->count < most && assembly_at(search->placed, angles, &found)) {
        search->assemblies[search->list->count] = found;
        search->list->count += 1u;
    } else if (!search->is_unplaced) {
        search->is_unplaced = 1;
        search->unplaced[0] = angles[0];
        search->unplaced[1] = angles[1];
    }
}

/* Takes a piece: 1 if it has to be divided, -1 if the budget is spent. */
static int take_piece(Search *search, const Piece *piece, int is_room)
{
    const double from = angle_at(search, piece->is_opposite, piece->from), to = angle_at(search, piece->is_opposite, piece->to);
    const uint32_t count = (uint32_t)search->nodes->count;
    LinkageAssemblies *list = search->list;
    double ends[2], angles[2];
    Told told;
    if (list->pieces >= search->budget.pieces) {
        return -1;
    }
    list->pieces += 1u;
    if (has_none(search->placed, (from + to) / 2.0, (to - from) / 2.0)) {
        return 0;
    }
    if (search->budget.samples - list->samples < count) {
        return -1;
    }
    list->samples += count;
    told = zeros_in(search, piece, ends);
    if (told == UNTOLD) {
        if (piece->to - piece->from >= SHORTEST && is_room) {
            return 1;
        }
        ends[0] = piece->from;
        ends[1] = piece->to;
        angles_of(search, piece, ends, angles);
        add_untold(search, angles);
    } else if (told == ONE_ZERO) {
        angles_of(search, piece, ends, angles);
        add_zero(search, angles);
    }
    return 0;
}

/* Looks at a part of half the circle piece by piece: 1 if all is looked at, 0 if enough is not told, -1 if the budget is
 * spent. */
static int take_part(Search *search, Piece whole)
{
    Piece waiting[WAITING];
    int count = 1;
    waiting[0] = whole;
    while (count > 0) {
        const Piece piece = waiting[count - 1];
        const int is_divided = take_piece(search, &piece, count + 1 <= WAITING);
        if (is_divided < 0 || search->untold == MOST_UNTOLD) {
            return is_divided < 0 ? -1 : 0;
        }
        count -= 1;
        if (is_divided) {
            const double between = piece.from + (piece.to - piece.from) * DIVIDED_AT;
            waiting[count].from = between;
            waiting[count + 1].to = between;
            waiting[count + 1].from = piece.from;
            waiting[count + 1].is_opposite = piece.is_opposite;
            count += 2;
        }
    }
    return 1;
}

/* All zeros around the circle. */
static void take_circle(Search *search)
{
    /* The first ends of pieces: no number of a drawing. */
    static const double ends[5] = { -1.0, -0.421875, 0.015625, 0.40625, 1.0 };
    int goes_on = 1, part;
    for (part = 0; part < 8 && goes_on > 0; part++) {
        Piece piece;
        piece.from = ends[part % 4];
        piece.to = ends[part % 4 + 1];
        piece.is_opposite = part / 4;
        goes_on = take_part(search, piece);
    }
    search->list->outcome = goes_on < 0 ? LINKAGE_OUT_OF_BUDGET : LINKAGE_PROVED;
    if (search->untold > 0) {
        search->list->outcome = LINKAGE_OPEN;
        search->list->from = search->first[0];
        search->list->to = search->first[1];
    } else if (goes_on >= 0 && search->is_unplaced) {
        search->list->outcome = LINKAGE_OPEN;
        search->list->from = search->unplaced[0];
        search->list->to = search->unplaced[1];
    }
}
