% SPDX-License-Identifier: MIT
% Octave, after mkoctfile --mex touchstone_eval.c -ltouchstone
disp(touchstone_eval('contact.area', 'n=3 load=1/8 G=5/2', 30))
