/* SPDX-License-Identifier: MIT */
/* touchstone.h from Octave and MATLAB: mkoctfile --mex touchstone_eval.c -ltouchstone; then
   touchstone_eval('contact.area', 'n=3 load=1/8 G=5/2', 30) gives the digits as text. */
#include "touchstone.h"
#include <mex.h>

void mexFunction(int nlhs, mxArray* plhs[], int nrhs, const mxArray* prhs[])
{
    touchstone_value* v = NULL;
    char why[256];
    (void)nlhs;
    if (nrhs != 3) mexErrMsgTxt("touchstone_eval(quantity, inputs, digits)");
    if (touchstone_eval(mxArrayToString(prhs[0]), mxArrayToString(prhs[1]), (long)mxGetScalar(prhs[2]), "nearest", &v, why, sizeof why) != TOUCHSTONE_OK)
        mexErrMsgTxt(why);
    plhs[0] = mxCreateString(touchstone_decimal(v));
    touchstone_free(v);
}
