/* linkage_assemblies.c: all ways to assemble a group of pins, proved. linkage_run.h says whose text this is.
 *
 * The group's equation, multiplied over all modes of its dyads and times powers of their bases, is a trigonometric polynomial
 * of the unknown, whose degree depends on the kind of group alone. As many values as it has coefficients are all of it on a
 * part of the circle. They are enclosed with all roundings, and a part is settled where its coefficients show that it has no
 * zero, or a single one. A part that is not settled is divided. A list takes 10 kB on the stack. */
#include "linkage_run.h"
#include "linkage_assemblies.h"

#ifndef LINKAGE_NO_DOUBLE

#define PI 3.141592653589793
#define TAU 6.283185307179586

typedef struct Complex {
    double x;
    double y;
} Complex;

/* All numbers as near to x + i y as the radius. Each operation returns a disc that holds the exact results of all numbers of
 * its operands' discs. */
typedef struct Disc {
    double x;
    double y;
    double radius;
} Disc;

static Complex complex_of(double x, double y)
{
    Complex made;
    made.x = x;
    made.y = y;
    return made;
}

/* An angle from -pi on. */
static double wrapped(double angle) { return angle - TAU * floor((angle + PI) / TAU); }

static Complex turned(double angle) { return complex_of(cos(angle), sin(angle)); }

static double square_of(Complex z) { return z.x * z.x + z.y * z.y; }

static double length_of(Complex z) { return hypot(z.x, z.y); }

static Complex number_complex(Complex z) { return z; }

static Complex conjugate_complex(Complex z) { return complex_of(z.x, -z.y); }

static Complex plus_complex(Complex a, Complex b) { return complex_of(a.x + b.x, a.y + b.y); }

static Complex minus_complex(Complex a, Complex b) { return complex_of(a.x - b.x, a.y - b.y); }

static Complex times_complex(Complex a, Complex b)
{
    return complex_of(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

static Complex inverse_complex(Complex z)
{
    const double by = 1.0 / square_of(z);
    return complex_of(z.x * by, -z.y * by);
}

/* The root of a dyad's square, which assembles where that is negative. */
static Complex root_complex(Complex z, int *assembles)
{
    *assembles = *assembles && z.x <= 0.0;
    return complex_of(0.0, sqrt(fmax(-z.x, 0.0)));
}

static Disc disc_of(double x, double y, double radius)
{
    Disc made;
    made.x = x;
    made.y = y;
    made.radius = radius;
    return made;
}

/* A radius with room for a dozen roundings of its own sum, and for underflow. */
static double outward(double radius) { return radius * (1.0 + 8.0 * DBL_EPSILON) + DBL_MIN; }

/* No less than the length of the centre, and no more than 1.09 times that: the octagon about a circle. */
static double most_of(Disc z)
{
    const double x = fabs(z.x), y = fabs(z.y);
    return (fmax(x, y) + 0.41421356237309515 * fmin(x, y)) * (1.0 + 4.0 * DBL_EPSILON);
}

/* No more than the length of the centre. */
static double least_of(Disc z) { return hypot(z.x, z.y) * (1.0 - 4.0 * DBL_EPSILON); }

static Disc number_disc(Complex z) { return disc_of(z.x, z.y, 0.0); }

static Disc conjugate_disc(Disc z) { return disc_of(z.x, -z.y, z.radius); }

static Disc plus_disc(Disc a, Disc b)
{
    Disc sum = disc_of(a.x + b.x, a.y + b.y, 0.0);
    sum.radius = outward(a.radius + b.radius + DBL_EPSILON * most_of(sum));
    return sum;
}

static Disc minus_disc(Disc a, Disc b) { return plus_disc(a, disc_of(-b.x, -b.y, b.radius)); }

/* Each part of a product is off by three half units of |x||u| + |y||v|. */
static Disc times_disc(Disc a, Disc b)
{
    const double first = most_of(a), second = most_of(b);
    const double radius = 3.0 * DBL_EPSILON * first * second + first * b.radius + second * a.radius;
    return disc_of(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x, outward(radius + a.radius * b.radius));
}

/* The radius is infinite for a disc that holds zero. |1/z - 1/c| = |z - c|/(|z| |c|). */
static Disc inverse_disc(Disc z)
{
    const double least = least_of(z);
    double radius;
    if (!(least > z.radius)) {
        return disc_of(0.0, 0.0, HUGE_VAL);
    }
    radius = z.radius / (least * (least - z.radius)) + 16.0 * DBL_EPSILON / least;
    return disc_of(z.x / least / least, -z.y / least / least, outward(radius));
}

/* A root: of each number of the disc one of both roots is in the result. */
static Disc root_disc(Disc z, int *assembles)
{
    const double far = hypot(z.x, z.y);
    const double larger = sqrt((far + fabs(z.x)) / 2.0);
    const double smaller = larger > 0.0 ? fabs(z.y) / larger / 2.0 : 0.0;
    Disc root = z.x >= 0.0 ? disc_of(larger, smaller, 0.0) : disc_of(smaller, larger, 0.0);
    double near_root;
    (void)assembles;
    root.y = z.y < 0.0 ? -root.y : root.y;
    near_root = least_of(root) > 0.0 ? z.radius / least_of(root) : HUGE_VAL;
    root.radius = outward(fmin(near_root, sqrt(z.radius)) + 8.0 * DBL_EPSILON * most_of(root));
    return root;
}

/* A group with its places, counted from an origin a body and made of a size about one, which rounds nothing. */
typedef struct Placed {
    const LinkagePinned *kind;
    const double *places;
    double length;
    double scale;
    uint8_t origins[10];
} Placed;

#define STANDING 0
#define TURNED 1

static Complex place_of(const Placed *placed, uint8_t body, uint8_t place)
{
    const double *at = &placed->places[2 * place], *origin = &placed->places[2 * placed->origins[body]];
    return complex_of((at[0] - origin[0]) * placed->scale, (at[1] - origin[1]) * placed->scale);
}

static Complex pin_of(const Placed *placed, LinkageBodyPin at) { return place_of(placed, at.body, at.place); }

/* The vector of a bar from its outer pin to the inner one. */
static Complex bar_of(const Placed *placed, const LinkageHungBar *bar)
{
    return place_of(placed, bar->body, bar->ends[1]);
}
