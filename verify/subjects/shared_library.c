/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A C code as a shared library: touchstone judge TABLE --library libsubject.so --symbol NAME */
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

double half_width(double load);
double pressure(double x, double load);
double crashes(double load);
double prints(double load);
double ends(double load);
double open_files(double load);

static const double pi = 3.14159265358979323846;

double half_width(double load) { return atan2(sqrt(load), sqrt(1 - load)) / pi; }

double pressure(double x, double load)
{
    const double c = cos(pi * x), s = sin(pi * x);
    if (load >= 1) return load - 1 + 2 * c * c;
    return s * s < load ? 2 * c * sqrt(load - s * s) : 0;
}

/* misbehave in ways a judge must survive */
double crashes(double load)
{
    if (load > 0.5) abort();
    return half_width(load);
}

double prints(double load)
{
    printf("half_width(%g) called\n", load);
    return half_width(load);
}

double ends(double load)
{
    if (load > 0.5) exit(0);
    return half_width(load);
}

double open_files(double load) /* wrong if it was left a file of the judge's: beside the three streams it has the one for its answers */
{
    int file, open = 0;
    for (file = 3; file < 1000; ++file) open += fcntl(file, F_GETFD) != -1;
    return open == 1 ? half_width(load) : -open;
}
