! SPDX-License-Identifier: MIT
! Reading a canonical table in Fortran: list-directed READ takes the rows as they are.
!   read_table westergaard_half_width.txt     prints the largest difference in ulps
program read_table
  use, intrinsic :: iso_fortran_env, only: error_unit
  implicit none
  integer, parameter :: dp = kind(1.0d0)
  character(len=4096) :: file, line, reason
  real(dp) :: load, value, error, answer, worst = 0
  integer :: status, rows = 0
  if (command_argument_count() /= 1) call give_up('which table? read_table westergaard_half_width.txt')
  call get_command_argument(1, file)
  open (10, file=trim(file), status='old', action='read', iostat=status, iomsg=reason)
  if (status /= 0) call give_up(trim(reason))
  do
    read (10, '(a)', iostat=status) line
    if (status /= 0) exit
    if (line(1:1) == '#') cycle
    read (line, *, iostat=status) load, value, error
    if (status /= 0) call give_up('not a row of numbers: '//trim(line))
    answer = atan2(sqrt(load), sqrt(1 - load)) / acos(-1.0_dp)   ! the code under test
    worst = max(worst, abs(answer - value) / spacing(value))
    rows = rows + 1
  end do
  if (rows == 0) call give_up('no rows in '//trim(file))
  write (*, '(f0.2)') worst

contains

  subroutine give_up(why)   ! one line and a status, where error stop adds a backtrace
    use, intrinsic :: iso_c_binding, only: c_int
    character(len=*), intent(in) :: why
    interface
      subroutine leave(code) bind(c, name='exit')
        import :: c_int
        integer(c_int), value :: code
      end subroutine leave
    end interface
    write (error_unit, '(2a)') 'read_table: ', why
    call leave(1_c_int)
  end subroutine give_up
end program
