! SPDX-License-Identifier: GPL-3.0-or-later
! A Fortran code under test: westergaard.half_width. Hexadecimal input is read by C's strtod;
! the answer is written in decimal with the 17 digits that carry a double.
program half_width
  use, intrinsic :: iso_c_binding
  use, intrinsic :: iso_fortran_env, only: iostat_end
  implicit none
  interface
    real(c_double) function strtod(text, rest) bind(c)
      import :: c_double, c_char, c_ptr
      character(kind=c_char), intent(in) :: text(*)
      type(c_ptr), value :: rest
    end function
  end interface
  character(len=200) :: line
  real(c_double) :: load
  integer :: status
  do
    read (*, '(a)', iostat=status) line
    if (status == iostat_end) exit
    load = strtod(trim(line)//c_null_char, c_null_ptr)
    write (*, '(es24.16e3)') atan2(sqrt(load), sqrt(1 - load)) / acos(-1.0_c_double)
  end do
end program
