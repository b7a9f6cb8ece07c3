program from_fortran
  use, intrinsic :: iso_c_binding
  implicit none
  interface
    type(c_ptr) function nipref_find(name) bind(c)
      import
      character(kind=c_char), intent(in) :: name(*)
    end function
    integer(c_int) function nipref_fast(quantity, arguments, rtol, value) bind(c)
      import
      type(c_ptr), value :: quantity
      real(c_double), intent(in) :: arguments(*)
      real(c_double), value :: rtol
      real(c_double), intent(out) :: value
    end function
  end interface
  real(c_double) :: value
  if (nipref_fast(nipref_find("I1" // c_null_char), [0.73_c_double], 0.0_c_double, value) /= 0) stop 1
  print '(a, f19.17)', "I1(0.73) = ", value
end program
