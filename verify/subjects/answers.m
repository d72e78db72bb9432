% SPDX-License-Identifier: GPL-3.0-or-later
% An Octave code under test by a file of answers:
%   octave-cli answers.m westergaard_half_width.txt answers.txt
%   touchstone judge westergaard_half_width.txt --answers answers.txt
names = argv();
comments = sum(strncmp(strsplit(fileread(names{1}), "\n"), "#", 1));
rows = dlmread(names{1}, " ", comments, 0);
load_ratio = rows(:, 1);
answers = atan2(sqrt(load_ratio), sqrt(1 - load_ratio)) / pi;
save("-text", names{2}, "answers");
