% SPDX-License-Identifier: MIT
% Reading a canonical table in MATLAB or Octave: the header is comments, the rows are numbers.
%   read_table('westergaard_half_width.txt')                                     at the prompt: the largest difference in ulps, beyond what rounded inputs force
%   [worst, failing] = read_table(file, @my_code, rtol, atol, where)             failing: all rows beyond atol + rtol |value| and what is forced
%   octave-cli --path FOLDER --eval "read_table('westergaard_half_width.txt')"   from a shell
% code and where take the matrix of inputs, one row each.
function [worst, failing] = read_table(file, code, rtol, atol, where)
if nargin < 1
    error('touchstone:usage', 'which table? read_table(''westergaard_half_width.txt'')');
end
if nargin < 2, code = @(x) atan2(sqrt(x(:, 1)), sqrt(1 - x(:, 1))) / pi; end   % the code under test
if nargin < 3, rtol = 4 * eps; end
if nargin < 4, atol = 0; end
lines = strsplit(strtrim(fileread(file)), sprintf('\n'));
names = strsplit(strtrim(lines{find(strncmp(lines, '#', 1), 1, 'last')}(2:end)));
quoted = @(word) [char(34) word char(34)];
estimated = strfind(lines, [quoted('forced') ':' quoted('estimated')]);
margin = 1 + 3 * any(~cellfun(@isempty, estimated));   % four times an estimate, as touchstone judge
lines = lines(~strncmp(lines, '#', 1));
rows = zeros(numel(lines), numel(names));
for k = 1:numel(lines)
    rows(k, :) = sscanf(lines{k}, '%f');
end
if nargin >= 5, rows = rows(where(rows), :); end
at = find(strcmp(names, 'value'));
value = rows(:, at);
forced = margin * max(rows(:, end), 0) .* strcmp(names{end}, 'forced');   % ulps; absolute where the value is 0
unit = eps(value);
unit(value == 0) = 1;
off = abs(code(rows(:, 1:at - 1)) - value);
failing = rows(~(off <= max(atol + rtol * abs(value), eps(value)) + forced .* unit), :);   % nan fails
beyond = max(off ./ unit - forced);
if nargout > 0
    worst = beyond;
else
    fprintf('%.2f\n', beyond);
end
end
