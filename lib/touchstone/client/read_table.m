% SPDX-License-Identifier: MIT
% Reading a canonical table in Octave (or MATLAB): the header is comments, the rows are numbers.
%   octave-cli read_table.m westergaard_half_width.txt     prints the largest difference in ulps
arguments = argv();
text = fileread(arguments{1});
lines = strsplit(strtrim(text), "\n");
rows = cell2mat(cellfun(@(l) sscanf(l, "%f")', lines(! strncmp(lines, "#", 1))', "UniformOutput", false));
load_ratio = rows(:, 1);
value = rows(:, 2);
answer = atan2(sqrt(load_ratio), sqrt(1 - load_ratio)) / pi;   % the code under test
printf("%.2f\n", max(abs(answer - value) ./ eps(value)));
