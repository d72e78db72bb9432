% SPDX-License-Identifier: MIT
% Reading a canonical table in MATLAB or Octave: the header is comments, the rows are numbers.
%   read_table('westergaard_half_width.txt')                                     at the prompt: the largest difference in ulps
%   octave-cli --path FOLDER --eval "read_table('westergaard_half_width.txt')"   from a shell
function worst = read_table(file)
if nargin < 1
    error('touchstone:usage', 'which table? read_table(''westergaard_half_width.txt'')');
end
lines = strsplit(strtrim(fileread(file)), sprintf('\n'));
lines = lines(~strncmp(lines, '#', 1));
rows = zeros(numel(lines), 3);
for k = 1:numel(lines)
    row = sscanf(lines{k}, '%f');     % load, value, error, and what else the table has
    rows(k, :) = row(1:3);
end
load_ratio = rows(:, 1);
value = rows(:, 2);
answer = atan2(sqrt(load_ratio), sqrt(1 - load_ratio)) / pi;   % the code under test
difference = max(abs(answer - value) ./ eps(value));
if nargout > 0
    worst = difference;
else
    fprintf('%.2f\n', difference);
end
end
