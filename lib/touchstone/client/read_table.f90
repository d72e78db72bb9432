! SPDX-License-Identifier: MIT
! Reading a canonical table in Fortran: list-directed READ takes the rows as they are.
!   read_table westergaard_half_width.txt [rtol [atol]]     prints the rows beyond atol + rtol |value| and what rounded inputs force,
!                                                           then the largest difference in ulps beyond what is forced
program read_table
  use, intrinsic :: iso_fortran_env, only: error_unit
  implicit none
  integer, parameter :: dp = kind(1.0d0)
  character(len=4096) :: file, line, reason
  real(dp) :: load, value, error, forced, answer, off, rtol, atol, worst = -huge(1.0_dp), margin = 1
  integer :: status, rows = 0
  if (command_argument_count() < 1 .or. command_argument_count() > 3) &
    call give_up('which table? read_table westergaard_half_width.txt')
  call get_command_argument(1, file)
  rtol = argument(2, 4 * epsilon(1.0_dp))
  atol = argument(3, 0.0_dp)
  open (10, file=trim(file), status='old', action='read', iostat=status, iomsg=reason)
  if (status /= 0) call give_up(trim(reason))
  do
    read (10, '(a)', iostat=status) line
    if (status /= 0) exit
    if (index(line, '"forced":"estimated"') > 0) margin = 4          ! four times an estimate, as touchstone judge
    if (line(1:1) == '#') cycle
    if (.not. chosen(line)) cycle
    read (line, *, iostat=status) load, value, error, forced
    if (status /= 0) then                                        ! a table without that column
      forced = 0
      read (line, *, iostat=status) load, value, error
    end if
    if (status /= 0) call give_up('not a row of numbers: '//trim(line))
    answer = atan2(sqrt(load), sqrt(1 - load)) / acos(-1.0_dp)   ! the code under test
    forced = margin * max(forced, 0.0_dp)                                 ! ulps; -1: not known
    off = abs(answer - value)
    if (.not. off <= atol + rtol * abs(value) + forced * spacing(value)) write (*, '(2a)') 'fails: ', trim(line)
    worst = max(worst, off / spacing(value) - forced)
    rows = rows + 1
  end do
  if (rows == 0) call give_up('no rows in '//trim(file))
  write (*, '(f0.2)') worst

contains

  logical function chosen(row)   ! where: change this to the rows that your code is meant for
    character(len=*), intent(in) :: row
    chosen = len_trim(row) > 0
  end function chosen

  real(dp) function argument(k, otherwise)
    integer, intent(in) :: k
    real(dp), intent(in) :: otherwise
    character(len=64) :: word
    argument = otherwise
    if (command_argument_count() < k) return
    call get_command_argument(k, word)
    read (word, *, iostat=status) argument
    if (status /= 0) call give_up('not a number: '//trim(word))
  end function argument

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
