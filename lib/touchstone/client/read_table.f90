! SPDX-License-Identifier: MIT
! Reading a canonical table in Fortran: list-directed READ takes the rows as they are.
!   read_table westergaard_half_width.txt     prints the largest difference in ulps
program read_table
  implicit none
  integer, parameter :: dp = kind(1.0d0)
  character(len=4096) :: file, line
  real(dp) :: load, value, error, answer, worst = 0
  integer :: status
  call get_command_argument(1, file)
  open (10, file=trim(file), status='old', action='read')
  do
    read (10, '(a)', iostat=status) line
    if (status /= 0) exit
    if (line(1:1) == '#') cycle
    read (line, *) load, value, error
    answer = atan2(sqrt(load), sqrt(1 - load)) / acos(-1.0_dp)   ! the code under test
    worst = max(worst, abs(answer - value) / spacing(value))
  end do
  write (*, '(f0.2)') worst
end program
