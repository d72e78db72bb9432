! SPDX-License-Identifier: MIT
! touchstone.h from Fortran: gfortran area.f90 -ltouchstone
program area
  use, intrinsic :: iso_c_binding
  implicit none
  interface
    integer(c_int) function touchstone_eval_rows(quantity, inputs, rows, columns, values, how, message, size) bind(C)
      import :: c_int, c_char, c_double, c_size_t
      character(kind=c_char), intent(in) :: quantity(*)
      real(c_double), intent(in) :: inputs(*)
      integer(c_size_t), value :: rows, columns, size
      real(c_double), intent(out) :: values(*)
      integer(c_int), intent(out) :: how(*)
      character(kind=c_char), intent(out) :: message(*)
    end function
  end interface
  real(c_double) :: inputs(3, 2), values(2)   ! n, load, G of each row
  integer(c_int) :: how(2), code
  character(kind=c_char) :: message(256)
  inputs(:, 1) = [3.0_c_double, 0.125_c_double, 2.5_c_double]
  inputs(:, 2) = [4.0_c_double, 0.125_c_double, 2.5_c_double]
  code = touchstone_eval_rows("contact.area" // c_null_char, inputs, 2_c_size_t, 3_c_size_t, values, how, message, 256_c_size_t)
  if (code /= 0) error stop
  write (*, '(es24.16e3)') values
end program
